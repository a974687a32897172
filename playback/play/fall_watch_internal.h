// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/engine/world.h"

namespace gaitwright::playing {

/// Detects a fall: the robot is tilted from its planned attitude, lies on a body that is not a foot, or has sunk.
///
/// Heights of the base are those of its HeightPoint above the mean height of the standing feet. In the plan these are
/// the feet of the schedule; in the world the touching feet, or the last ones that touched. While no foot touches, the
/// plan's height is above the feet that stood in the plan at the last touch. So neither unplanned ground heights nor a
/// late landing on lower ground is a fall.
class FallWatch {
 public:
  /// @param height_lowest  share of the plan's height below which the base has sunk; 0 disables the check.
  FallWatch(const RobotModel& model, const MotionPlan& plan, double height_lowest);

  /// Contacts of bodies count from this time on.
  void Start(double time_s) { contact_since_s_ = time_s; }
  /// Adds the state at `time_s`, after a step.
  void Add(double time_s, const World& world);
  /// True some time after the fall, so that the log contains the fall.
  bool Over(double time_s) const;

 private:
  std::size_t RowAt(double time_s) const;
  bool Sunk(double time_s, const World& world);

  std::vector<Vector3> up_B_;  ///< by row of the plan
  double start_s_, step_s_, height_lowest_;
  Vector3 height_point_B_;
  std::vector<double> planned_m_;         ///< height of the HeightPoint in W, by row of the plan
  std::vector<double> planned_ground_m_;  ///< mean height of the feet that stand, or stood last, by row
  std::size_t touched_row_ = 0;           ///< row of the plan at the last touch
  double ground_m_ = 0.0;                 ///< mean height of the feet that touched last
  double contact_since_s_ = 0.0, fallen_s_ = 0.0;
  bool fallen_ = false;
};

}  // namespace gaitwright::playing
