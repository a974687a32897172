// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/damped_search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kConvergedError = 1e-11;  // norm of the scaled error
constexpr int kMaxSteps = 100;
constexpr int kPatience = 10;              // consecutive steps that each reduce the error by less than 2 %
constexpr double kLongestJointStep = 0.5;  // [rad]

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

/// Derivative of e = log(R) for a rotation of R from the left: d e = this matrix times w.
Matrix3 InverseLeftJacobian(const Vector3& e) {
  const double angle = e.norm();
  const double k = angle < 1e-4 ? 1.0 / 12.0 : (1.0 - 0.5 * angle / std::tan(0.5 * angle)) / (angle * angle);
  const Matrix3 cross = Skew(e);
  return Matrix3::Identity() - 0.5 * cross + k * cross * cross;
}

/// One damped least-squares search; all memory is allocated at the start.
class Descent {
 public:
  Descent(const LegChain& chain, const Pose& X_BF, const VectorX& lower, const VectorX& upper)
      : chain_(chain),
        target_(X_BF),
        lower_(lower),
        upper_(upper),
        screws_(6, static_cast<Eigen::Index>(chain.links.size())),
        J_(6, chain.num_coordinates()),
        A_(chain.num_rows, chain.num_coordinates()),
        error_(chain.num_rows),
        step_(chain.num_coordinates()),
        trial_(chain.num_coordinates()) {}

  void Run(const VectorX& start, DampedSearch& out) {
    VectorX& x = out.coordinates;
    x = start.cwiseMax(lower_).cwiseMin(upper_);
    double cost = Linearise(x);
    double damping = std::min(1e-2, cost);
    int stalled = 0;
    for (out.iterations = 0; out.iterations < kMaxSteps && !Converged(); ++out.iterations) {
      Step(x, damping);
      trial_ = (x + step_).cwiseMax(lower_).cwiseMin(upper_);
      if ((trial_ - x).lpNorm<Eigen::Infinity>() < 1e-14) break;  // at rest
      const double tried = ErrorOf(trial_);
      stalled = tried > 0.98 * cost ? stalled + 1 : 0;
      if (stalled > kPatience) break;
      if (tried < cost) {
        x.swap(trial_);
        cost = Linearise(x);
        damping = std::max(std::min(0.2 * damping, cost), 1e-15);
      } else {
        damping = std::max(10.0 * damping, 1e-9);
        if (damping > 1e6) break;
      }
    }
    Linearise(x);
    out.converged = Converged();
    out.distance_m = chain_.length_m * error_.head<3>().norm();
    out.angle_rad = error_.tail(error_.size() - 3).norm();
  }

 private:
  bool Converged() const { return error_.lpNorm<Eigen::Infinity>() < kConvergedError; }

  /// Sets error_ for a pose. @return its squared length.
  double SetError(const Pose& X) {
    full_.head<3>() = (target_.translation() - X.translation()) / chain_.length_m;
    full_.tail<3>().setZero();
    if (chain_.num_rows > 3) full_.tail<3>() = RotationLog(X.linear().transpose() * target_.linear());
    for (int r = 0; r < chain_.num_rows; ++r) error_[r] = full_[chain_.rows[static_cast<std::size_t>(r)]];
    return error_.squaredNorm();
  }
  double ErrorOf(const VectorX& x) { return SetError(chain_.FootPose(x)); }

  /// Sets error_ and A_ = -d error_ / dx at x.
  double Linearise(const VectorX& x) {
    const double cost = SetError(chain_.FootPose(x, screws_, J_));
    J_.topRows<3>() /= chain_.length_m;
    if (chain_.num_rows > 3) {
      const Matrix3 to_log = InverseLeftJacobian(full_.tail<3>());
      for (Eigen::Index c = 0; c < J_.cols(); ++c) J_.col(c).tail<3>() = (to_log * J_.col(c).tail<3>()).eval();
    }
    for (int r = 0; r < chain_.num_rows; ++r) A_.row(r) = J_.row(chain_.rows[static_cast<std::size_t>(r)]);
    return cost;
  }

  /// Sets step_ from x; coordinates that would leave their limits are fixed.
  void Step(const VectorX& x, double damping) {
    for (Eigen::Index c = 0; c < x.size(); ++c) {
      const double push = A_.col(c).dot(error_);
      held_ = (x[c] <= lower_[c] && push < 0.0) || (x[c] >= upper_[c] && push > 0.0);
      if (held_) A_.col(c).setZero();
    }
    normal_ = A_.lazyProduct(A_.transpose());
    normal_.diagonal().array() += damping;
    solver_.compute(normal_);
    solved_ = solver_.solve(error_);
    step_ = A_.transpose().lazyProduct(solved_);
    const double longest = step_.lpNorm<Eigen::Infinity>();
    if (longest > kLongestJointStep) step_ *= kLongestJointStep / longest;
  }

  const LegChain& chain_;
  const Pose& target_;
  const VectorX &lower_, &upper_;
  LegChain::Jacobian screws_, J_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, Eigen::Dynamic> A_;
  Vector6 full_;
  Rows error_, solved_;
  Square normal_;
  Eigen::LDLT<Square> solver_;
  VectorX step_, trial_;
  bool held_ = false;
};

/// Random coordinates within the limits; within a full turn for joints without limits.
VectorX Place(const VectorX& lower, const VectorX& upper, std::mt19937& engine) {
  VectorX place(lower.size());
  for (Eigen::Index c = 0; c < place.size(); ++c) {
    const double low = std::max(lower[c], -std::numbers::pi), high = std::min(upper[c], std::numbers::pi);
    place[c] = low + (high - low) * (static_cast<double>(engine()) / 4294967296.0);
  }
  return place;
}

}  // namespace

DampedSearch DescendToPose(const LegChain& chain, const Pose& X_BF, const VectorX& lower, const VectorX& upper,
                           const VectorX& start) {
  DampedSearch found;
  Descent(chain, X_BF, lower, upper).Run(start, found);
  return found;
}

DampedSearch SearchPose(const LegChain& chain, const Pose& X_BF, const VectorX& lower, const VectorX& upper,
                        const VectorX& guess, int starts) {
  Descent descent(chain, X_BF, lower, upper);
  DampedSearch best, found;
  std::mt19937 engine(1);
  const auto left = [&](const DampedSearch& s) { return std::hypot(s.distance_m / chain.length_m, s.angle_rad); };
  int iterations = 0;
  for (int i = 0; i < starts && !best.converged; ++i) {
    descent.Run(i == 0 ? guess : i == 1 ? chain.standing : Place(lower, upper, engine), found);
    iterations += found.iterations;
    if (i == 0 || found.converged || left(found) < left(best)) std::swap(best, found);
  }
  best.iterations = iterations;
  return best;
}

}  // namespace gaitwright
