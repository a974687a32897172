// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/cost_by_durations.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// The optimal cost at other times, solved again from the variables of a motion.
double CostAt(const RigidBodyProblem& problem, const RigidBodyOptions& options, const RigidBodyPlan& plan,
              std::size_t phase, double step_s) {
  const std::vector<double> switches = SwitchTimes(problem);
  std::vector<double> moved = switches;
  for (std::size_t k = phase + 1; k < moved.size(); ++k) moved[k] += step_s;
  const TimeMap map(switches, moved);
  const Result<RigidBodyPlan> other = PlanRigidBodyFrom(Retimed(problem, map), options, Retimed(plan.numbers, map));
  EXPECT_TRUE(other.ok()) << other.failure().message;
  return other.ok() ? other->summary.cost : std::nan("");
}

void ExpectSlopesOfLeastCosts(const RigidBodyProblem& problem, const RigidBodyOptions& options, double step_s,
                              double close) {
  const Result<RigidBodyPlan> plan = PlanRigidBody(problem, options);
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  const VectorX slope = CostByDurations(problem, options, plan->numbers);
  ASSERT_EQ(static_cast<std::size_t>(slope.size()) + 1, SwitchTimes(problem).size());
  EXPECT_GT(slope.norm(), 1e-3);
  for (Eigen::Index i = 0; i < slope.size(); ++i) {
    const auto phase = static_cast<std::size_t>(i);
    const double by_solves =
        (CostAt(problem, options, *plan, phase, step_s) - CostAt(problem, options, *plan, phase, -step_s)) /
        (2.0 * step_s);
    EXPECT_NE(slope[i], by_solves) << "they are two roads";
    EXPECT_NEAR(slope[i], by_solves, close * (0.1 * slope.norm() + std::abs(by_solves))) << "phase " << phase;
  }
}

TEST(CostByDurations, IsTheSlopeOfTheLeastCosts) {
  RigidBodyOptions options;
  options.cost_tolerance = 1e-7;
  options.tolerance = 1e-8;
  for (const RigidBodyProblem& problem :
       {rigid_bodies::Hopper(), rigid_bodies::Walker(), rigid_bodies::Trotter(), rigid_bodies::SoledWalker()})
    ExpectSlopesOfLeastCosts(problem, options, 1e-3, 0.02);
}

TEST(CostByDurations, IsSoByTheOtherMethodToo) {
  RigidBodyOptions options;
  options.method = "ceres";
  options.cost_tolerance = 1e-6;
  ExpectSlopesOfLeastCosts(rigid_bodies::Hopper(), options, 1e-3, 0.05);
}

TEST(CostByDurations, RefusesNumbersOfAnotherProblem) {
  const Result<RigidBodyPlan> plan = PlanRigidBody(rigid_bodies::Hopper());
  ASSERT_TRUE(plan.ok());
  EXPECT_THROW((void)CostByDurations(rigid_bodies::Walker(), {}, plan->numbers), InvalidArgument);
  RigidBodyNumbers fewer = plan->numbers;
  fewer.multipliers.conservativeResize(fewer.multipliers.size() - 1);
  EXPECT_THROW((void)CostByDurations(rigid_bodies::Hopper(), {}, fewer), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
