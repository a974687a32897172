// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "tests/optimisation/centroidal/own_variables.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// Number of constraints whose name begins with a text.
std::ptrdiff_t RowsNamed(const ConstrainedProblem& rows, const std::string& start) {
  return std::count_if(rows.constraints.begin(), rows.constraints.end(),
                       [&](const Constraint& c) { return c.name.starts_with(start); });
}

ConstrainedProblem RowsOf(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns,
                          const RigidBodyOptions& options = {}, const std::vector<MissedReach>& missed = {}) {
  return RigidBodyRows(problem, unknowns, options, missed);
}

TEST(RigidBodyRowsTest, ForcesTurnTheBodyUnlessRotationIsFree) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  RigidBodyOptions options;
  EXPECT_EQ(RowsNamed(RowsOf(problem, unknowns, options), "turning from"),
            static_cast<std::ptrdiff_t>(unknowns.intervals()));
  options.turns_by_forces = false;
  EXPECT_EQ(RowsNamed(RowsOf(problem, unknowns, options), "turning from"), 0);
}

TEST(RigidBodyRowsTest, EachForceHasFrictionAndEachFreeNodeHasNoForce) {
  const RigidBodyProblem problem = rigid_bodies::Hopper();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const ConstrainedProblem rows = RowsOf(problem, unknowns);
  ASSERT_FALSE(unknowns.FreeNodes().empty());
  EXPECT_EQ(RowsNamed(rows, "free flight at"), static_cast<std::ptrdiff_t>(unknowns.FreeNodes().size()));
  const auto bound = std::count_if(unknowns.BoundForces().begin(), unknowns.BoundForces().end(),
                                   [](const BoundForce& force) { return !force.force.parts.empty(); });
  EXPECT_EQ(RowsNamed(rows, "friction of foot 0"), bound);
  for (const Constraint& row : rows.constraints) EXPECT_FALSE(row.variables.empty()) << row.name;
}

TEST(RigidBodyRowsTest, MotorsHoldAllPointsOfAStanceAtANodeTogether) {
  RigidBodyProblem problem = rigid_bodies::SoledWalker();
  rigid_bodies::AddMotors(problem, 200.0);
  problem.stances[3].motors.clear();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  std::set<std::pair<std::size_t, std::size_t>> loaded;
  for (const BoundForce& force : unknowns.BoundForces()) {
    if (force.stance != 3) loaded.insert({force.stance, force.at_node});
  }
  const ConstrainedProblem rows = RowsOf(problem, unknowns);
  EXPECT_EQ(RowsNamed(rows, "motors of foot"), static_cast<std::ptrdiff_t>(loaded.size()));
  EXPECT_EQ(RowsNamed(rows, "motors of foot 1 at 0.000 s"), 0) << "a stance without motors";
}

TEST(RigidBodyRowsTest, ReachLeadsAStanceUnlessItsSwingIsKnown) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  RigidBodyOptions options;
  options.swing_lead_s = 0.02;
  const auto leads = [&] {
    const RigidBodyUnknowns unknowns(problem, 0.1, 3);
    const ConstrainedProblem rows = RowsOf(problem, unknowns, options);
    return std::vector<std::ptrdiff_t>{
        RowsNamed(rows, "reach of foot 0 at 0.320 s"), RowsNamed(rows, "reach of foot 0 at 0.530 s"),
        RowsNamed(rows, "reach of foot 0 at 1.220 s"), RowsNamed(rows, "reach of foot 0 at 1.430 s")};
  };
  EXPECT_EQ(leads(), (std::vector<std::ptrdiff_t>{1, 1, 1, 1}));
  problem.swings = {{0, 1, 0.1}};
  EXPECT_EQ(leads(), (std::vector<std::ptrdiff_t>{0, 0, 1, 1}));
}

