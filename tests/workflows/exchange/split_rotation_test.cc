// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "workflows/exchange/split_rotation_internal.h"

namespace gaitwright {
namespace {

Matrix3 Joined(const std::vector<Vector3>& axes, const VectorX& angles) {
  Matrix3 R = Matrix3::Identity();
  for (std::size_t i = 0; i < axes.size(); ++i)
    R = R * Eigen::AngleAxisd(angles[static_cast<Eigen::Index>(i)], axes[i]).toRotationMatrix();
  return R;
}

TEST(SplitRotation, FindsTheAnglesOfHingesAgain) {
  const std::vector<std::vector<Vector3>> hinges = {
      {Vector3::UnitY()},
      {Vector3::UnitY(), Vector3::UnitX()},
      {Vector3::UnitY(), Vector3::UnitX(), Vector3::UnitZ()},
      {Vector3(0.0, 0.7, -0.7).normalized(), Vector3(1.0, 0.1, 0.0).normalized(), Vector3(0.2, 0.9, 0.1).normalized()}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-1.2, 1.2);
  for (const std::vector<Vector3>& axes : hinges) {
    for (int i = 0; i < 50; ++i) {
      VectorX angles(static_cast<Eigen::Index>(axes.size())), near = angles;
      for (double& one : angles) one = angle(random);
      for (Eigen::Index k = 0; k < near.size(); ++k) near[k] = angles[k] + 0.1;
      const SplitAngles split = SplitRotation(Joined(axes, angles), axes, near, false);
      EXPECT_LT((split.angles - angles).norm(), 1e-7) << axes.size();
      EXPECT_LT(split.left_rad, 1e-9);
      const SplitAngles first = SplitRotation(Joined(axes, angles), axes, VectorX::Zero(near.size()), true);
      EXPECT_LT(first.left_rad, 1e-6) << "from anywhere";
    }
  }
}

TEST(SplitRotation, FollowsBeyondHalfATurn) {
  const std::vector<Vector3> axes = {Vector3::UnitZ()};
  VectorX near = VectorX::Zero(1);
  for (int i = 0; i <= 40; ++i)
    near = SplitRotation(Joined(axes, VectorX::Constant(1, 0.1 * i)), axes, near, false).angles;
  EXPECT_NEAR(near[0], 4.0, 1e-9);
}

TEST(SplitRotation, LeavesWhatNoHingeDoes) {
  const Matrix3 R = Joined({Vector3::UnitZ(), Vector3::UnitX()}, Eigen::Vector2d(0.8, 0.2));
  const SplitAngles split = SplitRotation(R, {Vector3::UnitZ()}, VectorX::Zero(1), true);
  EXPECT_NEAR(split.angles[0], 0.8, 1e-9);
  EXPECT_NEAR(split.left_rad, 0.2, 1e-9);
}

}  // namespace
}  // namespace gaitwright
