// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/bad_times_internal.h"

namespace gaitwright {
namespace {

/// A plan that stands for 4 s, of a file whose times are half of the plan's.
struct Case {
  RobotModel model = NamedRobot("a1");
  MotionFindings findings;
  RepairedMotion repaired;

  Case() {
    findings.rested.motion = synthetic::Standing(model, 401);
    for (int k = 0; k <= 400; ++k) findings.rested.file_s.push_back(0.005 * k);
    findings.clean.motion = synthetic::Standing(model, 401);
    const EvenMotion stands = synthetic::Standing(model, 401);
    repaired.plan.whole_body = {0.0, 0.01, stands.q, stands.v, stands.a, {}, {}};
  }
  BadTimes Bad(const PlanProof& proof = {}) const { return BadTimesOf({}, findings, repaired, {}, proof); }
};

TEST(BadTimes, ThereAreNoneForASoundPlan) {
  const Case sound;
  EXPECT_TRUE(sound.Bad().file_s.empty());
  const BadTimes played = sound.Bad([](const MotionPlan&) { return PlayProof{}; });
  EXPECT_TRUE(played.file_s.empty());
  EXPECT_TRUE(played.played);
}

TEST(BadTimes, AreThoseWithoutASolution) {
  const Case sound;
  FollowReport report;
  report.unmet_s = {1.0, 1.01};
  const BadTimes bad = BadTimesOf({}, sound.findings, Failure{}, report, {});
  EXPECT_EQ(bad.file_s, (std::vector<double>{0.5, 0.505}));
  EXPECT_NE(bad.why.find("no motion was found"), std::string::npos);
}

TEST(BadTimes, AreThoseOfTheAudit) {
  Case broken;
  broken.repaired.after.violations = {{Law::kJointTorque, 3.0, "knee", 30.0, 20.0, "N m"}};
  broken.repaired.broken = {{Law::kJointTorque, 0.2, {2.0}}};
  const BadTimes bad = broken.Bad([](const MotionPlan&) { return PlayProof{false, 1.0}; });
  ASSERT_EQ(bad.file_s.size(), 2U);
  EXPECT_NEAR(bad.file_s[0], 1.5, 1e-9);
  EXPECT_NEAR(bad.file_s[1], 1.25, 1e-9) << "the middle of the second";
  EXPECT_FALSE(bad.played);
}

TEST(BadTimes, AreThoseFarFromTheMotion) {
  Case far;
  for (std::size_t k = 100; k < 200; ++k) far.findings.clean.motion.q[k].tail(12).array() += 0.2;
  const BadTimes bad = far.Bad();
  ASSERT_FALSE(bad.file_s.empty());
  const auto [first, last] = std::minmax_element(bad.file_s.begin(), bad.file_s.end());
  EXPECT_NEAR(*first, 0.5, 0.06);
  EXPECT_NEAR(*last, 1.0, 0.06);
  EXPECT_NE(bad.why.find("could not keep to the motion"), std::string::npos);
}

TEST(BadTimes, AreTheSecondBeforeAFall) {
  const Case falls;
  const BadTimes bad = falls.Bad([](const MotionPlan&) { return PlayProof{false, 3.0}; });
  ASSERT_FALSE(bad.file_s.empty());
  EXPECT_NEAR(bad.file_s.front(), 1.0, 1e-9);
  EXPECT_NEAR(bad.file_s.back(), 1.5, 0.06);
  EXPECT_TRUE(falls.Bad([](const MotionPlan&) { return PlayProof{false, {}}; }).file_s.empty()) << "nobody knows when";
}

}  // namespace
}  // namespace gaitwright
