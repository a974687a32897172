// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "playback/play/playable_internal.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

constexpr double kPlanLasts = 1.0, kHolds = 0.3;  // [s]

struct PlayableCase {
  RobotModel model = synthetic::Robot(2, FootType::kSole);
  MotionPlan plan = synthetic::StandingPlan(model, kPlanLasts);
  PlayOptions options;

  std::optional<Failure> Why() const { return ReasonNotPlayed(model, plan, options); }
};

struct Unplayable {
  const char* name;
  std::function<void(PlayableCase&)> spoil;
  std::optional<FailureCode> code;  ///< nothing if it is played
};

void PrintTo(const Unplayable& one, std::ostream* out) { *out << one.name; }

class PlayableTest : public testing::TestWithParam<Unplayable> {};

TEST_P(PlayableTest, HasTheCodeOfItsReason) {
  PlayableCase c;
  ASSERT_FALSE(c.Why().has_value());
  GetParam().spoil(c);
  const auto why = c.Why();
  ASSERT_EQ(why.has_value(), GetParam().code.has_value()) << (why ? why->message : "");
  if (!why) return;
  EXPECT_EQ(why->code, *GetParam().code) << why->message;
  EXPECT_EQ(why->kind, FailureKind::kBadInput);
  EXPECT_EQ(why->suggestions.size(), 1U);
}

using Case = PlayableCase;

void PushAt(Case& c, double at_s, double force_n) {
  c.options.push_force_W.y() = force_n;
  c.options.push_at_s = at_s;
}

INSTANTIATE_TEST_SUITE_P(
    Plans, PlayableTest,
    testing::Values(
        Unplayable{"NoRows", [](Case& c) { c.plan.whole_body = {}; }, FailureCode::kPlanWithoutMotion},
        Unplayable{"NoStep", [](Case& c) { c.plan.whole_body.step_s = 0.0; }, FailureCode::kPlanWithoutMotion},
        Unplayable{"OverAnHour", [](Case& c) { c.plan.whole_body.step_s = 18.1; }, FailureCode::kPlanTooLong},
        Unplayable{"NoStart", [](Case& c) { c.plan.whole_body.start_s = std::numeric_limits<double>::quiet_NaN(); },
                   FailureCode::kPlanTooLong},
        Unplayable{"Hangs",
                   [](Case& c) {
                     c.plan.parts.front().gait.duty_factor = {0.0, 0.0};
                   },
                   FailureCode::kHangs},
        Unplayable{"HalfStands",
                   [](Case& c) {
                     c.plan.parts.front().gait.duty_factor = {0.0, 0.5};
                   },
                   {}},
        Unplayable{"OtherHash", [](Case& c) { c.model.hash = "a", c.plan.robot_hash = "b"; },
                   FailureCode::kPlanOfOtherRobot},
        Unplayable{"SameHash", [](Case& c) { c.model.hash = c.plan.robot_hash = "a"; }, {}},
        Unplayable{"HashOfRobotOnly", [](Case& c) { c.model.hash = "a", c.plan.robot_hash = ""; }, {}},
        Unplayable{"FourLegs", [](Case& c) { c.model = synthetic::Robot(4, FootType::kPoint); },
                   FailureCode::kPlanOfOtherRobot}),
    [](const auto& one) { return std::string(one.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Pushes, PlayableTest,
    testing::Values(
        Unplayable{"WhileItHolds", [](Case& c) { PushAt(c, kPlanLasts + kHolds - 1e-6, 10.0); }, {}},
        Unplayable{"AfterTheEnd", [](Case& c) { PushAt(c, kPlanLasts + kHolds + 1e-6, 10.0); }, FailureCode::kLatePush},
        Unplayable{"WithoutForce", [](Case& c) { PushAt(c, 100.0, 0.0); }, {}},
        Unplayable{"AShorterHold", [](Case& c) { PushAt(c, kPlanLasts, 10.0), c.options.hold_s = 0.0; },
                   FailureCode::kLatePush},
        Unplayable{"OneOfMany",
                   [](Case& c) {
                     PushAt(c, 0.5, 10.0);
                     c.options.more_pushes = {{{0.0, 5.0, 0.0}, 0.7, 0.1, "base"}, {{0.0, 5.0, 0.0}, 9.0, 0.1, "base"}};
                   },
                   FailureCode::kLatePush}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(Playable, OptionsThatCannotBeAreThrown) {
  PlayableCase link;
  PushAt(link, 0.5, 10.0);
  link.options.push_on = "trunc";
  EXPECT_THROW(link.Why(), InvalidArgument);
  Frame shin;
  shin.name = link.options.push_on = "shin";
  link.model.frames.push_back(shin);
  EXPECT_FALSE(link.Why().has_value());
  PlayableCase rate;
  rate.options.world.step_s = 0.001;
  rate.options.log_rate_hz = 300.0;  // 3.33 steps
  EXPECT_THROW(rate.Why(), InvalidArgument);
  PlayableCase range;
  range.options.settle_s = -0.1;
  EXPECT_THROW(range.Why(), InvalidArgument);
}

TEST(Playable, AMisfitIsReportedBeforeALatePush) {
  PlayableCase c;
  PushAt(c, 9.0, 10.0);
  c.plan.whole_body = {};
  EXPECT_EQ(c.Why()->code, FailureCode::kPlanWithoutMotion);
}

TEST(Playable, BumpsReachTwoMetresBeyondWhereTheBaseGoes) {
  PlayableCase c;
  c.plan.whole_body.q[20].head<2>() << -1.5, 0.25;
  c.plan.whole_body.q[90].head<2>() << 0.75, -3.0;
  const WorldOptions world = playing::WorldOf(c.plan, c.options);
  EXPECT_NEAR((world.bumps_from_W - Vector2(-3.5, -5.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((world.bumps_to_W - Vector2(2.75, 2.25)).norm(), 0.0, 1e-12);
}

TEST(Playable, BumpsOverTooMuchGroundAreRefused) {
  PlayableCase c;
  c.plan.whole_body.q[20].head<2>() << 300.0, 300.0;
  EXPECT_NO_THROW(c.Why());
  c.options.world.ground_bumps_m = 0.005;
  EXPECT_THROW(c.Why(), InvalidArgument);
}

TEST(Playable, OnlyJointsThatThePlanNeverMovesAreLockedAndOnlyWhenAskedFor) {
  PlayableCase c;
  EXPECT_TRUE(playing::WorldOf(c.plan, c.options).locked_dofs.empty());
  c.options.lock_unmoved = true;
  EXPECT_EQ(playing::WorldOf(c.plan, c.options).locked_dofs, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  c.plan.whole_body.q[30][7 + 2] -= 1e-3;  // there and back
  c.plan.whole_body.q.back()[7 + 5] += 1e-3;
  c.plan.whole_body.q[30][7 + 1] += 1e-12;  // rounding
  EXPECT_EQ(playing::WorldOf(c.plan, c.options).locked_dofs, (std::vector<int>{0, 1, 3, 4}));
}

}  // namespace
}  // namespace gaitwright
