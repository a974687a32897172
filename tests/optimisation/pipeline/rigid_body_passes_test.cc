// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/rigid_body_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {
namespace {

WalkCommand ForwardWalk(double speed_m_s, double distance_m) {
  WalkCommand command;
  command.speed_m_s = speed_m_s;
  command.distance_m = distance_m;
  return command;
}

/// A bound of two cycles, the result of its passes, and the finished plan; made once.
struct Bounded {
  RobotModel model = *LoadNamedRobot("a1");
  WalkCommand command = ForwardWalk(0.5, 0.2);
  Gait gait = *FindGait(model, "bound", CommandedSpeed(model, command), {});
  MotionOptions options;
  FootstepSkeleton skeleton = *PlanFootsteps(model, FlatTerrain(), gait, command, options.footsteps);
  int passes = 0;
  MotionPass pass;
  MotionPlan plan;

  Bounded() {
    const Terrain ground = FlatTerrain();
    const BodyPath body(model, skeleton, gait.cycle_s);
    Result<MotionPass> made =
        RigidBodyPasses(MotionTask{model, ground, skeleton, options, body, gait.cycle_s}).Run(passes);
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.failure().message);
    if (made.ok()) pass = std::move(*made);
    const Result<PlannedMotion> planned = PlanMotion(model, ground, gait, command, options);
    EXPECT_TRUE(planned.ok() && !planned->unfinished);
    if (planned.ok()) plan = planned->plan;
  }

  /// Of the passes.
  const WholeBodyTrajectory& rows() const { return pass.solution.trajectory; }
};

const Bounded& Bound() {
  static const Bounded bound;
  return bound;
}

/// Unbalanced force / weight, and moment / weight [m], of base and contacts at a row.
double UnbalancedAt(const Bounded& bound, std::size_t row, DynamicsScratch& scratch) {
  const WholeBodyTrajectory& rows = bound.rows();
  VectorX tau;
  InverseDynamics(bound.model, rows.q[row], rows.v[row], rows.a[row], scratch, tau);
  for (int f = 0; f < static_cast<int>(bound.model.feet.size()); ++f) {
    const ContactWrench& given = rows.wrenches[row][static_cast<std::size_t>(f)];
    Vector6 wrench;
    wrench << given.force_W, given.moment_W;
    AddPointWrench(bound.model, scratch, bound.model.feet[static_cast<std::size_t>(f)].body,
                   ContactFrame(bound.model, scratch, f).translation(), -wrench, tau);
  }
  return std::max(tau.head<3>().norm(), tau.segment<3>(3).norm()) / bound.model.weight_n();
}

TEST(RigidBodyPasses, LeaveUnbalancedWhatLegsWithMassNeed) {
  const Bounded& bound = Bound();
  EXPECT_EQ(bound.passes, 1);
  EXPECT_GT(bound.pass.error_m, 0.01);
  DynamicsScratch scratch(bound.model);
  double worst = 0.0;
  for (std::size_t k = 0; k < bound.rows().q.size(); ++k) worst = std::max(worst, UnbalancedAt(bound, k, scratch));
  EXPECT_NEAR(worst, bound.pass.error_m, 1e-6);
}

TEST(RigidBodyPasses, FinishedFeetAreOnTheirFootholdsAndRollAsSaid) {
  const Bounded& bound = Bound();
  const WholeBodyTrajectory& rows = bound.plan.whole_body;
  DynamicsScratch scratch(bound.model);
  double rolled = 0.0;
  int looked = 0;
  for (const Foothold& foothold : bound.plan.footsteps.footholds) {
    for (std::size_t k = 0; k < rows.q.size(); ++k) {
      const double t = rows.start_s + static_cast<double>(k) * rows.step_s;
      const bool first = std::abs(t - foothold.touchdown_s) < 1e-6, last = std::abs(t - foothold.liftoff_s) < 1e-6;
      if (!first && !last) continue;
      ForwardKinematics(bound.model, rows.q[k], scratch);
      const Vector3 p_WF = ContactFrame(bound.model, scratch, foothold.foot).translation();
      const Vector3 expected = foothold.X_WF.translation() + (last ? foothold.roll_W : Vector3::Zero());
      EXPECT_LT((p_WF - expected).norm(), 1e-3) << "foot " << foothold.foot << " at " << t << " s";
      EXPECT_NEAR(p_WF.z(), 0.0, 1e-5);
      rolled = std::max(rolled, foothold.roll_W.norm());
      ++looked;
    }
  }
  EXPECT_EQ(looked, static_cast<int>(2 * bound.plan.footsteps.footholds.size()));
  EXPECT_GT(rolled, 1e-3) << "spheres roll";
}

