// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planning/plan/carried_plan.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/left_out_internal.h"

namespace gaitwright {
namespace {

constexpr int kRowsOfCase = 601;  // of 10 ms

/// Stands for 2 s, moves forward by 0.5 m and turns by 0.4 rad in the air until 4 s, and stands for 2 s.
EvenMotion Leap(const RobotModel& model) {
  EvenMotion motion = synthetic::Standing(model, kRowsOfCase);
  for (int k = 0; k < kRowsOfCase; ++k) {
    const double share = std::clamp((k - 200) / 200.0, 0.0, 1.0);
    const Pose there = PoseOf({0.5 * share, 0.1 * share, 0.4 * share});
    motion.q[static_cast<std::size_t>(k)] = CarriedState(there, motion.q[static_cast<std::size_t>(k)]);
    motion.contact.push_back(k < 200 || k > 400 ? AllFeet(static_cast<int>(model.legs.size())) : 0U);
  }
  return motion;
}

TEST(LeftOut, MovesWhatFollowsToWhereTheRobotStands) {
  for (const char* name : {"a1", "g1"}) {
    const RobotModel& model = NamedRobot(name);
    const EvenMotion motion = Leap(model);
    std::vector<LeftOutPart> parts;
    ASSERT_TRUE(LeaveOut(model, GroundKind::kFlat, motion, {3.0, 2.9}, "it flies", parts)) << name;
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_NEAR(parts[0].start_s, 1.82, 0.051);
    EXPECT_NEAR(parts[0].end_s, 4.18, 0.051);
    EXPECT_EQ(parts[0].why, "it flies");
    EXPECT_NEAR(DurationOf(parts), parts[0].end_s - parts[0].start_s, 1e-12);
    const EvenMotion kept = WithoutParts(motion, parts);
    ASSERT_EQ(kept.size(), kRowsOfCase);
    for (std::size_t k = 0; k < kept.q.size(); ++k) {
      EXPECT_LT((kept.q[k] - motion.q[0]).norm(), 1e-9) << name << " row " << k;
      EXPECT_EQ(kept.contact[k], AllFeet(static_cast<int>(model.legs.size())));
    }
    // The ghost shows the leap, from the place where the robot stands.
    EXPECT_LT((PostureOfFile(motion, parts, 3.0, kept.q[300]) - motion.q[300]).norm(), 1e-9);
    EXPECT_EQ(PostureOfFile(motion, parts, 5.0, kept.q[500]), kept.q[500]);
  }
}

TEST(LeftOut, PassesSmoothlyBetweenPostures) {
  const RobotModel& model = NamedRobot("g1");
  EvenMotion motion = Leap(model);
  const int arm = model.num_dofs() - 1;
  for (int k = 0; k < kRowsOfCase; ++k) motion.q[static_cast<std::size_t>(k)][7 + arm] = 0.3 * std::sin(0.02 * k);
  std::vector<LeftOutPart> parts;
  ASSERT_TRUE(LeaveOut(model, GroundKind::kFlat, motion, {3.0}, "", parts));
  const EvenMotion kept = WithoutParts(motion, parts);
  double largest = 0.0;
  for (std::size_t k = 2; k < kept.q.size(); ++k) {
    const double a = (kept.q[k][7 + arm] - 2.0 * kept.q[k - 1][7 + arm] + kept.q[k - 2][7 + arm]) / 1e-4;
    largest = std::max(largest, std::abs(a));
  }
  EXPECT_LT(largest, 6.0) << "[rad/s^2]; the file has 1.2, a jump of the speed would have 30";
  EXPECT_EQ(kept.q[100], motion.q[100]);
  EXPECT_NEAR(kept.q[550][7 + arm], motion.q[550][7 + arm], 1e-12);
}

TEST(LeftOut, LeavesOutAnEndAfterWhichTheRobotDoesNotStandAlike) {
  const RobotModel& model = NamedRobot("g1");
  EvenMotion motion = Leap(model);
  const int hip = model.joints[static_cast<std::size_t>(model.legs[0].joints[1])].dof;
  for (std::size_t k = 400; k < motion.q.size(); ++k) motion.q[k][7 + hip] += 0.3;  // one foot stands elsewhere
  std::vector<LeftOutPart> parts;
  ASSERT_TRUE(LeaveOut(model, GroundKind::kFlat, motion, {3.5}, "", parts));
  ASSERT_EQ(parts.size(), 1U);
  const bool at_end = parts[0].end_s == motion.TimeOf(kRowsOfCase - 1);
  EXPECT_TRUE(at_end || parts[0].start_s == 0.0);
  const EvenMotion kept = WithoutParts(motion, parts);
  const VectorX& stands = at_end ? kept.q.front() : kept.q.back();
  for (const VectorX& q : kept.q) EXPECT_LT((q - stands).norm(), 1e-9);
}

TEST(LeftOut, DoesNotMoveAMotionOnUnevenGround) {
  const RobotModel& model = NamedRobot("a1");
  std::vector<LeftOutPart> parts;
  ASSERT_TRUE(LeaveOut(model, GroundKind::kUneven, Leap(model), {3.5}, "", parts));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].moved.isApprox(Pose::Identity()));
  EXPECT_TRUE(parts[0].start_s == 0.0 || parts[0].end_s == 6.0) << "only one of both ends is kept";
}

TEST(LeftOut, JoinsPartsThatAreNear) {
  const RobotModel& model = NamedRobot("a1");
  const EvenMotion motion = synthetic::Standing(model, 1001);
  EvenMotion stands = motion;
  stands.contact.assign(1001, AllFeet(4));
  std::vector<LeftOutPart> parts;
  ASSERT_TRUE(LeaveOut(model, GroundKind::kFlat, stands, {2.0, 7.0}, "first", parts));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_LT(parts[0].end_s, parts[1].start_s);
  ASSERT_TRUE(LeaveOut(model, GroundKind::kFlat, stands, {3.0}, "second", parts));
  ASSERT_EQ(parts.size(), 2U) << "the second is near the first";
  EXPECT_LE(parts[0].start_s, 1.6 + 1e-9);
  EXPECT_GE(parts[0].end_s, 3.4 - 1e-9);
  ASSERT_TRUE(LeaveOut(model, GroundKind::kFlat, stands, {2.5}, "third", parts));
  EXPECT_LT(parts[0].start_s, 1.6) << "a part that fails again becomes longer";
  EXPECT_GT(parts[0].end_s, 3.4);
}

TEST(LeftOut, PartsThatAreTooLongAreReported) {
  const std::string text = LostText({{0.5, 1.5, Pose::Identity(), ""}, {2.0, 4.0, Pose::Identity(), ""}}, 5.0);
  for (const char* part : {"0.50 to 1.50 s", "2.00 to 4.00 s", "60 %"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(LeftOut, IsNothingWhereTheRobotNeverStands) {
  const RobotModel& model = NamedRobot("a1");
  EvenMotion flies = synthetic::Standing(model, 101);
  flies.contact.assign(101, 0U);
  std::vector<LeftOutPart> parts;
  EXPECT_FALSE(LeaveOut(model, GroundKind::kFlat, flies, {0.5}, "", parts));
  EXPECT_TRUE(parts.empty());
}

}  // namespace
}  // namespace gaitwright
