// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/solid_inertia.h"

#include <cmath>
#include <numbers>

#include "kinematics/spatial/steiner.h"

namespace gaitwright {
namespace {

/// A solid of density 1.
struct Solid {
  double mass = 0.0;
  Vector3 centre = Vector3::Zero();   ///< in S
  Vector3 moments = Vector3::Zero();  ///< principal moments about the centre, along the axes of S
};

Solid Box(const Vector3& size, const Vector3& centre) {
  const Vector3 square = size.cwiseAbs2();
  const double mass = size.prod();
  return {mass, centre, mass / 12.0 * (Vector3::Constant(square.sum()) - square)};
}

Solid Cylinder(double radius, double length) {
  const double mass = std::numbers::pi * radius * radius * length;
  const double across = mass * (radius * radius / 4.0 + length * length / 12.0);
  return {mass, Vector3::Zero(), {across, across, mass * radius * radius / 2.0}};
}

Solid Sphere(double radius) {
  const double mass = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3);
  return {mass, Vector3::Zero(), Vector3::Constant(0.4 * mass * radius * radius)};
}

/// A cylinder with a hemisphere at each end; the centre of mass of a hemisphere is 3/8 r from its flat face.
Solid Capsule(double radius, double length) {
  Solid solid = Cylinder(radius, length);
  const Solid ends = Sphere(radius);
  const double across = ends.moments.x() + ends.mass * (length * length / 4.0 + 3.0 / 8.0 * length * radius);
  solid.mass += ends.mass;
  solid.moments += Vector3(across, across, ends.moments.z());
  return solid;
}

Solid SolidOf(const Shape& shape) {
  switch (shape.type) {
    case ShapeType::kBox:
      return Box(shape.size, Vector3::Zero());
    case ShapeType::kCylinder:
      return Cylinder(shape.size.x(), shape.size.y());
    case ShapeType::kSphere:
      return Sphere(shape.size.x());
    case ShapeType::kCapsule:
      return Capsule(shape.size.x(), shape.size.y());
    case ShapeType::kMesh:
      break;
  }
  if (shape.vertices.empty()) return {};
  Vector3 low = shape.vertices.front(), high = low;
  for (const Vector3& v : shape.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return Box(high - low, 0.5 * (low + high));
}

}  // namespace

std::optional<Matrix3> SolidInertia(const std::vector<const Shape*>& shapes, double mass) {
  double volume = 0.0;
  Vector3 centre = Vector3::Zero();
  for (const Shape* shape : shapes) {
    const Solid solid = SolidOf(*shape);
    volume += solid.mass;
    centre += solid.mass * (shape->X_BS * solid.centre);
  }
  constexpr double kLeastVolume = 1e-30;  // [m^3]; below it the density would overflow
  if (!(volume >= kLeastVolume)) return std::nullopt;
  centre /= volume;
  Matrix3 inertia = Matrix3::Zero();
  for (const Shape* shape : shapes) {
    const Solid solid = SolidOf(*shape);
    const Matrix3 R = shape->X_BS.linear();
    inertia +=
        R * solid.moments.asDiagonal() * R.transpose() + Steiner(solid.mass, shape->X_BS * solid.centre - centre);
  }
  return Matrix3(mass / volume * inertia);
}

}  // namespace gaitwright
