// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"

/// Robots, plans and logs whose values are all known in closed form.
///
/// The robot is a point mass on massless legs of three prismatic joints, so that the centre of mass is the base and a
/// foot is at hip + (qx, qy, qz). Plans solve the pendulum x - (z/g) x'' = p on their grid, so that the ZMP of their
/// inverse dynamics is the reference p up to rounding.
namespace gaitwright::synthetic {

inline constexpr double kStep = 0.005;                          // [s]
inline constexpr double kHeight = 0.5;                          // of the centre of mass [m]
inline constexpr double kHalfLength = 0.08, kHalfWidth = 0.04;  // of a sole [m]

/// Two soles at y = +-0.1, or four point or sphere feet at (+-0.2, +-0.15); 10 kg.
RobotModel Robot(int num_legs, FootType type);

/// Target places of feet and ZMP over time.
struct Motion {
  ContactSchedule schedule;
  std::vector<std::vector<Vector3>> foot;  ///< by row, foot: contact point on the ground
  std::vector<Vector2> zmp;                ///< by row
};

/// Adds a foothold for each stance of a foot, at its place in the middle of the stance.
void FillFootholds(const Motion& motion, int num_feet, MotionPlan& plan);

/// The plan with that motion, on level ground.
MotionPlan PlanOf(const RobotModel& model, const Motion& motion);

/// All feet on the ground; ZMP and centre of mass at `zmp`, which is the middle of the hips.
MotionPlan StandingPlan(const RobotModel& model, double duration_s, const Vector2& zmp = Vector2::Zero());

/// Groups of feet step in turn.
struct Steps {
  int count = 6;
  double length_m = 0.1;  ///< advance of a swing
  double swing_s = 0.4, double_s = 0.1;
  double lift_m = 0.04;
  double rest_s = 0.8;  ///< standing at both ends
};

/// A walk forward: feet of a biped in turn, or the diagonals of a quadruped. The ZMP stays in the middle of the stance
/// feet and moves to the next ones while all feet stand.
MotionPlan SteppingPlan(const RobotModel& model, const Steps& steps = {});

/// The log of a playback that follows the plan exactly.
PlaybackLog PerfectLog(const RobotModel& model, const MotionPlan& plan);

/// Lowers the base; the feet stay in place, from sample `first` on.
void Sink(PlaybackLog& log, std::size_t first, double base_height_m);

}  // namespace gaitwright::synthetic
