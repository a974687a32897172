// SPDX-License-Identifier: BSD-3-Clause
#include "playback/bullet/bumps.h"

#include <algorithm>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/value_noise.h"

namespace gaitwright {
namespace {

/// A circle about the base that takes in all feet, with 2 cm to spare.
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

}  // namespace gaitwright
