// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "kinematics/base/result.h"
#include "kinematics/trajectory/bspline.h"
#include "optimisation/trajectory/chain_spline_internal.h"

namespace gaitwright {

void SetPace(const KnotPace& pace, VectorJet& jet) {
  jet.acceleration = pace.rate * (pace.rate * jet.acceleration + pace.slope * jet.rate);
  jet.rate *= pace.rate;
}

KnotBasis AtPace(const KnotBasis& basis, const KnotPace& pace) {
  KnotBasis now = basis;
  for (std::size_t i = 0; i < 3; ++i) {
    now.rate[i] = pace.rate * basis.rate[i];
    now.acceleration[i] = pace.rate * (pace.rate * basis.acceleration[i] + pace.slope * basis.rate[i]);
  }
  return now;
}

ChainSpline::ChainSpline(std::vector<double> time_s) : time_s_(std::move(time_s)) {
  for (std::size_t k = 0; k < time_s_.size(); ++k) {
    const CubicBasis of = EvaluateCubicBasis(time_s_, time_s_[k]);
    const std::size_t skipped = k - static_cast<std::size_t>(of.first);  // 1 at the last knot, else 0
    KnotBasis basis;
    for (std::size_t i = 0; i < 3; ++i) {
      basis.value[i] = of.value[skipped + i];
      basis.rate[i] = of.rate[skipped + i];
      basis.acceleration[i] = of.acceleration[skipped + i];
    }
    basis_.push_back(basis);
  }
}

ChainSpline::ChainSpline(std::vector<double> time_s, std::vector<KnotBasis> basis)
    : time_s_(std::move(time_s)), basis_(std::move(basis)) {
  if (basis_.size() != time_s_.size()) throw InvalidArgument("ChainSpline: there must be one basis by knot");
}

MatrixX ChainSpline::Through(const MatrixX& values, const VectorX& first_rate, const VectorX& last_rate) const {
  const Eigen::Index n = values.rows(), last = points() - 1;
  MatrixX points(n, last + 1);
  // At an end one control point has the value, the next one the rate.
  points.col(0) = values.col(0);
  points.col(1) = (first_rate - basis_.front().rate[0] * points.col(0)) / basis_.front().rate[1];
  points.col(last) = values.col(last - 2);
  points.col(last - 1) = (last_rate - basis_.back().rate[2] * points.col(last)) / basis_.back().rate[1];
  // The rest by elimination: knot k has points k, k + 1, k + 2.
  std::vector<double> above(time_s_.size(), 0.0);
  for (Eigen::Index k = 1; k + 1 < knots(); ++k) {
    const std::array<double, 3>& b = basis_[static_cast<std::size_t>(k)].value;
    const bool ends = k + 2 == last - 1;
    const double pivot = b[1] - b[0] * above[static_cast<std::size_t>(k - 1)];
    points.col(k + 1) = (values.col(k) - b[0] * points.col(k)) / pivot;
    if (ends) {
      points.col(k + 1) -= b[2] / pivot * points.col(k + 2);
    } else {
      above[static_cast<std::size_t>(k)] = b[2] / pivot;
    }
  }
  for (Eigen::Index k = last - 4; k >= 1; --k)
    points.col(k + 1) -= above[static_cast<std::size_t>(k)] * points.col(k + 2);
  return points;
}

void ChainSpline::Sample(const Eigen::Ref<const MatrixX>& points, double at_s, VectorJet& jet) const {
  const CubicBasis basis = EvaluateCubicBasis(time_s_, at_s);
  jet.x.setZero(points.rows());
  jet.rate.setZero(points.rows());
  jet.acceleration.setZero(points.rows());
  for (std::size_t i = 0; i < basis.value.size(); ++i) {
    const auto point = points.col(basis.first + static_cast<Eigen::Index>(i));
    jet.x += basis.value[i] * point;
    jet.rate += basis.rate[i] * point;
    jet.acceleration += basis.acceleration[i] * point;
  }
}

}  // namespace gaitwright
