// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/stability/holdable_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/actuator.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

/// Lowest and highest corner coordinates.
std::pair<Vector2, Vector2> Extent(const Polygon& polygon) {
  std::pair<Vector2, Vector2> extent = {polygon[0], polygon[0]};
  for (const Vector2& corner : polygon) {
    extent.first = extent.first.cwiseMin(corner);
    extent.second = extent.second.cwiseMax(corner);
  }
  return extent;
}

/// NAO in its standing posture on one foot.
class HoldableSupportTest : public ::testing::TestWithParam<int> {
 protected:
  HoldableSupportTest() {
    ForwardKinematics(model_, StandingConfiguration(model_), scratch_);
    p_WC_ = CentreOfMass(model_, scratch_);
    for (const Vector3& corner : ContactPoints(model_, scratch_, GetParam())) sole_.push_back(corner.head<2>());
    sole_ = ConvexHull(sole_);
  }

  Polygon Held(double use) const {
    return HoldableSupport(model_, scratch_, GetParam(), sole_, {p_WC_, model_.weight_n()}, use);
  }

  /// Largest share of a motor's limit over the revolute joints below half of the height of C. By virtual work: the
  /// torques are J^T f, with the force through Z and C on the foot.
  double Effort(const Vector2& zmp) const { return Effort(model_, zmp); }
  double Effort(const RobotModel& model, const Vector2& zmp) const {
    const double ground = ContactFrame(model_, scratch_, GetParam()).translation().z();
    const Vector3 p_WZ(zmp.x(), zmp.y(), ground);
    const Vector3 force = (p_WC_ - p_WZ) * model_.weight_n() / (p_WC_.z() - ground);
    VectorX tau = VectorX::Zero(model_.nv());
    AddPointForce(model_, scratch_, model_.feet[static_cast<std::size_t>(GetParam())].body, p_WZ, force, tau);
    VectorX near = VectorX::Zero(model.num_dofs());
    for (const int index : model_.legs[static_cast<std::size_t>(GetParam())].joints) {
      const auto joint = static_cast<std::size_t>(index);
      if (scratch_.p_WB[joint + 1].z() - ground > 0.5 * (p_WC_.z() - ground)) continue;
      if (scratch_.axis_W[joint].head<2>().norm() < 0.5) continue;
      const int dof = model_.joints[joint].dof;
      near[dof] = tau[6 + dof];
    }
    const double most = LargestEffortUse(model, near).share;
    return most;
  }

  const RobotModel model_ = Robot("nao");
  DynamicsScratch scratch_{model_};
  Vector3 p_WC_;
  Polygon sole_;
};

