// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/plan_rigid_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/trajectory/swing_curve.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// Plans a motion that satisfies its constraints at 1 kHz, also between nodes.
RigidBodyPlan Planned(const RigidBodyProblem& problem, const RigidBodyOptions& options = {}) {
  const Result<RigidBodyPlan> plan = PlanRigidBody(problem, options);
  EXPECT_TRUE(plan.ok()) << plan.failure().message;
  if (!plan.ok()) return {};
  const RigidBodyFaults faults = FaultsOf(problem, plan->motion, 1e-3);
  EXPECT_LT(faults.Largest(), 1e-3) << faults.torque_balance << " " << faults.reach_m << " " << faults.goal;
  EXPECT_LT(faults.force_balance, 1e-6);
  EXPECT_LE(faults.friction, 0.0);
  EXPECT_LE(faults.unilateral, 0.0);
  return *plan;
}

TEST(PlanRigidBody, KeepsTheLawsForOneTwoAndFourFeet) {
  Planned(rigid_bodies::Hopper());
  Planned(rigid_bodies::Walker());
  Planned(rigid_bodies::Trotter());
  Planned(rigid_bodies::SoledWalker());
}

TEST(PlanRigidBody, StandingStillIsTheCheapestMotionToTheSamePlace) {
  RigidBodyProblem problem = rigid_bodies::Trotter(0.0);
  std::erase_if(problem.stances, [](const RigidStance& s) { return s.start_s > 0.0; });
  for (RigidStance& stance : problem.stances) stance.end_s = problem.duration_s;
  const RigidBodyPlan plan = Planned(problem);
  EXPECT_LT(plan.summary.cost, 1e-9);
  for (const RigidBodySample& s : Sample(plan.motion, 0.1)) {
    EXPECT_LT((s.p_WC - problem.start.p_WC).norm(), 1e-4);
    for (const Vector3& f : s.force_W) EXPECT_LT((f - 0.25 * 12.0 * kGravity * Vector3::UnitZ()).norm(), 0.02);
  }
}

TEST(PlanRigidBody, FlightIsAParabola) {
  const RigidBodyPlan plan = Planned(rigid_bodies::Hopper());
  int flying = 0;
  Vector3 v_off = Vector3::Zero();
  for (const RigidBodySample& s : Sample(plan.motion, 1e-3)) {
    if (s.time_s < 0.5 || s.time_s > 0.75 - 1e-9) continue;
    if (flying++ == 0) v_off = s.v_WC;
    const double t = s.time_s - 0.5;
    EXPECT_LT((s.v_WC - v_off + kGravity * t * Vector3::UnitZ()).norm(), 1e-4) << s.time_s;
  }
  EXPECT_GE(flying, 249);
  EXPECT_GT(v_off.z(), 0.8);  // up for half of 0.25 s, if it had to land at the height of its lift-off
}

TEST(PlanRigidBody, LeftAndRightAreAlike) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  RigidBodyProblem mirrored = problem;
  for (RigidFoot& foot : mirrored.feet) {
    foot.p_CF_nominal_B.y() *= -1.0;
    for (WorkspaceSide& side : foot.workspace_B) side.normal.y() *= -1.0;
  }
  for (RigidStance& stance : mirrored.stances) stance.X_WF.translation().y() *= -1.0;
  const RigidBodyPlan left = Planned(problem), right = Planned(mirrored);
  EXPECT_NEAR(left.summary.cost, right.summary.cost, 1e-3 * left.summary.cost);
  const std::vector<RigidBodySample> a = Sample(left.motion, 0.01), b = Sample(right.motion, 0.01);
  double sway = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sway = std::max(sway, std::abs(a[k].p_WC.y()));
    EXPECT_NEAR(a[k].p_WC.y(), -b[k].p_WC.y(), 5e-3);
    EXPECT_NEAR(a[k].p_WC.x(), b[k].p_WC.x(), 5e-3);
  }
  EXPECT_GT(sway, 0.02);
}

