// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/body_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/body_tree.h"

namespace gaitwright {
namespace {

using Extent = Eigen::AlignedBox3d;

/// Marks the bodies that belong to a leg or are carried by one.
std::vector<bool> BodiesOnLegs(const RobotModel& model) {
  std::vector<bool> of_leg = BodiesOfLegs(model);
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    if (of_leg[static_cast<std::size_t>(model.joints[j].parent_body)]) of_leg[j + 1] = true;
  }
  return of_leg;
}

void AddShape(const DynamicsScratch& scratch, const Shape& shape, Extent& extent) {
  const Pose X_WS = FramePose(scratch, shape.body, shape.X_BS);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Vector3 direction = sign * Vector3::Unit(axis);
      extent.extend(X_WS * SupportPoint(shape, X_WS.linear().transpose() * direction));
    }
  }
}

/// Whether each foot has a mirror image on the other side; if so, both sides get the same space.
bool IsMirrored(const RobotModel& model) {
  return std::all_of(model.legs.begin(), model.legs.end(), [](const Leg& leg) { return leg.mirror >= 0; });
}

void MakeSymmetric(Extent& extent) {
  const double half = std::max(-extent.min().y(), extent.max().y());
  extent.min().y() = -half;
  extent.max().y() = half;
}

/// Moves the feet of two sides to the mean of their places and the mirror images of these.
void MakeSymmetric(const RobotModel& model, std::vector<Vector2>& feet) {
  const std::vector<Vector2> as_they_are = feet;
  for (std::size_t f = 0; f < feet.size(); ++f) {
    const Vector2& other = as_they_are[static_cast<std::size_t>(model.legs[f].mirror)];
    feet[f] = 0.5 * (as_they_are[f] + Vector2(other.x(), -other.y()));
  }
}

/// Adds a box around an extent, enlarged on all sides. The box begins at `lowest` or higher; nothing is added if the
/// extent is lower than that.
void AddBox(Extent extent, const Vector3& grown, double lowest, BodySpace& space) {
  if (extent.isEmpty()) return;
  extent.min() -= grown;
  extent.max() += grown;
  extent.min().z() = std::max(extent.min().z(), lowest);
  if (extent.min().z() >= extent.max().z()) return;
  Shape box;
  box.type = ShapeType::kBox;
  box.X_BS.translation() = extent.center();
  box.size = extent.sizes();
  space.boxes.push_back(box);
  for (const double x : {extent.min().x(), extent.max().x()}) {
    for (const double y : {extent.min().y(), extent.max().y()})
      space.radius_m = std::max(space.radius_m, std::hypot(x, y));
  }
}

/// Half the smallest width of the soles, or the largest radius of the spheres.
double FootRadius(const RobotModel& model) {
  double radius = 0.0;
  for (const Foot& foot : model.feet) {
    radius = std::max(radius, foot.radius);
    if (foot.sole_F.empty()) continue;
    Vector2 most = Vector2::Zero();
    for (const Vector2& corner : foot.sole_F) most = most.cwiseMax(corner.cwiseAbs());
    radius = std::max(radius, most.minCoeff());
  }
  return radius;
}

/// Half the distance between the feet of a biped; 0 for other robots, whose bodies stay between their feet.
double HalfStance(const std::vector<Vector2>& feet_G) {
  return feet_G.size() == 2 ? 0.5 * std::abs(feet_G[1].y() - feet_G[0].y()) : 0.0;
}

}  // namespace

BodySpace BodySpaceOf(const RobotModel& model, const BodySpaceOptions& options) {
  constexpr double kRadians = std::numbers::pi / 180.0;
  BodySpaceOptions checked = options;
  CheckOptions(checked.Fields());
  const double leg = model.leg_length_m();
  BodySpace space;
  space.leg_length_m = leg;
  space.foot_radius_m = FootRadius(model);
  space.reach_forward_m = options.foothold_forward * leg;
  space.reach_lateral_m = options.foothold_lateral * leg;
  space.step_height_m = options.step_height * leg;
  space.margin_m = options.margin * leg;
  space.max_slope_rad = options.max_slope_deg * kRadians;
  space.max_tilt_rad = options.max_tilt_deg * kRadians;
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  Extent legs, rest;
  const std::vector<bool> of_leg = BodiesOnLegs(model);
  for (const Shape& shape : model.collision_shapes)
    AddShape(scratch, shape, of_leg[static_cast<std::size_t>(shape.body)] ? legs : rest);
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    space.feet_G.emplace_back(ContactFrame(model, scratch, f).translation().head<2>());
    for (const Vector3& p : ContactPoints(model, scratch, f)) legs.extend(p);
    const Leg& chain = model.legs[static_cast<std::size_t>(f)];
    legs.extend(scratch.p_WB[static_cast<std::size_t>(std::max(chain.hip_joint, chain.joints.front()) + 1)]);
  }
  if (IsMirrored(model)) {
    for (Extent* extent : {&legs, &rest}) {
      if (!extent->isEmpty()) MakeSymmetric(*extent);
    }
    MakeSymmetric(model, space.feet_G);
  }
  const Vector3 margin = Vector3::Constant(space.margin_m);
  AddBox(legs, margin + Vector3(options.step_forward * leg, options.step_lateral * leg, 0.0), space.step_height_m,
         space);
  AddBox(rest, margin + options.sway * HalfStance(space.feet_G) * Vector3::UnitY(), space.step_height_m, space);
  return space;
}

}  // namespace gaitwright
