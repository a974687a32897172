// SPDX-License-Identifier: BSD-3-Clause
#include "playback/engine/bumps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/value_noise.h"

namespace gaitwright {
namespace {

constexpr double kCell = 0.02;        // of ground with bumps [m]
constexpr double kMostCells = 2.5e7;  // of ground with bumps: 0.2 GB
constexpr double kNoGround = -2.0;    // height where the terrain has none [m]

/// Radius of a circle around the base that contains all feet, with a margin of 2 cm.
double StanceRadius(const RobotModel& model, const VectorX& q) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  double radius = 0.0;
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    for (const Vector3& p_W : ContactPoints(model, scratch, foot)) {
      radius = std::max(radius, (p_W.head<2>() - q.head<2>()).norm());
    }
  }
  return radius + 0.02;
}

}  // namespace

double Bumps::HeightAt(const Vector2& p_W) const {
  const double rise = std::clamp(((p_W - start).norm() - free_radius) / (0.5 * wavelength), 0.0, 1.0);
  return amplitude * ValueNoise(p_W - start, wavelength, seed) * SmoothStep(rise).value;
}

Bumps BumpsOf(const RobotModel& model, const VectorX& q, const WorldOptions& options) {
  const double free_m = options.bump_free_radius_m == 0.0 ? StanceRadius(model, q) : options.bump_free_radius_m;
  return {q.head<2>(), options.ground_bumps_m, options.bump_wavelength_m, free_m,
          static_cast<std::uint64_t>(options.seed)};
}

void CheckBumps(const WorldOptions& options) {
  const Vector2 extent = options.bumps_to_W - options.bumps_from_W;
  if (options.ground_bumps_m <= 0.0 || (extent.minCoeff() > 0.0 && (extent / kCell).prod() <= kMostCells)) return;
  throw InvalidArgument(
      fmt::format("ground_bumps_m: bumpy ground of {:.6g} m by {:.6g} m is too large; at most {:.6g} m^2 are accepted; "
                  "play a shorter walk, or without bumps",
                  extent.x(), extent.y(), kMostCells * kCell * kCell));
}

HeightField BumpyGround(const Terrain& terrain, const WorldOptions& options, const Bumps& bumps) {
  CheckBumps(options);
  const Vector2 extent = options.bumps_to_W - options.bumps_from_W;
  HeightField field;
  field.origin_W = options.bumps_from_W;
  field.resolution_m = kCell;
  field.columns = static_cast<int>(std::ceil(extent.x() / kCell)) + 1;
  field.rows = static_cast<int>(std::ceil(extent.y() / kCell)) + 1;
  field.height_m.reserve(static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows));
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const Vector2 p = field.origin_W + kCell * Vector2(column, row);
      const GroundPoint ground = GroundAt(terrain, p);
      field.height_m.push_back(ground.patch < 0 ? kNoGround : ground.height_m + bumps.HeightAt(p));
    }
  }
  return field;
}

}  // namespace gaitwright
