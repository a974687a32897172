// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/motion_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "optimisation/pipeline/robot_body.h"
#include "planning/footsteps/plan_sequence.h"
#include "planning/gait/find_gait.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

MotionPass PassOf(bool settled, double error_m) {
  MotionPass pass;
  pass.settled = settled;
  pass.error_m = error_m;
  return pass;
}

TEST(MotionPass, IsBetterWhereItHasConvergedThenWhereItIsLaterOrNearer) {
  const MotionPass none, unsettled = PassOf(false, 0.1), settled = PassOf(true, 0.1);
  EXPECT_EQ(none.error_m, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(unsettled.BetterThan(none));
  EXPECT_TRUE(PassOf(false, 0.9).BetterThan(unsettled)) << "the latest of those that have not converged";
  EXPECT_TRUE(PassOf(true, 0.9).BetterThan(unsettled));
  EXPECT_FALSE(PassOf(false, 0.01).BetterThan(settled));
  EXPECT_TRUE(PassOf(true, 0.09).BetterThan(settled));
  EXPECT_FALSE(PassOf(true, 0.1).BetterThan(settled)) << "no nearer";
}

/// Standing still, or a few steps forward, as a task for the passes.
struct PassesTask {
  PassesTask(const RobotModel& robot, int steps, double step_length_m = 0.03) : model(robot) {
    options.pipeline.grid_step_s = 0.01;
    options.footsteps.initial_stand_s = options.footsteps.final_stand_s = 0.3;
    WalkCommand command;
    command.extent = WalkCommand::Extent::kDuration;
    command.duration_s = 0.4;
    Gait gait = StandingGait(static_cast<int>(model.legs.size()));
    if (steps > 0) {
      command = WalkCommand{};
      command.extent = WalkCommand::Extent::kSteps;
      command.steps = steps;
      command.step_length_m = step_length_m;
      gait = FindGait(model, "walk", CommandedSpeed(model, command), {}).value();
    }
    skeleton = PlanSequence(model, terrain, {{gait, command}}, StandingOptions(options)).value();
    cycle_s = gait.cycle_s;
  }

  /// Keeps references to this object and to the body.
  MotionTask Task(const BodyPath& body) const { return {model, terrain, skeleton, options, body, cycle_s}; }

  BodyStrategy Upright() const {
    BodyStrategy strategy;
    strategy.com_height_m = StandingCentreOfMass(model).z();
    strategy.zmp_inward = options.pipeline.zmp_inward;
    return strategy;
  }

  Result<MotionPass> RunWith(const BodyStrategy& strategy, int& passes,
                             double infeasible = std::numeric_limits<double>::infinity()) const {
    const BodyPath body(model, skeleton, cycle_s);
    return MotionPasses(Task(body), strategy).Run(passes, infeasible);
  }
  Result<MotionPass> Once(const BodyStrategy& strategy) const {
    const BodyPath body(model, skeleton, cycle_s);
    return MotionPasses(Task(body), strategy).RunOnce();
  }

  const RobotModel& model;
  Terrain terrain = FlatTerrain();
  MotionOptions options;
  FootstepSkeleton skeleton;
  double cycle_s = 0.5;
};

class MotionPassesTest : public testing::TestWithParam<const char*> {};

TEST_P(MotionPassesTest, StandingStillNeedsOnePass) {
  const PassesTask task(NamedRobot(GetParam()), 0);
  int passes = 99;
  const Result<MotionPass> pass = task.RunWith(task.Upright(), passes);
  ASSERT_TRUE(pass.ok()) << pass.failure().message;
  EXPECT_EQ(passes, 0);
  EXPECT_TRUE(pass->settled);
  EXPECT_LT(pass->error_m, 1e-5);
  EXPECT_LE(pass->outside_m, 0.0);
  EXPECT_TRUE(pass->swings.empty());
  const CentroidalTrajectory& c = pass->centroidal;
  EXPECT_EQ(c.size(), pass->solution.trajectory.size());
  for (const Vector3& p : c.p_WC) EXPECT_LT((p - StandingCentreOfMass(task.model)).norm(), 1e-6);
}

TEST_P(MotionPassesTest, TheBodyIsCarriedAtTheHeightThatIsAsked) {
  const PassesTask task(NamedRobot(GetParam()), 0);
  BodyStrategy low = task.Upright();
  low.com_height_m *= 0.93;
  const Result<MotionPass> pass = task.Once(low);
  ASSERT_TRUE(pass.ok()) << pass.failure().message;
  EXPECT_NEAR(pass->centroidal.p_WC.front().z(), low.com_height_m, 1e-9);
  EXPECT_NEAR(pass->centroidal.omega_rad_s, std::sqrt(kGravity / low.com_height_m), 1e-12);
}

TEST_P(MotionPassesTest, ABodyHigherThanItsLegsIsOutOfReach) {
  const PassesTask task(NamedRobot(GetParam()), 0);
  BodyStrategy high = task.Upright();
  high.com_height_m += task.model.leg_length_m();
  int passes = 0;
  for (const Result<MotionPass>& pass : {task.Once(high), task.RunWith(high, passes)}) {
    ASSERT_FALSE(pass.ok());
    EXPECT_EQ(pass.failure().kind, FailureKind::kInfeasible);
    EXPECT_EQ(pass.failure().code, FailureCode::kOutOfReach);
  }
}

TEST_P(MotionPassesTest, PassesBringTheMultibodysZmpToItsReference) {
  const PassesTask task(NamedRobot(GetParam()), 2);
  const Result<MotionPass> first = task.Once(task.Upright());
  ASSERT_TRUE(first.ok()) << first.failure().message;
  int passes = 0;
  const Result<MotionPass> last = task.RunWith(task.Upright(), passes);
  ASSERT_TRUE(last.ok()) << last.failure().message;
  EXPECT_GT(first->error_m, task.options.pipeline.zmp_tolerance_m);
  EXPECT_LT(last->error_m, 0.5 * first->error_m);
  EXPECT_TRUE(last->settled);
  EXPECT_GT(passes, 0);
  EXPECT_LE(passes, 2 * task.options.pipeline.max_passes);
  double largest = 0.0;
  for (std::size_t k = 0; k < last->solution.zmp_W.size(); ++k)
    largest = std::max(largest, (last->solution.zmp_W[k] - last->centroidal.p_WZ[k]).norm());
  EXPECT_DOUBLE_EQ(last->error_m, largest);
}

TEST_P(MotionPassesTest, InAConvergedPassFeetRollAsTheirFootholdsSay) {
  const PassesTask task(NamedRobot(GetParam()), 2);
  int passes = 0;
  const Result<MotionPass> pass = task.RunWith(task.Upright(), passes);
  ASSERT_TRUE(pass.ok()) << pass.failure().message;
  ASSERT_TRUE(pass->settled);
  bool rolls = false;
  for (std::size_t i = 0; i < pass->footsteps.footholds.size(); ++i) {
    const Vector3 rolled = pass->solution.roll_at_liftoff_W[i] - pass->solution.roll_at_touchdown_W[i];
    EXPECT_LT((pass->footsteps.footholds[i].roll_W - rolled).norm(), 2e-4) << i;
    rolls = rolls || rolled.norm() > 1e-3;
  }
  EXPECT_EQ(rolls, task.model.feet[0].radius > 0.0);
}

TEST_P(MotionPassesTest, AFirstPassPastHopeIsTheLast) {
  const PassesTask task(NamedRobot(GetParam()), 2);
  int passes = 99;
  const Result<MotionPass> pass = task.RunWith(task.Upright(), passes, -1.0);
  ASSERT_TRUE(pass.ok()) << pass.failure().message;
  EXPECT_EQ(passes, 0);
  EXPECT_DOUBLE_EQ(pass->error_m, task.Once(task.Upright())->error_m);
}

INSTANTIATE_TEST_SUITE_P(Robots, MotionPassesTest, testing::Values("a1", "nao"));

TEST(MotionPasses, FeetThatRollAreSetDownSoThatTheyEndAsStanding) {
  PassesTask task(NamedRobot("a1"), 4);
  task.options.pipeline.end_as_standing = true;
  int passes = 0;
  const Result<MotionPass> pass = task.RunWith(task.Upright(), passes);
  ASSERT_TRUE(pass.ok()) << pass.failure().message;
  const double end_s = task.skeleton.schedule.end_s();
  int last = 0;
  for (std::size_t i = 0; i < pass->footsteps.footholds.size(); ++i) {
    const Foothold& foothold = pass->footsteps.footholds[i];
    if (foothold.liftoff_s < end_s - 1e-6 || foothold.touchdown_s == 0.0) continue;
    ++last;
    const Vector3 rests = foothold.X_WF.translation() + foothold.roll_W;
    const Vector3 as_standing = task.skeleton.footsteps.footholds[i].X_WF.translation();
    EXPECT_LT((rests - as_standing).head<2>().norm(), 1e-9);
  }
  EXPECT_EQ(last, 4);
}

}  // namespace
}  // namespace gaitwright