TEST_P(HoldableSupportTest, IsWhereTheTorquesOfVirtualWorkHold) {
  constexpr double kUse = 0.8;
  const Polygon held = Held(kUse);
  ASSERT_GE(held.size(), 3U);
  int inside = 0, outside = 0;
  for (double u = 0.01; u < 1.0; u += 0.02) {
    for (double w = 0.01; w < 1.0; w += 0.02) {
      const auto [low, high] = Extent(sole_);
      const Vector2 zmp = low + Vector2(u, w).cwiseProduct(high - low);
      if (SignedDistance(sole_, zmp) <= 0.0) continue;
      const double distance = SignedDistance(held, zmp);
      if (std::abs(distance) < 1e-6) continue;
      EXPECT_EQ(distance > 0.0, Effort(zmp) <= kUse) << zmp.transpose();
      ++(distance > 0.0 ? inside : outside);
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100) << "the ankles hold the robot everywhere: this tests nothing";
}

TEST_P(HoldableSupportTest, OfMotorsOfATransmissionIsWhereTheirTorquesHold) {
  constexpr double kUse = 0.8;
  RobotModel driven = model_;
  const std::vector<int>& joints = model_.legs[static_cast<std::size_t>(GetParam())].joints;
  Transmission ankle{.name = "ankle", .dofs = {}, .motors = {}, .ratios = MatrixX(2, 2), .inverse = {}};
  ankle.ratios << 1.0, 1.0, 1.0, -1.0;
  for (std::size_t i = joints.size() - 2; i < joints.size(); ++i) {
    ankle.dofs.push_back(model_.joints[static_cast<std::size_t>(joints[i])].dof);
    ankle.motors.push_back({.name = "motor", .effort_limit = 0.6 * model_.dof_effort_limit(ankle.dofs.back())});
  }
  AddTransmission(ankle, driven);
  const Polygon held = HoldableSupport(driven, scratch_, GetParam(), sole_, {p_WC_, driven.weight_n()}, kUse);
  ASSERT_GE(held.size(), 3U);
  int inside = 0, outside = 0, others = 0;
  for (double u = 0.01; u < 1.0; u += 0.02) {
    for (double w = 0.01; w < 1.0; w += 0.02) {
      const auto [low, high] = Extent(sole_);
      const Vector2 zmp = low + Vector2(u, w).cwiseProduct(high - low);
      const double distance = SignedDistance(held, zmp);
      if (SignedDistance(sole_, zmp) <= 0.0 || std::abs(distance) < 1e-6) continue;
      EXPECT_EQ(distance > 0.0, Effort(driven, zmp) <= kUse) << zmp.transpose();
      ++(distance > 0.0 ? inside : outside);
      others += (Effort(zmp) <= kUse) != (distance > 0.0);
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100);
  EXPECT_GT(others, 50) << "boxes of the joints say otherwise";
}

TEST_P(HoldableSupportTest, LiesInTheSoleAndGrowsWithTheTorque) {
  Polygon smaller = Held(0.1);
  EXPECT_LT(Area(smaller), 0.5 * Area(sole_));
  for (double use = 0.2; use < 3.0; use += 0.1) {
    const Polygon held = Held(use);
    for (const Vector2& corner : held) EXPECT_GE(SignedDistance(sole_, corner), -1e-12);
    for (const Vector2& corner : smaller) EXPECT_GE(SignedDistance(held, corner), -1e-12) << use;
    EXPECT_GE(Area(held), Area(smaller) - 1e-12);
    smaller = held;
  }
  EXPECT_EQ(Held(100.0), sole_);
}

TEST_P(HoldableSupportTest, HalfTheLoadIsTwiceTheTorque) {
  const Polygon light = HoldableSupport(model_, scratch_, GetParam(), sole_, {p_WC_, 0.5 * model_.weight_n()}, 0.3);
  EXPECT_NEAR(Area(light), Area(Held(0.6)), 1e-12);
  EXPECT_GT(Area(light), Area(Held(0.3)) + 1e-6);
}

TEST_P(HoldableSupportTest, AJointThatLeavesNothingIsPassedOver) {
  Polygon far = sole_;
  for (Vector2& corner : far) corner.x() += 1.0;
  const auto held = Extent(HoldableSupport(model_, scratch_, GetParam(), far, {p_WC_, model_.weight_n()}, 0.5));
  EXPECT_NEAR(held.first.x(), Extent(far).first.x(), 1e-12) << "no pitch torque holds so far ahead";
  EXPECT_NEAR(held.second.x(), Extent(far).second.x(), 1e-12);
  EXPECT_LT(held.second.y() - held.first.y(), Extent(far).second.y() - Extent(far).first.y() - 1e-3) << "roll does";
}

TEST_P(HoldableSupportTest, WhatHasNoAreaIsGivenBack) {
  const Polygon line = {sole_[0], sole_[1]}, point = {sole_[0]};
  for (const Polygon& support : {line, point, Polygon()}) {
    EXPECT_EQ(HoldableSupport(model_, scratch_, GetParam(), support, {p_WC_, model_.weight_n()}, 0.01), support);
  }
}

INSTANTIATE_TEST_SUITE_P(Feet, HoldableSupportTest, ::testing::Values(0, 1),
                         [](const auto& i) { return i.param == 0 ? "first" : "second"; });

TEST(HoldableSupport, OfMirroredFeetIsMirrored) {
  const RobotModel nao = Robot("nao");
  DynamicsScratch scratch(nao);
  ForwardKinematics(nao, StandingConfiguration(nao), scratch);
  Vector3 p_WC = CentreOfMass(nao, scratch);
  p_WC.y() = 0.0;
  double area[2];
  Vector2 centre[2];
  for (int foot = 0; foot < 2; ++foot) {
    Polygon sole;
    for (const Vector3& corner : ContactPoints(nao, scratch, foot)) sole.push_back(corner.head<2>());
    const Polygon held = HoldableSupport(nao, scratch, foot, ConvexHull(sole), {p_WC, nao.weight_n()}, 0.5);
    area[foot] = Area(held);
    centre[foot] = Centroid(held);
  }
  EXPECT_NEAR(area[0], area[1], 1e-2 * area[0]);
  EXPECT_NEAR(centre[0].x(), centre[1].x(), 1e-3);
  EXPECT_NEAR(centre[0].y(), -centre[1].y(), 1e-3);
  EXPECT_GT(std::abs(centre[0].y()), 0.01);
}

}  // namespace
}  // namespace gaitwright