TEST(PlanRigidBody, RestsWhereItIsTo) {
  // Diagonal pairs in turn, all feet on the ground for a while, and diagonal pairs again.
  std::vector<rigid_bodies::Step> steps;
  for (const int foot : {0, 3})
    steps.insert(steps.end(), {{foot, 0.0, 0.2, 0.0}, {foot, 0.45, 1.3, 0.5}, {foot, 1.55, 2.2, 1.0}});
  for (const int foot : {1, 2})
    steps.insert(steps.end(), {{foot, 0.0, 0.45, 0.0}, {foot, 0.7, 1.55, 0.5}, {foot, 1.8, 2.2, 1.0}});
  const RigidBodyProblem trotter = rigid_bodies::Trotter();
  RigidBodyProblem problem = rigid_bodies::Going(12.0, trotter.inertia_B.diagonal(), trotter.feet, 0.5, 2.2, steps);
  // Lower than the unconstrained motion at that time.
  const RigidRest rest{0.95, 1.05, 0.5 * (problem.start.p_WC + problem.goal.p_WC) - 0.03 * Vector3::UnitZ(),
                       Vector3::Zero()};
  double nearest = 1.0;
  for (const RigidBodySample& sample : Sample(Planned(problem).motion, 0.01))
    nearest = std::min(nearest, (sample.p_WC - rest.p_WC).norm());
  EXPECT_GT(nearest, 0.01);
  problem.rests = {rest};
  int still = 0;
  for (const RigidBodySample& sample : Sample(Planned(problem).motion, 0.01)) {
    if (sample.time_s < rest.start_s - 1e-9 || sample.time_s > rest.end_s + 1e-9) continue;
    EXPECT_LT((sample.p_WC - rest.p_WC).norm(), 1e-9);
    EXPECT_LT(sample.v_WC.norm(), 1e-9);
    EXPECT_LT(sample.angles_rad.norm(), 1e-4);
    ++still;
  }
  EXPECT_GE(still, 4);
  problem.rests.front().end_s = problem.duration_s;
  EXPECT_THROW((void)PlanRigidBody(problem), InvalidArgument);
}

/// Distance of a point of the body beyond a plane.
double Beyond(const RigidBodyPlan& plan, const RigidClearance& of) {
  const std::vector<RigidBodySample> samples = Sample(plan.motion, 1e-3);
  const RigidBodySample& at = samples[static_cast<std::size_t>(std::lround(of.time_s / 1e-3))];
  return of.normal_W.dot(at.p_WC + RotationOf(at.angles_rad) * of.p_CQ_B) - of.offset_m;
}

TEST(PlanRigidBody, StaysClearOfPlanesAndTurnsForThat) {
  RigidBodyProblem problem = rigid_bodies::Trotter();
  const double t = 0.5 * problem.duration_s;
  const RigidBodyPlan free = Planned(problem);
  RigidClearance nose{t, {0.25, 0.0, -0.05}, Vector3::UnitZ(), 0.0, "nose"};
  nose.offset_m = Beyond(free, nose) + 0.02;
  problem.clearances = {nose};
  EXPECT_NEAR(Beyond(free, nose), -0.02, 1e-12);
  EXPECT_GT(Beyond(Planned(problem), nose), -1e-5) << "integrated anew, to what the rule leaves";
  problem.clearances.front().offset_m += 2.0;
  const Result<RigidBodyPlan> no_path = PlanRigidBody(problem);
  ASSERT_FALSE(no_path.ok());
  EXPECT_EQ(no_path.failure().code, FailureCode::kUnmetLaw);
  EXPECT_NE(no_path.failure().message.find("clearance of nose"), std::string::npos) << no_path.failure().message;
}

/// The largest upward or downward speed while a foot is on the ground.
double FastestRise(const RigidBodyPlan& plan) {
  double fastest = 0.0;
  for (const RigidBodySample& sample : Sample(plan.motion, 1e-3)) {
    if (!plan.motion.intervals[sample.interval].forces.empty()) fastest = std::max(fastest, std::abs(sample.v_WC.z()));
  }
  return fastest;
}

TEST(PlanRigidBody, RisesNoFasterThanItMay) {
  RigidBodyProblem problem = rigid_bodies::Hopper();
  const double free = FastestRise(Planned(problem));
  problem.rise_max_m_s = 0.9 * free;
  EXPECT_LT(FastestRise(Planned(problem)), 0.92 * free) << "between the times at which it is looked at, by little";
  problem.rise_max_m_s = 0.3 * free;
  const Result<RigidBodyPlan> too_slow = PlanRigidBody(problem);
  ASSERT_FALSE(too_slow.ok());
  EXPECT_NE(too_slow.failure().message.find("rise at"), std::string::npos) << too_slow.failure().message;
  problem.rise_max_m_s = -1.0;
  EXPECT_THROW((void)PlanRigidBody(problem), InvalidArgument);
}

