// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/knot_spline.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "kinematics/base/result.h"
#include "workflows/exchange/median_internal.h"

namespace gaitwright {
namespace {

void CheckKnots(const std::vector<double>& time_s, const std::vector<double>& values) {
  if (time_s.size() < 2 || time_s.size() != values.size())
    throw InvalidArgument("a spline needs two knots or more, with one value each");
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (!(time_s[i] > time_s[i - 1])) throw InvalidArgument("a spline needs knots at increasing times");
  }
}

}  // namespace

KnotSpline::KnotSpline(std::vector<double> time_s, std::vector<double> values)
    : time_s_(std::move(time_s)), values_(std::move(values)) {
  CheckKnots(time_s_, values_);
  Slopes();
}

/// Solves the tridiagonal system for the rates at the knots, by elimination from the first row.
void KnotSpline::Slopes() {
  const std::size_t n = values_.size();
  const auto step = [&](std::size_t i) { return time_s_[i + 1] - time_s_[i]; };
  const auto slope = [&](std::size_t i) { return (values_[i + 1] - values_[i]) / step(i); };
  rates_.assign(n, slope(0));
  if (n == 2) return;
  if (n == 3) {
    const double bend = (slope(1) - slope(0)) / (step(0) + step(1));
    rates_ = {slope(0) - bend * step(0), slope(0) + bend * step(0), slope(1) + bend * step(1)};
    return;
  }
  std::vector<double> below(n), diagonal(n), above(n), right(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    below[i] = step(i);
    diagonal[i] = 2.0 * (step(i - 1) + step(i));
    above[i] = step(i - 1);
    right[i] = 3.0 * (step(i) * slope(i - 1) + step(i - 1) * slope(i));
  }
  const double d0 = step(0) + step(1), d1 = step(n - 2) + step(n - 3);
  diagonal[0] = step(1);
  above[0] = d0;
  right[0] = ((step(0) + 2.0 * d0) * step(1) * slope(0) + step(0) * step(0) * slope(1)) / d0;
  diagonal[n - 1] = step(n - 3);
  below[n - 1] = d1;
  right[n - 1] =
      (step(n - 2) * step(n - 2) * slope(n - 3) + (2.0 * d1 + step(n - 2)) * step(n - 3) * slope(n - 2)) / d1;
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = below[i] / diagonal[i - 1];
    diagonal[i] -= factor * above[i - 1];
    right[i] -= factor * right[i - 1];
  }
  rates_[n - 1] = right[n - 1] / diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) rates_[i] = (right[i] - above[i] * rates_[i + 1]) / diagonal[i];
}

Motion1 KnotSpline::At(double time_s) const {
  if (time_s < time_s_.front()) return {values_.front(), 0.0, 0.0};
  if (time_s > time_s_.back()) return {values_.back(), 0.0, 0.0};
  const auto after = std::upper_bound(time_s_.begin() + 1, time_s_.end() - 1, time_s);
  const auto i = static_cast<std::size_t>(after - time_s_.begin()) - 1;
  const double h = time_s_[i + 1] - time_s_[i], u = (time_s - time_s_[i]) / h;
  const double rise = values_[i + 1] - values_[i], r0 = h * rates_[i], r1 = h * rates_[i + 1];
  const double c2 = 3.0 * rise - 2.0 * r0 - r1, c3 = r0 + r1 - 2.0 * rise;
  return {values_[i] + u * (r0 + u * (c2 + u * c3)), (r0 + u * (2.0 * c2 + 3.0 * u * c3)) / h,
          (2.0 * c2 + 6.0 * u * c3) / (h * h)};
}

std::vector<double> Smoothed(const std::vector<double>& time_s, const std::vector<double>& values, double cutoff_hz) {
  CheckKnots(time_s, values);
  if (!(cutoff_hz > 0.0)) throw InvalidArgument("smoothing needs a frequency above 0 Hz");
  const auto n = static_cast<Eigen::Index>(values.size());
  if (n < 3) return values;
  const double mean_step = (time_s.back() - time_s.front()) / static_cast<double>(n - 1);
  const double lambda = 1.0 / (mean_step * std::pow(2.0 * std::numbers::pi * cutoff_hz, 4));
  const auto step = [&](Eigen::Index i) {
    return time_s[static_cast<std::size_t>(i) + 1] - time_s[static_cast<std::size_t>(i)];
  };
  using Triplet = Eigen::Triplet<double>;
  std::vector<Triplet> second, gram;  // Q: second divided differences; R: their products
  for (Eigen::Index i = 0; i + 2 < n; ++i) {
    second.emplace_back(i, i, 1.0 / step(i));
    second.emplace_back(i + 1, i, -1.0 / step(i) - 1.0 / step(i + 1));
    second.emplace_back(i + 2, i, 1.0 / step(i + 1));
    gram.emplace_back(i, i, (step(i) + step(i + 1)) / 3.0);
    if (i + 3 < n) {
      gram.emplace_back(i, i + 1, step(i + 1) / 6.0);
      gram.emplace_back(i + 1, i, step(i + 1) / 6.0);
    }
  }
  Eigen::SparseMatrix<double> Q(n, n - 2), R(n - 2, n - 2);
  Q.setFromTriplets(second.begin(), second.end());
  R.setFromTriplets(gram.begin(), gram.end());
  const Eigen::Map<const VectorX> y(values.data(), n);
  const Eigen::SparseMatrix<double> system = R + lambda * Eigen::SparseMatrix<double>(Q.transpose() * Q);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
  const VectorX bends = solver.solve(Q.transpose() * y);
  const VectorX smooth = y - lambda * (Q * bends);
  return {smooth.data(), smooth.data() + n};
}

double NoiseOf(const std::vector<double>& values) {
  constexpr double kMedianOfNormal = 0.6745;
  const double spread = std::sqrt(70.0);  // root of the sum of squares of 1, 4, 6, 4, 1
  if (values.size() < 9) return 0.0;
  std::vector<double> differences;
  for (std::size_t i = 4; i < values.size(); ++i) {
    differences.push_back(
        std::abs(values[i] - 4.0 * values[i - 1] + 6.0 * values[i - 2] - 4.0 * values[i - 3] + values[i - 4]));
  }
  return MedianOf(std::move(differences)) / (kMedianOfNormal * spread);
}

}  // namespace gaitwright
