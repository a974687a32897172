// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/find_feet.h"

#include <algorithm>
#include <cmath>

#include "kinematics/model/build_model.h"

namespace gaitwright {
namespace {

/// Points that span a shape (a sphere: its centre), in the body's frame.
std::vector<Vector3> Corners(const Shape& shape) {
  std::vector<Vector3> corners;
  if (shape.type == ShapeType::kMesh) {
    for (const Vector3& v : shape.vertices) corners.push_back(shape.X_BS * v);
    return corners;
  }
  if (shape.type == ShapeType::kSphere) return {shape.X_BS.translation()};
  Vector3 half = 0.5 * shape.size;
  if (shape.type != ShapeType::kBox) half = Vector3(shape.size.x(), shape.size.x(), 0.5 * shape.size.y());
  for (int i = 0; i < 8; ++i) {
    corners.push_back(shape.X_BS * Vector3((i & 1) != 0 ? half.x() : -half.x(), (i & 2) != 0 ? half.y() : -half.y(),
                                           (i & 4) != 0 ? half.z() : -half.z()));
  }
  return corners;
}

double Radius(const Shape& shape) { return shape.type == ShapeType::kSphere ? shape.size.x() : 0.0; }

std::vector<const Shape*> ShapesOf(const RobotModel& model, int body) {
  std::vector<const Shape*> shapes;
  for (const Shape& shape : model.collision_shapes) {
    if (shape.body == body) shapes.push_back(&shape);
  }
  return shapes;
}

double Extent(const Shape& shape) {
  double extent = 0.0;
  for (const Vector3& corner : Corners(shape)) extent = std::max(extent, corner.norm() + Radius(shape));
  return extent;
}

/// Axis-aligned rectangle around points in the plane, counter-clockwise, and its middle.
std::vector<Vector2> Rectangle(const std::vector<Vector2>& points, Vector2& middle) {
  Vector2 low = points.front(), high = points.front();
  for (const Vector2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  middle = 0.5 * (low + high);
  const Vector2 half = 0.5 * (high - low);
  return {{-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}};
}

bool HasRoll(const RobotModel& model, const Leg& leg, const std::vector<Pose>& X_OB) {
  // A sole can be levelled sideways when a joint beyond the knee turns about x.
  for (std::size_t i = leg.joints.size() < 2 ? 0 : leg.joints.size() - 2; i < leg.joints.size(); ++i) {
    const auto j = static_cast<std::size_t>(leg.joints[i]);
    if (std::abs((X_OB[j + 1].linear() * model.joints[j].axis_J).x()) > 0.7) return true;
  }
  return false;
}

/// The flat bottom of the last body at joint positions zero, as a sole.
bool FindSole(const RobotModel& model, const Leg& leg, const std::vector<Pose>& X_OB, Foot& foot) {
  const Pose& X_OE = X_OB[static_cast<std::size_t>(foot.body)];
  double bottom = 1e9;
  for (const Shape* shape : ShapesOf(model, foot.body)) {
    for (const Vector3& corner : Corners(*shape)) bottom = std::min(bottom, (X_OE * corner).z() - Radius(*shape));
  }
  std::vector<Vector2> touching;
  for (const Shape* shape : ShapesOf(model, foot.body)) {
    for (const Vector3& corner : Corners(*shape)) {
      const Vector3 p = X_OE * corner;
      if (p.z() - Radius(*shape) < bottom + 2e-3) touching.push_back(p.head<2>());
    }
  }
  if (touching.size() < 3) return false;
  Vector2 middle;
  foot.sole_F = Rectangle(touching, middle);
  foot.type = HasRoll(model, leg, X_OB) ? FootType::kSole : FootType::kLine;
  Pose X_OF = Pose::Identity();
  X_OF.translation() = Vector3(middle.x(), middle.y(), bottom);
  foot.X_BF = X_OE.inverse() * X_OF;
  return true;
}

void FindTip(const RobotModel& model, Foot& foot) {
  double farthest = -1.0;
  for (const Shape* shape : ShapesOf(model, foot.body)) {
    for (const Vector3& corner : Corners(*shape)) {
      // A sphere at the far end stands out a little beyond the shank that it ends.
      const double extent = corner.norm() + Radius(*shape);
      if (extent < farthest + (shape->type == ShapeType::kSphere ? -1e-3 : 1e-3)) continue;
      farthest = extent;
      foot.X_BF.translation() = corner;
      foot.radius = Radius(*shape);
      foot.link = shape->link;
    }
  }
  if (farthest < 0.0) {
    for (const Frame& frame : model.frames) {
      if (frame.body != foot.body || frame.X_BF.translation().norm() < farthest) continue;
      farthest = frame.X_BF.translation().norm();
      foot.X_BF.translation() = frame.X_BF.translation();
      foot.link = frame.name;
    }
  }
  foot.type = foot.radius > 0.0 ? FootType::kSphere : FootType::kPoint;
}

}  // namespace

double FarthestExtent(const RobotModel& model, int body) {
  double extent = 0.0;
  for (const Shape* shape : ShapesOf(model, body)) extent = std::max(extent, Extent(*shape));
  for (const Frame& frame : model.frames) {
    if (frame.body == body) extent = std::max(extent, frame.X_BF.translation().norm());
  }
  return extent;
}

Foot FindFoot(const RobotModel& model, const Leg& leg, const FootOverride* given) {
  Foot foot;
  foot.body = leg.joints.back() + 1;
  foot.link = model.bodies[static_cast<std::size_t>(foot.body)].name;
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  constexpr std::size_t kSoleJoints = 5;
  if (given != nullptr && !given->sole_m.empty()) {
    const Frame& frame = model.frames[static_cast<std::size_t>(model.FrameIndex(given->link))];
    foot.type = given->type.value_or(FootType::kSole);
    Vector2 middle = Vector2::Zero();
    for (const Vector2& corner : given->sole_m) middle += corner / static_cast<double>(given->sole_m.size());
    for (const Vector2& corner : given->sole_m) foot.sole_F.push_back(corner - middle);
    foot.X_BF = frame.X_BF * Eigen::Translation3d(middle.x(), middle.y(), 0.0);
  } else if (leg.joints.size() < kSoleJoints || !FindSole(model, leg, X_OB, foot)) {
    FindTip(model, foot);
  }
  if (given != nullptr) {
    foot.link = given->link;
    if (given->radius_m > 0.0) foot.radius = given->radius_m;
    if (given->type) foot.type = *given->type;
    if (foot.type == FootType::kPoint) foot.radius = 0.0;
  }
  foot.name = foot.link;
  return foot;
}

}  // namespace gaitwright
