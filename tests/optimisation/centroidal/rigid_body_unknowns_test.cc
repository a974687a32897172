// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_unknowns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

VectorX Wavy(const RigidBodyUnknowns& unknowns) {
  VectorX x(unknowns.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = std::sin(1.7 * static_cast<double>(i) + 0.3);
  return x;
}

TEST(RigidBodyUnknowns, EverySwitchIsANodeAndStancesHaveTheirIntervals) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 5);
  const std::vector<double>& nodes = unknowns.nodes_s();
  EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
  for (std::size_t k = 1; k < nodes.size(); ++k) EXPECT_LE(nodes[k] - nodes[k - 1], 0.1 + 1e-9);
  for (const RigidStance& stance : problem.stances) {
    int within = 0;
    for (const double t : {stance.start_s, stance.end_s})
      EXPECT_TRUE(std::any_of(nodes.begin(), nodes.end(), [t](double b) { return std::abs(b - t) < 1e-12; })) << t;
    for (const double t : nodes) within += t > stance.start_s - 1e-9 && t < stance.end_s - 1e-9 ? 1 : 0;
    EXPECT_GE(within, 5);
  }
}

TEST(RigidBodyUnknowns, SwitchesThatAreNearlyTheSameAreOneNode) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  const std::size_t before = RigidBodyUnknowns(problem, 0.1, 3).nodes_s().size();
  problem.stances[1].start_s += 3e-5;
  EXPECT_EQ(RigidBodyUnknowns(problem, 0.1, 3).nodes_s().size(), before);
}

bool Holds(const std::vector<double>& nodes, double t) {
  return std::any_of(nodes.begin(), nodes.end(), [t](double b) { return std::abs(b - t) < 1e-12; });
}

TEST(RigidBodyUnknowns, NodesBetweenSwitchesAreOnAGrid) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.stances[1].start_s += 3e-3;  // a switch that is not on the grid
  std::vector<double> switches;
  for (const RigidStance& stance : problem.stances) switches.insert(switches.end(), {stance.start_s, stance.end_s});
  const std::vector<double> even = RigidBodyUnknowns(problem, 0.07, 3).nodes_s();
  int off = 0;
  for (const double grid_s : {0.001, 0.005, 0.02}) {
    const std::vector<double> nodes = RigidBodyUnknowns(problem, 0.07, 3, grid_s).nodes_s();
    EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
    for (const double t : switches) EXPECT_TRUE(Holds(nodes, t)) << t;
    for (const double t : nodes)
      EXPECT_TRUE(Holds(switches, t) || std::abs(std::remainder(t, grid_s)) < 1e-12) << t << " on " << grid_s;
    EXPECT_EQ(nodes.size(), even.size()) << grid_s;
    for (std::size_t k = 0; k < std::min(nodes.size(), even.size()); ++k)
      EXPECT_LE(std::abs(nodes[k] - even[k]), 0.5 * grid_s + 1e-12);
    for (const double t : even) off += std::abs(std::remainder(t, grid_s)) > 1e-6 ? 1 : 0;
  }
  EXPECT_GT(off, 10) << "without a grid they are anywhere";
}

TEST(RigidBodyUnknowns, NodesThatMeetOnACoarseGridAreMerged) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const std::vector<double> even = RigidBodyUnknowns(problem, 0.02, 3).nodes_s();
  const std::vector<double> nodes = RigidBodyUnknowns(problem, 0.02, 3, 0.05).nodes_s();
  EXPECT_LT(nodes.size(), even.size());
  for (std::size_t k = 1; k < nodes.size(); ++k) EXPECT_GT(nodes[k] - nodes[k - 1], 0.04);
}

TEST(RigidBodyUnknowns, FlightIsOneInterval) {
  const RigidBodyUnknowns unknowns(rigid_bodies::Hopper(), 0.05, 3);
  int empty = 0;
  for (std::size_t i = 0; i < unknowns.intervals(); ++i) empty += unknowns.Forces(i).empty() ? 1 : 0;
  EXPECT_EQ(empty, 1);
  ASSERT_EQ(unknowns.FreeNodes().size(), 2U);
  EXPECT_NEAR(unknowns.nodes_s()[unknowns.FreeNodes()[0]], 0.5, 1e-12);
  EXPECT_NEAR(unknowns.nodes_s()[unknowns.FreeNodes()[1]], 0.75, 1e-12);
}

TEST(RigidBodyUnknowns, ForcesAddUpToTheForceOnTheWholeWhateverTheUnknownsAre) {
  for (const RigidBodyProblem& problem :
       {rigid_bodies::Walker(), rigid_bodies::Trotter(), rigid_bodies::SoledWalker()}) {
    const RigidBodyUnknowns unknowns(problem, 0.08, 3);
    const VectorX x = Wavy(unknowns);
    for (std::size_t i = 0; i < unknowns.intervals(); ++i) {
      Vector3 from = -unknowns.WholeForce(i).At(x), to = -unknowns.WholeForce(i + 1).At(x);
      for (const ContactForce& force : unknowns.Forces(i)) {
        from += force.from.At(x);
        to += force.to.At(x);
      }
      EXPECT_LT(from.norm() + to.norm(), 1e-9) << i;
    }
  }
}

