// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/optimise_timing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "optimisation/centroidal/gait_phases.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// Optimises the timing; the motion must satisfy its constraints at 1 kHz and must not cost more.
TimedPlan Timed(const RigidBodyProblem& problem, const TimingOptions& options = {},
                const RigidBodyOptions& planning = {}) {
  const Result<TimedPlan> timed = OptimiseTiming(problem, planning, options);
  EXPECT_TRUE(timed.ok()) << timed.failure().message;
  if (!timed.ok()) return {};
  EXPECT_NO_THROW(CheckRigidBodyProblem(timed->problem));
  const RigidBodyFaults faults = FaultsOf(timed->problem, timed->plan.motion, 1e-3);
  EXPECT_LT(faults.Largest(), 1e-3) << faults.torque_balance << " " << faults.reach_m << " " << faults.goal;
  EXPECT_LE(faults.friction, 0.0);
  EXPECT_LE(timed->plan.summary.violation, planning.tolerance);
  EXPECT_LE(timed->plan.summary.cost, timed->first_cost);
  EXPECT_NEAR(timed->plan.motion.duration_s(), timed->problem.duration_s, 1e-12);
  return *timed;
}

VectorX DurationsOf(const RigidBodyProblem& problem) {
  const std::vector<double> switches = SwitchTimes(problem);
  const Eigen::Map<const VectorX> times(switches.data(), static_cast<Eigen::Index>(switches.size()));
  return times.tail(times.size() - 1) - times.head(times.size() - 1);
}

TEST(OptimiseTiming, CostsFallInTheSameTime) {
  for (const RigidBodyProblem& problem :
       {rigid_bodies::Hopper(), rigid_bodies::Walker(), rigid_bodies::Trotter(), rigid_bodies::SoledWalker()}) {
    const TimedPlan timed = Timed(problem);
    const Result<RigidBodyPlan> first = PlanRigidBody(problem);
    ASSERT_TRUE(first.ok());
    EXPECT_EQ(timed.first_cost, first->summary.cost);
    EXPECT_LT(timed.plan.summary.cost, 0.97 * timed.first_cost);
    EXPECT_GE(timed.steps, 1);
    EXPECT_GE(timed.solves, timed.steps);
    EXPECT_EQ(timed.problem.duration_s, problem.duration_s);
    // Solved again from scratch, over nodes of its own spacing.
    const Result<RigidBodyPlan> anew = PlanRigidBody(timed.problem);
    ASSERT_TRUE(anew.ok()) << anew.failure().message;
    EXPECT_NEAR(anew->summary.cost, timed.plan.summary.cost, 0.1 * timed.plan.summary.cost);
  }
}

TEST(OptimiseTiming, ByTheOtherMethodToo) {
  const TimedPlan interior = Timed(rigid_bodies::Hopper());
  const TimedPlan augmented = Timed(rigid_bodies::Hopper(), {}, {.method = "ceres"});
  EXPECT_NEAR(interior.plan.summary.cost, augmented.plan.summary.cost, 0.05 * interior.plan.summary.cost);
}

/// A vertical hop on one foot: no other flight within the same time costs less than the result.
TEST(OptimiseTiming, TheFlightOfAHopOnTheSpotIsTheBestOfAScan) {
  const RigidBodyProblem problem = rigid_bodies::Hopper(0.0);
  const TimedPlan timed =
      Timed(problem, {.shortest_s = 0.1, .shortest_swing_s = 0.0, .least_gain = 1e-4, .max_solves = 30});
  const VectorX found = DurationsOf(timed.problem);
  EXPECT_NEAR(found[0], found[2], 0.01) << "what is the same backwards stays so";
  const std::vector<double> from = SwitchTimes(problem);
  double least = 1e9, best_s = 0.0;
  for (double flight_s = 0.1; flight_s < 0.45; flight_s += 0.01) {
    const double stand_s = 0.5 * (problem.duration_s - flight_s);
    const TimeMap map(from, {0.0, stand_s, stand_s + flight_s, problem.duration_s});
    const Result<RigidBodyPlan> plan = PlanRigidBody(Retimed(problem, map));
    ASSERT_TRUE(plan.ok()) << flight_s;
    if (plan->summary.cost >= least) continue;
    least = plan->summary.cost;
    best_s = flight_s;
  }
  EXPECT_NEAR(found[1], best_s, 0.011);
  EXPECT_LT(timed.plan.summary.cost, 1.02 * least);
}

TEST(OptimiseTiming, WhatIsAtItsBestStays) {
  const TimingOptions fine{.least_gain = 1e-3, .max_solves = 40};
  const TimedPlan timed = Timed(rigid_bodies::Hopper(), fine);
  const TimedPlan again = Timed(timed.problem);
  EXPECT_GT(again.plan.summary.cost, 0.97 * timed.plan.summary.cost);
  EXPECT_LT((DurationsOf(again.problem) - DurationsOf(timed.problem)).cwiseAbs().maxCoeff(), 0.06);
}

