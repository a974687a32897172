// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/trajectory/bspline.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

/// The basis of one degree over clamped knots, in the span from knot `span` to the next.
template <std::size_t degree, typename Knots>
class Basis {
 public:
  Basis(Knots knot, int span) : knot_(knot), span_(span) {}

  BsplineBasis<degree> At(double t) const {
    std::array<Row, degree + 1> N{};
    N[0][0] = 1.0;
    for (int p = 1; p <= kDegree; ++p) N[At(p)] = Raised(p, N[At(p - 1)], t);
    BsplineBasis<degree> basis;
    basis.first = span_ - kDegree;
    basis.value = N[degree];
    basis.rate = Derivative(kDegree, N[degree - 1]);
    basis.acceleration = Derivative(kDegree, Derivative(kDegree - 1, N[degree - 2]));
    return basis;
  }

 private:
  static constexpr int kDegree = static_cast<int>(degree);
  /// Entry j of degree p is function span - p + j.
  using Row = std::array<double, degree + 1>;
  static std::size_t At(int i) { return static_cast<std::size_t>(i); }

  /// Functions of degree p from the functions of degree p - 1.
  Row Raised(int p, const Row& below, double t) const {
    Row row{};
    for (int j = 0; j <= p; ++j) {
      const int i = span_ - p + j;
      if (j > 0) row[At(j)] += (t - knot_(i)) / (knot_(i + p) - knot_(i)) * below[At(j - 1)];
      if (j < p) row[At(j)] += (knot_(i + p + 1) - t) / (knot_(i + p + 1) - knot_(i + 1)) * below[At(j)];
    }
    return row;
  }

  /// Derivatives of functions of degree p from the functions, or derivatives, of degree p - 1:
  ///   N'_i,p = p N_i,p-1 / (k_i+p - k_i) - p N_i+1,p-1 / (k_i+p+1 - k_i+1).
  Row Derivative(int p, const Row& below) const {
    Row row{};
    for (int j = 0; j <= p; ++j) {
      const int i = span_ - p + j;
      if (j > 0) row[At(j)] += p * below[At(j - 1)] / (knot_(i + p) - knot_(i));
      if (j < p) row[At(j)] -= p * below[At(j)] / (knot_(i + p + 1) - knot_(i + 1));
    }
    return row;
  }

  Knots knot_;
  int span_;
};

}  // namespace

QuinticBasis EvaluateQuinticBasis(int control_points, double u) {
  constexpr int kDegree = 5;
  if (control_points <= kDegree)
    throw InvalidArgument(fmt::format("a quintic B-spline needs six control points or more; {} given", control_points));
  u = std::clamp(u, 0.0, 1.0);
  const int intervals = control_points - kDegree;
  const auto knot = [intervals](int i) {
    return std::clamp(i - kDegree, 0, intervals) / static_cast<double>(intervals);
  };
  return Basis<5, decltype(knot)>(knot, kDegree + std::min(static_cast<int>(u * intervals), intervals - 1)).At(u);
}

CubicBasis EvaluateCubicBasis(const std::vector<double>& knots, double t) {
  constexpr int kDegree = 3;
  if (knots.size() < 2 || std::adjacent_find(knots.begin(), knots.end(), std::greater_equal<>()) != knots.end())
    throw InvalidArgument("a cubic B-spline needs two or more knots in rising order");
  t = std::clamp(t, knots.front(), knots.back());
  const int intervals = static_cast<int>(knots.size()) - 1;
  const auto after = std::upper_bound(knots.begin(), knots.end() - 1, t);
  const auto knot = [&](int i) { return knots[static_cast<std::size_t>(std::clamp(i - kDegree, 0, intervals))]; };
  return Basis<3, decltype(knot)>(knot, kDegree + static_cast<int>(after - knots.begin()) - 1).At(t);
}

}  // namespace gaitwright