TEST(PlanRigidBody, RefusesPlanesThatAreNone) {
  for (const RigidClearance& clearance :
       {RigidClearance{-0.1}, RigidClearance{9.0}, RigidClearance{0.3, Vector3::Zero(), Vector3(0.0, 0.0, 2.0)},
        RigidClearance{0.3, Vector3(NAN, 0.0, 0.0)}}) {
    RigidBodyProblem problem = rigid_bodies::Hopper();
    problem.clearances = {clearance};
    EXPECT_THROW((void)PlanRigidBody(problem), InvalidArgument);
  }
}

TEST(PlanRigidBody, TheSameProblemHasTheSameMotion) {
  const RigidBodyPlan a = Planned(rigid_bodies::Trotter()), b = Planned(rigid_bodies::Trotter());
  for (std::size_t i = 0; i < a.motion.intervals.size(); ++i) {
    EXPECT_EQ(a.motion.intervals[i].com, b.motion.intervals[i].com);
    EXPECT_EQ(a.motion.intervals[i].momentum_W, b.motion.intervals[i].momentum_W);
  }
}

TEST(PlanRigidBody, FootholdsStayInTheirRegions) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  // The first step must be short and wide, on a tile away from the nominal foothold.
  problem.stances[1].region_F = {{-0.2, 0.06}, {-0.14, 0.06}, {-0.14, 0.1}, {-0.2, 0.1}};
  const RigidBodyPlan plan = Planned(problem);
  const Vector3 moved = plan.motion.X_WF[1].translation() - problem.stances[1].X_WF.translation();
  EXPECT_NEAR(moved.x(), -0.14, 5e-3);
  EXPECT_NEAR(moved.y(), 0.06, 5e-3);
}

TEST(PlanRigidBody, LittleFrictionIsKeptToAndCostsMore) {
  RigidBodyProblem problem = rigid_bodies::Trotter();
  const double cost = Planned(problem).summary.cost;
  for (RigidStance& stance : problem.stances) stance.friction = 0.2;
  EXPECT_GT(Planned(problem).summary.cost, cost);
}

TEST(PlanRigidBody, SaysWhichLawStaysUnmetAndWhere) {
  RigidBodyProblem far = rigid_bodies::Hopper(2.5);
  RigidBodyPlan last;
  const Result<RigidBodyPlan> plan = PlanRigidBody(far, {}, &last);
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.failure().code, FailureCode::kUnmetLaw);
  EXPECT_TRUE(plan.failure().message.starts_with("no motion was found that satisfies all constraints: "));
  EXPECT_NE(plan.failure().message.find(last.summary.worst + " stays violated by"), std::string::npos)
      << plan.failure().message;
  EXPECT_NE(last.summary.worst.find(" s"), std::string::npos) << last.summary.worst;
  EXPECT_GT(last.summary.violation, 1e-3);
  EXPECT_FALSE(last.motion.intervals.empty());
}

TEST(ReasonNotCarried, IsSilentWhereThereIsAMotion) {
  for (const RigidBodyProblem& problem : {rigid_bodies::Hopper(), rigid_bodies::Walker(), rigid_bodies::Trotter()})
    EXPECT_FALSE(ReasonNotCarried(problem, {}).has_value());
}

TEST(ReasonNotCarried, SaysWhatForcesCannotDoHoweverTheBodyTurns) {
  const std::optional<Failure> failure = ReasonNotCarried(rigid_bodies::Hopper(2.5), {});
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->kind, FailureKind::kInfeasible);
  EXPECT_EQ(failure->code, FailureCode::kNotCarried);
  EXPECT_NE(failure->message.find(" of foot 0 at "), std::string::npos) << failure->message;
  EXPECT_EQ(failure->suggestions.size(), 2U);
}

TEST(ReasonNotCarried, IsSilentWhereForcesCarryButDoNotTurn) {
  // Feet in a line cannot hold a body whose centre of mass is beside them.
  RigidBodyProblem problem = rigid_bodies::Hopper(0.0);
  problem.start.p_WC.y() = problem.goal.p_WC.y() = 0.1;
  EXPECT_FALSE(ReasonNotCarried(problem, {}).has_value());
  for (const char* method : {"interior-point", "ceres"}) {
    const Result<RigidBodyPlan> plan = PlanRigidBody(problem, {.method = method});
    ASSERT_FALSE(plan.ok()) << method;
    EXPECT_EQ(plan.failure().code, FailureCode::kUnmetLaw) << method;
  }
}

