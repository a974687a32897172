// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/response_surface.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <memory>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

/// 1, x_i, x_i^2 / 2 and x_i x_k of a point.
VectorX Monomials(const VectorX& x) {
  const Eigen::Index n = x.size();
  VectorX row(CoefficientsOfQuadratic(static_cast<int>(n)));
  Eigen::Index at = 0;
  row[at++] = 1.0;
  for (Eigen::Index i = 0; i < n; ++i) row[at++] = x[i];
  for (Eigen::Index i = 0; i < n; ++i) {
    row[at++] = 0.5 * x[i] * x[i];
    for (Eigen::Index k = i + 1; k < n; ++k) row[at++] = x[i] * x[k];
  }
  return row;
}

QuadraticSurface FromCoefficients(const VectorX& c, Eigen::Index n) {
  QuadraticSurface surface{c[0], c.segment(1, n), MatrixX::Zero(n, n)};
  Eigen::Index at = 1 + n;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = i; k < n; ++k) surface.curvature(i, k) = surface.curvature(k, i) = c[at++];
  }
  return surface;
}

void CheckMeasured(const std::vector<VectorX>& points, const std::vector<double>& values) {
  const Eigen::Index n = points.empty() ? 0 : points.front().size();
  const int needed = CoefficientsOfQuadratic(static_cast<int>(n));
  if (n == 0 || points.size() != values.size() || points.size() < static_cast<std::size_t>(needed)) {
    throw InvalidArgument(
        fmt::format("FitQuadratic: {} points of {} unknowns and {} values; one value for each point and at least {} "
                    "points are needed",
                    points.size(), n, values.size(), needed));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].size() != n || !points[i].allFinite() || !std::isfinite(values[i]))
      throw InvalidArgument(fmt::format("FitQuadratic: point {} has another size or is not finite", i));
  }
}

/// Residual of one eigendirection of the surface, as a function of all unknowns.
class AlongEigenvector {
 public:
  AlongEigenvector(VectorX v, double slope, double curvature, double top)
      : v_(std::move(v)), slope_(slope), curvature_(curvature), top_(top) {}

  /// Residual at t, and its derivative.
  void At(double t, double& residual, double& derivative) const {
    if (curvature_ < 0.0) {
      derivative = std::sqrt(-curvature_);
      residual = derivative * (t + slope_ / curvature_);
    } else {
      residual = std::sqrt(2.0 * std::max(top_ - slope_ * t - 0.5 * curvature_ * t * t, 1e-12));
      derivative = -(slope_ + curvature_ * t) / residual;
    }
  }
  const VectorX& direction() const { return v_; }

 private:
  VectorX v_;
  double slope_, curvature_, top_;
};