TEST(RigidBodyPasses, NothingPushesInFlightAndTheFinishedCentreOfMassFallsFreely) {
  const Bounded& bound = Bound();
  const WholeBodyTrajectory& rows = bound.plan.whole_body;
  const double weight = bound.model.weight_n();
  DynamicsScratch scratch(bound.model);
  VectorX tau;
  int flying = 0;
  for (std::size_t k = 0; k < rows.q.size(); ++k) {
    const double time_s = rows.start_s + static_cast<double>(k) * rows.step_s;
    const bool flies = std::any_of(
        bound.skeleton.schedule.phases.begin(), bound.skeleton.schedule.phases.end(), [&](const ContactPhase& phase) {
          return phase.stance == 0 && time_s > phase.start_s + 1e-6 && time_s < phase.end_s - 1e-6;
        });
    if (!flies) continue;
    ++flying;
    for (const ContactWrench& wrench : rows.wrenches[k]) {
      EXPECT_EQ(wrench.force_W.norm(), 0.0);
      EXPECT_EQ(wrench.moment_W.norm(), 0.0);
    }
    InverseDynamics(bound.model, rows.q[k], rows.v[k], rows.a[k], scratch, tau);
    EXPECT_LT(tau.head<3>().norm(), 1e-3 * weight) << time_s;
    EXPECT_LT(tau.segment<3>(3).norm(), 1e-3 * weight * bound.model.leg_length_m()) << time_s;
    EXPECT_LT((bound.plan.centroidal.a_WC[k] + kGravity * Vector3::UnitZ()).norm(), 1e-3 * kGravity) << time_s;
    EXPECT_LT((CentreOfMass(bound.model, scratch) - bound.plan.centroidal.p_WC[k]).norm(), 1e-9);
  }
  EXPECT_GT(flying, 10);
}

TEST(RigidBodyPasses, WhatStandsCarriesAndTheMotionBeginsAndEndsAtRest) {
  const Bounded& bound = Bound();
  double most = 0.0;
  for (std::size_t k = 0; k < bound.rows().q.size(); ++k) {
    double carried = 0.0;
    for (const ContactWrench& wrench : bound.rows().wrenches[k]) {
      EXPECT_GE(wrench.force_W.z(), -1e-6);
      carried += wrench.force_W.z();
    }
    most = std::max(most, carried / bound.model.weight_n());
  }
  EXPECT_GT(most, 1.3) << "what flies is pushed off by more than its weight";
  const std::vector<VectorX>& v = bound.plan.whole_body.v;
  for (const VectorX& end : {v.front(), v.back()}) EXPECT_LT(end.norm(), 1e-4);
}

MotionPlan PlannedBy(const RobotModel& model, const std::string& name, const WalkCommand& command,
                     const MotionOptions& options, const GaitOptions& gaits = {}) {
  const Result<Gait> gait = FindGait(model, name, CommandedSpeed(model, command), gaits);
  const Result<PlannedMotion> motion = PlanMotion(model, FlatTerrain(), *gait, command, options);
  EXPECT_TRUE(motion.ok()) << (motion.ok() ? "" : motion.failure().message);
  return motion.ok() ? motion->plan : MotionPlan{};
}

class RigidBodyPassesOf : public testing::TestWithParam<std::pair<std::string, double>> {};

// The feet of a bound roll more within a force interval than those of other gaits.
INSTANTIATE_TEST_SUITE_P(Gaits, RigidBodyPassesOf,
                         testing::Values(std::pair<std::string, double>{"pronk", 0.5},
                                         std::pair<std::string, double>{"bound", 0.8}),
                         [](const auto& gait) { return gait.param.first; });

TEST_P(RigidBodyPassesOf, AreFinishedToTheProgramsOwnTolerance) {
  const RobotModel model = *LoadNamedRobot("a1");
  const auto& [name, speed_m_s] = GetParam();
  const WalkCommand command = ForwardWalk(speed_m_s, 0.2);
  const Gait gait = *FindGait(model, name, CommandedSpeed(model, command), {});
  const MotionOptions options;
  const Result<PlannedMotion> motion = PlanMotion(model, FlatTerrain(), gait, command, options);
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  EXPECT_FALSE(motion->unfinished);
  EXPECT_LE(motion->residual, options.trajectory.residual);
  EXPECT_EQ(motion->passes, 1);
}