TEST(RigidBodyRowsTest, AKnownSwingIsCheckedAtItsSharesOrAtNine) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1, 0.1}};
  const auto count = [&](const std::string& name) { return RowsNamed(RowsOf(problem, {problem, 0.1, 3}), name); };
  const auto with_nine = count("reach of foot 0");
  EXPECT_EQ(count("reach of foot 0 at 0.425 s"), 1) << "half way";
  problem.swings[0].shares = {0.2, 0.6};
  EXPECT_EQ(with_nine - count("reach of foot 0"), 7);
  EXPECT_EQ(count("reach of foot 0 at 0.450 s"), 1) << "0.6 of 0.25 s after 0.3 s";
  EXPECT_EQ(count("clearance of foot 0"), 0);
  problem.swings[0].detour_W.assign(6, {0.0, 0.0, 0.1});
  problem.swings[0].free = true;
  problem.swings[0].planes = {{0.5, Vector3::UnitZ(), 0.02}};
  EXPECT_EQ(count("clearance of foot 0"), 1);
}

TEST(RigidBodyRowsTest, RiseIsLimitedOnlyInContact) {
  RigidBodyProblem problem = rigid_bodies::Hopper();
  const RigidBodyUnknowns unknowns(problem, 0.05, 3);
  EXPECT_EQ(RowsNamed(RowsOf(problem, unknowns), "rise at"), 0);
  problem.rise_max_m_s = 1.0;
  const ConstrainedProblem rows = RowsOf(problem, unknowns);
  EXPECT_GT(RowsNamed(rows, "rise at"), 10);
  for (const Constraint& row : rows.constraints) {
    if (!row.name.starts_with("rise at")) continue;
    const double time_s = std::stod(row.name.substr(8));
    EXPECT_FALSE(time_s > 0.501 && time_s < 0.749) << row.name << ": in the air";
  }
}

TEST(RigidBodyRowsTest, RegionsClearancesAndMissedTimesAddARowEach) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const auto plain = RowsOf(problem, unknowns).constraints.size();
  EXPECT_EQ(RowsOf(problem, unknowns, {}, {{1, 0.777}}).constraints.size(), plain + 1);
  EXPECT_EQ(RowsNamed(RowsOf(problem, unknowns, {}, {{1, 0.777}}), "reach of foot 0 at 0.777 s"), 1);
  const std::vector<Vector2> square = {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
  problem.stances[0].region_F = square;
  EXPECT_EQ(RowsOf(problem, unknowns).constraints.size(), plain) << "it is held";
  problem.stances[1].region_F = square;
  EXPECT_EQ(RowsNamed(RowsOf(problem, unknowns), "region of foot 0"), 1);
  problem.clearances = {{0.5, {0.1, 0.0, -0.1}, Vector3::UnitZ(), 0.0, "shin"}};
  EXPECT_EQ(RowsNamed(RowsOf(problem, unknowns), "clearance of shin at 0.500 s"), 1);
}

TEST(GuessRigidBody, StandsAboveItsFeetWithEvenForces) {
  const RigidBodyProblem problem = rigid_bodies::Stander();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const VectorX x = GuessRigidBody(problem, unknowns);
  for (const double t : {0.0, 0.11, 0.2, 0.4})
    EXPECT_LT((unknowns.CentreOfMass(t).At(x) - problem.start.p_WC).norm(), 1e-12);
  for (const BoundForce& force : unknowns.BoundForces())
    EXPECT_LT((force.force.At(x) - Vector3(0.0, 0.0, 0.25)).norm(), 1e-9) << force.at_node;
}

TEST(GuessRigidBody, GoesOverItsFeetAndBeginsAndEndsWithThem) {
  const RigidBodyProblem problem = rigid_bodies::Walker(0.6);
  const RigidBodyUnknowns unknowns(problem, 0.05, 3);
  const VectorX x = GuessRigidBody(problem, unknowns);
  double last = -1e-3;
  for (double t = 0.0; t <= problem.duration_s; t += 0.05) {
    const Vector3 p_WC = unknowns.CentreOfMass(t).At(x);
    EXPECT_GT(p_WC.x(), last - 1e-6) << t;
    EXPECT_NEAR(p_WC.y(), 0.0, 1e-9);
    EXPECT_NEAR(p_WC.z(), problem.start.p_WC.z(), 1e-9);
    last = p_WC.x();
  }
  EXPECT_NEAR(last, 0.6, 1e-6);
  // With one foot at 0.3 m and the other halfway from 0 to 0.6 m, the body is at 0.3 m.
  EXPECT_NEAR(unknowns.CentreOfMass(0.85).At(x).x(), 0.3, 0.02);
}