class SurfaceCost : public ceres::CostFunction {
 public:
  SurfaceCost(const QuadraticSurface& surface, const VectorX& low, const VectorX& high) {
    const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(surface.curvature);
    const double widest = std::max(eigen.eigenvalues().cwiseAbs().maxCoeff(), surface.slope.norm());
    for (Eigen::Index i = 0; i < low.size(); ++i) {
      const VectorX v = eigen.eigenvectors().col(i);
      const double slope = v.dot(surface.slope);
      double curvature = eigen.eigenvalues()[i];
      const bool flat = curvature < 0.0 && -curvature < 1e-9 * widest;
      if (flat) curvature = 0.0;
      const double farthest = v.cwiseAbs().dot(low.cwiseAbs().cwiseMax(high.cwiseAbs()));
      const double top = std::abs(slope) * farthest + 0.5 * std::max(curvature, 0.0) * farthest * farthest;
      along_.emplace_back(v, slope, curvature, 1.1 * top + 1e-6);
    }
    mutable_parameter_block_sizes()->push_back(static_cast<int>(low.size()));
    set_num_residuals(static_cast<int>(along_.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::Map<const VectorX> x(parameters[0], static_cast<Eigen::Index>(along_.size()));
    for (std::size_t i = 0; i < along_.size(); ++i) {
      const VectorX& v = along_[i].direction();
      double derivative = 0.0;
      along_[i].At(v.dot(x), residuals[i], derivative);
      if (jacobians == nullptr || jacobians[0] == nullptr) continue;
      for (Eigen::Index k = 0; k < v.size(); ++k)
        jacobians[0][i * along_.size() + static_cast<std::size_t>(k)] = derivative * v[k];
    }
    return true;
  }

 private:
  std::vector<AlongEigenvector> along_;
};

VectorX Climbed(ceres::CostFunction& cost, VectorX x, const VectorX& low, const VectorX& high) {
  ceres::Problem::Options shared;
  shared.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(shared);
  problem.AddResidualBlock(&cost, nullptr, x.data());
  for (int i = 0; i < static_cast<int>(x.size()); ++i) {
    problem.SetParameterLowerBound(x.data(), i, low[i]);
    problem.SetParameterUpperBound(x.data(), i, high[i]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 500;
  options.function_tolerance = 1e-15;
  options.gradient_tolerance = 1e-12;
  options.parameter_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return x.cwiseMax(low).cwiseMin(high);
}

/// Maximises along one coordinate after the other until the value no longer increases.
VectorX Sharpened(const QuadraticSurface& surface, VectorX x, const VectorX& low, const VectorX& high) {
  constexpr int kMostRounds = 200;
  for (int round = 0; round < kMostRounds; ++round) {
    const double before = surface.At(x);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double curvature = surface.curvature(i, i), slope = surface.slope[i] + surface.curvature.row(i).dot(x);
      VectorX best = x;
      for (const double value : {low[i], high[i], x[i] - slope / std::min(curvature, -1e-12)}) {
        VectorX other = x;
        other[i] = std::clamp(value, low[i], high[i]);
        if (surface.At(other) > surface.At(best)) best = other;
      }
      x = best;
    }
    if (surface.At(x) <= before) break;
  }
  return x;
}

/// Start points: the middle, each end and all combinations for up to four unknowns; otherwise the middle and at most 64
/// vertices.
std::vector<VectorX> Starts(const VectorX& low, const VectorX& high) {
  const Eigen::Index n = low.size();
  const VectorX middle = 0.5 * (low + high);
  std::vector<VectorX> starts = {middle};
  const bool few = n <= 4;
  const int base = few ? 3 : 2;
  const Eigen::Index digits = few ? n : 6;
  const int count = static_cast<int>(std::pow(base, std::min(n, digits)));
  for (int number = 0; number < count; ++number) {
    VectorX start = middle;
    for (Eigen::Index i = 0; i < n; ++i) {
      const int digit = number / static_cast<int>(std::pow(base, i % digits)) % base;
      if (digit < 2) start[i] = digit == 0 ? low[i] : high[i];
    }
    starts.push_back(start);
  }
  return starts;
}

}  // namespace

int CoefficientsOfQuadratic(int unknowns) { return (unknowns + 1) * (unknowns + 2) / 2; }

FittedSurface FitQuadratic(const std::vector<VectorX>& points, const std::vector<double>& values) {
  CheckMeasured(points, values);
  const auto count = static_cast<Eigen::Index>(points.size());
  const Eigen::Index n = points.front().size();
  MatrixX A(count, CoefficientsOfQuadratic(static_cast<int>(n)));
  for (Eigen::Index i = 0; i < count; ++i) A.row(i) = Monomials(points[static_cast<std::size_t>(i)]).transpose();
  const VectorX y = Eigen::Map<const VectorX>(values.data(), count);
  const Eigen::CompleteOrthogonalDecomposition<MatrixX> solver(A);
  const VectorX coefficients = solver.solve(y);
  FittedSurface fitted{FromCoefficients(coefficients, n), 0.0};
  const double about_mean = (y.array() - y.mean()).square().sum();
  if (count <= A.cols() || about_mean <= 0.0) return fitted;
  const VectorX leverage = (A * solver.pseudoInverse()).diagonal();
  const VectorX error = (y - A * coefficients).cwiseQuotient((1.0 - leverage.array()).max(1e-9).matrix());
  fitted.predicted = 1.0 - error.squaredNorm() / about_mean;
  return fitted;
}

VectorX HighestOf(const QuadraticSurface& surface, const VectorX& low, const VectorX& high) {
  const Eigen::Index n = low.size();
  const bool fits = n > 0 && high.size() == n && surface.slope.size() == n && surface.curvature.rows() == n &&
                    surface.curvature.cols() == n;
  if (!fits || !low.allFinite() || !high.allFinite() || !(low.array() < high.array()).all())
    throw InvalidArgument("HighestOf: sizes differ, or a lower bound is not below its upper bound");
  SurfaceCost cost(surface, low, high);
  VectorX best = 0.5 * (low + high);
  for (const VectorX& start : Starts(low, high)) {
    const VectorX top = Sharpened(surface, Climbed(cost, start, low, high), low, high);
    if (surface.At(top) > surface.At(best) + 1e-12) best = top;
  }
  return best;
}

}  // namespace gaitwright
