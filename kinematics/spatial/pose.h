// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace gaitwright {

/// X_AB: the pose of frame B in frame A, so that p_AQ = X_AB * p_BQ.
using Pose = Eigen::Isometry3d;

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix3 = Eigen::Matrix3d;
using VectorX = Eigen::VectorXd;
using MatrixX = Eigen::MatrixXd;
using Quaternion = Eigen::Quaterniond;

/// Gravity used by plans, metrics and playback [m/s^2].
inline constexpr double kGravity = 9.81;

}  // namespace gaitwright
