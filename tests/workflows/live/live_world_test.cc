// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_world.h"

#include <gtest/gtest.h>

#include "kinematics/spatial/rotation.h"
#include "tests/workflows/live/made_world.h"

namespace gaitwright {
namespace {

class Live : public testing::Test {
 protected:
  explicit Live(const std::string& robot = "a1") : model_(ChooseRobot(robot, "").value()) { live_ = MadeWorld(model_); }

  void Run(double seconds) {
    for (const double end = live_->time_s() + seconds; live_->time_s() < end - 1e-9;) live_->Step();
  }
  void Ask(const WalkPace& pace) {
    live_->Ask(pace);
    live_->WaitForPlan();
    live_->Step();
    EXPECT_FALSE(live_->wanted()) << pace.gait;
    for (const std::string& note : live_->TakeNotes()) std::cout << note << "\n";
  }
  double x() const { return live_->world().q()[0]; }

  const RobotModel model_;
  std::unique_ptr<LiveWorld> live_;
};

TEST_F(Live, StandsWalksChangesItsPaceAndStops) {
  Run(0.5);
  EXPECT_EQ(live_->mode(), LiveMode::kStands);
  Ask({.gait = "trot", .speed_m_s = 0.3});
  Run(4.0);
  EXPECT_EQ(live_->mode(), LiveMode::kWalks);
  const double before = x();
  Run(2.0);
  EXPECT_NEAR(x() - before, 0.6, 0.1);
  Ask({.gait = "trot", .speed_m_s = 0.8});
  Run(4.0);
  const double fast = x();
  Run(2.0);
  EXPECT_NEAR(x() - fast, 1.6, 0.2);
  Ask({.gait = "amble", .speed_m_s = 0.4});
  Run(6.0);
  EXPECT_EQ(live_->mode(), LiveMode::kWalks);
  EXPECT_EQ(live_->pace().gait, "amble");
  Ask({.gait = "trot", .speed_m_s = 0.3, .yaw_rate_rad_s = 0.3});
  Run(6.0);
  EXPECT_EQ(live_->mode(), LiveMode::kWalks);
  live_->Ask({.gait = "stand"});
  Run(6.0);
  EXPECT_EQ(live_->mode(), LiveMode::kStands);
  const double still = x();
  Run(1.0);
  EXPECT_NEAR(x(), still, 0.01);
}

TEST_F(Live, GoesOverIntoAGaitThatFlies) {
  Ask({.gait = "bound", .speed_m_s = 0.5});
  Run(5.0);
  EXPECT_EQ(live_->mode(), LiveMode::kWalks);
  live_->Ask({.gait = "stand"});
  Run(5.0);
  EXPECT_EQ(live_->mode(), LiveMode::kStands);
}

TEST_F(Live, TurnsToAHeading) {
  live_->AskHeading(1.0);
  EXPECT_FALSE(live_->wanted()) << "it stands";
  EXPECT_EQ(live_->TakeNotes().size(), 1U);
  Ask({.gait = "trot", .speed_m_s = 0.3, .yaw_rate_rad_s = 0.3});
  Run(3.0);
  live_->AskHeading(2.0);
  live_->AskHeading(-2.0);
  live_->WaitForPlan();
  live_->Step();
  EXPECT_TRUE(live_->wanted()) << "it goes straight first, and then turns";
  while (live_->wanted()) {
    live_->WaitForPlan();
    live_->Step();
  }
  EXPECT_EQ(live_->wanted_heading_rad(), -2.0) << "it is on its way";
  Run(14.0);
  EXPECT_FALSE(live_->wanted_heading_rad());
  EXPECT_EQ(live_->mode(), LiveMode::kWalks);
  EXPECT_NEAR(YawOf(BaseRotation(live_->world().q())), -2.0, 0.1);
}

TEST_F(Live, AWalkToNowhereIsStanding) {
  Ask({.gait = "trot", .speed_m_s = 0.3});
  Run(2.0);
  live_->Ask({.gait = "trot"});
  Run(4.0);
  EXPECT_EQ(live_->mode(), LiveMode::kStands);
  const double stands_at = x();
  Run(1.0);
  EXPECT_NEAR(x(), stands_at, 1e-3);
  Ask({.gait = "trot", .yaw_rate_rad_s = 0.4});
  Run(2.0);
  live_->TakeNotes();
  live_->AskHeading(0.0);
  EXPECT_FALSE(live_->wanted()) << "there is no straight walk on the spot";
  EXPECT_EQ(live_->TakeNotes().size(), 1U);
}

TEST_F(Live, PosesAreNearAndTellNoOldForces) {
  Run(0.5);
  VectorX q = live_->world().q();
  q[2] += 0.3;
  live_->PutInPose(q);
  for (const FootContact& foot : live_->world().feet()) EXPECT_FALSE(foot.touching);
  EXPECT_TRUE(live_->pace().stands());
  q[0] += 99.0;
  live_->PutInPose(q);
  q[0] += 99.0;
  live_->PutInPose(q);  // relative to its present place
  q[0] += 101.0;
  EXPECT_THROW(live_->PutInPose(q), InvalidArgument);
  const double time_s = live_->time_s();
  live_->StandUp();
  EXPECT_EQ(live_->time_s(), time_s);
  EXPECT_NEAR(x(), 198.0, 0.1);
  Run(1.0);
  EXPECT_EQ(live_->mode(), LiveMode::kStands);
}

TEST_F(Live, AskedForMoreThanOneThingWhileItPlansItDoesThemAll) {
  Ask({.gait = "trot", .speed_m_s = 0.3});
  Run(2.0);
  live_->Ask({.gait = "trot", .speed_m_s = 0.4});
  live_->AskHeading(0.5);
  EXPECT_EQ(live_->wanted(), (WalkWish{{.gait = "trot", .speed_m_s = 0.4}, 0.5}));
  live_->AskHeading(0.7);
  live_->Ask({.gait = "trot", .speed_m_s = 0.35});
  EXPECT_EQ(live_->wanted(), (WalkWish{{.gait = "trot", .speed_m_s = 0.35}, 0.7}));
  while (live_->wanted()) {
    live_->WaitForPlan();
    live_->Step();
  }
  Run(8.0);
  EXPECT_EQ(live_->pace().speed_m_s, 0.35);
  EXPECT_NEAR(YawOf(BaseRotation(live_->world().q())), 0.7, 0.1);
}

TEST_F(Live, AnswersANudgeOfAJoint) {
  Run(0.5);
  const double before = live_->world().q()[7 + 2];
  live_->hands().Nudge(2, 0.1, live_->time_s() + 0.3);
  Run(0.3);
  EXPECT_GT(live_->world().q()[7 + 2] - before, 0.02);
  Run(1.0);
  EXPECT_NEAR(live_->world().q()[7 + 2], before, 0.01);
  EXPECT_EQ(live_->mode(), LiveMode::kStands);
  EXPECT_THROW(live_->hands().Nudge(12, 0.1, 0.3), InvalidArgument);
  EXPECT_THROW(live_->hands().Nudge(2, 4.0, 0.3), InvalidArgument);
  EXPECT_THROW(live_->hands().Nudge(2, NAN, 0.3), InvalidArgument);
}

TEST_F(Live, SamplesAreMeansSinceTheLast) {
  Run(1.0);
  live_->TakeSample();
  Run(0.05);
  const LogSample sample = live_->TakeSample();
  double up = 0.0;
  for (const ContactWrench& wrench : sample.wrenches) up += wrench.force_W.z();
  EXPECT_NEAR(up, model_.weight_n(), 0.05 * model_.weight_n());
  EXPECT_NEAR(sample.time_s, live_->time_s(), 1e-12);
}

TEST_F(Live, IsPulledAboutAndRecovers) {
  Ask({.gait = "trot", .speed_m_s = 0.3});
  Run(4.0);
  const double y = live_->world().q()[1];
  live_->hands().Pull(1, 0, Vector3::Zero(), Vector3(0.0, 0.08, 0.0));
  Run(0.3);
  EXPECT_GT(live_->hands().grips().at(0).force_W.norm(), 0.0);
  EXPECT_GT(live_->world().q()[1] - y, 0.003) << "it was moved";
  live_->hands().LetGo(1);
  Run(4.0);
  EXPECT_EQ(live_->mode(), LiveMode::kWalks);
  EXPECT_THROW(live_->hands().Pull(1, 99, Vector3::Zero(), Vector3::Zero()), InvalidArgument);
}

TEST_F(Live, AHandThatWalksAlongDoesNotHoldTheRobotBack) {
  Ask({.gait = "trot", .speed_m_s = 0.3});
  Run(4.0);
  const double x = live_->world().q()[0];
  live_->hands().Pull(1, 0, Vector3::Zero(), Vector3::Zero(), true);
  Run(3.0);
  EXPECT_GT(live_->world().q()[0] - x, 0.7) << "it has walked on";
  const double held_back_n = live_->hands().grips().at(0).force_W.norm();
  EXPECT_LT(held_back_n, 0.15 * model_.weight_n());
  live_->hands().Pull(1, 0, Vector3::Zero(), Vector3(0.0, 0.02, 0.0), true);
  Run(0.05);
  EXPECT_GT(live_->hands().grips()[0].force_W.y(), 5.0) << "from where it took hold, though that has gone along";
  live_->hands().Pull(1, 0, Vector3(0.1, 0.0, 0.0), Vector3::Zero());
  Run(0.5);
  EXPECT_LT(live_->hands().grips()[0].force_W.x(), -2.0 * held_back_n) << "one that stays holds it back";
}

TEST_F(Live, StandsAndWalksOnASlopeAndFrictionThatItDoesNotKnow) {
  for (const double slope_deg : {1.0, 4.0}) {
    SCOPED_TRACE(slope_deg);
    Run(1.0);
    live_->SetGround(0.7, slope_deg, 0.0);
    Run(2.0);
    EXPECT_EQ(live_->mode(), LiveMode::kStands);
    live_->Reset();
    Run(1.0);
    EXPECT_EQ(live_->mode(), LiveMode::kStands);
    Ask({.gait = "trot", .speed_m_s = 0.3});
    Run(5.0);
    EXPECT_EQ(live_->mode(), LiveMode::kWalks);
    live_->SetGround(0.0, 0.0, 0.0);
    Run(3.0);
    EXPECT_EQ(live_->mode(), LiveMode::kWalks);
    live_->Reset();
  }
}

TEST_F(Live, SeveralHandsPullAndEachLetsGoOfItsOwn) {
  const Vector3 lateral(0.0, 0.01, 0.0);
  for (const HandId hand : {HandId{1}, HandId{2}}) live_->hands().Pull(hand, 0, Vector3::Zero(), lateral);
  live_->hands().Pull(2, 0, Vector3::Zero(), -lateral);
  Run(0.01);
  ASSERT_EQ(live_->hands().grips().size(), 2U);
  EXPECT_NEAR((live_->hands().grips()[0].force_W + live_->hands().grips()[1].force_W).y(), 0.0, 0.1);
  live_->hands().LetGo(1);
  live_->hands().LetGo(1);
  ASSERT_EQ(live_->hands().grips().size(), 1U);
  EXPECT_EQ(live_->hands().grips()[0].hand, 2U);
  for (HandId hand = 3; hand < 2 + HandsOn::kMostGrips; ++hand) live_->hands().Pull(hand, 0, Vector3::Zero(), lateral);
  EXPECT_THROW(live_->hands().Pull(99, 0, Vector3::Zero(), lateral), InvalidArgument);
  const VectorX q = live_->world().q();
  live_->PutInPose(live_->world().q());
  EXPECT_LT((live_->world().q() - q).norm(), 1e-12);
  EXPECT_TRUE(live_->hands().grips().empty()) << "what is posed is not pulled";
}

TEST_F(Live, FallsWhenItIsPulledOverAndStandsUp) {
  live_->hands().Pull(1, 0, Vector3::Zero(), Vector3(0.0, 3.0, 0.0));
  Run(1.0);
  EXPECT_EQ(live_->mode(), LiveMode::kFallen);
  live_->hands().LetGo(1);
  Run(1.0);
  live_->StandUp();
  Run(1.0);
  EXPECT_EQ(live_->mode(), LiveMode::kStands);
  live_->Reset();
  EXPECT_EQ(x(), 0.0);
  Ask({.gait = "trot", .speed_m_s = 0.3});
  Run(3.0);
  EXPECT_EQ(live_->mode(), LiveMode::kWalks);
}

TEST_F(Live, WhatHasNoPlanIsSaidAndChangesNothing) {
  live_->Ask({.gait = "trot", .speed_m_s = 12.0});
  live_->WaitForPlan();
  live_->Step();
  EXPECT_EQ(live_->mode(), LiveMode::kStands);
  const auto notes = live_->TakeNotes();
  ASSERT_FALSE(notes.empty());
  EXPECT_NE(notes.front().find("trot at 12 m/s"), std::string::npos) << notes.front();
}

}  // namespace
}  // namespace gaitwright
