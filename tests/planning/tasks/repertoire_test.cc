// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/repertoire.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/upper_body.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

std::string OptionOf(const PostureMotion& motion, const std::string& key) {
  for (const auto& [name, text] : motion.options) {
    if (name == key) return text;
  }
  return "none";
}

/// Whether two keys have the same posture, at any times.
bool SamePosture(const PostureKey& a, const PostureKey& b) {
  return (a.shift - b.shift).norm() < 1e-12 && (a.turn_rad - b.turn_rad).norm() < 1e-12 &&
         (a.joints - b.joints).norm() < 1e-12;
}

/// The first key of a test: standing, moved a little.
PostureKey Shifted(const RobotModel& model) {
  PostureKey key = StandingKey(model);
  key.shift = Vector3(0.01, -0.005, -0.02);
  key.after_s = 7.0;  // ignored
  return key;
}

class RepertoireTest : public testing::TestWithParam<const char*> {};

TEST_P(RepertoireTest, WhatComesBackBeginsAndEndsWithTheKeyItIsGiven) {
  const RobotModel& model = NamedRobot(GetParam());
  const PostureKey from = Shifted(model);
  for (const PostureMotion& motion :
       {Hold(from, 1.0), Squat(model, from, 0.03, 2, 0.5), Bow(model, from, 0.2, 0.01, 1), Nod(model, from, 2)}) {
    EXPECT_EQ(motion.keys.front().after_s, 0.0) << motion.name;
    EXPECT_TRUE(SamePosture(motion.keys.front(), from)) << motion.name;
    EXPECT_TRUE(SamePosture(motion.keys.back(), from)) << motion.name;
    EXPECT_NO_THROW(CheckPostureMotion(model, motion));
    for (std::size_t k = 1; k < motion.keys.size(); ++k) EXPECT_GT(motion.keys[k].after_s, 0.0);
  }
}

TEST_P(RepertoireTest, ASquatGoesDownAndUpAsOftenAsAsked) {
  const RobotModel& model = NamedRobot(GetParam());
  const PostureKey from = Shifted(model);
  const PostureMotion motion = Squat(model, from, 0.04, 3, 0.7);
  int lows = 0;
  for (std::size_t k = 1; k < motion.keys.size(); ++k) {
    const double down = from.shift.z() - motion.keys[k].shift.z();
    EXPECT_TRUE(std::abs(down) < 1e-12 || std::abs(down - 0.04) < 1e-12) << k;
    const bool stays = SamePosture(motion.keys[k], motion.keys[k - 1]);
    if (down < 0.02 || stays) continue;
    ++lows;
    EXPECT_DOUBLE_EQ(motion.keys[k + 1].after_s, 0.7) << "it stays low";
  }
  EXPECT_EQ(lows, 3);
  EXPECT_EQ(OptionOf(motion, "times"), "3");
  EXPECT_EQ(OptionOf(motion, "depth_m"), "0.04");
}

TEST_P(RepertoireTest, FarMovesTakeTheRootOfTheirLengthAndShortOnesTheLeast) {
  const RobotModel& model = NamedRobot(GetParam());
  const PostureKey from = StandingKey(model);
  const auto time_of = [&](double depth_m) { return Squat(model, from, depth_m, 1, 0.0).keys[1].after_s; };
  EXPECT_NEAR(time_of(0.8), 2.0 * time_of(0.2), 1e-9);
  EXPECT_NEAR(time_of(1e-4), time_of(2e-4), 1e-12);
  EXPECT_GE(time_of(0.2), time_of(1e-4));
}

TEST_P(RepertoireTest, TheBodyIsNeverAcceleratedByMoreThanATenthOfGravity) {
  const RobotModel& model = NamedRobot(GetParam());
  const PostureMotion motion = Squat(model, StandingKey(model), 0.3 * model.leg_length_m(), 1, 0.3);
  PostureSample sample;
  double strongest = 0.0;
  for (double t = 0.0; t < motion.duration_s(); t += 0.01) {
    SampleAt(motion, t, sample);
    strongest = std::max(strongest, std::abs(sample.shift[2].acceleration));
  }
  EXPECT_LT(strongest, 0.1 * kGravity * 1.001);
  EXPECT_GT(strongest, 0.05 * kGravity);
}

TEST_P(RepertoireTest, ABowTipsForwardAndABraceIsTwiceAsFastAsASquat) {
  const RobotModel& model = NamedRobot(GetParam());
  const PostureKey from = StandingKey(model);
  const PostureMotion bow = Bow(model, from, 0.3, 0.02, 1);
  EXPECT_DOUBLE_EQ(bow.keys[1].turn_rad.y(), 0.3);
  EXPECT_DOUBLE_EQ(bow.keys[1].shift.z(), -0.02);
  const PostureMotion brace = Brace(model, from, 0.05, 2.0), squat = Squat(model, from, 0.05, 1, 2.0);
  EXPECT_NEAR(brace.keys[1].after_s, 0.5 * squat.keys[1].after_s, 1e-12);
  EXPECT_TRUE(SamePosture(brace.keys.back(), brace.keys[1])) << "it stays low";
  EXPECT_DOUBLE_EQ(brace.keys.back().after_s, 2.0);
}

TEST_P(RepertoireTest, GoingToAKeyEndsThereAndStaysAWhile) {
  const RobotModel& model = NamedRobot(GetParam());
  const PostureKey sitting = SittingKey(model, 0.4, 0.06);
  EXPECT_DOUBLE_EQ(sitting.turn_rad.y(), -0.4) << "tipped back";
  EXPECT_DOUBLE_EQ(sitting.shift.z(), -0.06);
  const PostureMotion motion = GoTo(model, "sit", StandingKey(model), sitting);
  EXPECT_EQ(motion.name, "sit");
  ASSERT_EQ(motion.keys.size(), 3U);
  EXPECT_TRUE(SamePosture(motion.keys[1], sitting));
  EXPECT_TRUE(SamePosture(motion.keys[2], sitting));
}

