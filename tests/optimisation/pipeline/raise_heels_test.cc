// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/raise_heels_internal.h"
#include "planning/audit/audit.h"
#include "planning/plan/heel_off_internal.h"
#include "planning/plan/sample_plan.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

constexpr double kPitch = 0.2;  // [rad]

MotionPlan Raised(double share = 1.0) {
  MotionPlan plan = GoodPlanOf("nao").plan;
  RaiseHeels(GoodPlanOf("nao").model, {kPitch, share}, plan);
  return plan;
}

/// The walk with heel-off, its whole body optimised.
const MotionPlan& Finished() {
  static const MotionPlan plan = [] {
    TrajectoryOptions options;
    options.knot_step_s = 0.02;
    const Result<MotionPlan> finished = FinishMotion(GoodPlanOf("nao").model, Raised(), options);
    EXPECT_TRUE(finished.ok()) << (finished.ok() ? "" : finished.failure().message);
    return finished.ok() ? *finished : Raised();
  }();
  return plan;
}

TEST(RaiseHeels, InTheDoubleSupportBeforeStepsForward) {
  const RobotModel& model = GoodPlanOf("nao").model;
  const MotionPlan plan = Raised(), half = Raised(0.5);
  double largest = 0.0, rise_s = 1.0;
  for (const ContactPhase& phase : plan.schedule.phases) {
    if (phase.stance == AllFeet(2) && phase.start_s > plan.schedule.start_s() && phase.end_s < plan.schedule.end_s())
      rise_s = std::min(rise_s, phase.end_s - phase.start_s);
  }
  int raised = 0;
  for (const SwingTrajectory& swing : plan.swings) {
    const auto left = std::find_if(
        plan.footsteps.footholds.begin(), plan.footsteps.footholds.end(),
        [&](const auto& f) { return f.foot == swing.foot && std::abs(f.liftoff_s - swing.start_s) < 1e-9; });
    ASSERT_NE(left, plan.footsteps.footholds.end());
    if (!left->heel_off_s) continue;
    ++raised;
    const ContactPhase& phase =
        plan.schedule.phases[static_cast<std::size_t>(PhaseAt(plan.schedule, *left->heel_off_s))];
    EXPECT_LT(phase.start_s, *left->heel_off_s + 1e-9);
    EXPECT_NEAR(phase.end_s, left->liftoff_s, 1e-9);
    EXPECT_NEAR(left->liftoff_s - *left->heel_off_s, rise_s, 1e-9) << "also in the long first double support";
    EXPECT_EQ(phase.stance, AllFeet(2));
    const auto i = static_cast<std::size_t>(left - plan.footsteps.footholds.begin());
    EXPECT_NEAR(left->liftoff_s - *half.footsteps.footholds[i].heel_off_s, 0.5 * rise_s, 0.51 * plan.whole_body.step_s);
    const EdgeTurn turn = EdgeTurnOf(model.feet[static_cast<std::size_t>(swing.foot)], left->X_WF, swing.X_WF_start);
    EXPECT_LT(turn.off_m, 1e-12);
    EXPECT_GT(turn.pitch_rad, 0.1 * kPitch);
    largest = std::max(largest, turn.pitch_rad);
    EXPECT_GT(swing.clearance_m, 0.0);
  }
  EXPECT_GT(raised, 1);
  EXPECT_NEAR(largest, kPitch, 1e-12) << "on the longest step";
}

TEST(RaiseHeels, LeavesWhatHasNoFrontEdgeOrNoStepForward) {
  for (const char* robot : {"a1", "nao"}) {
    const GoodPlan& good = GoodPlanOf(robot);
    MotionPlan plan = good.plan;
    const bool has_sole = good.model.feet.front().has_sole();
    // Soles turned around step backward.
    for (Foothold& foothold : plan.footsteps.footholds)
      foothold.X_WF.linear() *= RotationExp(std::numbers::pi * Vector3::UnitZ());
    for (SwingTrajectory& swing : plan.swings)
      swing.X_WF_start.linear() *= RotationExp(std::numbers::pi * Vector3::UnitZ());
    if (!has_sole) plan = good.plan;
    RaiseHeels(good.model, {kPitch, 1.0}, plan);
    for (const Foothold& foothold : plan.footsteps.footholds) EXPECT_FALSE(foothold.heel_off_s) << robot;
  }
  MotionPlan flat = GoodPlanOf("nao").plan;
  RaiseHeels(GoodPlanOf("nao").model, {0.0, 1.0}, flat);
  for (const Foothold& foothold : flat.footsteps.footholds) EXPECT_FALSE(foothold.heel_off_s);
}

