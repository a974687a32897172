// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/terrain_scale.h"

#include <algorithm>

#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/foot_contact.h"

namespace gaitwright {
namespace {

using Box = Eigen::AlignedBox3d;

/// The axis-parallel box in W around a foot's sole or sphere.
Box FootBox(const RobotModel& model, const DynamicsScratch& scratch, int foot) {
  Box box;
  for (const Vector3& p : ContactPoints(model, scratch, foot)) box.extend(p);
  const double radius = model.feet[static_cast<std::size_t>(foot)].radius;
  if (radius > 0.0) box = Box(box.min() - Vector3(radius, radius, 0.0), box.max() + Vector3(radius, radius, 0.0));
  return box;
}

Box ShapeBox(const Shape& shape, const Pose& X_WS) {
  Vector3 low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 along_S = X_WS.linear().row(axis).transpose();
    high[axis] = (X_WS * SupportPoint(shape, along_S))[axis];
    low[axis] = (X_WS * SupportPoint(shape, -along_S))[axis];
  }
  return {low, high};
}

}  // namespace

TerrainScale ScaleOf(const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  TerrainScale scale;
  scale.leg_length_m = model.leg_length_m();
  scale.foot_length_m = scale.foot_width_m = 0.0;
  Box feet, all;
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    const Box foot = FootBox(model, scratch, f);
    scale.foot_length_m = std::max(scale.foot_length_m, foot.sizes().x());
    scale.foot_width_m = std::max(scale.foot_width_m, foot.sizes().y());
    feet.extend(foot);
  }
  all = feet;
  for (const Shape& shape : model.collision_shapes) {
    if (shape.type == ShapeType::kMesh && shape.vertices.empty()) continue;
    all.extend(ShapeBox(shape, FramePose(scratch, shape.body, shape.X_BS)));
  }
  scale.body_length_m = all.sizes().x();
  scale.body_width_m = all.sizes().y();
  scale.body_height_m = all.max().z();
  scale.front_m = all.max().x();
  scale.stance_width_m = feet.sizes().y();
  return scale;
}

}  // namespace gaitwright
