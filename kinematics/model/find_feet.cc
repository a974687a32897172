// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/find_feet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/shape_support.h"
#include "kinematics/model/yaml_line.h"
#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {
namespace {

/// Points that, blown up by Radius, span a shape (a sphere: its centre; a capsule: those of its ends), in the body's
/// frame.
std::vector<Vector3> Corners(const Shape& shape) {
  std::vector<Vector3> corners;
  if (shape.type == ShapeType::kMesh) {
    for (const Vector3& v : shape.vertices) corners.push_back(shape.X_BS * v);
    return corners;
  }
  if (shape.type == ShapeType::kSphere) return {shape.X_BS.translation()};
  if (shape.type == ShapeType::kCapsule) {
    const Vector3 end(0.0, 0.0, 0.5 * shape.size.y());
    return {shape.X_BS * Vector3(-end), shape.X_BS * end};
  }
  Vector3 half = 0.5 * shape.size;
  if (shape.type != ShapeType::kBox) half = Vector3(shape.size.x(), shape.size.x(), 0.5 * shape.size.y());
  for (int i = 0; i < 8; ++i) {
    corners.push_back(shape.X_BS * Vector3((i & 1) != 0 ? half.x() : -half.x(), (i & 2) != 0 ? half.y() : -half.y(),
                                           (i & 4) != 0 ? half.z() : -half.z()));
  }
  return corners;
}

/// Of a shape with round ends.
double Radius(const Shape& shape) {
  return shape.type == ShapeType::kSphere || shape.type == ShapeType::kCapsule ? shape.size.x() : 0.0;
}

std::vector<const Shape*> ShapesOf(const RobotModel& model, int body) {
  std::vector<const Shape*> shapes;
  for (const Shape& shape : model.collision_shapes) {
    if (shape.body == body) shapes.push_back(&shape);
  }
  return shapes;
}

/// How far a shape reaches along a direction of its body's frame from its origin.
double SupportAlong(const Shape& shape, const Vector3& d) {
  return d.dot(shape.X_BS * SupportPoint(shape, shape.X_BS.linear().transpose() * d));
}

double Extent(const Shape& shape) {
  double extent = 0.0;
  for (const Vector3& corner : Corners(shape)) extent = std::max(extent, corner.norm() + Radius(shape));
  return extent;
}

/// At most this many corners of a mesh's flat bottom are kept, which of a disc is 95 % of the area.
constexpr int kMostCorners = 12;

/// The convex hull of points in the plane, or the polygon of its points that are farthest in evenly spread directions.
Polygon Outline(const std::vector<Vector2>& points) {
  Polygon hull = ConvexHull(points);
  if (hull.size() <= kMostCorners) return hull;
  std::vector<Vector2> farthest;
  for (int i = 0; i < kMostCorners; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kMostCorners;
    const Vector2 d(std::cos(turn), std::sin(turn));
    farthest.push_back(
        *std::max_element(hull.begin(), hull.end(), [&](const auto& a, const auto& b) { return a.dot(d) < b.dot(d); }));
  }
  return ConvexHull(farthest);
}

/// Axis-aligned rectangle around points in the plane, counter-clockwise, and its middle.
Polygon Rectangle(const std::vector<Vector2>& points, Vector2& middle) {
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
  // A sole can be levelled sideways when a joint at the ankle turns about x.
  constexpr double kAnkle = 0.2;  // of the way from the last joint to the first
  const auto at = [&](int j) { return X_OB[static_cast<std::size_t>(j) + 1].translation(); };
  const double length = (at(leg.joints.back()) - at(leg.joints.front())).norm();
  return std::any_of(leg.joints.begin(), leg.joints.end(), [&](int j) {
    const Vector3 axis =
        X_OB[static_cast<std::size_t>(j) + 1].linear() * model.joints[static_cast<std::size_t>(j)].axis_J;
    return (at(leg.joints.back()) - at(j)).norm() <= kAnkle * length && std::abs(axis.x()) > 0.7;
  });
}

constexpr double kLeastSole = 1e-4;     // [m^2] a flat bottom smaller than this is a tip
constexpr double kThinnestSole = 1e-3;  // of its length: a round limb that lies level touches the ground in a line

/// "the mesh 'foot.stl' of link 'l_foot'", "4 spheres of link 'l_foot'": for people.
std::string NameOf(const std::vector<const Shape*>& shapes) {
  const char* const kinds[] = {"box", "cylinder", "sphere", "capsule", "mesh"};
  const Shape& first = *shapes.front();
  const std::string kind = kinds[static_cast<int>(first.type)];
  if (shapes.size() > 1) {
    const bool alike = std::all_of(shapes.begin(), shapes.end(), [&](const Shape* s) { return s->type == first.type; });
    return fmt::format("{} {} of link '{}'", shapes.size(), alike ? kind + (kind == "box" ? "es" : "s") : "shapes",
                       first.link);
  }
  return fmt::format("the {}{} of link '{}'", kind, first.mesh_file.empty() ? "" : " '" + first.mesh_file + "'",
                     first.link);
}

constexpr double kLeastGive = 2e-3;  // [m]

/// By how much rubber gives [m]: what of a mesh is no higher than that over its lowest point touches the ground too, so
/// that the hull of a rounded sole has the area that people see. It goes with the size of the foot.
double GiveOf(const std::vector<Vector3>& corners) {
  constexpr double kShare = 0.02, kMost = 0.006;
  Vector2 low = corners.front().head<2>(), high = low;
  for (const Vector3& p : corners) {
    low = low.cwiseMin(p.head<2>());
    high = high.cwiseMax(p.head<2>());
  }
  return std::clamp(kShare * (high - low).maxCoeff(), kLeastGive, kMost);
}

/// The flat bottom of shapes of a foot's body in a posture: its corners, frame and what it is derived from.
bool FindFlatBottom(const std::vector<Pose>& X_OB, const std::vector<const Shape*>& shapes, Foot& foot) {
  const Pose& X_OE = X_OB[static_cast<std::size_t>(foot.body)];
  double bottom = std::numeric_limits<double>::infinity();
  for (const Shape* shape : shapes) {
    for (const Vector3& corner : Corners(*shape)) bottom = std::min(bottom, (X_OE * corner).z() - Radius(*shape));
  }
  std::vector<Vector2> touching;
  std::vector<const Shape*> at_bottom;
  for (const Shape* shape : shapes) {
    std::vector<Vector3> corners = Corners(*shape);
    for (Vector3& corner : corners) corner = X_OE * corner;
    const double give = shape->type == ShapeType::kMesh ? GiveOf(corners) : kLeastGive;
    for (const Vector3& p : corners) {
      if (p.z() - Radius(*shape) >= bottom + give) continue;
      touching.push_back(p.head<2>());
      if (at_bottom.empty() || at_bottom.back() != shape) at_bottom.push_back(shape);
    }
  }
  if (touching.size() < 3) return false;
  Vector2 middle;
  foot.sole_F = Rectangle(touching, middle);
  const Vector2 size = foot.sole_F[2] - foot.sole_F[0];
  if (size.minCoeff() < kThinnestSole * size.maxCoeff()) {
    foot.sole_F.clear();
    return false;
  }
  if (std::any_of(at_bottom.begin(), at_bottom.end(), [](const auto* s) { return s->type == ShapeType::kMesh; })) {
    for (Vector2& p : touching) p -= middle;
    const Polygon outline = Outline(touching);
    foot.sole_F = Area(outline) < kLeastSole ? Polygon{} : outline;
    if (foot.sole_F.empty()) return false;
  }
  Pose X_OF = Pose::Identity();
  X_OF.translation() = Vector3(middle.x(), middle.y(), bottom);
  foot.X_BF = X_OE.inverse() * X_OF;
  foot.derived_from = fmt::format("the flat bottom of {}", NameOf(at_bottom));
  return true;
}

/// The flat bottom of shapes of the last body at joint positions zero, as a sole.
bool FindSole(const RobotModel& model, const Leg& leg, const std::vector<const Shape*>& shapes, Foot& foot) {
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  if (!FindFlatBottom(X_OB, shapes, foot)) return false;
  foot.type = HasRoll(model, leg, X_OB) ? FootType::kSole : FootType::kLine;
  foot.derived_from = fmt::format("a {} from {}", foot.type == FootType::kSole ? "sole" : "line", foot.derived_from);
  return true;
}

/// The farthest point of the shapes from the last joint: the middle of those points of one shape that are as far, so
/// that a box that hangs straight down ends in the middle of its bottom. Without shapes: the frame that is farthest.
void FindTip(const RobotModel& model, const std::vector<const Shape*>& shapes, Foot& foot) {
  constexpr double kPointRadius = 1e-3;  // [m] a smaller ball is a point
  constexpr double kSame = 1e-3;         // [m]
  double farthest = -1.0;
  const Shape* tip = nullptr;
  for (const Shape* shape : shapes) {
    // A sphere at the far end stands out a little beyond the shank that it ends.
    const double extent = Extent(*shape);
    if (extent < farthest + (shape->type == ShapeType::kSphere ? -kSame : kSame)) continue;
    farthest = extent;
    tip = shape;
  }
  if (tip != nullptr) {
    Vector3 sum = Vector3::Zero();
    double count = 0.0;
    for (const Vector3& corner : Corners(*tip)) {
      if (corner.norm() + Radius(*tip) < farthest - kSame) continue;
      sum += corner;
      count += 1.0;
    }
    foot.X_BF.translation() = sum / count;
    foot.radius = Radius(*tip) < kPointRadius ? 0.0 : Radius(*tip);
    foot.link = tip->link;
    foot.derived_from = fmt::format("a {} from {}, the farthest from its last joint",
                                    foot.radius > 0.0 ? "rolling foot" : "point", NameOf({tip}));
  }
  for (const Frame& frame : model.frames) {
    if (tip != nullptr || frame.body != foot.body || frame.X_BF.translation().norm() < farthest) continue;
    farthest = frame.X_BF.translation().norm();
    foot.X_BF.translation() = frame.X_BF.translation();
    foot.link = frame.name;
    foot.derived_from = fmt::format("a point at the frame of link '{}', since no shape is there", frame.name);
  }
  foot.type = foot.radius > 0.0 ? FootType::kSphere : FootType::kPoint;
}

/// The wheel that shapes of a body make about its joint: all round to one radius. It is held still and stands as a ball
/// of its radius does, about its axle. @return whether there is one.
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
  foot.derived_from =
      fmt::format("a wheel that is held still, round its axle '{}', from {}", axle.name, NameOf(shapes));
  return true;
}