TEST(OptimiseTiming, DurationsStayWithinBoundsAndInOrder) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const TimingOptions options{.shortest_s = 0.14, .longest_s = 0.46, .shortest_swing_s = 0.0};
  const TimedPlan timed = Timed(problem, options);
  const VectorX durations = DurationsOf(timed.problem);
  ASSERT_EQ(durations.size(), DurationsOf(problem).size());
  EXPECT_GE(durations.minCoeff(), options.shortest_s - 1e-12);
  EXPECT_LE(durations.maxCoeff(), options.longest_s + 1e-12);
  EXPECT_LT(std::min(durations.minCoeff() - options.shortest_s, options.longest_s - durations.maxCoeff()), 1e-3)
      << "bounds that matter";
  const std::vector<double> before = SwitchTimes(problem), after = SwitchTimes(timed.problem);
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    const auto index = [](const std::vector<double>& times, double t) {
      return std::find_if(times.begin(), times.end(), [t](double other) { return std::abs(other - t) < 1e-9; }) -
             times.begin();
    };
    EXPECT_EQ(index(before, problem.stances[s].start_s), index(after, timed.problem.stances[s].start_s));
    EXPECT_EQ(index(before, problem.stances[s].end_s), index(after, timed.problem.stances[s].end_s));
  }
}

/// The shortest time between two stances of a foot.
double ShortestSwing(const RigidBodyProblem& problem) {
  double shortest = 1e9;
  for (std::size_t s = 1; s < problem.stances.size(); ++s) {
    if (problem.stances[s].foot == problem.stances[s - 1].foot)
      shortest = std::min(shortest, problem.stances[s].start_s - problem.stances[s - 1].end_s);
  }
  return shortest;
}

TEST(OptimiseTiming, SwingsAreNotHurried) {
  for (const RigidBodyProblem& problem : {rigid_bodies::Hopper(), rigid_bodies::Walker(), rigid_bodies::Trotter()}) {
    const double heedless = ShortestSwing(Timed(problem, {.shortest_swing_s = 0.0}).problem), least = heedless + 0.02;
    ASSERT_LT(least, ShortestSwing(problem));
    EXPECT_GE(ShortestSwing(Timed(problem, {.shortest_swing_s = least}).problem), least - 1e-9);
  }
  // A swing that starts out shorter does not become shorter.
  const RigidBodyProblem hopper = rigid_bodies::Hopper();
  EXPECT_GE(ShortestSwing(Timed(hopper, {.shortest_swing_s = 0.6}).problem), ShortestSwing(hopper) - 1e-9);
}

TEST(OptimiseTiming, FeetThatChangeTogetherStillDo) {
  const RigidBodyProblem problem = rigid_bodies::Trotter();
  const TimedPlan timed = Timed(problem);
  ASSERT_GT(timed.steps, 0);
  for (std::size_t a = 0; a < problem.stances.size(); ++a) {
    for (std::size_t b = 0; b < problem.stances.size(); ++b) {
      if (std::abs(problem.stances[a].end_s - problem.stances[b].start_s) > 1e-9) continue;
      EXPECT_EQ(timed.problem.stances[a].end_s, timed.problem.stances[b].start_s);
    }
  }
}

TEST(OptimiseTiming, ATotalThatIsFreeStaysWithinItsBoundsAndCostsLess) {
  const RigidBodyProblem problem = rigid_bodies::Hopper();
  const TimedPlan fixed = Timed(problem);
  const TimedPlan longer = Timed(problem, {.most_total = 1.2});
  EXPECT_LT(longer.plan.summary.cost, fixed.plan.summary.cost);
  EXPECT_GT(longer.problem.duration_s, 1.05 * problem.duration_s);
  EXPECT_LE(longer.problem.duration_s, 1.2 * problem.duration_s);
  const TimedPlan shorter = Timed(problem, {.least_total = 0.9});
  EXPECT_GE(shorter.problem.duration_s, 0.9 * problem.duration_s);
  EXPECT_LE(shorter.problem.duration_s, problem.duration_s);
}

TEST(OptimiseTiming, TimesOutOfBoundsAreBroughtToTheNearestOnes) {
  const RigidBodyProblem problem = rigid_bodies::Hopper();
  const TimedPlan timed = Timed(problem, {.longest_s = 0.45, .max_solves = 0});
  EXPECT_EQ(timed.steps, 0);
  const VectorX expected = (VectorX(3) << 0.45, 0.35, 0.45).finished();
  EXPECT_LT((DurationsOf(timed.problem) - expected).norm(), 1e-9);
}

TEST(OptimiseTiming, TheSameProblemHasTheSameTimes) {
  const TimedPlan a = Timed(rigid_bodies::Walker()), b = Timed(rigid_bodies::Walker());
  EXPECT_EQ(SwitchTimes(a.problem), SwitchTimes(b.problem));
  EXPECT_EQ(a.plan.summary.cost, b.plan.summary.cost);
  const Result<RigidBodyPlan> first = PlanRigidBody(rigid_bodies::Walker());
  ASSERT_TRUE(first.ok());
  const Result<TimedPlan> c = OptimiseTiming(rigid_bodies::Walker(), {}, {}, &*first);
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(SwitchTimes(a.problem), SwitchTimes(c->problem));
}

