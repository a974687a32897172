// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/walk_stream.h"

#include <gtest/gtest.h>

#include "planning/audit/audit.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

const WalkPace kStand = {.gait = "stand"};

RobotModel Robot(const std::string& name) { return ChooseRobot(name, "").value(); }

PacePlan Planned(const RobotModel& model, const WalkPace& from, const WalkPace& to) {
  Result<PacePlan> plan = PlanPace(model, {.from = from, .to = to}, {});
  EXPECT_TRUE(plan.ok()) << (plan.ok() ? "" : plan.failure().message);
  return std::move(plan).value();
}

/// The first violated check, or nothing.
std::string Broken(const RobotModel& model, const MotionPlan& plan) {
  const AuditReport report = Audit(model, plan, {}).value();
  if (report.pass()) return "";
  const Violation& v = report.violations.front();
  return LawName(v.law) + ", " + v.where + " at " + std::to_string(v.at_s) + " s: " + std::to_string(v.value) +
         " against " + std::to_string(v.limit);
}

TEST(PacePlans, HaveAStretchThatRepeatsItself) {
  for (const auto& [name, gait, speed] :
       {std::tuple("a1", "trot", 0.3), {"a1", "crawl", 0.05}, {"a1", "bound", 0.8}, {"nao", "walk", 0.08}}) {
    SCOPED_TRACE(std::string(name) + " " + gait);
    const PacePlan plan = Planned(Robot(name), kStand, {.gait = gait, .speed_m_s = speed});
    EXPECT_FALSE(plan.before);
    EXPECT_GE(plan.stretch.cycles, 1);
    const Seam seam = SeamBetween(plan.plan, plan.stretch.start_s, plan.plan, plan.stretch.end_s());
    EXPECT_LE(seam.joints, kSteady.joints * plan.stretch.cycles);
    EXPECT_LE(seam.height_m, kSteady.height_m);
    const auto row = [&](double t) {
      return plan.plan.whole_body
          .q[static_cast<std::size_t>(std::lround((t - plan.plan.whole_body.start_s) / plan.plan.whole_body.step_s))];
    };
    EXPECT_NEAR(
        row(plan.stretch.end_s())[0] - row(plan.stretch.start_s)[0], speed * plan.stretch.cycles * plan.stretch.cycle_s,
        (plan.plan.parts[0].gait.name == "bound" ? 0.25 : 0.02) * speed * plan.stretch.cycles * plan.stretch.cycle_s)
        << "a rigid body may go quicker at one time than at another";
  }
}

TEST(WalkStream, OfOnePaceGoesOnForEverAndKeepsAllLaws) {
  for (const auto& [name, gait, speed] : {std::tuple("a1", "trot", 0.3), {"nao", "walk", 0.08}}) {
    SCOPED_TRACE(name);
    const RobotModel model = Robot(name);
    const WalkPace pace = {.gait = gait, .speed_m_s = speed};
    const PacePlan plan = Planned(model, kStand, pace);
    WalkStream stream(plan.plan);
    EXPECT_TRUE(stream.stops());
    ASSERT_EQ(stream.GoOver(0.5, pace, plan), std::nullopt);
    for (double until = 2.0; until < 20.0; until += 1.0) stream.GoOn(until);
    EXPECT_GE(stream.plan().whole_body.end_s(), 20.0);
    EXPECT_EQ(Broken(model, stream.plan()), "");
    EXPECT_GT(stream.plan().whole_body.q.back()[0], 15.0 * speed);
    stream.Stop(10.0);
    EXPECT_TRUE(stream.stops());
    EXPECT_LT(stream.plan().whole_body.end_s(), 15.0);
    EXPECT_EQ(Broken(model, stream.plan()), "");
    EXPECT_LT(stream.plan().whole_body.v.back().norm(), 1e-6) << "at rest";
  }
}