/// A foot whose sole the user gives.
void TakeSole(const RobotModel& model, const FootOverride& given, Foot& foot) {
  const Frame& frame = model.frames[static_cast<std::size_t>(model.FrameIndex(given.link))];
  foot.type = given.type.value_or(FootType::kSole);
  Vector2 middle = Vector2::Zero();
  for (const Vector2& corner : given.sole_m) middle += corner / static_cast<double>(given.sole_m.size());
  for (const Vector2& corner : given.sole_m) foot.sole_F.push_back(corner - middle);
  foot.X_BF = frame.X_BF * Eigen::Translation3d(middle.x(), middle.y(), 0.0);
  foot.derived_from = fmt::format("its {} corners from robot.yaml", given.sole_m.size());
}

/// Puts the type and radius that the user gives in place of those that were found. @throws InvalidArgument for a sphere
/// without a radius.
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
    RefuseYamlLine(given.line,
                   fmt::format("foot '{}' of type sphere needs 'radius_m': no sphere ends it in the URDF", given.link));
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

Foot FindFoot(const RobotModel& model, const Leg& leg, const FootOverride* given) {
  Foot foot;
  foot.body = leg.joints.back() + 1;
  foot.link = model.bodies[static_cast<std::size_t>(foot.body)].name;
  std::vector<const Shape*> shapes = ShapesOf(model, foot.body);
  if (given != nullptr) {  // the link's own shapes, where it has some
    std::vector<const Shape*> own;
    std::copy_if(shapes.begin(), shapes.end(), std::back_inserter(own),
                 [&](const Shape* shape) { return shape->link == given->link; });
    if (!own.empty()) shapes = own;
  }
  constexpr std::size_t kSoleJoints = 5;
  const bool tip = given != nullptr && (given->type || given->radius_m > 0.0);
  if (given != nullptr && !given->sole_m.empty()) {
    TakeSole(model, *given, foot);
  } else if (tip || (!FindWheel(model, shapes, foot) &&
                     (leg.joints.size() < kSoleJoints || !FindSole(model, leg, shapes, foot)))) {
    FindTip(model, shapes, foot);
  }
  if (given != nullptr) TakeType(*given, foot);
  foot.name = foot.link;
  return foot;
}

std::optional<Foot> FindRest(const RobotModel& model, const std::string& link) {
  const Frame& frame = model.frames[static_cast<std::size_t>(model.FrameIndex(link))];
  std::vector<const Shape*> shapes;
  for (const Shape* shape : ShapesOf(model, frame.body)) {
    if (shape->link == link) shapes.push_back(shape);
  }
  Foot rest;
  rest.name = rest.link = link;
  rest.body = frame.body;
  rest.type = FootType::kSole;
  if (!FindFlatBottom(BodyPoses(model, model.standing_joints), shapes, rest)) return std::nullopt;
  rest.derived_from = "a rest from " + rest.derived_from;
  return rest;
}

}  // namespace gaitwright
