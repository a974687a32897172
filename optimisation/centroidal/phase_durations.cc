// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/phase_durations.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

VectorX Clamped(const VectorX& wanted, double shift, const DurationBounds& bounds) {
  return (wanted.array() + shift).matrix().cwiseMax(bounds.lower).cwiseMin(bounds.upper);
}

}  // namespace

VectorX NearestDurations(const VectorX& wanted, const DurationBounds& bounds) {
  VectorX nearest = Clamped(wanted, 0.0, bounds);
  constexpr double kDigits = 1e-13;
  const double total = std::clamp(nearest.sum(), bounds.least_total_s, bounds.most_total_s);
  if (std::abs(total - nearest.sum()) <= kDigits * total) return nearest;
  // All durations get the same shift; their sum is a rising function of it.
  double low = (bounds.lower - wanted).minCoeff(), high = (bounds.upper - wanted).maxCoeff();
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (Clamped(wanted, middle, bounds).sum() < total ? low : high) = middle;
  }
  nearest = Clamped(wanted, 0.5 * (low + high), bounds);
  return nearest;
}

VectorX BestDurations(const VectorX& at, const VectorX& slope, const MatrixX& curvature, const VectorX& most,
                      const DurationBounds& bounds) {
  constexpr int kSteps = 300;
  DurationBounds near = bounds;
  near.lower = bounds.lower.cwiseMax(at - most);
  near.upper = bounds.upper.cwiseMin(at + most);
  const double steep = slope.norm() / (100.0 * most.maxCoeff());
  const double step = 1.0 / std::max({curvature.norm(), steep, 1e-12});
  const auto model = [&](const VectorX& d) { return slope.dot(d - at) + 0.5 * (d - at).dot(curvature * (d - at)); };
  VectorX best = at, extrapolated = at;
  double least = 0.0, momentum = 1.0;
  for (int i = 0; i < kSteps; ++i) {
    const VectorX next = NearestDurations(extrapolated - step * (slope + curvature * (extrapolated - at)), near);
    const double value = model(next);
    if (value > least) {
      if (momentum == 1.0) break;
      extrapolated = best;
      momentum = 1.0;
      continue;
    }
    const double after = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * momentum * momentum));
    extrapolated = next + (momentum - 1.0) / after * (next - best);
    momentum = after;
    best = next;
    least = value;
  }
  return best;
}

}  // namespace gaitwright
