// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "kinematics/base/random.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Random numbers of one sensor. Streams of one seed are independent, and the n-th number of a stream is always the
/// same.
class NoiseStream {
 public:
  /// @param stream  number of the sensor; each has its own sequence.
  NoiseStream(int seed, int stream)
      : numbers_(MixBits(MixBits(static_cast<std::uint64_t>(seed)) + static_cast<std::uint64_t>(stream))) {}

  /// Uniform in [0, 1).
  double Uniform() { return numbers_.Uniform(); }

  /// Mean 0, standard deviation 1. Box and Muller, Annals of Mathematical Statistics 29(2), 1958.
  double Normal() {
    if (has_second_) {
      has_second_ = false;
      return second_;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
    const double angle = 2.0 * std::numbers::pi * Uniform();
    second_ = radius * std::sin(angle);
    has_second_ = true;
    return radius * std::cos(angle);
  }

  /// Three independent normal numbers.
  Vector3 Normal3() {
    const double x = Normal(), y = Normal(), z = Normal();
    return {x, y, z};
  }

  /// Uniform on the unit sphere.
  Vector3 Direction() {
    const Vector3 v = Normal3();
    return v.norm() > 0.0 ? Vector3(v.normalized()) : Vector3(Vector3::UnitX());
  }

 private:
  SplitMix numbers_;
  double second_ = 0.0;
  bool has_second_ = false;
};

}  // namespace gaitwright
