// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/trajectory/quintic_bspline.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

constexpr int kDegree = 5;
using Row = std::array<double, kDegree + 1>;

/// Even knots, the first and last six times.
double Knot(int control_points, int i) {
  const int intervals = control_points - kDegree;
  return std::clamp(i - kDegree, 0, intervals) / static_cast<double>(intervals);
}

/// Derivatives of basis functions of one degree from the functions (or derivatives) of the degree below:
///   N'_i,p = p N_i,p-1 / (k_i+p - k_i) - p N_i+1,p-1 / (k_i+p+1 - k_i+1).
/// Entry j of degree p stands for function span - p + j.
Row Derivative(int control_points, int span, int degree, const Row& below) {
  Row row{};
  for (int j = 0; j <= degree; ++j) {
    const int i = span - degree + j;
    const auto term = [&](int function, int entry) {
      if (entry < 0 || entry > degree - 1) return 0.0;
      return degree * below[static_cast<std::size_t>(entry)] /
             (Knot(control_points, function + degree) - Knot(control_points, function));
    };
    row[static_cast<std::size_t>(j)] = term(i, j - 1) - term(i + 1, j);
  }
  return row;
}

}  // namespace

QuinticBasis EvaluateQuinticBasis(int control_points, double u) {
  if (control_points <= kDegree)
    throw InvalidArgument(fmt::format("a quintic B-spline needs six control points or more; {} given", control_points));
  u = std::clamp(u, 0.0, 1.0);
  const int intervals = control_points - kDegree;
  const int span = kDegree + std::min(static_cast<int>(u * intervals), intervals - 1);
  std::array<Row, kDegree + 1> N{};
  N[0][0] = 1.0;
  for (int p = 1; p <= kDegree; ++p) {
    for (int j = 0; j <= p; ++j) {
      const int i = span - p + j;
      double sum = 0.0;
      if (j > 0) {
        const double left = Knot(control_points, i), right = Knot(control_points, i + p);
        sum += (u - left) / (right - left) * N[static_cast<std::size_t>(p - 1)][static_cast<std::size_t>(j - 1)];
      }
      if (j < p) {
        const double left = Knot(control_points, i + 1), right = Knot(control_points, i + p + 1);
        sum += (right - u) / (right - left) * N[static_cast<std::size_t>(p - 1)][static_cast<std::size_t>(j)];
      }
      N[static_cast<std::size_t>(p)][static_cast<std::size_t>(j)] = sum;
    }
  }
  QuinticBasis basis;
  basis.first = span - kDegree;
  basis.value = N[5];
  basis.rate = Derivative(control_points, span, 5, N[4]);
  basis.acceleration = Derivative(control_points, span, 5, Derivative(control_points, span, 4, N[3]));
  return basis;
}

}  // namespace gaitwright
