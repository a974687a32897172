// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "kinematics/spatial/rotation.h"
#include "tests/named_robot.h"
#include "tests/optimisation/whole_body/standing_problem.h"

namespace gaitwright {
namespace {

/// Forces of the standing posture with a constant acceleration of the whole robot.
WholeBodySolution ForcesWhileStanding(const StandingProblem& standing, const Vector3& acceleration = Vector3::Zero()) {
  WholeBodySolution solution = standing.Still(acceleration);
  AddContactForces(standing.model, standing.Problem(), {}, solution);
  return solution;
}

Vector3 SumOfForces(const std::vector<ContactWrench>& wrenches) {
  Vector3 sum = Vector3::Zero();
  for (const ContactWrench& wrench : wrenches) sum += wrench.force_W;
  return sum;
}

class ContactForcesTest : public testing::TestWithParam<const char*> {};

TEST_P(ContactForcesTest, CarryTheWeightAndDoNotTurnTheBody) {
  const StandingProblem standing(NamedRobot(GetParam()), 2);
  const RobotModel& model = standing.model;
  const WholeBodySolution solution = ForcesWhileStanding(standing);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<ContactWrench>& wrenches = solution.trajectory.wrenches[k];
    EXPECT_LT((SumOfForces(wrenches) - Vector3(0.0, 0.0, model.weight_n())).norm(), 1e-3 * model.weight_n());
    Vector3 moment = Vector3::Zero();
    for (std::size_t f = 0; f < model.legs.size(); ++f) {
      EXPECT_GT(wrenches[f].force_W.z(), 0.0) << model.feet[f].name;
      moment += (solution.contact_W[f][k] - standing.centroidal.p_WC[0]).cross(wrenches[f].force_W);
      moment += wrenches[f].moment_W;
    }
    EXPECT_LT(moment.norm(), 1e-3 * model.weight_n() * standing.centroidal.p_WC[0].z());
    EXPECT_LT(solution.residual_W[k].force_W.norm(), 1e-3 * model.weight_n());
  }
}

TEST_P(ContactForcesTest, AtRestTheZmpIsBelowTheCentreOfMass) {
  const StandingProblem standing(NamedRobot(GetParam()), 2);
  const WholeBodySolution solution = ForcesWhileStanding(standing);
  const Vector2 below = standing.centroidal.p_WC[0].head<2>();
  EXPECT_LT((solution.zmp_W[1] - below).norm(), 1e-9);
  EXPECT_LT((solution.pressure_W[1] - below).norm(), 1e-4);
}

TEST_P(ContactForcesTest, AForwardAccelerationMovesTheZmpBackward) {
  const StandingProblem standing(NamedRobot(GetParam()), 2);
  const Vector3 p_WC = standing.centroidal.p_WC[0];
  const WholeBodySolution solution = ForcesWhileStanding(standing, {0.3, 0.0, 0.0});
  EXPECT_NEAR(solution.zmp_W[0].x(), p_WC.x() - p_WC.z() * 0.3 / kGravity, 1e-6);
  EXPECT_NEAR(solution.zmp_W[0].y(), p_WC.y(), 1e-6);
  EXPECT_NEAR(SumOfForces(solution.trajectory.wrenches[0]).x(), 0.3 * standing.model.total_mass_kg,
              1e-3 * standing.model.weight_n());
}

/// Work of gravity and of contact forces for a small rotation of one joint, by differences.
double HoldingTorque(const StandingProblem& standing, const WholeBodySolution& solution, int dof) {
  constexpr double kStep = 1e-5;
  const RobotModel& model = standing.model;
  VectorX q = StandingConfiguration(model);
  DynamicsScratch before(model), here(model), after(model);
  ForwardKinematics(model, q, here);
  q[7 + dof] += kStep;
  ForwardKinematics(model, q, after);
  q[7 + dof] -= 2.0 * kStep;
  ForwardKinematics(model, q, before);
  double work = model.weight_n() * (CentreOfMass(model, after) - CentreOfMass(model, before)).z();
  for (std::size_t f = 0; f < model.legs.size(); ++f) {
    const int body = model.feet[f].body;
    Pose X_WF = Pose::Identity();
    X_WF.translation() = solution.contact_W[f][0];
    const Pose X_BF = FramePose(here, body, Pose::Identity()).inverse() * X_WF;
    const Pose from = FramePose(before, body, X_BF), to = FramePose(after, body, X_BF);
    const ContactWrench& wrench = solution.trajectory.wrenches[0][f];
    work -= wrench.force_W.dot(to.translation() - from.translation());
    work -= wrench.moment_W.dot(RotationLog(to.linear() * from.linear().transpose()));
  }
  return work / (2.0 * kStep);
}

TEST_P(ContactForcesTest, TorquesHoldGravityAndContactForcesByVirtualWork) {
  const StandingProblem standing(NamedRobot(GetParam()), 2);
  const WholeBodySolution solution = ForcesWhileStanding(standing);
  const double scale = standing.model.weight_n() * standing.model.leg_length_m();
  const VectorX& tau = solution.trajectory.tau[0];
  ASSERT_EQ(tau.size(), standing.model.num_dofs());
  EXPECT_GT(tau.cwiseAbs().maxCoeff(), 1e-3 * scale);
  for (int dof = 0; dof < standing.model.num_dofs(); ++dof)
    EXPECT_NEAR(tau[dof], HoldingTorque(standing, solution, dof), 1e-6 * scale)
        << standing.model.dof_names.at(static_cast<std::size_t>(dof));
}

TEST_P(ContactForcesTest, AFootThatIsToCarryMoreDoes) {
  const StandingProblem standing(NamedRobot(GetParam()), 2);
  const double even = ForcesWhileStanding(standing).trajectory.wrenches[0][0].force_W.z();
  WholeBodyProblem problem = standing.Problem();
  problem.load = [](int foot, double) { return foot == 0 ? 20.0 : 1.0; };
  WholeBodySolution solution = standing.Still();
  AddContactForces(standing.model, problem, {}, solution);
  EXPECT_GT(solution.trajectory.wrenches[0][0].force_W.z(), even + 0.01 * standing.model.weight_n());
  EXPECT_NEAR(SumOfForces(solution.trajectory.wrenches[0]).z(), standing.model.weight_n(),
              1e-3 * standing.model.weight_n());
}

TEST_P(ContactForcesTest, InFlightNothingIsGivenAndFallingFreelyNothingIsNeeded) {
  StandingProblem standing(NamedRobot(GetParam()), 5);
  standing.schedule = ScheduleFromIntervals(std::vector<std::vector<ContactInterval>>(standing.model.feet.size()), 0.0,
                                            standing.end_s());
  const RobotModel& model = standing.model;
  const WholeBodySolution held = ForcesWhileStanding(standing);
  EXPECT_EQ(SumOfForces(held.trajectory.wrenches[2]).norm(), 0.0);
  EXPECT_NEAR(held.residual_W[2].force_W.z(), model.weight_n(), 1e-6 * model.weight_n());
  const WholeBodySolution falls = ForcesWhileStanding(standing, {0.0, 0.0, -kGravity});
  EXPECT_LT(falls.residual_W[2].force_W.norm(), 1e-6 * model.weight_n());
  EXPECT_LT(falls.trajectory.tau[2].norm(), 1e-6 * model.weight_n() * model.leg_length_m());
  EXPECT_LT((falls.zmp_W[2] - standing.centroidal.p_WC[0].head<2>()).norm(), 1e-9) << "below the centre of mass";
}

INSTANTIATE_TEST_SUITE_P(Robots, ContactForcesTest, testing::Values("a1", "nao"));

TEST(AddContactForces, SlipperyGroundGivesNoMoreThanTheUsedShareOfItsFriction) {
  const StandingProblem standing(NamedRobot("a1"), 2, 0.1);
  WholeBodySolution solution = standing.Still({2.0, 0.0, 0.0});
  WholeBodyOptions options;
  options.friction_use = 0.5;
  AddContactForces(standing.model, standing.Problem(), options, solution);
  for (std::size_t f = 0; f < standing.model.legs.size(); ++f) {
    const Vector3& force = solution.trajectory.wrenches[0][f].force_W;
    EXPECT_LE(force.head<2>().norm(), 0.05 * force.z() + 1e-6 * standing.model.weight_n());
  }
  const Vector3 needed(2.0 * standing.model.total_mass_kg, 0.0, standing.model.weight_n());
  const Vector3 given = SumOfForces(solution.trajectory.wrenches[0]);
  EXPECT_LT((given + solution.residual_W[0].force_W - needed).norm(), 1e-6 * standing.model.weight_n());
  EXPECT_GT(solution.residual_W[0].force_W.x(), standing.model.total_mass_kg);
}

TEST(AddContactForces, AFootTakesUpItsLoadOverTheRampAfterTouchDown) {
  StandingProblem standing(NamedRobot("a1"), 61);  // 0.3 s
  const double steady = ForcesWhileStanding(standing).trajectory.wrenches[0][0].force_W.z();
  std::vector<std::vector<ContactInterval>> stays(standing.model.feet.size());
  for (std::size_t f = 0; f < 4; ++f) stays[f] = {{0.0, standing.end_s()}};
  stays[0] = {{0.1, standing.end_s()}};
  standing.schedule = ScheduleFromIntervals(stays, 0.0, standing.end_s());
  const WholeBodySolution solution = ForcesWhileStanding(standing);
  const auto load = [&](std::size_t k) { return solution.trajectory.wrenches[k][0].force_W.z(); };
  EXPECT_EQ(load(10), 0.0) << "in the air";
  EXPECT_LT(load(20), 0.3 * steady) << "at touch-down";
  for (std::size_t k = 20; k < 40; ++k) EXPECT_LE(load(k), load(k + 1) + 1e-6 * standing.model.weight_n()) << k;
  EXPECT_NEAR(load(41), steady, 1e-3 * standing.model.weight_n()) << "the ramp of 0.1 s is over";
}

TEST(AddContactForces, ReplacesWhatItGaveBefore) {
  const StandingProblem standing(NamedRobot("a1"), 3);
  WholeBodySolution solution = ForcesWhileStanding(standing);
  const WholeBodySolution once = solution;
  AddContactForces(standing.model, standing.Problem(), {}, solution);
  EXPECT_EQ(solution.trajectory.tau, once.trajectory.tau);
  EXPECT_EQ(solution.trajectory.wrenches, once.trajectory.wrenches);
  EXPECT_EQ(solution.contact_W, once.contact_W);
  EXPECT_EQ(solution.zmp_W.size(), 3U);
}

std::vector<Vector2> NumberedPoints(std::size_t count) {
  std::vector<Vector2> points;
  for (std::size_t k = 0; k < count; ++k) points.emplace_back(static_cast<double>(k), 0.0);
  return points;
}

TEST(HeldOverFlights, IsTheNearestRowAtWhichSomethingPresses) {
  for (const unsigned pattern : {0b1U, 0b100000U, 0b1000000001U, 0b1100010011U, 0b0110000010U, 0b1111111111U}) {
    std::vector<bool> presses;
    for (unsigned k = 0; k < 10; ++k) presses.push_back((pattern >> k & 1U) != 0);
    const std::vector<Vector2> held = HeldOverFlights(NumberedPoints(10), presses);
    ASSERT_EQ(held.size(), 10U);
    for (int k = 0; k < 10; ++k) {
      int nearest = 99;
      for (int j = 0; j < 10; ++j) {
        if (presses[static_cast<std::size_t>(j)]) nearest = std::min(nearest, std::abs(j - k));
      }
      const int taken = static_cast<int>(held[static_cast<std::size_t>(k)].x());
      EXPECT_TRUE(presses[static_cast<std::size_t>(taken)]) << pattern << " at " << k;
      EXPECT_EQ(std::abs(taken - k), nearest) << pattern << " at " << k;
    }
  }
}

TEST(HeldOverFlights, WhereNothingEverPressesPointsStay) {
  EXPECT_EQ(HeldOverFlights(NumberedPoints(4), std::vector<bool>(4, false)), NumberedPoints(4));
  EXPECT_TRUE(HeldOverFlights({}, {}).empty());
}

}  // namespace
}  // namespace gaitwright
