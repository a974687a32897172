// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Random numbers of one sensor: a counter put through SplitMix64, so that streams of one seed do not touch each other
/// and the n-th number of a stream is always the same. The standard library's distributions differ between
/// implementations. Steele, Lea and Flood, OOPSLA 2014, doi:10.1145/2660193.2660195.
class NoiseStream {
 public:
  /// @param stream  number of the sensor; each has its own sequence.
  NoiseStream(int seed, int stream)
      : counter_(Mixed(Mixed(static_cast<std::uint64_t>(seed)) + static_cast<std::uint64_t>(stream))) {}

  /// Evenly in [0, 1).
  double Uniform() {
    counter_ += 0x9E3779B97F4A7C15ULL;
    return static_cast<double>(Mixed(counter_) >> 11) * 0x1p-53;
  }

  /// Mean 0, standard deviation 1. Box and Muller, Annals of Mathematical Statistics 29(2), 1958.
  double Normal() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
    const double angle = 2.0 * std::numbers::pi * Uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
  }

  /// Three of them, each for itself.
  Vector3 Normal3() {
    const double x = Normal(), y = Normal(), z = Normal();
    return {x, y, z};
  }

  /// Evenly over the unit sphere.
  Vector3 Direction() {
    const Vector3 v = Normal3();
    return v.norm() > 0.0 ? Vector3(v.normalized()) : Vector3(Vector3::UnitX());
  }

 private:
  static std::uint64_t Mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31);
  }

  std::uint64_t counter_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace gaitwright
