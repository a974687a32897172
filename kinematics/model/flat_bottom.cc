// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/flat_bottom.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {
namespace {

/// Largest number of corners of a mesh's flat bottom; for a disc they cover 95 % of the area.
constexpr int kMostCorners = 12;

/// The convex hull of points in the plane. A hull with too many corners is reduced to the points that are farthest in
/// evenly spread directions.
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

/// Axis-aligned rectangle around points in the plane, counter-clockwise, relative to its middle.
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

constexpr double kLeastSole = 1e-4;     // [m^2] a flat bottom smaller than this is a tip
constexpr double kThinnestSole = 1e-3;  // width over length: a level round limb touches the ground along a line

constexpr double kLeastGive = 2e-3;  // [m]

/// Compression of the rubber of a mesh's sole [m], proportional to the size of the foot. Parts of the mesh up to this
/// height above its lowest point also touch the ground, so that a rounded sole has its visible area.
double DerivedGiveOf(const std::vector<Vector3>& corners) {
  constexpr double kShare = 0.02, kMost = 0.006;
  Vector2 low = corners.front().head<2>(), high = low;
  for (const Vector3& p : corners) {
    low = low.cwiseMin(p.head<2>());
    high = high.cwiseMax(p.head<2>());
  }
  return std::clamp(kShare * (high - low).maxCoeff(), kLeastGive, kMost);
}

/// Compression of a shape of a sole [m]. @param given_m  the user's value, for shapes of any kind.
double GiveOf(const Shape& shape, const std::vector<Vector3>& corners, std::optional<double> given_m) {
  constexpr double kRoundingGive = 1e-6;  // [m] points at the same height differ by rounding
  if (given_m) return std::max(*given_m, kRoundingGive);
  return shape.type == ShapeType::kMesh ? DerivedGiveOf(corners) : kLeastGive;
}

/// Height in O of the lowest point of shapes.
double LowestOf(const Pose& X_OE, const std::vector<const Shape*>& shapes) {
  double bottom = std::numeric_limits<double>::infinity();
  for (const Shape* shape : shapes) {
    for (const Vector3& corner : SpanningCorners(*shape))
      bottom = std::min(bottom, (X_OE * corner).z() - RoundingRadius(*shape));
  }
  return bottom;
}

}  // namespace

std::vector<Vector3> SpanningCorners(const Shape& shape) {
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

double RoundingRadius(const Shape& shape) {
  return shape.type == ShapeType::kSphere || shape.type == ShapeType::kCapsule ? shape.size.x() : 0.0;
}

std::string NameOfShapes(const std::vector<const Shape*>& shapes) {
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

bool FindFlatBottom(const Pose& X_OE, const std::vector<const Shape*>& shapes, std::optional<double> given_give_m,
                    Foot& foot) {
  const double bottom = LowestOf(X_OE, shapes);
  std::vector<Vector2> touching;
  std::vector<const Shape*> at_bottom;
  for (const Shape* shape : shapes) {
    std::vector<Vector3> corners = SpanningCorners(*shape);
    for (Vector3& corner : corners) corner = X_OE * corner;
    const double give = GiveOf(*shape, corners, given_give_m);
    for (const Vector3& p : corners) {
      if (p.z() - RoundingRadius(*shape) >= bottom + give) continue;
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
  foot.derived_from = fmt::format("the flat bottom of {}", NameOfShapes(at_bottom));
  if (given_give_m)
    foot.derived_from += fmt::format(", within {:.4g} mm of its lowest point (robot.yaml)", 1e3 * *given_give_m);
  return true;
}

Eigen::Quaterniond BottomTilt(const Pose& X_OE, const std::vector<const Shape*>& shapes) {
  constexpr double kNear = 0.006, kFlat = 1e-3;  // [m]
  constexpr double kMost = 0.1;                  // [rad]
  const double bottom = LowestOf(X_OE, shapes);
  std::vector<Vector3> points;
  Vector3 middle = Vector3::Zero();
  for (const Shape* shape : shapes) {
    for (const Vector3& corner : SpanningCorners(*shape)) {
      const Vector3 p = X_OE * corner - RoundingRadius(*shape) * Vector3::UnitZ();
      if (p.z() > bottom + kNear) continue;
      points.push_back(p);
      middle += p;
    }
  }
  Eigen::Quaterniond none = Eigen::Quaterniond::Identity();
  if (points.size() < 3) return none;
  middle /= static_cast<double>(points.size());
  Matrix3 spread = Matrix3::Zero();
  for (const Vector3& p : points) spread += (p - middle) * (p - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3> axes(spread / static_cast<double>(points.size()));
  const Vector3 spreads = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  if (spreads[0] > kFlat || spreads[1] < 10.0 * kFlat) return none;
  Vector3 normal = axes.eigenvectors().col(0);
  if (normal.z() < 0.0) normal = -normal;
  if (std::acos(std::min(normal.z(), 1.0)) > kMost) return none;
  return Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), normal);
}

}  // namespace gaitwright
