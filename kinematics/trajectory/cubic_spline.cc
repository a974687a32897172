// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/trajectory/cubic_spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/base/result.h"

namespace gaitwright {

CubicSpline::CubicSpline(double start_s, double step_s, std::vector<double> values)
    : start_s_(start_s), step_s_(step_s), values_(std::move(values)) {
  if (values_.size() < 2 || !(step_s > 0.0)) {
    throw InvalidArgument("CubicSpline needs two or more values and a positive step");
  }
  const std::size_t n = values_.size();
  rates_.assign(n, 0.0);
  // r[i-1] + 4 r[i] + r[i+1] = 3 (y[i+1] - y[i-1]) / h with r = 0 at the ends (Thomas).
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double pivot = 4.0 - upper[i - 1];
    upper[i] = 1.0 / pivot;
    rates_[i] = (3.0 * (values_[i + 1] - values_[i - 1]) / step_s_ - rates_[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) rates_[i] -= upper[i] * rates_[i + 1];
}

Motion1 CubicSpline::At(double time_s) const {
  const double position = (time_s - start_s_) / step_s_;
  if (position <= 0.0) return {values_.front(), 0.0, 0.0};
  if (position >= static_cast<double>(values_.size() - 1)) return {values_.back(), 0.0, 0.0};
  const auto i = static_cast<std::size_t>(position);
  const double u = position - std::floor(position);
  const double d = values_[i + 1] - values_[i];
  const double r0 = rates_[i] * step_s_, r1 = rates_[i + 1] * step_s_;
  const double c2 = 3.0 * d - 2.0 * r0 - r1, c3 = r0 + r1 - 2.0 * d;
  return {values_[i] + u * (r0 + u * (c2 + u * c3)), (r0 + u * (2.0 * c2 + 3.0 * u * c3)) / step_s_,
          (2.0 * c2 + 6.0 * u * c3) / (step_s_ * step_s_)};
}

}  // namespace gaitwright