TEST(WalkStream, StaysAsLowAsAPaceHasNeededItAndGoesNoFartherAtOnce) {
  const RobotModel model = Robot("nao");
  const WalkPace slow = {.gait = "biped", .speed_m_s = 0.05}, fast = {.gait = "biped", .speed_m_s = 0.12};
  const PacePlan first = Planned(model, kStand, slow), lower = Planned(model, slow, fast);
  const double height = lower.plan.centroidal.p_WC.back().z();
  ASSERT_LT(height, first.plan.centroidal.p_WC.back().z() - 0.005);
  const PaceChange back = {.from = fast, .to = slow, .turn_rad = 0.0, .com_height_m = height};
  const Result<PacePlan> again = PlanPace(model, back, {});
  ASSERT_TRUE(again);
  EXPECT_NEAR(again->plan.centroidal.p_WC.back().z(), height, 1e-6);
  WalkStream stream(first.plan);
  ASSERT_EQ(stream.GoOver(0.5, slow, first), std::nullopt);
  stream.GoOn(6.0);
  PacePlan too_low = lower;
  for (VectorX& q : too_low.plan.whole_body.q) q[2] -= 0.03;
  const auto failure = stream.GoOver(5.0, fast, too_low);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, FailureKind::kInfeasible);
  ASSERT_EQ(stream.GoOver(5.0, fast, lower), std::nullopt);
  stream.GoOn(stream.steady_from_s() + 1.0);
  const double at_s = stream.steady_from_s();
  const auto same = SameMoment(stream.plan(), at_s, again->plan, *again->before);
  ASSERT_TRUE(same);
  const Seam seam = SeamBetween(stream.plan(), at_s, again->plan, *same);
  EXPECT_LT(seam.height_m, 1e-4) << "there is no step in its height";
  EXPECT_LT(seam.joints, 2e-3);
  EXPECT_EQ(stream.GoOver(at_s + 0.5, slow, *again), std::nullopt);
}

TEST(WalkStream, GoesOverIntoOtherPacesWithoutAStand) {
  const RobotModel model = Robot("a1");
  const WalkPace slow = {.gait = "trot", .speed_m_s = 0.3}, fast = {.gait = "trot", .speed_m_s = 0.8},
                 turning = {.gait = "trot", .speed_m_s = 0.3, .yaw_rate_rad_s = 0.4};
  WalkStream stream(Planned(model, kStand, slow).plan);
  ASSERT_EQ(stream.GoOver(0.0, slow, Planned(model, kStand, slow)), std::nullopt);
  ASSERT_EQ(stream.GoOver(4.0, fast, Planned(model, slow, fast)), std::nullopt);
  stream.GoOn(8.0);
  ASSERT_EQ(stream.GoOver(8.5, turning, Planned(model, fast, turning)), std::nullopt);
  stream.GoOn(16.0);
  EXPECT_EQ(stream.pace(), turning);
  EXPECT_EQ(Broken(model, stream.plan()), "");
  EXPECT_GE(stream.plan().parts.size(), 4U);
  EXPECT_NE(stream.GoOver(17.0, fast, Planned(model, kStand, fast)), std::nullopt) << "it does not stand";
}

TEST(WalkStream, TurnsToAHeadingAndGoesOnStraight) {
  for (const auto& [name, gait, speed] : {std::tuple("a1", "trot", 0.3), {"nao", "walk", 0.08}}) {
    SCOPED_TRACE(name);
    const RobotModel model = Robot(name);
    const WalkPace pace = {.gait = gait, .speed_m_s = speed};
    WalkStream stream(Planned(model, kStand, pace).plan);
    ASSERT_EQ(stream.GoOver(0.0, pace, Planned(model, kStand, pace)), std::nullopt);
    EXPECT_NEAR(stream.heading_rad(), 0.0, 0.01);
    const auto turning = PlanPace(model, {.from = pace, .to = pace, .turn_rad = 1.0}, {});
    ASSERT_TRUE(turning.ok()) << turning.failure().message;
    ASSERT_EQ(stream.GoOver(5.0, pace, *turning), std::nullopt);
    stream.GoOn(20.0);
    EXPECT_NEAR(stream.heading_rad(), 1.0, 0.05);
    EXPECT_EQ(Broken(model, stream.plan()), "");
  }
}

TEST(WalkStream, ForgetsWithoutAChangeOfWhatComes) {
  const RobotModel model = Robot("a1");
  const WalkPace pace = {.gait = "trot", .speed_m_s = 0.3};
  const PacePlan plan = Planned(model, kStand, pace);
  WalkStream whole(plan.plan), short_of(plan.plan);
  for (WalkStream* stream : {&whole, &short_of}) ASSERT_EQ(stream->GoOver(0.5, pace, plan), std::nullopt);
  for (double until = 2.0; until < 60.0; until += 1.0) {
    whole.GoOn(until + 1.0);
    short_of.GoOn(until + 1.0);
    short_of.Forget(until - 2.0);
    EXPECT_LT(short_of.plan().whole_body.size(), 4000);
  }
  WholeBodySample a, b;
  for (const double t : {57.0, 58.5, 60.0}) {
    SampleWholeBody(whole.plan().whole_body, t, a);
    SampleWholeBody(short_of.plan().whole_body, t, b);
    EXPECT_LT((a.q - b.q).norm(), 1e-9) << t;
  }
  short_of.Stop(61.0);
  ASSERT_EQ(short_of.GoOver(4000.0, pace, plan), std::nullopt) << "after having stood for an hour";
  EXPECT_LT(short_of.plan().whole_body.size(), 8000);
  EXPECT_GT(short_of.plan().whole_body.end_s(), 4000.0);
}

}  // namespace
}  // namespace gaitwright
