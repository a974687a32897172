// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/motion_plan.h"
#include "planning/plan/terrain.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Motion of one foot over the rows, from the joints and the base.
struct FootTrack {
  std::vector<Pose> X_WF;         ///< its contact frame, aligned with the normal of the ground under it
  std::vector<double> height_m;   ///< height of its lowest point above the ground; infinite without ground
  std::vector<double> speed_m_s;  ///< speed of the fastest contact point
  std::vector<Vector3> rolled_W;  ///< for a sphere: distance rolled since the first row [m]; otherwise zero
};

/// The motion of every foot.
std::vector<FootTrack> FeetOf(const RobotModel& model, const Terrain& terrain, const EvenMotion& motion);

/// The schedule of a motion: from its contact column, or from low and slow feet (ImportOptions), without contacts and
/// gaps shorter than `contact_least_s`. Every boundary is at a row. The notes describe the method.
/// @throws InvalidArgument for a foot that is never in stance, with its smallest height and speed.
ContactSchedule ScheduleOf(const RobotModel& model, const EvenMotion& motion, const std::vector<FootTrack>& feet,
                           const ImportOptions& options, std::vector<DerivedPart>& derived);

/// The footholds of a schedule: the component-wise median of the contact frame over each stance, minus rolling,
/// projected onto the ground with its normal; a sole keeps its heading.
/// @throws InvalidArgument if there is no ground.
FootstepPlan FootholdsOf(const RobotModel& model, const Terrain& terrain, const ContactSchedule& schedule,
                         const EvenMotion& motion, const std::vector<FootTrack>& feet);

/// The swing between two footholds that fits the foot's path best (least squares).
/// @param farthest_m  receives the largest distance of the path from the swing.
SwingTrajectory SwingOf(const Foothold& from, const Foothold& to, const EvenMotion& motion, const FootTrack& foot,
                        double& farthest_m);

}  // namespace gaitwright