TEST(PlanRigidBody, SaysWhereFrictionHoldsNoBodyAtRest) {
  RigidBodyProblem problem = rigid_bodies::Hopper();
  for (RigidStance& stance : problem.stances) stance.friction = 0.5;
  problem.stances[1].X_WF.linear() = Eigen::AngleAxisd(-0.6, Vector3::UnitY()).toRotationMatrix();
  const Result<RigidBodyPlan> plan = PlanRigidBody(problem);
  ASSERT_FALSE(plan.ok());
  EXPECT_NE(plan.failure().message.find("at the goal, all feet are on ground that needs a friction of 0.68 to "
                                        "stand on, but 0.50 may be used"),
            std::string::npos)
      << plan.failure().message;
}

TEST(PlanRigidBody, NodesTooFarApartAreReportedAndRefined) {
  const RigidBodyProblem problem = rigid_bodies::Walker(1.1);
  RigidBodyOptions coarse{.spacing_s = 0.32, .force_margin = 1e-5, .tolerance = 1e-6, .weights = {}};
  coarse.least_intervals = 2;
  coarse.reach_margin_m = 0.0;
  coarse.max_refinements = 0;
  RigidBodyPlan last;
  const Result<RigidBodyPlan> plan = PlanRigidBody(problem, coarse, &last);
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.failure().code, FailureCode::kFaultsBetween);
  EXPECT_LE(last.summary.violation, coarse.tolerance);
  EXPECT_GT(last.summary.faults.Largest(), 1e-3);
  coarse.max_refinements = 4;
  const RigidBodyPlan refined = Planned(problem, coarse);
  EXPECT_GE(refined.summary.refinements, 1);
  EXPECT_GT(refined.summary.variables, last.summary.variables);
}

TEST(PlanRigidBody, FinerNodesMissTheGoalByLess) {
  const RigidBodyProblem problem = rigid_bodies::Trotter();
  const auto missed = [&](double spacing_s) {
    const Result<RigidBodyPlan> plan =
        PlanRigidBody(problem, {.spacing_s = spacing_s, .least_intervals = 2, .tolerance = 1e-8});
    EXPECT_TRUE(plan.ok());
    return plan.ok() ? plan->summary.faults.goal : 0.0;
  };
  const double coarse = missed(0.12), fine = missed(0.03);
  EXPECT_GT(coarse, 1e-9);
  EXPECT_LT(fine, 0.1 * coarse);
}

/// Compares two solvers of different kinds.
TEST(PlanRigidBody, BothMethodsComeToTheSameCost) {
  for (const RigidBodyProblem& problem : {rigid_bodies::Hopper(), rigid_bodies::Walker(), rigid_bodies::Trotter()}) {
    RigidBodyOptions options;
    options.tolerance = 1e-5;
    options.cost_tolerance = 1e-4;
    const RigidBodyPlan interior = Planned(problem, options);
    options.method = "ceres";
    const RigidBodyPlan augmented = Planned(problem, options);
    EXPECT_NE(interior.summary.cost, augmented.summary.cost) << "they are two roads";
    EXPECT_NEAR(interior.summary.cost, augmented.summary.cost, 1e-3 * interior.summary.cost);
  }
}

/// Largest distance of a swing foot out of its workspace at 1 kHz [m].
double OutOfReachInTheAir(const RigidBodyProblem& problem, const RigidBodyMotion& motion,
                          const std::vector<RigidSwing>& swings) {
  double farthest = -1.0;
  for (const RigidSwing& swing : swings) {
    const RigidStance &from = problem.stances[swing.from], &to = problem.stances[swing.to];
    const SwingCurve curve{from.end_s, to.start_s, motion.X_WF[swing.from], motion.X_WF[swing.to], swing.lift_m};
    for (const RigidBodySample& s : Sample(motion, 1e-3)) {
      if (s.time_s < curve.start_s || s.time_s > curve.end_s) continue;
      const Vector3 p_CF = Evaluate(curve, s.time_s).X_WF.translation() - s.p_WC;
      for (const WorkspaceSide& side : problem.feet[static_cast<std::size_t>(from.foot)].workspace_B)
        farthest = std::max(farthest, side.normal.dot(RotationOf(s.angles_rad).transpose() * p_CF) - side.offset);
    }
  }
  return farthest;
}

