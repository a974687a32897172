// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/oversized_inertia.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "kinematics/model/shape_support.h"
#include "kinematics/model/solid_inertia.h"

namespace gaitwright {
namespace {

constexpr double kFarOut = 4.0;  // radius of gyration over the extent
constexpr double kPoint = 1e-3;  // [m] a link with a smaller extent is a point, and its size is unknown

}  // namespace

double LinkExtent(const std::vector<const Shape*>& shapes, std::vector<Vector3> points) {
  for (const Shape* shape : shapes) {
    if (shape->type == ShapeType::kMesh && shape->vertices.empty()) continue;
    for (int i = 0; i < 27; ++i) {  // along the axes and the diagonals
      const std::div_t by_nine = std::div(i, 9), by_three = std::div(by_nine.rem, 3);
      const Vector3 d_S(by_three.rem - 1, by_three.quot - 1, by_nine.quot - 1);
      if (!d_S.isZero()) points.push_back(shape->X_BS * SupportPoint(*shape, d_S.normalized()));
    }
  }
  double extent = 0.0;
  for (const Vector3& p : points) {
    for (const Vector3& q : points) extent = std::max(extent, (p - q).norm());
  }
  return extent;
}

std::optional<MendedInertia> MendOversizedInertia(const Matrix3& I, double mass, double extent_m,
                                                  const std::vector<const Shape*>& shapes) {
  if (!(mass > 0.0) || !(extent_m > kPoint)) return std::nullopt;
  const double gyration = std::sqrt(0.5 * I.trace() / mass);
  if (!(gyration >= kFarOut * extent_m)) return std::nullopt;
  const auto solid = SolidInertia(shapes, mass);
  if (!solid) return std::nullopt;
  return MendedInertia{
      *solid,
      fmt::format("equals that of {:.3g} kg at {:.3g} m from its centre, {:.3g} times its size of {:.3g} m", mass,
                  gyration, gyration / extent_m, extent_m),
      "the inertia of its shapes"};
}

}  // namespace gaitwright
