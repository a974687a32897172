// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/reason.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "playback/score/reason_of_fall.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

using synthetic::Played;
using synthetic::Says;

/// A biped that stands for three seconds.
struct ReasonCase : Played {
  ReasonCase()
      : Played(synthetic::Robot(2, FootType::kSole),
               synthetic::StandingPlan(synthetic::Robot(2, FootType::kSole), 3.0)) {}

  ScoreInputs Inputs(const Fall& fall = {}) const {
    return {model, plan, log, options, MakeMotionSeries(model, plan, log, options), fall, 0.6};
  }
  std::vector<std::string> Disturbances() const { return DisturbancesOf(plan, log); }

  ScoreOptions options;
};

Fall FallAt(double time_s, FallKind kind) { return {true, time_s, kind, "it went down"}; }

Metric AtMost(const std::string& key, double value, double limit) {
  Metric metric;
  metric.key = key;
  metric.unit = "m";
  metric.value = value;
  metric.limit = limit;
  metric.bound = Bound::kAtMost;
  metric.applied = true;
  metric.pass = value <= limit;
  return metric;
}

const std::vector<Metric> kReasonBroken = {AtMost("goal_error_m", 0.01, 0.05), AtMost("slip_max_step_m", 0.3, 0.01),
                                           AtMost("penetration_max_m", 0.2, 0.01)};

struct OptionWords {
  const char *key, *text;
  const char* words;  ///< empty if the plan knows it
};

class OneDisturbance : public testing::TestWithParam<OptionWords> {};

TEST_P(OneDisturbance, IsReportedUnlessItIsTheUsualValue) {
  ReasonCase c;
  c.log.options = {{"play.step_s", "0.001"}, {GetParam().key, GetParam().text}};
  const std::vector<std::string> reported = c.Disturbances();
  if (std::string(GetParam().words).empty()) {
    EXPECT_TRUE(reported.empty()) << reported.front();
  } else {
    EXPECT_EQ(reported, std::vector<std::string>{GetParam().words});
  }
}

INSTANTIATE_TEST_SUITE_P(
    Options, OneDisturbance,
    testing::Values(OptionWords{"play.ground_slope_deg", "-2", "a slope of -2 degrees"},
                    OptionWords{"play.ground_bumps_m", "0.004", "bumps of 4 mm"},
                    OptionWords{"play.friction", "0.5", "a friction of 0.5"}, OptionWords{"play.friction", "0.8", ""},
                    OptionWords{"play.mass_scale", "1.2", "1.2 times the mass"},
                    OptionWords{"play.mass_scale", "1", ""},
                    OptionWords{"play.com_shift_y_m", "-0.02", "the base's centre of mass shifted by 20 mm"},
                    OptionWords{"command_delay_s", "0.0026", "a command delay of 3 ms"},
                    OptionWords{"command_delay_s", "0.0004", ""},
                    OptionWords{"state", "estimated", "the state source estimated"}, OptionWords{"state", "true", ""},
                    OptionWords{"play.start_yaw_rad", "-0.1", "a start rotated by 0.1 rad"},
                    OptionWords{"play.rotor_inertia_kg_m2", "0.01", "additional rotor inertia"},
                    OptionWords{"play.log_rate_hz", "100", ""}));

TEST(Reason, ShiftsAndStartsAreReportedByTheirLength) {
  ReasonCase c;
  c.log.options = {{"play.com_shift_x_m", "0.003"},
                   {"play.com_shift_z_m", "-0.004"},
                   {"play.start_x_m", "0.06"},
                   {"play.start_y_m", "0.08"}};
  EXPECT_EQ(c.Disturbances(),
            (std::vector<std::string>{"the base's centre of mass shifted by 5 mm", "a start displaced by 100 mm"}));
}

TEST(Reason, APushIsNamedByItsLargestPartAndSense) {
  const std::pair<Vector3, const char*> pushes[] = {
      {{60.0, 1.0, 1.0}, " forward "},       {{-60.0, 1.0, 1.0}, " backward "}, {{9.0, 60.0, -9.0}, " to the left "},
      {{9.0, -60.0, 9.0}, " to the right "}, {{0.0, 5.0, 60.0}, " up "},        {{0.0, 5.0, -60.0}, " down "}};
  for (const auto& [force, words] : pushes) {
    ReasonCase c;
    c.log.pushes = {{force, 1.0, 0.1, "base"}};
    ASSERT_EQ(c.Disturbances().size(), 1U);
    EXPECT_TRUE(Says(c.Disturbances().front(), words)) << c.Disturbances().front();
  }
}

TEST(Reason, TheLastTwoPushesBeforeATimeAreReported) {
  ReasonCase c;
  for (const double at_s : {0.5, 1.0, 1.5, 2.0}) c.log.pushes.push_back({{0.0, 60.0, 0.0}, at_s, 0.1, "base"});
  EXPECT_EQ(DisturbancesOf(c.plan, c.log, 2.0),
            (std::vector<std::string>{"a push of 60 N to the left from 1.00 s for 0.10 s",
                                      "a push of 60 N to the left from 1.50 s for 0.10 s"}));
  EXPECT_TRUE(DisturbancesOf(c.plan, c.log, 0.5).empty()) << "it began when the time was over";
  EXPECT_EQ(c.Disturbances().size(), 2U);
}

