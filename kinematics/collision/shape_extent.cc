// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/collision/shape_extent.h"

#include <algorithm>

namespace gaitwright {

Vector3 LowestPoint(const DynamicsScratch& scratch, const Shape& shape) {
  const Pose X_WS = FramePose(scratch, shape.body, shape.X_BS);
  return X_WS * SupportPoint(shape, -X_WS.linear().row(2).transpose());
}

bool IsShapeOfFoot(const Foot& foot, const Shape& shape) {
  constexpr double kSameSurface = 2e-3;  // [m]
  if (shape.link == foot.link) return true;
  if (shape.body != foot.body) return false;
  const Pose X_FS = foot.X_BF.inverse() * shape.X_BS;
  const Vector3 down_S = X_FS.linear().transpose() * -Vector3::UnitZ();
  return (X_FS * SupportPoint(shape, down_S)).z() < kSameSurface - foot.radius;
}

bool IsShapeOfAFoot(const RobotModel& model, const Shape& shape) {
  return std::any_of(model.feet.begin(), model.feet.end(),
                     [&](const Foot& foot) { return IsShapeOfFoot(foot, shape); });
}

}  // namespace gaitwright
