// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/other_contacts_internal.h"

namespace gaitwright {
namespace {

std::vector<OtherContact> OthersOf(const RobotModel& model, const EvenMotion& motion, double height_m = 0.0) {
  return FindOtherContacts(model, FlatTerrain(), motion, height_m, {});
}

TEST(OtherContacts, AreNoneOfAStandingRobot) {
  for (const char* name : {"a1", "g1", "nao", "h1"}) {
    const RobotModel& model = NamedRobot(name);
    EXPECT_TRUE(OthersOf(model, synthetic::Standing(model, 100)).empty()) << name;
  }
}

TEST(OtherContacts, AreThoseOfARobotThatKneels) {
  const RobotModel& model = NamedRobot("g1");
  EvenMotion motion = synthetic::Standing(model, 400);
  const VectorX stands = motion.q.front();
  VectorX kneels = stands;
  for (const Leg& leg : model.legs) {
    const auto dof = [&](int joint) { return 7 + model.joints[static_cast<std::size_t>(joint)].dof; };
    kneels[dof(leg.joints.front())] = 0.0;
    kneels[dof(leg.knee_joint)] = 1.7;
  }
  kneels[2] = 0.40;  // shanks are level, and their middle is in the ground
  for (int k = 100; k < 250; ++k) motion.q[static_cast<std::size_t>(k)] = kneels;
  const std::vector<OtherContact> others = OthersOf(model, motion);
  ASSERT_GE(others.size(), 2U);
  EXPECT_TRUE(
      std::ranges::any_of(others, [](const OtherContact& c) { return c.link.find("knee") != std::string::npos; }));
  for (const OtherContact& contact : others) {
    EXPECT_NEAR(contact.start_s, 1.0, 0.06);
    EXPECT_NEAR(contact.end_s, 2.45, 0.06);
  }
  for (VectorX& q : motion.q) q[2] += 0.3;
  EXPECT_TRUE(OthersOf(model, motion).empty()) << "high above the ground";
  EXPECT_EQ(OthersOf(model, motion, 0.3).size(), others.size()) << "feet that stand float as high";
}

}  // namespace
}  // namespace gaitwright