TEST(Reason, APassNamesTheGateNearestToItsLimit) {
  const ReasonCase c;
  std::vector<Metric> metrics = {AtMost("goal_error_m", 0.01, 0.05), AtMost("slip_max_step_m", 0.009, 0.01),
                                 AtMost("zero_limit", 0.0, 0.0), AtMost("not_applied", 0.999, 1.0)};
  metrics.back().applied = false;
  const std::string reason = ReasonOf(c.Inputs(), metrics);
  EXPECT_TRUE(Says(reason, "slip_max_step_m")) << reason;
  for (const char* other : {"goal_error_m", "zero_limit", "not_applied"}) EXPECT_FALSE(Says(reason, other)) << reason;
  EXPECT_EQ(CauseOf(c.Inputs(), metrics), "");
}

TEST(Reason, AFailureWithoutAFallNamesEachBrokenGateAndCountsAsTheFirst) {
  const ReasonCase c;
  const std::string reason = ReasonOf(c.Inputs(), kReasonBroken);
  EXPECT_TRUE(Says(reason, "slip_max_step_m is ")) << reason;
  EXPECT_TRUE(Says(reason, "penetration_max_m is ")) << reason;
  EXPECT_FALSE(Says(reason, "goal_error_m")) << reason;
  EXPECT_EQ(CauseOf(c.Inputs(), kReasonBroken), "slip_max_step_m");
  EXPECT_FALSE(IsCauseOfFall("slip_max_step_m"));
}

TEST(Reason, AValueThatRoundsToItsLimitIsSaidToBeJustOverIt) {
  const ReasonCase c;
  const std::string reason = ReasonOf(c.Inputs(), {AtMost("goal_error_m", 0.05 + 1e-9, 0.05)});
  EXPECT_TRUE(Says(reason, "just over its limit")) << reason;
  EXPECT_TRUE(Says(reason, "1e-09 m")) << reason;
}

TEST(Reason, OfManyDisturbancesTheFiveLargestAreReported) {
  ReasonCase c;
  c.log.options = {{"play.ground_slope_deg", "20"}, {"play.ground_bumps_m", "0.00001"}, {"play.mass_scale", "3"},
                   {"play.inertia_scale", "1.001"}, {"play.com_shift_x_m", "0.3"},      {"command_delay_s", "0.05"},
                   {"gains.stiffness_scale", "0.1"}};
  const std::string reason = ReasonOf(c.Inputs(FallAt(2.0, FallKind::kTilted)), kReasonBroken);
  EXPECT_EQ(reason.rfind("under a slope of 20 degrees, 3 times the mass, ", 0), 0U) << reason;
  EXPECT_TRUE(Says(reason, "0.1 times the joints' stiffness and 2 smaller disturbances: ")) << reason;
  EXPECT_FALSE(Says(reason, "bumps")) << reason;
  EXPECT_FALSE(Says(reason, "inertia")) << reason;
}

TEST(Reason, AFallInTheFirstMomentCameWhileSettling) {
  const ReasonCase c;
  EXPECT_TRUE(Says(ReasonOf(c.Inputs(FallAt(0.04, FallKind::kTilted)), kReasonBroken), "while settling"));
  const std::string later = ReasonOf(c.Inputs(FallAt(0.06, FallKind::kTilted)), kReasonBroken);
  EXPECT_TRUE(Says(later, "fell at 0.06 s: it went down")) << later;
}

TEST(Reason, CausesOfFallsDifferByHowTheyEnded) {
  const ReasonCase c;
  std::vector<std::string> causes;
  for (const FallKind kind : {FallKind::kTilted, FallKind::kLeftHeight, FallKind::kControllerStopped,
                              FallKind::kPhysicsStopped, FallKind::kEndedEarly}) {
    const std::string cause = CauseOf(c.Inputs(FallAt(2.5, kind)), kReasonBroken);
    EXPECT_TRUE(IsCauseOfFall(cause)) << cause;
    EXPECT_EQ(std::count(causes.begin(), causes.end(), cause), 0) << cause;
    causes.push_back(cause);
  }
  EXPECT_EQ(CauseOf(c.Inputs(FallAt(2.5, FallKind::kNotFinite)), kReasonBroken), causes[3]);
  EXPECT_FALSE(IsCauseOfFall(""));
}

TEST(Reason, TheCauseIsAnEventOfTheLastSecondOnly) {
  ReasonCase c;
  const Fall fall = FallAt(2.5, FallKind::kTilted);
  const std::string tilted = CauseOf(c.Inputs(fall), kReasonBroken);
  c.log.body_contacts = {{1.4, "trunk"}};
  EXPECT_EQ(CauseOf(c.Inputs(fall), kReasonBroken), tilted);
  c.log.body_contacts = {{1.6, "trunk"}};
  ASSERT_EQ(FailureEvents(c.Inputs(fall)).size(), 1U);
  const std::string touched = CauseOf(c.Inputs(fall), kReasonBroken);
  EXPECT_NE(touched, tilted);
  EXPECT_TRUE(IsCauseOfFall(touched)) << touched;
  const Fall stopped = FallAt(2.5, FallKind::kControllerStopped);
  EXPECT_NE(CauseOf(c.Inputs(stopped), kReasonBroken), touched) << "a controller without a number is the cause";
}

}  // namespace
}  // namespace gaitwright
