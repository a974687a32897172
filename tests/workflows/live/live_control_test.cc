// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_control.h"

#include <gtest/gtest.h>

#include "tests/workflows/live/made_world.h"
#include "workflows/live/live_requests.h"

namespace gaitwright {
namespace {

const WalkPace kTrot = {.gait = "trot", .speed_m_s = 0.3};

/// A robot with a controller and manual actions.
class Controlled {
 public:
  explicit Controlled(const std::string& controller) {
    PlayRequest play;
    play.controller = controller;
    live_ = MadeWorld(model_, play);
  }
  void GoOn(double seconds) {
    for (const double end = live_->time_s() + seconds; live_->time_s() < end - 1e-9;) live_->Step();
  }
  void Trot() {
    live_->Ask(kTrot);
    live_->WaitForPlan();
    for (const double most = live_->time_s() + 3.0; live_->wanted() && live_->time_s() < most;) live_->Step();
    EXPECT_EQ(live_->mode(), LiveMode::kWalks) << Notes();
  }
  /// Whether the robot survives a push that it cannot withstand without steps.
  bool BearsAPush() {
    live_->hands().Push(Vector3(-210.0, 0.0, 0.0), live_->time_s() + 0.1);
    GoOn(5.0);
    return live_->mode() == LiveMode::kStands;
  }
  /// Changes controller options as a page does.
  void Say(const std::string& message) {
    LiveClock clock;
    ReadLiveRequest(model_, message)(*live_, clock, 1);
  }
  std::string Notes() {
    std::string all;
    for (const std::string& note : live_->TakeNotes()) all += note + "\n";
    return all;
  }
  /// Mean over the feet.
  double FeetAt_x() const {
    double sum = 0.0;
    for (const FootContact& foot : live_->world().feet()) sum += foot.p_W.x();
    return sum / static_cast<double>(live_->world().feet().size());
  }

 protected:
  const RobotModel model_ = ChooseRobot("a1", "").value();
  std::unique_ptr<LiveWorld> live_;
};

class LiveRecovering : public testing::Test, protected Controlled {
 protected:
  LiveRecovering() : Controlled("recovering") {}
};

TEST_F(LiveRecovering, StepsWherePushedAndWalksFromWhereItStandsThen) {
  GoOn(0.5);
  const double x = FeetAt_x();
  EXPECT_TRUE(BearsAPush());
  EXPECT_LT(FeetAt_x(), x - 0.05) << "it stepped back";
  EXPECT_EQ(Notes(), "");
  Trot();
  GoOn(4.0);
  EXPECT_EQ(live_->mode(), LiveMode::kWalks);
}

TEST_F(LiveRecovering, LetsStabilisedWalkAndSaysSoOnce) {
  Trot();
  EXPECT_NE(Notes().find("'stabilised' is used now: 'recovering' needs a plan that stands"), std::string::npos);
  GoOn(4.0);
  EXPECT_EQ(Notes().find("stabilised"), std::string::npos);
  live_->Ask({.gait = "stand"});
  GoOn(4.0);
  EXPECT_EQ(live_->mode(), LiveMode::kStands);
  EXPECT_TRUE(BearsAPush()) << "'recovering' has it again";
}

constexpr char kBraceMargin[] = R"({"do": "options", "options": {"recovering.brace_margin": 0.5}})";

TEST_F(LiveRecovering, HasItsOptionsChanged) {
  Say(kBraceMargin);
  EXPECT_EQ(live_->play().recovering.brace_margin, 0.5);
  GoOn(0.5);
  EXPECT_TRUE(BearsAPush());
  EXPECT_THROW(Say(R"({"do": "options", "options": {"recovering.brace_margin": -1}})"), InvalidArgument);
}

TEST(LiveControl, HasNoOptionsOfAnother) {
  Controlled robot("stabilised");
  EXPECT_THROW(robot.Say(kBraceMargin), InvalidArgument);
}

TEST(LiveControl, WithoutRecoveringItFalls) {
  Controlled robot("stabilised");
  robot.GoOn(0.5);
  EXPECT_FALSE(robot.BearsAPush());
}

TEST(LiveControl, KnowsItsControllers) {
  EXPECT_THROW(Controlled("pid"), InvalidArgument);
  Controlled robot("joint-pd");
  robot.Trot();
  EXPECT_EQ(robot.Notes().find("stabilised"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
