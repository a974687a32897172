// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "optimisation/pipeline/choose_contacts_internal.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/whole_body/swing_room_internal.h"
#include "planning/audit/audit.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/sample_plan.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

const MotionPlan& BoundPlan() {
  static const MotionPlan plan = [] {
    WalkCommand command;
    command.speed_m_s = 0.8;
    command.distance_m = 0.8;
    const RobotModel& model = NamedRobot("a1");
    const Result<PlannedMotion> planned =
        PlanMotion(model, FlatTerrain(0.8), *FindGait(model, "bound", 0.8, {}), command, {});
    EXPECT_TRUE(planned.ok()) << (planned.ok() ? "" : planned.failure().message);
    return planned->plan;
  }();
  return plan;
}

MotionPlan Finished(const TrajectoryOptions& options, FinishReport& report) {
  const Result<MotionPlan> finished = FinishMotion(NamedRobot("a1"), BoundPlan(), options, 0.9, &report);
  EXPECT_TRUE(finished.ok()) << (finished.ok() ? "" : finished.failure().message);
  return finished.ok() ? *finished : BoundPlan();
}

void ExpectAudited(const MotionPlan& plan) {
  const Result<AuditReport> audit = Audit(NamedRobot("a1"), plan, {});
  ASSERT_TRUE(audit.ok());
  for (const Violation& v : audit->violations)
    ADD_FAILURE() << LawName(v.law) << " at " << v.at_s << ", " << v.where << ": " << v.value << " over " << v.limit;
}

double PositiveWork(const MotionPlan& plan) {
  double work = 0.0;
  for (std::size_t k = 0; k < plan.whole_body.tau.size(); ++k) {
    const VectorX rates = plan.whole_body.v[k].tail(plan.whole_body.tau[k].size());
    work += plan.whole_body.step_s * plan.whole_body.tau[k].cwiseProduct(rates).cwiseMax(0.0).sum();
  }
  return work;
}

/// Far from the plan at little cost.
FinishSettings Loose() {
  FinishSettings settings;
  for (double* weight : {&settings.weights.base_position, &settings.weights.base_rotation, &settings.weights.joint})
    *weight *= 0.1;
  return settings;
}

TEST(ChooseContacts, ChoosesNothingUnlessAsked) {
  ChosenContacts chosen;
  const MotionPlan plan = ChooseContacts(NamedRobot("a1"), BoundPlan(), {}, {}, chosen);
  EXPECT_EQ(plan.whole_body.q, BoundPlan().whole_body.q);
  EXPECT_EQ(chosen.iterations, 0);
  EXPECT_TRUE(chosen.summary.empty());
}

TEST(ChooseContacts, ReducesWorkByTimesAndPlaces) {
  FinishReport fixed_report, report;
  const MotionPlan fixed = Finished({}, fixed_report);
  const MotionPlan chosen = Finished({.near = 0.2, .power = 3.0, .timing = "optimised", .footholds = "free"}, report);
  ExpectAudited(chosen);
  EXPECT_NEAR(chosen.duration_s(), fixed.duration_s(), 0.5 * fixed.whole_body.step_s);
  EXPECT_LT(PositiveWork(chosen), 0.85 * PositiveWork(fixed));
  EXPECT_GT(report.iterations, fixed_report.iterations);
  EXPECT_LE(report.residual_force, 1e-3);
  bool times_change = false, places_change = false;
  for (std::size_t i = 0; i < fixed.footsteps.footholds.size(); ++i) {
    const Foothold &before = fixed.footsteps.footholds[i], &now = chosen.footsteps.footholds[i];
    times_change |= std::abs(before.touchdown_s - now.touchdown_s) > fixed.whole_body.step_s;
    const double moved = (before.X_WF.translation() - now.X_WF.translation()).norm();
    places_change |= moved > 5e-3;
    EXPECT_LT(moved, 0.05 * std::sqrt(2.0) + 0.01);
  }
  EXPECT_TRUE(times_change);
  EXPECT_TRUE(places_change);
}

