// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/contact_split.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

std::vector<ContactPoint> Rectangle(double half_x, double half_y) {
  std::vector<ContactPoint> contacts;
  for (const double x : {-half_x, half_x}) {
    for (const double y : {-half_y, half_y}) contacts.push_back({Vector3(x, y, 0.0), Vector3::UnitZ(), 0.6, 1.0});
  }
  return contacts;
}

double ConeExcess(const ContactPoint& contact, const Vector3& force) {
  return force.head<2>().norm() - contact.friction * force.z();
}

TEST(ContactSplit, GivesAWrenchThatTheConesAllow) {
  const auto contacts = Rectangle(0.2, 0.1);
  ContactSplit split;
  ContactSplitter().Solve(contacts, {Vector3(0.05, 0.02, 0.3), Vector3(10.0, -5.0, 100.0), Vector3(1.0, 2.0, 0.5)},
                          split);
  EXPECT_LT(split.residual_force_W.norm(), 1e-5);
  EXPECT_LT(split.residual_moment_W.norm(), 1e-5);
  for (std::size_t i = 0; i < contacts.size(); ++i) EXPECT_LE(ConeExcess(contacts[i], split.force_W[i]), 1e-9);
}

TEST(ContactSplit, StaysInsideTheConesWhenAskedForTooMuch) {
  const auto contacts = Rectangle(0.2, 0.1);
  ContactSplit split;
  ContactSplitter().Solve(contacts, {Vector3::Zero(), Vector3(100.0, 0.0, 100.0), Vector3::Zero()}, split);
  EXPECT_GT(split.residual_force_W.norm(), 1.0);
  for (std::size_t i = 0; i < contacts.size(); ++i) EXPECT_LE(ConeExcess(contacts[i], split.force_W[i]), 1e-9);
}

TEST(ContactSplit, TwoPointsCannotHoldTheMomentAboutTheirLine) {
  const std::vector<ContactPoint> contacts = {{Vector3(0.2, 0.0, 0.0), Vector3::UnitZ(), 0.6, 1.0},
                                              {Vector3(-0.2, 0.0, 0.0), Vector3::UnitZ(), 0.6, 1.0}};
  ContactSplit split;
  ContactSplitter().Solve(contacts, {Vector3::Zero(), Vector3(0.0, 0.0, 100.0), Vector3(3.0, 2.0, 0.0)}, split);
  EXPECT_NEAR(split.residual_moment_W.x(), 3.0, 1e-3);
  EXPECT_NEAR(split.residual_moment_W.y(), 0.0, 1e-3);
  EXPECT_LT(split.residual_force_W.norm(), 1e-3);
}

TEST(ContactSplit, AReluctantFootTakesLittle) {
  auto contacts = Rectangle(0.2, 0.1);
  contacts[3].reluctance = 1e5;
  ContactSplit split;
  ContactSplitter().Solve(contacts, {Vector3(-0.05, -0.02, 0.0), Vector3(0.0, 0.0, 100.0), Vector3::Zero()}, split);
  EXPECT_LT(split.force_W[3].norm(), 0.1);
  EXPECT_LT(split.residual_moment_W.norm(), 1e-4);
}

TEST(ContactSplit, IsContinuousWhereACornerLetsGo) {
  const auto contacts = Rectangle(0.2, 0.1);
  ContactSplitter splitter;
  ContactSplit split;
  std::vector<Vector3> last;
  double largest = 0.0;
  for (int i = 0; i <= 180; ++i) {
    splitter.Solve(contacts, {Vector3(0.001 * i, 0.0005 * i, 0.0), Vector3(5.0, 0.0, 100.0), Vector3::Zero()}, split);
    for (std::size_t c = 0; c < last.size(); ++c) largest = std::max(largest, (split.force_W[c] - last[c]).norm());
    last = split.force_W;
  }
  EXPECT_LT(largest, 1.5);  // [N] for a millimetre
  EXPECT_NEAR(last[0].norm(), 0.0, 1.0);
}

TEST(ContactSplit, RefusesNoContact) {
  ContactSplit split;
  EXPECT_THROW(ContactSplitter().Solve({}, {}, split), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
