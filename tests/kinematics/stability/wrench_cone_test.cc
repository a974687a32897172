// SPDX-License-Identifier: BSD-3-Clause
// The margin is compared with that of the ZMP on level ground, and with the split of the wrench over the contacts on
// other ground.
#include "kinematics/stability/wrench_cone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kinematics/base/result.h"
#include "kinematics/stability/polygon.h"
#include "kinematics/stability/zero_moment_point.h"

namespace gaitwright {
namespace {

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double In(double low, double high) { return low + (high - low) * uniform_(random_); }
  Vector3 Box(const Vector3& half) {
    const double x = In(-half.x(), half.x()), y = In(-half.y(), half.y()), z = In(-half.z(), half.z());
    return {x, y, z};
  }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

TEST(WrenchConeMargin, IsTheDistanceOfTheZmpOnLevelGround) {
  Numbers numbers(1);
  int inside = 0, outside = 0;
  for (int k = 0; k < 200; ++k) {
    std::vector<ContactPoint> contacts;
    std::vector<Vector2> corners;
    for (int i = 0; i < 3 + k % 5; ++i) {
      contacts.push_back({numbers.Box({0.3, 0.2, 0.0}), Vector3::UnitZ(), 5.0, 1.0});
      corners.push_back(contacts.back().p_W.head<2>());
    }
    const PointWrench wrench{Vector3(0.02, -0.03, 0.3), numbers.Box({20.0, 20.0, 0.0}) + Vector3(0.0, 0.0, 100.0),
                             numbers.Box({15.0, 15.0, 0.0})};
    const Polygon support = ConvexHull(corners);
    if (Area(support) < 0.01) continue;
    const Vector2 zmp = ZeroMomentPoint(wrench.p_W, wrench.force_W, wrench.moment_W, 0.0);
    const double expected = SignedDistance(support, zmp);
    // Friction can give moments about the vertical only if forces press on both sides.
    EXPECT_NEAR(WrenchConeMargin(contacts, wrench), expected, expected > 0.0 ? 0.02 * 0.3 + 1e-3 : 0.01) << k;
    (expected > 0.0 ? inside : outside) += 1;
  }
  EXPECT_GT(inside, 20);
  EXPECT_GT(outside, 20);
}

TEST(WrenchConeMargin, IsExactWhereNothingTurns) {
  std::vector<ContactPoint> contacts;
  for (const double x : {-0.2, 0.2}) {
    for (const double y : {-0.1, 0.1}) contacts.push_back({Vector3(x, y, 0.0), Vector3::UnitZ(), 0.6, 1.0});
  }
  const auto at = [&](double x, double y) {
    return WrenchConeMargin(contacts, {Vector3(x, y, 0.4), Vector3(0.0, 0.0, 50.0), Vector3::Zero()});
  };
  EXPECT_NEAR(at(0.0, 0.0), 0.1, 1e-6);
  EXPECT_NEAR(at(0.15, 0.02), 0.05, 1e-6);
  EXPECT_NEAR(at(0.25, 0.0), -0.05, 1e-6);
  EXPECT_NEAR(at(0.23, 0.14), -0.05, 1e-6);
  const PointWrench slips{Vector3(0.0, 0.0, 0.4), Vector3(31.0, 0.0, 50.0), Vector3::Zero()};
  EXPECT_EQ(WrenchConeMargin(contacts, slips), -std::numeric_limits<double>::infinity());
}

TEST(WrenchConeMargin, OfTwoPointsIsTheDistanceToTheirLine) {
  const std::vector<ContactPoint> contacts = {{Vector3(0.2, 0.1, 0.0), Vector3::UnitZ(), 0.6, 1.0},
                                              {Vector3(-0.2, -0.1, 0.05), Vector3::UnitZ(), 0.6, 1.0}};
  const Vector2 across = Vector2(-0.1, 0.2).normalized();
  for (const double off : {0.0, 0.01, -0.03}) {
    const Vector2 at = off * across;
    const PointWrench wrench{Vector3(at.x(), at.y(), 0.3), Vector3(0.0, 0.0, 50.0), Vector3::Zero()};
    EXPECT_NEAR(WrenchConeMargin(contacts, wrench), -std::abs(off), 1e-5);
  }
}

/// Remaining part of a wrench after its split over the contacts, as a share of its force.
double LeftBySplit(const std::vector<ContactPoint>& contacts, const PointWrench& wrench) {
  ContactSplit split;
  ContactSplitter().Solve(contacts, wrench, split);
  return std::hypot(split.residual_force_W.norm(), split.residual_moment_W.norm() / 0.3) / wrench.force_W.norm();
}

/// Independent check: the wrench with a shifted axis can be split over the contacts exactly up to the margin.
TEST(WrenchConeMargin, IsWhereTheSplitBeginsToFailOnContactsInNoPlane) {
  Numbers numbers(5);
  const auto left = [](const std::vector<ContactPoint>& contacts, PointWrench wrench, const Vector2& shift) {
    wrench.moment_W += Vector3(shift.x(), shift.y(), 0.0).cross(wrench.force_W);
    return LeftBySplit(contacts, wrench);
  };
  int inside = 0, outside = 0;
  for (int k = 0; k < 60; ++k) {
    std::vector<ContactPoint> contacts;
    for (int i = 0; i < 4; ++i) {
      const Vector3 corner(i % 2 == 0 ? 0.25 : -0.25, i < 2 ? 0.15 : -0.15, 0.0);
      contacts.push_back({corner + numbers.Box({0.05, 0.05, 0.1}),
                          (Vector3::UnitZ() + numbers.Box({0.3, 0.3, 0.0})).normalized(), 0.7, 1.0});
    }
    const PointWrench wrench{numbers.Box({0.3, 0.2, 0.0}) + Vector3(0.0, 0.0, 0.3),
                             numbers.Box({20.0, 20.0, 0.0}) + Vector3(0.0, 0.0, 100.0), numbers.Box({2.0, 2.0, 1.0})};
    const double margin = WrenchConeMargin(contacts, wrench);
    if (!std::isfinite(margin) || std::abs(margin) < 5e-3) continue;
    const double now = left(contacts, wrench, Vector2::Zero());
    EXPECT_EQ(margin > 0.0, now < 1e-4) << k << " margin " << margin << ", left " << now;
    (margin > 0.0 ? inside : outside) += 1;
    if (margin < 0.0) continue;
    double most = 0.0;
    for (int i = 0; i < 24; ++i) {
      const Vector2 direction(std::cos(i * M_PI / 12.0), std::sin(i * M_PI / 12.0));
      EXPECT_LT(left(contacts, wrench, 0.97 * margin * direction), 1e-4) << k;
      most = std::max(most, left(contacts, wrench, 1.1 * margin * direction));
    }
    EXPECT_GT(most, 1e-4) << k;
  }
  EXPECT_GT(inside, 8);
  EXPECT_GT(outside, 8);
}

TEST(WrenchConeMargin, HasNoEndWhereContactsPressAgainstEachOther) {
  const auto between_faces = [](double fall_rad) {
    std::vector<ContactPoint> contacts;
    for (const double x : {-0.2, 0.2}) {
      for (const double side : {1.0, -1.0}) {
        const Vector3 normal_W(0.0, -side * std::sin(fall_rad), std::cos(fall_rad));
        contacts.push_back({Vector3(x, 0.15 * side, 0.0), normal_W, 0.8, 1.0});
      }
    }
    return contacts;
  };
  for (const double lateral : {0.0, 0.4, 0.9}) {  // of the weight
    const PointWrench pushed{Vector3(0.0, 0.0, 0.3), Vector3(0.0, 100.0 * lateral, 100.0), Vector3::Zero()};
    EXPECT_GT(WrenchConeMargin(between_faces(1.2), pushed), 1.0) << lateral;
    EXPECT_LT(LeftBySplit(between_faces(1.2), pushed), 1e-4) << lateral;
    const double within_cones = WrenchConeMargin(between_faces(0.8), pushed);
    EXPECT_EQ(within_cones > 0.0, LeftBySplit(between_faces(0.8), pushed) < 1e-4) << lateral << " " << within_cones;
    EXPECT_LT(within_cones, 1.0) << lateral;
  }
}

TEST(WrenchConeMargin, RefusesWhatHasNone) {
  const std::vector<ContactPoint> contact = {{Vector3::Zero(), Vector3::UnitZ(), 0.8, 1.0}};
  EXPECT_THROW((void)WrenchConeMargin({}, {Vector3::Zero(), Vector3::UnitZ(), Vector3::Zero()}), InvalidArgument);
  EXPECT_THROW((void)WrenchConeMargin(contact, {Vector3::Zero(), -Vector3::UnitZ(), Vector3::Zero()}), InvalidArgument);
  EXPECT_THROW((void)WrenchConeMargin({{Vector3::Zero(), Vector3::UnitZ(), 0.0, 1.0}},
                                      {Vector3::Zero(), Vector3::UnitZ(), Vector3::Zero()}),
               InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
