// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/motion_plan.h"
#include "planning/plan/terrain.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// What one foot does over the rows of a motion, by its joints and the base.
struct FootPathRows {
  std::vector<Pose> X_WF;         ///< its contact frame, on the normal of the ground under it
  std::vector<double> height_m;   ///< of its lowest point over the ground; infinite where there is none
  std::vector<double> speed_m_s;  ///< of the fastest of the points with which it touches
  std::vector<Vector3> rolled_W;  ///< how far a sphere has rolled since the first row [m]; else zero
};

/// The motion of every foot.
std::vector<FootPathRows> FeetOf(const RobotModel& model, const Terrain& terrain, const EvenMotion& motion);

/// The schedule of a motion: from its column of contacts, or where the feet are low and slow (ImportOptions), with
/// contacts and gaps shorter than `contact_least_s` left out. Every boundary is a row. What is done is said.
/// @throws InvalidArgument for a foot that never stands, with its least height and speed.
ContactSchedule ScheduleOf(const RobotModel& model, const EvenMotion& motion, const std::vector<FootPathRows>& feet,
                           const ImportOptions& options, std::vector<DerivedPart>& derived);

/// The footholds of a schedule: by component the median of where the contact frame is over each stance, less what it
/// has rolled, put on the ground there with its normal; a sole keeps its heading.
/// @throws InvalidArgument where there is no ground.
FootstepPlan FootholdsOf(const RobotModel& model, const Terrain& terrain, const ContactSchedule& schedule,
                         const EvenMotion& motion, const std::vector<FootPathRows>& feet);

/// The swing between two footholds whose detour comes nearest to the foot's path, in the least squares.
/// @param farthest_m  gets how far the path is from it at the most.
SwingTrajectory SwingOf(const Foothold& from, const Foothold& to, const EvenMotion& motion, const FootPathRows& foot,
                        double& farthest_m);

}  // namespace gaitwright