TEST(GuessRigidBody, FollowsAStraightPathExactly) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  const Vector3 from(0.1, -0.2, 0.6), to(0.5, 0.3, 0.7);
  problem.path = {{0.0, problem.duration_s}, {from, to}, {Vector3(0.0, 0.1, 0.0), Vector3(0.2, 0.1, -0.8)}};
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const VectorX x = GuessRigidBody(problem, unknowns);
  const std::vector<double>& t = unknowns.nodes_s();
  ASSERT_GT(t.size(), 10U);
  for (double at = t[3]; at <= t[t.size() - 4]; at += 0.037) {
    const Vector3 expected = from + (to - from) * at / problem.duration_s;
    EXPECT_LT((unknowns.CentreOfMass(at).At(x) - expected).norm(), 1e-9) << at;
  }
  for (std::size_t k = 1; k + 1 < t.size(); ++k)
    EXPECT_LT((unknowns.Angles(k).At(x) - problem.path.AnglesAt(t[k])).norm(), 1e-12);
}

TEST(GuessRigidBody, TakesTheControlPointsOfFreeSwings) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1, 0.1}, {3, 4}};
  problem.swings[1].detour_W = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  problem.swings[1].free = true;
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const VectorX x = GuessRigidBody(problem, unknowns);
  for (int k = 0; k < 6; ++k) EXPECT_DOUBLE_EQ(x[unknowns.Detour(1) + k], 0.1 * (k + 1));
}

/// A body that moves above one foot of the hopper by a polynomial, in one interval of 1 s.
RigidBodyMotion MovedOverItsFoot(const RigidBodyProblem& problem, const std::array<Vector3, 4>& com) {
  RigidBodyMotion motion;
  motion.mass_kg = problem.mass_kg;
  motion.inertia_B = problem.inertia_B;
  motion.X_WF = {Pose::Identity(), Pose::Identity()};
  RigidBodyInterval interval{0.0, 1.0, com, Vector3::Zero(), Vector3::Zero(), {}};
  interval.forces.resize(1);
  motion.intervals = {interval};
  return motion;
}

TEST(MissedReaches, NameTheStanceAndTheTimeAtWhichItsFootIsFarthestOut) {
  const RigidBodyProblem problem = rigid_bodies::Hopper();  // reach of 0.25 m forward, 0.2 m upward
  const Vector3 up(0.0, 0.0, 0.58), none = Vector3::Zero();
  const auto even = MovedOverItsFoot(problem, {up, Vector3(0.4, 0.0, 0.0), none, none});
  const std::vector<MissedReach> missed = MissedReaches(problem, even, 1e-3);
  ASSERT_EQ(missed.size(), 1U);
  EXPECT_EQ(missed[0].stance, 0U);
  EXPECT_NEAR(missed[0].time_s, 1.0, 1e-9);
  EXPECT_TRUE(MissedReaches(problem, even, 0.151).empty()) << "it is out by 0.15 m";
  EXPECT_EQ(MissedReaches(problem, even, 0.149).size(), 1U);
  // Upward by 1.2 t - 1.2 t^2, at most 0.3 m: 0.1 m out of reach halfway.
  const auto hop = MovedOverItsFoot(problem, {up, Vector3(0.0, 0.0, 1.2), Vector3(0.0, 0.0, -1.2), none});
  ASSERT_EQ(MissedReaches(problem, hop, 0.099).size(), 1U);
  EXPECT_NEAR(MissedReaches(problem, hop, 0.099)[0].time_s, 0.5, 1e-3);
  EXPECT_TRUE(MissedReaches(problem, hop, 0.101).empty());
}

TEST(MissedReaches, AFootWithoutForceIsNotLookedAt) {
  const RigidBodyProblem problem = rigid_bodies::Hopper();
  const Vector3 none = Vector3::Zero();
  RigidBodyMotion motion = MovedOverItsFoot(problem, {Vector3(9.0, 0.0, 0.58), none, none, none});
  EXPECT_EQ(MissedReaches(problem, motion, 1e-3).size(), 1U);
  motion.intervals[0].forces.clear();
  EXPECT_TRUE(MissedReaches(problem, motion, 1e-3).empty());
}

}  // namespace
}  // namespace gaitwright