/// Tied phases: the two stances of a hop are one part, from which the flight takes time.
TEST(OptimiseTiming, TiedPhasesChangeTogetherInTheSameTime) {
  const RigidBodyProblem problem = rigid_bodies::Hopper();
  const VectorX given = DurationsOf(problem);
  ASSERT_EQ(given.size(), 3);
  PhaseTies ties{MatrixX::Zero(3, 2), VectorX::Zero(3), VectorX(2), VectorX::Constant(2, 0.05)};
  ties.phases_by_parts << 0.5, 0.0, 0.0, 1.0, 0.5, 0.0;
  ties.parts_s << given[0] + given[2], given[1];
  const Result<TimedPlan> timed = OptimiseTiming(problem, {}, {}, nullptr, &ties);
  ASSERT_TRUE(timed.ok()) << timed.failure().message;
  EXPECT_LT(timed->plan.summary.cost, 0.97 * timed->first_cost);
  EXPECT_EQ(timed->problem.duration_s, problem.duration_s);
  EXPECT_NEAR(timed->parts_s.sum(), ties.parts_s.sum(), 1e-9);
  const VectorX found = DurationsOf(timed->problem);
  EXPECT_NEAR(found[0], found[2], 1e-9);
  EXPECT_NEAR(found[1], timed->parts_s[1], 1e-9);
  EXPECT_GT(std::abs(found[1] - given[1]), 0.01);
}

TEST(OptimiseTiming, MendsTimesAtWhichThereIsNoMotion) {
  const RigidBodyOptions coarse{.spacing_s = 0.08, .force_margin = 1e-5, .tolerance = 1e-6, .weights = {}};
  struct Hop {
    double distance_m, flight_s;
  };
  // A flight that is too long for the reach of the leg, and one that is too short for the distance.
  for (const Hop& hop : {Hop{0.5, 0.8}, Hop{0.8, 0.1}}) {
    const RigidBodyProblem hopper = rigid_bodies::Hopper(hop.distance_m);
    const double stand_s = 0.5 * (hopper.duration_s - hop.flight_s);
    const TimeMap map(SwitchTimes(hopper), {0.0, stand_s, stand_s + hop.flight_s, hopper.duration_s});
    const RigidBodyProblem problem = Retimed(hopper, map);
    ASSERT_FALSE(PlanRigidBody(problem, coarse).ok());
    const TimedPlan timed = Timed(problem, {}, coarse);
    EXPECT_TRUE(timed.mended);
    EXPECT_EQ(timed.problem.duration_s, problem.duration_s);
    EXPECT_GT(std::abs(DurationsOf(timed.problem)[1] - hop.flight_s), 0.05);
  }
  EXPECT_FALSE(Timed(rigid_bodies::Hopper()).mended);
}

void ExpectRefused(const RigidBodyProblem& problem, const TimingOptions& options, FailureKind kind, FailureCode code,
                   const char* said) {
  const Result<TimedPlan> timed = OptimiseTiming(problem, {}, options);
  ASSERT_FALSE(timed.ok());
  EXPECT_EQ(timed.failure().kind, kind);
  EXPECT_EQ(timed.failure().code, code);
  EXPECT_NE(timed.failure().message.find(said), std::string::npos) << timed.failure().message;
}

TEST(OptimiseTiming, RefusesWhatCannotBe) {
  RigidBodyProblem problem = rigid_bodies::Hopper();
  ExpectRefused(problem, {.shortest_s = 0.5}, FailureKind::kInfeasible, FailureCode::kNoTiming,
                "the shortest durations of the 3 phases sum to 1.5 s; the longest accepted total is 1.25 s");
  ExpectRefused(problem, {.longest_s = 0.4}, FailureKind::kInfeasible, FailureCode::kNoTiming,
                "the longest durations of the 3 phases sum to 1.2 s; the shortest accepted total is 1.25 s");
  ExpectRefused(problem, {.shortest_s = 0.4, .longest_s = 0.3, .least_total = 0.5}, FailureKind::kBadInput,
                FailureCode::kNoDuration, "the shortest phase duration, 0.4 s, is above the longest, 0.3 s");
  ExpectRefused(rigid_bodies::Hopper(8.0), {}, FailureKind::kInfeasible, FailureCode::kUnmetLaw,
                "; with other contact times, ");
  rigid_bodies::AddLegMotion(problem, 20);
  ExpectRefused(problem, {}, FailureKind::kBadInput, FailureCode::kTiedToTime, "leg angular momentum");
  RigidBodyProblem beside = rigid_bodies::Hopper();
  beside.clearances = {{0.3}};
  ExpectRefused(beside, {}, FailureKind::kBadInput, FailureCode::kTiedToTime, "clearances");
  EXPECT_THROW((void)OptimiseTiming(rigid_bodies::Hopper(), {}, {.least_total = 1.2}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
