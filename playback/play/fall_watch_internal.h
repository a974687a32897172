// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/engine/world.h"

namespace gaitwright::playing {

/// Tells when going on is pointless: the robot is tilted, lies on a body that is no foot, or has sunk.
///
/// Heights of the base are those of its HeightPoint over the mean height of the feet that stand: those of the schedule
/// in the plan, those that touch in the world, or the last that did. So ground that the plan does not know is no fall.
class FallWatch {
 public:
  /// @param height_lowest  share of the plan's height below which the base has sunk; 0 never.
  FallWatch(const RobotModel& model, const MotionPlan& plan, double height_lowest);

  /// Contact of bodies counts from here on.
  void Start(double time_s) { contact_since_s_ = time_s; }
  /// The state at `time_s`, after a step.
  void Add(double time_s, const World& world);
  /// True some time after the fall, so that the log shows it.
  bool Over(double time_s) const;

 private:
  bool Sunk(double time_s, const World& world);

  Vector3 up_B_;
  double start_s_, step_s_, height_lowest_;
  Vector3 height_point_B_;
  std::vector<double> planned_height_;  ///< by row of the plan [m]
  double ground_m_ = 0.0;               ///< mean height of the feet that touched last
  double contact_since_s_ = 0.0, fallen_s_ = 0.0;
  bool fallen_ = false;
};

}  // namespace gaitwright::playing
