// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "workflows/exchange/split_rotation_internal.h"

namespace gaitwright {
namespace {

Vector3 LogOf(const Matrix3& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

/// The rotation of hinges, and what they lack of a rotation as a vector in its axes.
struct SplitState {
  Vector3 lack = Vector3::Zero();
  Eigen::Matrix3Xd J;  ///< d(rotation) / d(angles), as vectors in the axes of the result
};

SplitState StateAt(const Matrix3& R, const std::vector<Vector3>& axes, const VectorX& angles) {
  SplitState state;
  state.J.resize(3, angles.size());
  Matrix3 behind = Matrix3::Identity();  // rotation of the hinges behind the current one
  for (Eigen::Index i = angles.size(); i-- > 0;) {
    const Vector3& axis = axes[static_cast<std::size_t>(i)];
    state.J.col(i) = behind.transpose() * axis;
    behind = Eigen::AngleAxisd(angles[i], axis).toRotationMatrix() * behind;
  }
  state.lack = LogOf(behind.transpose() * R);
  return state;
}

SplitAngles SplitFrom(const Matrix3& R, const std::vector<Vector3>& axes, VectorX angles) {
  constexpr int kSteps = 40;
  constexpr double kSmallStep = 1e-12, kLeastDamping = 1e-9, kMostDamping = 1e6;
  SplitState state = StateAt(R, axes, angles);
  double damping = 1e-3;
  for (int step = 0; step < kSteps && damping < kMostDamping; ++step) {
    Eigen::MatrixXd H = state.J.transpose() * state.J;
    H.diagonal().array() += damping;
    const VectorX change = H.ldlt().solve(state.J.transpose() * state.lack);
    const SplitState next = StateAt(R, axes, angles + change);
    if (next.lack.norm() <= state.lack.norm()) {
      angles += change;
      state = next;
      damping = std::max(kLeastDamping, 0.1 * damping);
      if (change.norm() < kSmallStep) break;
    } else {
      damping *= 10.0;
    }
  }
  return {angles, state.lack.norm()};
}

}  // namespace

SplitAngles SplitRotation(const Matrix3& R, const std::vector<Vector3>& axes, const VectorX& near, bool anywhere) {
  constexpr double kBeginning = 1.5, kBetter = 1e-6;  // [rad]
  SplitAngles best = SplitFrom(R, axes, near);
  if (!anywhere || best.left_rad < kBetter) return best;
  // All beginnings with an angle below, at or above zero in each hinge.
  const int count = static_cast<int>(std::lround(std::pow(3.0, static_cast<double>(axes.size()))));
  for (int code = 0; code < count; ++code) {
    VectorX from(near.size());
    int rest = code;
    for (double& angle : from) {
      angle = kBeginning * (rest % 3 - 1);
      rest /= 3;
    }
    const SplitAngles other = SplitFrom(R, axes, from);
    if (other.left_rad < best.left_rad - kBetter) best = other;
  }
  return best;
}

}  // namespace gaitwright