TEST(ChooseContacts, KeepsPhasesWithinTheirBounds) {
  ChosenContacts chosen;
  const TrajectoryOptions options{.timing = "optimised", .most_change = 0.1};
  const MotionPlan plan = ChooseContacts(NamedRobot("a1"), BoundPlan(), options, {}, chosen);
  ASSERT_GT(chosen.iterations, 0);
  constexpr double kRounding = 0.15;  // of the shortest phases, to rows
  EXPECT_GT(chosen.shortest, 1.0 / 1.1 - kRounding);
  EXPECT_LT(chosen.longest, 1.1 + kRounding);
  EXPECT_EQ(plan.footsteps.footholds.back().X_WF.matrix(), BoundPlan().footsteps.footholds.back().X_WF.matrix());
  EXPECT_EQ(plan.whole_body.size(), BoundPlan().whole_body.size());
}

TEST(ChooseContacts, ReducesPowerIfItIsWeighted) {
  FinishReport report;
  const MotionPlan fixed = Finished({}, report), spared = Finished({.power = 3.0}, report);
  ExpectAudited(spared);
  EXPECT_LT(PositiveWork(spared), 0.97 * PositiveWork(fixed));
}

/// Plans over stones that have hardly more room than feet need.
TEST(ChooseContacts, KeepsFeetOnTheirPatches) {
  const RobotModel& model = NamedRobot("a1");
  MotionPlan plan = BoundPlan();
  constexpr double kHalf = 0.02;  // [m] of a stone's side
  plan.terrain.patches.clear();
  for (Foothold& foothold : plan.footsteps.footholds) {
    foothold.patch = static_cast<int>(plan.terrain.patches.size());
    TerrainPatch stone;
    stone.X_WT = foothold.X_WF;
    stone.outline_T = {{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}};
    plan.terrain.patches.push_back(stone);
  }
  ChosenContacts chosen;
  const MotionPlan moved = ChooseContacts(model, plan, {.footholds = "free"}, Loose(), chosen);
  EXPECT_GT(chosen.largest_shift_m, 1e-3);
  EXPECT_EQ(moved.schedule, plan.schedule) << "times are not chosen";
  for (std::size_t i = 0; i < plan.footsteps.footholds.size(); ++i) {
    const Foothold& foothold = moved.footsteps.footholds[i];
    const Vector3 in_stone = plan.terrain.patches[i].X_WT.inverse() * foothold.X_WF.translation();
    EXPECT_LE(in_stone.head<2>().cwiseAbs().maxCoeff(), kHalf);
    EXPECT_NEAR(in_stone.z(), 0.0, 1e-9);
  }
}

TEST(ChooseContacts, SwingsFollowTheirFootholds) {
  ChosenContacts chosen;
  const TrajectoryOptions options{.timing = "optimised", .footholds = "free"};
  const MotionPlan plan = ChooseContacts(NamedRobot("a1"), BoundPlan(), options, Loose(), chosen);
  ASSERT_GT(chosen.largest_shift_m, 5e-3);
  for (const SwingTrajectory& swing : plan.swings) {
    const auto at = [&](double time_s, bool lands) {
      return std::find_if(plan.footsteps.footholds.begin(), plan.footsteps.footholds.end(), [&](const Foothold& f) {
        return f.foot == swing.foot && std::abs((lands ? f.touchdown_s : f.liftoff_s) - time_s) < 1e-9;
      });
    };
    const auto left = at(swing.start_s, false), landed = at(swing.end_s, true);
    ASSERT_NE(left, plan.footsteps.footholds.end());
    ASSERT_NE(landed, plan.footsteps.footholds.end());
    EXPECT_LT((swing.X_WF_end.translation() - landed->X_WF.translation()).norm(), 1e-6);
    EXPECT_LT((swing.X_WF_start.translation() - left->X_WF.translation() - left->roll_W).norm(), 1e-6);
  }
  CheckSchedule(plan.schedule, 4);
  EXPECT_EQ(plan.schedule.end_s(), plan.whole_body.end_s());
}