TEST(PlanRigidBody, FeetStayInReachDuringTheirSwings) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  const std::vector<RigidSwing> swings = {{0, 1, 0.22}, {1, 2, 0.22}, {3, 4, 0.22}};
  const RigidBodyPlan heedless = Planned(problem);
  EXPECT_GT(OutOfReachInTheAir(problem, heedless.motion, swings), 0.03);
  problem.swings = swings;
  for (const char* method : {"interior-point", "ceres"}) {
    const RigidBodyPlan plan = Planned(problem, {.method = method});
    EXPECT_LT(OutOfReachInTheAir(problem, plan.motion, swings), 0.0) << method << ", for the margin";
    EXPECT_GT(plan.summary.cost, heedless.summary.cost);
  }
}

/// Largest use of the motor limits by the forces at nodes; 1 is the limit.
double MotorUse(const RigidBodyProblem& problem, const RigidBodyMotion& motion) {
  double most = 0.0;
  for (const RigidBodyInterval& in : motion.intervals) {
    for (const bool at_end : {false, true}) {
      std::map<std::size_t, VectorX> forces;  // by stance
      for (const RigidBodyInterval::Force& f : in.forces) {
        VectorX& all = forces[f.stance];
        all.conservativeResize(all.size() + 3);
        all.tail<3>() = at_end ? f.to_W : f.from_W;
      }
      for (const auto& [stance, all] : forces) {
        const MotorLimits& limits = *problem.stances[stance].MotorsAt(at_end ? in.end_s : in.start_s);
        const VectorX held = limits.by_force * all;
        most =
            std::max({most, held.cwiseQuotient(limits.upper).maxCoeff(), held.cwiseQuotient(limits.lower).maxCoeff()});
      }
    }
  }
  return most;
}

TEST(PlanRigidBody, MotorsHoldTheForcesAtNodes) {
  for (const RigidBodyProblem& problem : {rigid_bodies::Trotter(), rigid_bodies::SoledWalker()}) {
    const double share = problem.stances.size() > 5 ? 0.9 : 0.6;  // share of the weight
    RigidBodyProblem held = problem;
    rigid_bodies::AddMotors(held, share * problem.mass_kg * kGravity);
    const RigidBodyPlan free = Planned(problem);
    EXPECT_GT(MotorUse(held, free.motion), 1.02);
    for (const char* method : {"interior-point", "ceres"}) {
      const RigidBodyPlan plan = Planned(held, {.method = method});
      EXPECT_LT(MotorUse(held, plan.motion), 1.0 + 1e-4) << method;
    }
  }
}

TEST(PlanRigidBody, KeepsTheLawsWithWhatMovesInsideAndContactsThatRoll) {
  for (const char* method : {"interior-point", "ceres"}) {
    RigidBodyProblem problem = rigid_bodies::Trotter();
    const double still = Planned(problem, {.method = method}).summary.cost;
    rigid_bodies::AddLegMotion(problem, 141);
    rigid_bodies::AddRolling(problem);
    const RigidBodyPlan plan = Planned(problem, {.method = method});
    EXPECT_NE(plan.summary.cost, still);
  }
}

TEST(PlanRigidBodyFrom, AMotionIsFoundAgain) {
  const RigidBodyProblem problem = rigid_bodies::Trotter();
  for (const char* method : {"interior-point", "ceres"}) {
    const RigidBodyOptions options{.method = method};
    const RigidBodyPlan plan = Planned(problem, options);
    const Result<RigidBodyPlan> again = PlanRigidBodyFrom(problem, options, plan.numbers);
    ASSERT_TRUE(again.ok()) << again.failure().message;
    EXPECT_NEAR(again->summary.cost, plan.summary.cost, 2e-3 * plan.summary.cost);
    EXPECT_TRUE(options.method == "ceres" || again->summary.iterations < plan.summary.iterations);
    EXPECT_EQ(again->numbers.nodes_s, plan.numbers.nodes_s);
  }
}

TEST(PlanRigidBodyFrom, RefusesNumbersOfAnotherProblem) {
  const RigidBodyPlan plan = Planned(rigid_bodies::Hopper());
  EXPECT_THROW((void)PlanRigidBodyFrom(rigid_bodies::Walker(), {}, plan.numbers), InvalidArgument);
  RigidBodyNumbers fewer = plan.numbers;
  fewer.x.conservativeResize(fewer.x.size() - 1);
  EXPECT_THROW((void)PlanRigidBodyFrom(rigid_bodies::Hopper(), {}, fewer), InvalidArgument);
}

TEST(PlanRigidBody, RefusesOptionsThatAreNone) {
  EXPECT_THROW((void)PlanRigidBody(rigid_bodies::Hopper(), {.spacing_s = -1.0}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
