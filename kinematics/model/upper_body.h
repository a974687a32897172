// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A limb that is not a leg: the chain from the trunk to its farthest end.
struct Limb {
  std::vector<int> dofs;  ///< independent joints, trunk first, each once
  int end_body = 0;
  Vector3 p_BE = Vector3::Zero();  ///< its end E in that body: the body's centre of mass [m]
};

/// Limbs of a robot other than its legs.
struct UpperBody {
  std::optional<Limb> left_arm, right_arm, head;

  /// The arm of a side, if there is one.
  const std::optional<Limb>& arm(bool left) const { return left ? left_arm : right_arm; }
};

/// Finds arms and a head by their position in the standing posture; names are not used.
///
///   arm    a part outside the legs with two or more joints whose ends are all on one side of the body; if a side has
///          several such parts, the longest one
///   head   a part outside the legs whose ends are all in the middle and above its first joint, with a joint that nods
///          (an axis within 45 degrees of the body's y)
///
/// The middle is within a tenth of the leg's length of the body's upright plane.
UpperBody FindUpperBody(const RobotModel& model);

}  // namespace gaitwright
