// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Checks straight lines in joint space for self-collision.
class PathCheck {
 public:
  /// @param q_base  size nq; only its base pose is used, which does not affect self-collision.
  PathCheck(const RobotModel& model, const VectorX& q_base);

  /// The first pair of links that collides on the straight line in joint space, if any. Checked every 0.01 rad (1 mm).
  /// @param from, to  independent joints, size n.
  std::optional<Overlap> FirstMeeting(const VectorX& from, const VectorX& to);

  /// A pair of links that collides at a posture, if any.
  std::optional<Overlap> MeetingAt(const VectorX& joints);

 private:
  const RobotModel& model_;
  DynamicsScratch scratch_;
  CollisionChecker collision_;
  VectorX q_;
};

}  // namespace gaitwright