TEST(RigidBodyUnknowns, TheForceOnTheWholeIsThatOfTheCentreOfMass) {
  const RigidBodyUnknowns unknowns(rigid_bodies::Trotter(), 0.1, 3);
  const VectorX x = Wavy(unknowns);
  constexpr double kStep = 1e-4;
  for (std::size_t k = 1; k + 1 < unknowns.nodes_s().size(); ++k) {
    const double t = unknowns.nodes_s()[k];
    const Vector3 a = (unknowns.CentreOfMass(t - kStep).At(x) - 2.0 * unknowns.CentreOfMass(t).At(x) +
                       unknowns.CentreOfMass(t + kStep).At(x)) /
                      (kStep * kStep);
    const Vector3 force = a / kGravity + Vector3::UnitZ();
    EXPECT_LT((unknowns.WholeForce(k).At(x) - force).norm(), 0.02 * (1.0 + force.norm()));
  }
}

TEST(RigidBodyUnknowns, StartsAndEndsAsTheProblemSays) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.start.v_WC = {0.3, -0.1, 0.2};
  problem.goal.v_WC = {-0.2, 0.4, 0.1};
  problem.goal.w_WB_B = {0.1, 0.2, 0.3};
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const VectorX x = Wavy(unknowns);
  constexpr double kStep = 1e-6;
  EXPECT_LT((unknowns.CentreOfMass(0.0).At(x) - problem.start.p_WC).norm(), 1e-12);
  EXPECT_LT((unknowns.CentreOfMass(1.9).At(x) - problem.goal.p_WC).norm(), 1e-12);
  EXPECT_LT(((unknowns.CentreOfMass(kStep).At(x) - problem.start.p_WC) / kStep - problem.start.v_WC).norm(), 1e-2);
  EXPECT_LT(((problem.goal.p_WC - unknowns.CentreOfMass(1.9 - kStep).At(x)) / kStep - problem.goal.v_WC).norm(), 1e-2);
  const std::size_t last = unknowns.intervals();
  EXPECT_LT((unknowns.Momentum(last).At(x) * unknowns.mean_inertia() - problem.inertia_B * problem.goal.w_WB_B).norm(),
            1e-12);
}

TEST(RigidBodyUnknowns, ForcesBeginAndEndAtZeroButWhereAllFeetAreExchanged) {
  const RigidBodyProblem walker = rigid_bodies::Walker(), trotter = rigid_bodies::Trotter();
  for (const RigidBodyProblem* problem : {&walker, &trotter}) {
    const RigidBodyUnknowns unknowns(*problem, 0.08, 3);
    const VectorX x = Wavy(unknowns);
    for (std::size_t i = 0; i < unknowns.intervals(); ++i) {
      for (const ContactForce& force : unknowns.Forces(i)) {
        const RigidStance& stance = problem->stances[force.stance];
        const double t = unknowns.nodes_s()[i];
        const bool touches_down = stance.start_s > 0.0 && std::abs(t - stance.start_s) < 1e-6;
        const bool exchanged = problem == &trotter && t < 1.1;
        EXPECT_EQ(force.from.At(x).norm() == 0.0, touches_down && !exchanged) << t;
      }
    }
  }
}

TEST(RigidBodyUnknowns, PointsOfASoleMoveWithItsFoothold) {
  const RigidBodyProblem problem = rigid_bodies::SoledWalker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const VectorX x = Wavy(unknowns);
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    const Vector3 foothold = unknowns.Foothold(s).At(x);
    EXPECT_EQ((foothold - problem.stances[s].X_WF.translation()).norm() < 1e-12, problem.stances[s].held);
    for (std::size_t point = 0; point < 4; ++point) {
      EXPECT_LT((unknowns.ContactPoint(s, point).At(x) - foothold - problem.feet[0].contacts_F[point]).norm(), 1e-12);
    }
  }
}

TEST(RigidBodyUnknowns, GivenNodesGiveTheSameUnknownsAsPlacedOnes) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns placed(problem, 0.08, 3), given(problem, placed.nodes_s());
  EXPECT_EQ(given.nodes_s(), placed.nodes_s());
  EXPECT_EQ(given.size(), placed.size());
  EXPECT_EQ(given.BoundForces().size(), placed.BoundForces().size());
}

TEST(RigidBodyUnknowns, RefusesNodesThatAreNotAtItsSwitches) {
  const RigidBodyProblem problem = rigid_bodies::Hopper();
  EXPECT_THROW(RigidBodyUnknowns(problem, {0.0, 0.2, 0.4, 0.75, 1.0, 1.25}), InvalidArgument);
  EXPECT_THROW(RigidBodyUnknowns(problem, {0.0, 0.5, 0.75, 0.75, 1.25}), InvalidArgument);
  EXPECT_THROW(RigidBodyUnknowns(problem, {0.0}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