INSTANTIATE_TEST_SUITE_P(Robots, RepertoireTest, testing::Values("a1", "nao"));

TEST(Nod, MovesTheHeadOrElseTheBody) {
  const RobotModel &nao = NamedRobot("nao"), &a1 = NamedRobot("a1");
  const PostureMotion with_head = Nod(nao, StandingKey(nao), 1), with_body = Nod(a1, StandingKey(a1), 1);
  EXPECT_EQ(OptionOf(with_head, "with"), "head");
  EXPECT_EQ(with_head.keys[1].turn_rad.norm(), 0.0);
  EXPECT_GT((with_head.keys[1].joints - nao.standing_joints).norm(), 0.1);
  EXPECT_EQ(OptionOf(with_body, "with"), "body");
  EXPECT_GT(with_body.keys[1].turn_rad.y(), 0.05);
  EXPECT_TRUE(with_body.keys[1].joints == a1.standing_joints);
}

TEST(ArmsOfRepertoire, LoweringUndoesRaisingAndSidesAreTheirOwn) {
  const RobotModel& nao = NamedRobot("nao");
  const PostureKey from = StandingKey(nao);
  const UpperBody upper = FindUpperBody(nao);
  ASSERT_TRUE(upper.left_arm && upper.right_arm);
  const Result<PostureMotion> raised = RaiseArms(nao, from, {true, false});
  ASSERT_TRUE(raised.ok()) << raised.failure().message;
  const VectorX moved = raised->keys.back().joints - from.joints;
  double left = 0.0;
  for (const int dof : upper.left_arm->dofs) left += std::abs(moved[dof]);
  EXPECT_GT(left, 0.5);
  for (const int dof : upper.right_arm->dofs) EXPECT_EQ(moved[dof], 0.0);
  EXPECT_EQ(OptionOf(*raised, "side"), "left");
  const Result<PostureMotion> lowered = LowerArms(nao, raised->keys.back(), {true, false});
  ASSERT_TRUE(lowered.ok());
  EXPECT_LT((lowered->keys.back().joints - from.joints).norm(), 1e-12);
}

TEST(ArmsOfRepertoire, AWaveGoesToBothSidesAndComesBack) {
  const RobotModel& nao = NamedRobot("nao");
  const Result<PostureMotion> wave = WaveArms(nao, StandingKey(nao), {false, true}, 3);
  ASSERT_TRUE(wave.ok()) << wave.failure().message;
  EXPECT_EQ(wave->keys.size(), 10U) << "from, up, three times to both sides, up, back";
  EXPECT_TRUE(SamePosture(wave->keys.front(), wave->keys.back()));
  EXPECT_TRUE(SamePosture(wave->keys[2], wave->keys[4]));
  EXPECT_FALSE(SamePosture(wave->keys[2], wave->keys[3]));
}

TEST(ArmsOfRepertoire, ARobotWithoutArmsIsReported) {
  const RobotModel& a1 = NamedRobot("a1");
  for (const Result<PostureMotion>& motion :
       {RaiseArms(a1, StandingKey(a1), {true, false}), LowerArms(a1, StandingKey(a1), {false, true}),
        WaveArms(a1, StandingKey(a1), {true, true}, 2)}) {
    ASSERT_FALSE(motion.ok());
    EXPECT_EQ(motion.failure().kind, FailureKind::kBadInput);
    EXPECT_EQ(motion.failure().code, FailureCode::kNoArm);
  }
}

TEST(BalanceOn, BringsTheCentreOfMassOverTheFootThatStays) {
  const RobotModel& nao = NamedRobot("nao");
  DynamicsScratch scratch(nao);
  ForwardKinematics(nao, StandingConfiguration(nao), scratch);
  const Vector3 p_WC = CentreOfMass(nao, scratch);
  for (const int on : {0, 1}) {
    const Result<PostureMotion> motion = BalanceOn(nao, StandingKey(nao), on, 0.0, 2.0);
    ASSERT_TRUE(motion.ok()) << motion.failure().message;
    ASSERT_EQ(motion->lifts.size(), 1U);
    const FootLift& lift = motion->lifts[0];
    EXPECT_EQ(lift.foot, 1 - on);
    const Vector3 p_WF = ContactFrame(nao, scratch, on).translation();
    for (const std::size_t key : {lift.from_key, lift.to_key}) {
      const Vector3 over = p_WC + motion->keys[key].shift;
      EXPECT_LT((over - p_WF).head<2>().norm(), 1e-9);
    }
    EXPECT_DOUBLE_EQ(motion->TimeOf(lift.to_key) - motion->TimeOf(lift.from_key), 2.0);
    EXPECT_TRUE(SamePosture(motion->keys.back(), StandingKey(nao)));
  }
  const double inward = BalanceOn(nao, StandingKey(nao), 0, 0.1, 2.0)->keys[1].shift.y();
  const double middle = BalanceOn(nao, StandingKey(nao), 0, 0.0, 2.0)->keys[1].shift.y();
  EXPECT_LT(inward, middle) << "less far to the left";
}

TEST(BalanceOn, IsForTwoFeetWithSoles) {
  const RobotModel& a1 = NamedRobot("a1");
  const Result<PostureMotion> motion = BalanceOn(a1, StandingKey(a1), 0, 0.0, 1.0);
  ASSERT_FALSE(motion.ok());
  EXPECT_EQ(motion.failure().code, FailureCode::kTwoFeet);
}

}  // namespace
}  // namespace gaitwright