TEST(ChooseContacts, ReducesWorkByThePathsOfSwings) {
  FinishReport report;
  const MotionPlan planned = Finished({.near = 0.2, .power = 3.0}, report);
  const MotionPlan free = Finished({.near = 0.2, .power = 3.0, .swings = "free"}, report);
  ExpectAudited(free);
  EXPECT_LE(report.residual_force, 1e-3);
  EXPECT_LT(PositiveWork(free), 0.97 * PositiveWork(planned));
  EXPECT_EQ(free.schedule, planned.schedule);
  int changed = 0;
  for (std::size_t i = 0; i < free.swings.size(); ++i) {
    const SwingTrajectory &now = free.swings[i], &before = BoundPlan().swings[i];
    EXPECT_GE(now.clearance_m, 0.5 * before.clearance_m - 1e-4);
    if (!now.detour_W.empty()) ++changed;
  }
  EXPECT_GT(changed, 0);
}

TEST(FitSwings, FindsThePathsOfAPlanInItsMotion) {
  MotionPlan plan = BoundPlan();
  EXPECT_EQ(FitSwings(NamedRobot("a1"), {}, plan), static_cast<int>(plan.swings.size()));
  for (std::size_t i = 0; i < plan.swings.size(); ++i) {
    const SwingTrajectory &now = plan.swings[i], &before = BoundPlan().swings[i];
    EXPECT_FALSE(now.detour_W.empty());
    EXPECT_NEAR(now.clearance_m, before.clearance_m, 2e-3);
    for (double share = 0.0; share <= 1.0; share += 0.1) {
      const double time_s = now.start_s + share * (now.end_s - now.start_s);
      const Vector3 off_W =
          Evaluate(CurveOf(now), time_s).X_WF.translation() - Evaluate(CurveOf(before), time_s).X_WF.translation();
      EXPECT_LT(off_W.norm(), 2e-3) << "swing " << i << " at " << share;
    }
  }
}

TEST(ChooseContacts, KeepsContactsForWhichItFindsNoMotion) {
  ChosenContacts chosen;
  const TrajectoryOptions none{.max_iterations = 1, .timing = "optimised"};
  const MotionPlan plan = ChooseContacts(NamedRobot("a1"), BoundPlan(), none, {}, chosen);
  EXPECT_EQ(plan.schedule, BoundPlan().schedule);
  EXPECT_EQ(plan.whole_body.q, BoundPlan().whole_body.q);
  EXPECT_FALSE(chosen.summary.empty());
}

TEST(PacedTimes, IsTheIdentityAtItsOwnPace) {
  const PacedTimes map(PaceSpline(1.0, 3.0, VectorX()), 1.0, 3.0, 0.005);
  EXPECT_EQ(map.rows(), 400);
  for (const double time_s : {1.0, 1.234, 2.0, 3.0}) {
    EXPECT_NEAR(map.New(time_s), time_s, 1e-12);
    EXPECT_NEAR(map.Old(time_s), time_s, 1e-12);
  }
}

TEST(PacedTimes, GoesThereAndBack) {
  VectorX points(6);
  points << 0.1, -0.2, 0.3, 0.0, -0.1, 0.2;
  const PacedTimes map(PaceSpline(1.0, 3.0, points), 1.0, 3.0, 0.005);
  double before = 0.0;
  for (double time_s = 1.0; time_s <= 3.0; time_s += 0.01) {
    EXPECT_GT(map.New(time_s), before);
    before = map.New(time_s);
    EXPECT_NEAR(map.Old(before), time_s, 1e-9);
  }
  EXPECT_NEAR(map.New(3.0), 1.0 + map.rows() * 0.005, 1e-12);
}

TEST(PacedTimes, AFasterPaceTakesLess) {
  const PacedTimes map(PaceSpline(0.0, 1.0, VectorX::Constant(5, std::log(1.25))), 0.0, 1.0, 0.01);
  EXPECT_EQ(map.rows(), 80);
  EXPECT_NEAR(map.New(0.5), 0.4, 1e-9);
  EXPECT_NEAR(map.NewRow(0.33), 0.26, 1e-12);
}

}  // namespace
}  // namespace gaitwright
