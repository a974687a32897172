// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/audit/audit_report.h"
#include "planning/plan/motion_plan.h"
#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// A foot and where it is put.
struct PlacedStep {
  int foot = 0;
  PlanarPose place;  ///< of the contact point or the sole's middle in W; yaw beyond that of standing
};

/// A footstep planner of one's own: the body goes round an arc that begins at the origin along x, and each foot in turn
/// is put where it stands under the body, a round of all feet further on. The feet of one side step from the rear to
/// the front, then those of the other: the order in which a quadruped that crawls stands most safely (McGhee and Frank,
/// Mathematical Biosciences 3, 1968, doi:10.1016/0025-5564(68)90090-4).
/// @param turn_rad  left positive.   @param stride_m  the farthest that the body goes in a round.
/// @throws InvalidArgument unless radius and stride are more than 0 and turn_rad is other than 0, all finite.
std::vector<PlacedStep> StepsOnArc(const RobotModel& model, double radius_m, double turn_rad, double stride_m);

/// The steps as a file of footsteps has them (docs/import.md), one after the other.
/// @param swing_s, pause_s  time of each step, and between two.
std::string FootstepsYaml(const RobotModel& model, const std::vector<PlacedStep>& steps, double swing_s,
                          double pause_s);

/// What came of one's own footsteps.
struct WalkedSteps {
  MotionPlan plan;
  AuditReport audit;
  StabilityReport report;
  double miss_m = 0.0;  ///< from a step to the nearest touch-down of its foot as measured, the largest
};

/// Plans the motion of all the rest over such a file, on level ground, and audits, plays and scores it.
/// @throws InvalidArgument with the reason, for steps that cannot be taken.
WalkedSteps WalkSteps(const RobotModel& model, const std::vector<PlacedStep>& steps);

}  // namespace gaitwright::examples
