// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/find_feet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/flat_bottom.h"
#include "kinematics/model/shape_support.h"
#include "kinematics/model/yaml_line.h"
#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {
namespace {

constexpr std::size_t kSoleJoints = 5;  // legs with fewer joints have no sole, except in a biped with one ankle joint

std::vector<const Shape*> ShapesOf(const RobotModel& model, int body) {
  std::vector<const Shape*> shapes;
  for (const Shape& shape : model.collision_shapes) {
    if (shape.body == body) shapes.push_back(&shape);
  }
  return shapes;
}

/// Largest coordinate of a shape along a direction, from the origin of its body's frame.
double SupportAlong(const Shape& shape, const Vector3& d) {
  return d.dot(shape.X_BS * SupportPoint(shape, shape.X_BS.linear().transpose() * d));
}

double Extent(const Shape& shape) {
  double extent = 0.0;
  for (const Vector3& corner : SpanningCorners(shape)) extent = std::max(extent, corner.norm() + RoundingRadius(shape));
  return extent;
}

bool HasRoll(const RobotModel& model, const Leg& leg, const std::vector<Pose>& X_OB) {
  // A sole can be levelled sideways if a joint at the ankle rotates about x.
  constexpr double kAnkle = 0.2;  // share of the distance from the last joint to the first
  const auto at = [&](int j) { return X_OB[static_cast<std::size_t>(j) + 1].translation(); };
  const double length = (at(leg.joints.back()) - at(leg.joints.front())).norm();
  return std::any_of(leg.joints.begin(), leg.joints.end(), [&](int j) {
    const Vector3 axis =
        X_OB[static_cast<std::size_t>(j) + 1].linear() * model.joints[static_cast<std::size_t>(j)].axis_J;
    return (at(leg.joints.back()) - at(j)).norm() <= kAnkle * length && std::abs(axis.x()) > 0.7;
  });
}

/// Pose of a foot's body in a posture, rotated about the vertical to its heading at joint positions zero, and then by
/// the small angle that makes its bottom level.
Pose LevelledPose(const RobotModel& model, int body, const VectorX& given, const std::vector<const Shape*>& shapes) {
  const auto b = static_cast<std::size_t>(body);
  const VectorX posture = given.unaryExpr([](double q) { return std::isfinite(q) ? q : 0.0; });
  Pose X_OE = BodyPoses(model, posture)[b];
  const Vector3 forward =
      X_OE.linear() * BodyPoses(model, VectorX::Zero(model.num_dofs()))[b].linear().transpose().col(0);
  X_OE = Eigen::AngleAxisd(-std::atan2(forward.y(), forward.x()), Vector3::UnitZ()) * X_OE;
  return BottomTilt(X_OE, shapes).inverse() * X_OE;
}

/// The largest flat bottom of tilted boxes and meshes, for an unknown posture. The foot is rotated into many
/// orientations, evenly spread within 1 rad, and the flat bottom is found in each.
bool FindAslantBottom(const Pose& X_OE, const std::vector<const Shape*>& shapes, Foot& foot) {
  constexpr double kFarthest = 1.0;  // [rad]
  constexpr int kDirections = 2500;  // 0.03 rad apart; BottomTilt corrects the rest
  constexpr double kFlat = 1e-3;     // [m]
  const auto has_faces = [](const Shape* s) { return s->type == ShapeType::kBox || s->type == ShapeType::kMesh; };
  if (!std::all_of(shapes.begin(), shapes.end(), has_faces)) return false;
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  double largest = 0.0;
  Pose X_OL = X_OE;
  for (int i = 0; i < kDirections; ++i) {
    const double tilt = std::acos(1.0 - (1.0 - std::cos(kFarthest)) * (i + 0.5) / kDirections);
    const Vector3 axis(std::cos(i * golden_angle), std::sin(i * golden_angle), 0.0);
    const Pose X_OT = Eigen::AngleAxisd(tilt, axis) * X_OE;
    const Matrix3 R_OT = (BottomTilt(X_OT, shapes).inverse() * X_OT).linear();
    // The smallest rotation that levels the same face, so that the foot keeps its heading.
    const Vector3 up_O = X_OE.linear() * R_OT.transpose() * Vector3::UnitZ();
    const Pose levelled = Eigen::Quaterniond::FromTwoVectors(up_O, Vector3::UnitZ()) * X_OE;
    Foot there = foot;
    if (!FindFlatBottom(levelled, shapes, kFlat, there) || Area(there.sole_F) <= largest) continue;
    largest = Area(there.sole_F);
    X_OL = levelled;
  }
  return largest > 0.0 && FindFlatBottom(X_OL, shapes, std::nullopt, foot);
}

/// The flat bottom of the last body's shapes at joint positions zero, as a sole. If the flat bottom in a given posture
/// is much larger, the sole is tilted at zero and the bottom in that posture is used. If there is neither, the largest
/// bottom over many orientations of the foot (FindAslantBottom).
bool FindSole(const RobotModel& model, const Leg& leg, const std::vector<const Shape*>& shapes, const VectorX& given,
              std::optional<double> give_m, Foot& foot) {
  constexpr double kLarger = 1.5;
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  const Pose& X_OE = X_OB[static_cast<std::size_t>(foot.body)];
  Foot found = foot;
  const bool at_zero = FindFlatBottom(X_OE, shapes, give_m, found);
  const bool is_given = std::all_of(leg.joints.begin(), leg.joints.end(), [&](int j) {
    return std::isfinite(given[model.joints[static_cast<std::size_t>(j)].dof]);
  });
  Foot there = foot;
  if (is_given && FindFlatBottom(LevelledPose(model, foot.body, given, shapes), shapes, give_m, there) &&
      (!at_zero || Area(there.sole_F) > kLarger * Area(found.sole_F))) {
    found = there;
  } else if (!at_zero && (is_given || give_m || !FindAslantBottom(X_OE, shapes, found))) {
    return false;
  }
  foot = found;
  foot.type = HasRoll(model, leg, X_OB) ? FootType::kSole : FootType::kLine;
  foot.derived_from = fmt::format("a {} from {}", foot.type == FootType::kSole ? "sole" : "line", foot.derived_from);
  return true;
}

/// The point of the shapes that is farthest from the last joint. If several points of a shape are equally far, their
/// mean, so that a box that hangs straight down ends at the middle of its bottom. Without shapes: the farthest frame.
void FindTip(const RobotModel& model, const std::vector<const Shape*>& shapes, Foot& foot) {
  constexpr double kPointRadius = 1e-3;  // [m] a smaller sphere is a point
  constexpr double kSame = 1e-3;         // [m]
  double farthest = -1.0;
  const Shape* tip = nullptr;
  for (const Shape* shape : shapes) {
    // A sphere at the end of a shank reaches only slightly farther than the shank.
    const double extent = Extent(*shape);
    if (extent < farthest + (shape->type == ShapeType::kSphere ? -kSame : kSame)) continue;
    farthest = extent;
    tip = shape;
  }
  if (tip != nullptr) {
    Vector3 sum = Vector3::Zero();
    double count = 0.0;
    for (const Vector3& corner : SpanningCorners(*tip)) {
      if (corner.norm() + RoundingRadius(*tip) < farthest - kSame) continue;
      sum += corner;
      count += 1.0;
    }
    foot.X_BF.translation() = sum / count;
    foot.radius = RoundingRadius(*tip) < kPointRadius ? 0.0 : RoundingRadius(*tip);
    foot.link = tip->link;
    foot.derived_from = fmt::format("a {} from {}, the farthest from its last joint",
                                    foot.radius > 0.0 ? "rolling foot" : "point", NameOfShapes({tip}));
  }
  for (const Frame& frame : model.frames) {
    if (tip != nullptr || frame.body != foot.body || frame.X_BF.translation().norm() < farthest) continue;
    farthest = frame.X_BF.translation().norm();
    foot.X_BF.translation() = frame.X_BF.translation();
    foot.link = frame.name;
    foot.derived_from = fmt::format("a point at the frame of link '{}', which has no shape", frame.name);
  }
  foot.type = foot.radius > 0.0 ? FootType::kSphere : FootType::kPoint;
}

/// Finds a wheel: shapes of a body with the same radius all around its joint. The wheel is locked and stands like a
/// sphere of its radius. @return whether there is a wheel.
bool FindWheel(const RobotModel& model, const std::vector<const Shape*>& shapes, Foot& foot) {
  constexpr double kRound = 0.05;  // share of the radius that a wheel may be out of round
  constexpr int kDirections = 24;
  const Joint& axle = model.joints[static_cast<std::size_t>(foot.body - 1)];
  if (shapes.empty() || axle.is_prismatic() || axle.upper - axle.lower < 2.0 * std::numbers::pi) return false;
  const Vector3 across = axle.axis_J.unitOrthogonal(), up = axle.axis_J.cross(across);
  double widest = 0.0, least = std::numeric_limits<double>::infinity();
  double near = std::numeric_limits<double>::infinity(), far = -near;
  for (int i = 0; i < kDirections; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kDirections;
    const Vector3 d = std::cos(turn) * across + std::sin(turn) * up;
    double reach = 0.0;
    for (const Shape* shape : shapes) {
      reach = std::max(reach, SupportAlong(*shape, d));
      near = std::min(near, -SupportAlong(*shape, -axle.axis_J));
      far = std::max(far, SupportAlong(*shape, axle.axis_J));
    }
    widest = std::max(widest, reach);
    least = std::min(least, reach);
  }
  if (least < (1.0 - kRound) * widest || far - near > 2.0 * widest) return false;
  foot.X_BF.translation() = 0.5 * (near + far) * axle.axis_J;
  foot.radius = widest;
  foot.link = shapes.front()->link;
  foot.type = FootType::kSphere;
  foot.derived_from = fmt::format("a locked wheel around its axle '{}', from {}", axle.name, NameOfShapes(shapes));
  return true;
}

/// Refuses a sole give that has no effect or removes the sole: for a foot with its own value and no sole, and for a
/// foot that would have a sole without this key.
void CheckGiveIsIdle(const RobotModel& model, const Leg& leg, const std::vector<const Shape*>& shapes,
                     const LegChoices& choices, const FootOverride* given, const VectorX& standing) {
  Foot foot;
  foot.body = leg.joints.back() + 1;
  const std::string name = given != nullptr ? given->link : model.bodies[static_cast<std::size_t>(foot.body)].name;
  const bool own = given != nullptr && given->sole_give_m.has_value();
  const int line = own ? given->line : choices.sole_give_line;
  if (leg.joints.size() >= kSoleJoints && FindSole(model, leg, shapes, standing, std::nullopt, foot)) {
    RefuseYamlLine(line, fmt::format("foot '{}' has no sole with 'sole_give_m' {}: its shapes have no area within this "
                                     "height [m] of their lowest point; leave the key out to find a sole",
                                     name, own ? *given->sole_give_m : *choices.sole_give_m));
  }
  if (own)
    RefuseYamlLine(line, fmt::format("foot '{}' has 'sole_give_m', but no sole is found in its shapes; leave the key "
                                     "out, or give the sole's corners: 'sole_m'",
                                     name));
}

/// Sets the sole given by the user.
void TakeSole(const RobotModel& model, const FootOverride& given, Foot& foot) {
  const Frame& frame = model.frames[static_cast<std::size_t>(model.FrameIndex(given.link))];
  foot.type = given.type.value_or(FootType::kSole);
  Vector2 middle = Vector2::Zero();
  for (const Vector2& corner : given.sole_m) middle += corner / static_cast<double>(given.sole_m.size());
  for (const Vector2& corner : given.sole_m) foot.sole_F.push_back(corner - middle);
  foot.X_BF = frame.X_BF * Eigen::Translation3d(middle.x(), middle.y(), 0.0);
  foot.derived_from = fmt::format("its {} corners from robot.yaml", given.sole_m.size());
}

/// Replaces type and radius of a foot by those given by the user. @throws InvalidArgument for a sphere without a
/// radius.
void TakeType(const FootOverride& given, Foot& foot) {
  foot.link = given.link;
  if (given.radius_m > 0.0) {
    foot.radius = given.radius_m;
    foot.type = FootType::kSphere;
    foot.derived_from += "; its radius from robot.yaml";
  }
  if (!given.type || !given.sole_m.empty()) return;
  foot.type = *given.type;
  foot.sole_F.clear();
  foot.derived_from += "; its type from robot.yaml";
  if (foot.type == FootType::kPoint) foot.radius = 0.0;
  if (foot.type == FootType::kSphere && foot.radius <= 0.0) {
    RefuseYamlLine(
        given.line,
        fmt::format("foot '{}' of type sphere needs 'radius_m': the URDF has no sphere at its end", given.link));
  }
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

Foot FindFoot(const RobotModel& model, const Leg& leg, const LegChoices& choices, const FootOverride* given,
              const VectorX& standing, bool biped) {
  Foot foot;
  foot.body = leg.joints.back() + 1;
  foot.link = model.bodies[static_cast<std::size_t>(foot.body)].name;
  std::vector<const Shape*> shapes = ShapesOf(model, foot.body);
  if (given != nullptr) {  // prefer the shapes of the named link
    std::vector<const Shape*> own;
    std::copy_if(shapes.begin(), shapes.end(), std::back_inserter(own),
                 [&](const Shape* shape) { return shape->link == given->link; });
    if (!own.empty()) shapes = own;
  }
  const bool tip = given != nullptr && (given->type || given->radius_m > 0.0);
  const std::optional<double> give_m =
      given != nullptr && given->sole_give_m ? given->sole_give_m : choices.sole_give_m;
  if (given != nullptr && !given->sole_m.empty()) {
    TakeSole(model, *given, foot);
  } else if (tip || (!FindWheel(model, shapes, foot) && (leg.joints.size() < kSoleJoints - (biped ? 1 : 0) ||
                                                         !FindSole(model, leg, shapes, standing, give_m, foot)))) {
    FindTip(model, shapes, foot);
    if (give_m && !tip) CheckGiveIsIdle(model, leg, shapes, choices, given, standing);
  }
  if (given != nullptr) TakeType(*given, foot);
  foot.name = foot.link;
  return foot;
}

std::optional<Foot> FindRest(const RobotModel& model, const std::string& link, std::optional<double> give_m) {
  const Frame& frame = model.frames[static_cast<std::size_t>(model.FrameIndex(link))];
  std::vector<const Shape*> shapes;
  for (const Shape* shape : ShapesOf(model, frame.body)) {
    if (shape->link == link) shapes.push_back(shape);
  }
  Foot rest;
  rest.name = rest.link = link;
  rest.body = frame.body;
  rest.type = FootType::kSole;
  if (!FindFlatBottom(BodyPoses(model, model.standing_joints)[static_cast<std::size_t>(rest.body)], shapes, give_m,
                      rest))
    return std::nullopt;
  rest.derived_from = "a surface to lie on from " + rest.derived_from;
  return rest;
}

}  // namespace gaitwright
