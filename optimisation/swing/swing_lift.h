// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <utility>

#include "kinematics/model/robot_model.h"
#include "optimisation/swing/plan_swings.h"

namespace gaitwright {

/// Default lift of a swing [m].
double SwingLift(const RobotModel& model, const SwingOptions& options);

/// Lift that the motors' speeds allow in a given time; small for slow motors and for legs that stand nearly straight.
class SpeedBoundLift {
 public:
  explicit SpeedBoundLift(const RobotModel& model) : model_(&model) {}

  /// The usual lift, or a smaller one that uses 0.6 of a joint's speed limit if the usual lift alone would exceed the
  /// limit. Computed straight up and down from the standing posture. At least a quarter of the usual lift.
  double LiftInTime(int foot, double duration_s, double usual_m);

 private:
  double LargestUse(int foot, double duration_s, double lift_m) const;

  const RobotModel* model_;
  std::map<std::pair<int, long long>, double> known_;  // by foot and duration [us]
};

}  // namespace gaitwright
