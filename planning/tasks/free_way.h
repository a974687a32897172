// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Holds straight ways in the space of joints against self-collision.
class WayCheck {
 public:
  /// @param q_base  size nq; its base is where the robot is, which changes nothing.
  WayCheck(const RobotModel& model, const VectorX& q_base);

  /// The first pair that collides on the straight line in joint space, checked every hundredth of a radian
  /// (millimetre), if any.
  /// @param from, to  independent joints, size n.
  std::optional<Overlap> FirstMeeting(const VectorX& from, const VectorX& to);

  /// A pair that meets at a posture, if one does.
  std::optional<Overlap> MeetingAt(const VectorX& joints);

 private:
  const RobotModel& model_;
  DynamicsScratch scratch_;
  CollisionChecker collision_;
  VectorX q_;
};

}  // namespace gaitwright