TEST(RaiseHeels, TheWholeBodyFollowsSoundly) {
  const std::vector<Violation> found = ViolationsOf(GoodPlanOf("nao").model, Finished());
  for (const Violation& v : found)
    ADD_FAILURE() << LawName(v.law) << " at " << v.at_s << ", " << v.where << ": " << v.value << " over " << v.limit;
}

/// Edges stay in place, heels rise, and the centres of pressure are on the edges.
TEST(RaiseHeels, EdgesStayAndCarryTheLoad) {
  const RobotModel& model = GoodPlanOf("nao").model;
  const MotionPlan& plan = Finished();
  double highest = 0.0, largest_n = 0.0;
  for (const Foothold& foothold : plan.footsteps.footholds) {
    if (!foothold.heel_off_s) continue;
    const Foot& foot = model.feet[static_cast<std::size_t>(foothold.foot)];
    const Polygon edge = FrontEdge(foot.sole_F);
    for (double t = *foothold.heel_off_s; t < foothold.liftoff_s; t += 1e-3) {
      const Moment moment(model, plan, t);
      const Pose X_WF = ContactFrame(model, moment.scratch, foothold.foot);
      const EdgeTurn turn = EdgeTurnOf(foot, foothold.X_WF, X_WF);
      EXPECT_LT(turn.off_m, 5e-4) << t;
      EXPECT_LT(turn.turned_rad, 1e-3) << t;
      EXPECT_GT(turn.pitch_rad, -1e-3) << t;
      highest = std::max(highest, turn.pitch_rad);
      const ContactWrench& wrench = moment.sample.wrenches[static_cast<std::size_t>(foothold.foot)];
      const Vector3 force_F = X_WF.linear().transpose() * wrench.force_W,
                    moment_F = X_WF.linear().transpose() * wrench.moment_W;
      largest_n = std::max(largest_n, force_F.z());
      if (force_F.z() < 1.0) continue;
      EXPECT_NEAR(-moment_F.y() / force_F.z(), edge.front().x(), 1e-4) << t;
    }
  }
  EXPECT_GT(highest, 0.5 * kPitch);
  EXPECT_GT(largest_n, 5.0) << "some load is carried by an edge";
}

TEST(RaiseHeels, TheAuditNamesAnEdgeThatSlipsOrIsNotThere) {
  const RobotModel& model = GoodPlanOf("nao").model;
  MotionPlan plan = Finished();
  const auto raised = std::find_if(plan.footsteps.footholds.begin(), plan.footsteps.footholds.end(),
                                   [](const Foothold& foothold) { return foothold.heel_off_s.has_value(); });
  ASSERT_NE(raised, plan.footsteps.footholds.end());
  const std::string foot = model.feet[static_cast<std::size_t>(raised->foot)].name;
  const Pose X_WF = raised->X_WF;
  raised->X_WF.translation().x() += 4e-3;
  EXPECT_NEAR(At(ViolationsOf(model, plan), foot + " front edge off its foothold").value, 4e-3, 5e-4);
  raised->X_WF = X_WF;
  raised->X_WF.linear() *= RotationExp(0.01 * Vector3::UnitZ());
  EXPECT_NEAR(At(ViolationsOf(model, plan), foot + " rotated from its front edge").value, 0.01, 1e-3);
  raised->X_WF = X_WF;
  raised->heel_off_s.reset();
  EXPECT_GT(At(ViolationsOf(model, plan), foot + " rotated from its foothold").value, 0.01);
}

}  // namespace
}  // namespace gaitwright