TEST(RigidBodyPasses, OfAMotionPastLimitsStayThePlanAndSayWhyItIsUnfinished) {
  RobotModel model = *LoadNamedRobot("a1");
  for (Joint& joint : model.joints) joint.velocity_limit *= 0.1;  // too slow for this bound
  const WalkCommand command = ForwardWalk(0.8, 1.0);
  const Gait gait = *FindGait(model, "bound", CommandedSpeed(model, command), {});
  const Result<PlannedMotion> planned = PlanMotion(model, FlatTerrain(), gait, command, {});
  ASSERT_TRUE(planned.ok());
  EXPECT_GT(planned->limit_violation, 1e-3);
  ASSERT_TRUE(planned->unfinished);
  EXPECT_EQ(planned->unfinished->kind, FailureKind::kInfeasible);
}

TEST(RigidBodyPasses, WhatNoForcesCarryIsRefusedByTheNamesOfFeet) {
  const RobotModel model = *LoadNamedRobot("a1");
  WalkCommand command;
  command.extent = WalkCommand::Extent::kSteps;
  command.steps = 4;
  command.step_length_m = 0.4;
  const Gait gait = *FindGait(model, "jump", CommandedSpeed(model, command), {});
  const Result<PlannedMotion> planned = PlanMotion(model, FlatTerrain(), gait, command, {});
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().kind, FailureKind::kInfeasible);
  EXPECT_NE(planned.failure().message.find("_foot' at "), std::string::npos) << planned.failure().message;
  GaitOptions slow;
  slow.cycle_s = 6.0;
  const Gait long_flights = *FindGait(model, "pronk", 0.2, slow);
  const Result<PlannedMotion> flying = PlanMotion(model, FlatTerrain(), long_flights, ForwardWalk(0.2, 0.5), {});
  ASSERT_FALSE(flying.ok());
  EXPECT_EQ(flying.failure().code, FailureCode::kLegsTooSlow);
  EXPECT_NE(flying.failure().message.find("_calf_joint' is limited to 21 rad/s"), std::string::npos)
      << flying.failure().message;
}

/// Vertical range of a plan's centre of mass [m]; 0 for a pendulum on level ground.
double Heave(const MotionPlan& plan) {
  const auto [least, most] = std::minmax_element(plan.centroidal.p_WC.begin(), plan.centroidal.p_WC.end(),
                                                 [](const Vector3& a, const Vector3& b) { return a.z() < b.z(); });
  return most->z() - least->z();
}

TEST(RigidBodyPasses, ATrotAskedForAsARigidBodysEndsAtItsGoal) {
  const RobotModel model = *LoadNamedRobot("a1");
  MotionOptions options;
  options.centre_of_mass.method = "rigid-body";
  WalkCommand command = ForwardWalk(0.4, 0.2);
  const MotionPlan plan = PlannedBy(model, "trot", command, options);
  ASSERT_FALSE(plan.whole_body.q.empty());
  const VectorX& end = plan.whole_body.q.back();
  EXPECT_NEAR(plan.goal.x_m, 0.2, 1e-6);
  EXPECT_LT((end.head<2>() - Vector2(plan.goal.x_m, plan.goal.y_m)).norm(), 2e-3);
  EXPECT_NEAR(YawOf(BaseRotation(end)), plan.goal.yaw_rad, 2e-3);
  EXPECT_GT(Heave(plan), 1e-4);
}

TEST(RigidBodyPasses, AreForGaitsInWhichNoFootCarriesOnAndForNoOthers) {
  const RobotModel model = *LoadNamedRobot("a1");
  MotionOptions once;
  once.pipeline.max_body_passes = 1;
  GaitOptions half;
  half.duty_factor = 0.5;
  const WalkCommand command = ForwardWalk(0.4, 0.15);
  EXPECT_GT(Heave(PlannedBy(model, "bound", command, once)), 1e-3) << "it flies";
  EXPECT_GT(Heave(PlannedBy(model, "trot", command, once, half)), 1e-4) << "pairs are exchanged at once";
  EXPECT_LT(Heave(PlannedBy(model, "trot", command, once)), 1e-9) << "a pendulum does";
  EXPECT_LT(Heave(PlannedBy(model, "crawl", ForwardWalk(0.1, 0.05), once)), 1e-9);
}

}  // namespace
}  // namespace gaitwright
