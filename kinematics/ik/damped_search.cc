// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/damped_search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
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
        at_(chain),
        tried_(chain),
        step_(chain.num_coordinates()),
        trial_(chain.num_coordinates()) {}

  void Run(const VectorX& start, DampedSearch& out) {
    VectorX& x = out.coordinates;
    x = start.cwiseMax(lower_).cwiseMin(upper_);
    Linearise(x, at_);
    double damping = std::min(1e-2, at_.cost);
    int stalled = 0;
    for (out.iterations = 0; out.iterations < kMaxSteps && !at_.Converged(); ++out.iterations) {
      Step(x, damping);
      trial_ = (x + step_).cwiseMax(lower_).cwiseMin(upper_);
      if ((trial_ - x).lpNorm<Eigen::Infinity>() < 1e-14) break;  // at rest
      Linearise(trial_, tried_);
      stalled = tried_.cost > 0.98 * at_.cost ? stalled + 1 : 0;
      if (stalled > kPatience) break;
      if (tried_.cost < at_.cost) {
        x.swap(trial_);
        std::swap(at_, tried_);
        damping = std::max(std::min(0.2 * damping, at_.cost), 1e-15);
      } else {
        damping = std::max(10.0 * damping, 1e-9);
        if (damping > 1e6) break;
      }
    }
    out.converged = at_.Converged();
    out.distance_m = chain_.length_m * at_.error.head<3>().norm();
    out.angle_rad = at_.error.tail(at_.error.size() - 3).norm();
  }

 private:
  /// The scaled error of the foot's pose, and its derivative.
  struct Linearised {
    explicit Linearised(const LegChain& chain) : A(chain.num_rows, chain.num_coordinates()), error(chain.num_rows) {}
    bool Converged() const { return error.lpNorm<Eigen::Infinity>() < kConvergedError; }

    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, Eigen::Dynamic> A;  // -d error / dx
    Rows error;
    double cost = 0.0;  // squared length of the error
  };

  /// Sets error and derivative at x.
  void Linearise(const VectorX& x, Linearised& out) {
    const Pose X = chain_.FootPose(x, screws_, J_);
    Vector6 full = Vector6::Zero();
    full.head<3>() = (target_.translation() - X.translation()) / chain_.length_m;
    J_.topRows<3>() /= chain_.length_m;
    if (chain_.num_rows > 3) {
      full.tail<3>() = RotationLog(X.linear().transpose() * target_.linear());
      const Matrix3 to_log = InverseLeftJacobian(full.tail<3>());
      for (Eigen::Index c = 0; c < J_.cols(); ++c) J_.col(c).tail<3>() = (to_log * J_.col(c).tail<3>()).eval();
    }
    for (int r = 0; r < chain_.num_rows; ++r) {
      const int row = chain_.rows[static_cast<std::size_t>(r)];
      out.error[r] = full[row];
      out.A.row(r) = J_.row(row);
    }
    out.cost = out.error.squaredNorm();
  }

  /// Sets step_ from x; coordinates that would leave their limits are fixed.
  void Step(const VectorX& x, double damping) {
    auto& A = at_.A;
    for (Eigen::Index c = 0; c < x.size(); ++c) {
      const double push = A.col(c).dot(at_.error);
      const bool held = (x[c] <= lower_[c] && push < 0.0) || (x[c] >= upper_[c] && push > 0.0);
      if (held) A.col(c).setZero();
    }
    normal_ = A.lazyProduct(A.transpose());
    normal_.diagonal().array() += damping;
    solver_.compute(normal_);
    solved_ = solver_.solve(at_.error);
    step_ = A.transpose().lazyProduct(solved_);
    const double longest = step_.lpNorm<Eigen::Infinity>();
    if (longest > kLongestJointStep) step_ *= kLongestJointStep / longest;
  }

  const LegChain& chain_;
  const Pose& target_;
  const VectorX &lower_, &upper_;
  LegChain::Jacobian screws_, J_;
  Linearised at_, tried_;
  Rows solved_;
  Square normal_;
  Eigen::LDLT<Square> solver_;
  VectorX step_, trial_;
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
  std::optional<std::mt19937> engine;  // costs as much as some steps
  const bool at_standing = guess.size() == chain.standing.size() && guess == chain.standing;
  const auto left = [&](const DampedSearch& s) { return std::hypot(s.distance_m / chain.length_m, s.angle_rad); };
  int iterations = 0;
  for (int i = 0; i < starts && !best.converged; ++i) {
    if (i == 1 && at_standing) continue;
    if (i > 1 && !engine) engine.emplace(1);
    descent.Run(i == 0 ? guess : i == 1 ? chain.standing : Place(lower, upper, *engine), found);
    iterations += found.iterations;
    if (i == 0 || found.converged || left(found) < left(best)) std::swap(best, found);
  }
  best.iterations = iterations;
  return best;
}

}  // namespace gaitwright
