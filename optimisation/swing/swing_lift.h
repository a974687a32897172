// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <utility>

#include "kinematics/model/robot_model.h"
#include "optimisation/swing/plan_swings.h"

namespace gaitwright {

/// The lift of a swing where nothing asks for more [m].
double SwingLift(const RobotModel& model, const SwingOptions& options);

/// How far feet can be lifted and put down again in a time, as slow motors or legs that stand nearly straight let them.
class SpeedBoundLift {
 public:
  explicit SpeedBoundLift(const RobotModel& model) : model_(&model) {}

  /// The usual lift, or where a joint of the leg would need more than its speed limit for that alone, one that takes
  /// 0.6 of the limit: from the standing posture, straight up and down. Never less than a quarter of the usual one.
  double LiftInTime(int foot, double duration_s, double usual_m);

 private:
  double LargestUse(int foot, double duration_s, double lift_m) const;

  const RobotModel* model_;
  std::map<std::pair<int, long long>, double> known_;  // by foot and duration [us]
};

}  // namespace gaitwright
