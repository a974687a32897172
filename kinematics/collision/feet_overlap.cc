// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/collision/feet_overlap_internal.h"
#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {
namespace {

bool IsFixedByFoothold(const RobotModel& model, const std::string& link) {
  return std::any_of(model.collision_shapes.begin(), model.collision_shapes.end(), [&](const Shape& shape) {
    const bool on_sole = std::any_of(model.feet.begin(), model.feet.end(), [&](const Foot& foot) {
      return foot.type == FootType::kSole && foot.body == shape.body;
    });
    return shape.link == link && (on_sole || IsShapeOfAFoot(model, shape));
  });
}

}  // namespace

bool FeetOverlap(const RobotModel& model, const VectorX& q) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  CollisionChecker checker(model);
  const std::vector<Overlap>& overlaps = checker.Overlaps(scratch);
  return std::any_of(overlaps.begin(), overlaps.end(), [&](const Overlap& overlap) {
    return IsFixedByFoothold(model, overlap.link_a) && IsFixedByFoothold(model, overlap.link_b);
  });
}

}  // namespace gaitwright
