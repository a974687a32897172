// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/cma_es.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace gaitwright {
namespace {

/// x mirrored at 0 and 1 until it is in [0, 1].
double Mirrored(double x) {
  const double within = std::abs(x) - 2.0 * std::floor(0.5 * std::abs(x));  // in [0, 2)
  return within <= 1.0 ? within : 2.0 - within;
}

VectorX Mirrored(const VectorX& x) {
  return x.unaryExpr([](double value) { return Mirrored(value); });
}

}  // namespace

CmaEs::CmaEs(const VectorX& start, std::uint64_t seed, const CmaEsOptions& options)
    : population_(options.population), spread_(options.spread), random_(seed), mean_(start) {
  CmaEsOptions checked = options;
  CheckOptions(checked.Fields());
  const Eigen::Index n = start.size();
  if (n == 0) throw InvalidArgument("CmaEs: there are no unknowns; one or more are needed");
  for (const double value : start) {
    if (!(value >= 0.0 && value <= 1.0))
      throw InvalidArgument(fmt::format("CmaEs: a coordinate of the start is {}; accepted: 0 to 1", value));
  }
  if (population_ == 0) population_ = 4 + static_cast<int>(3.0 * std::log(static_cast<double>(n)));
  population_ = std::max(population_, 2);
  path_ = spread_path_ = VectorX::Zero(n);
  covariance_ = MatrixX::Identity(n, n);
  SetWeights();
  Decompose();
}

void CmaEs::SetWeights() {
  const auto n = static_cast<double>(mean_.size());
  const int parents = population_ / 2;
  weights_.resize(parents);
  for (int i = 0; i < parents; ++i) weights_[i] = std::log(0.5 * (population_ + 1.0)) - std::log(i + 1.0);
  weights_ /= weights_.sum();
  mu_effective_ = 1.0 / weights_.squaredNorm();
  const double mu = mu_effective_;
  c_spread_ = (mu + 2.0) / (n + mu + 5.0);  // eq. 55
  damping_ = 1.0 + 2.0 * std::max(0.0, std::sqrt((mu - 1.0) / (n + 1.0)) - 1.0) + c_spread_;
  c_path_ = (4.0 + mu / n) / (n + 4.0 + 2.0 * mu / n);                                                // eq. 56
  c_one_ = 2.0 / ((n + 1.3) * (n + 1.3) + mu);                                                        // eq. 57
  c_mu_ = std::min(1.0 - c_one_, 2.0 * (0.25 + mu + 1.0 / mu - 2.0) / ((n + 2.0) * (n + 2.0) + mu));  // eq. 58
  expected_norm_ = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
}

VectorX CmaEs::mean() const { return Mirrored(mean_); }

void CmaEs::Decompose() {
  const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(covariance_);
  const VectorX lengths = eigen.eigenvalues().cwiseMax(1e-20).cwiseSqrt();
  axes_ = eigen.eigenvectors() * lengths.asDiagonal();
  inverse_axes_ = eigen.eigenvectors() * lengths.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
}

std::vector<VectorX> CmaEs::Ask() {
  drawn_.resize(mean_.size(), population_);
  std::vector<VectorX> points;
  VectorX normal(mean_.size());
  for (int k = 0; k < population_; ++k) {
    for (double& number : normal) number = random_.Normal();
    drawn_.col(k) = axes_ * normal;
    points.push_back(Mirrored(VectorX(mean_ + spread_ * drawn_.col(k))));
  }
  return points;
}

std::vector<std::size_t> CmaEs::Ranked(const std::vector<std::optional<double>>& values) const {
  std::vector<std::size_t> ranked(values.size());
  std::iota(ranked.begin(), ranked.end(), std::size_t{0});
  std::stable_sort(ranked.begin(), ranked.end(), [&](std::size_t a, std::size_t b) {
    if (!values[a] || !values[b]) return values[a].has_value() && !values[b].has_value();
    return *values[a] < *values[b];
  });
  return ranked;
}

void CmaEs::Tell(const std::vector<std::optional<double>>& values) {
  if (values.size() != static_cast<std::size_t>(drawn_.cols())) {
    throw InvalidArgument(
        fmt::format("CmaEs: {} values are given for {} requested points", values.size(), drawn_.cols()));
  }
  bool any = false;
  for (const std::optional<double>& value : values) {
    if (value && !std::isfinite(*value))
      throw InvalidArgument(fmt::format("CmaEs: a value is {}; give no value for an infeasible point", *value));
    any = any || value.has_value();
  }
  if (any) {
    Move(Ranked(values));
  } else {
    spread_ *= 0.5;
  }
  drawn_.resize(mean_.size(), 0);
}

void CmaEs::Move(const std::vector<std::size_t>& ranked) {
  const auto n = static_cast<double>(mean_.size());
  ++generation_;
  VectorX step = VectorX::Zero(mean_.size());
  MatrixX of_parents = MatrixX::Zero(mean_.size(), mean_.size());
  for (Eigen::Index i = 0; i < weights_.size(); ++i) {
    const VectorX y = drawn_.col(static_cast<Eigen::Index>(ranked[static_cast<std::size_t>(i)]));
    step += weights_[i] * y;  // eq. 41
    of_parents += weights_[i] * y * y.transpose();
  }
  mean_ += spread_ * step;  // eq. 42
  spread_path_ = (1.0 - c_spread_) * spread_path_ +
                 std::sqrt(c_spread_ * (2.0 - c_spread_) * mu_effective_) * (inverse_axes_ * step);  // eq. 43
  const double norm = spread_path_.norm();
  const double settled = std::sqrt(1.0 - std::pow(1.0 - c_spread_, 2.0 * generation_));
  const bool short_path = norm / settled < (1.4 + 2.0 / (n + 1.0)) * expected_norm_;
  path_ *= 1.0 - c_path_;
  if (short_path) path_ += std::sqrt(c_path_ * (2.0 - c_path_) * mu_effective_) * step;  // eq. 45
  const double lost = short_path ? 0.0 : c_path_ * (2.0 - c_path_);
  covariance_ = (1.0 + c_one_ * lost - c_one_ - c_mu_) * covariance_ + c_one_ * path_ * path_.transpose() +
                c_mu_ * of_parents;                                                          // eq. 47
  spread_ *= std::exp(std::min(1.0, c_spread_ / damping_ * (norm / expected_norm_ - 1.0)));  // eq. 44
  spread_ = std::min(spread_, 1.0);  // the box limits the spread anyway
  Decompose();
}

}  // namespace gaitwright
