// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "planning/plan/built_in_terrain.h"
#include "playback/bullet/condensed_solver_internal.h"
#include "playback/bullet/contact_rows_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/playback/bullet/small_world.h"
#include "tests/playback/one_joint.h"

namespace gaitwright::bullet {
namespace {

/// Makes the rows of contacts twice, by our code and by Bullet, and compares them.
class ComparedSolver : public CondensedSolver {
 public:
  explicit ComparedSolver(JointSpaceInertia& inertia) : CondensedSolver(inertia), inertia_(inertia) {}

  int rows = 0, feet_and_others = 0;

 protected:
  void convertContacts(btPersistentManifold** manifolds, int num_manifolds, const btContactSolverInfo& info) override {
    btMultiBodyConstraintSolver::convertContacts(  // NOLINT(bugprone-parent-virtual-call): Bullet's own rows
        manifolds, num_manifolds, info);
    const btMultiBodyConstraintArray normals = m_multiBodyNormalContactConstraints;
    const btMultiBodyConstraintArray frictions = m_multiBodyFrictionContactConstraints;
    const btAlignedObjectArray<btScalar> jacobians = m_data.m_jacobians;
    const btAlignedObjectArray<btScalar> responses = m_data.m_deltaVelocitiesUnitImpulse;
    Clear();
    CondensedSolver::convertContacts(manifolds, num_manifolds, info);
    NormaliseRows(inertia_, {m_multiBodyNonContactConstraints, m_multiBodyNormalContactConstraints,
                             m_multiBodyFrictionContactConstraints, m_data});
    ASSERT_EQ(normals.size(), m_multiBodyNormalContactConstraints.size());
    ASSERT_EQ(frictions.size(), m_multiBodyFrictionContactConstraints.size());
    ASSERT_EQ(frictions.size(), 2 * normals.size());
    for (int i = 0; i < normals.size(); ++i)
      Compare(normals[i], m_multiBodyNormalContactConstraints[i], jacobians, responses);
    for (int i = 0; i < frictions.size(); ++i)
      Compare(frictions[i], m_multiBodyFrictionContactConstraints[i], jacobians, responses);
    Clear();
    CondensedSolver::convertContacts(manifolds, num_manifolds, info);
  }

 private:
  void Clear() {
    m_multiBodyNormalContactConstraints.resize(0);
    m_multiBodyFrictionContactConstraints.resize(0);
    m_data.m_jacobians.resize(0);
    m_data.m_deltaVelocitiesUnitImpulse.resize(0);
  }

  void Compare(const btMultiBodySolverConstraint& wanted, const btMultiBodySolverConstraint& row,
               const btAlignedObjectArray<btScalar>& jacobians, const btAlignedObjectArray<btScalar>& responses) {
    const bool first = wanted.m_multiBodyA != nullptr;
    const int at = first ? wanted.m_jacAindex : wanted.m_jacBindex;
    EXPECT_EQ(row.m_multiBodyA, first ? wanted.m_multiBodyA : wanted.m_multiBodyB);
    EXPECT_EQ(row.m_linkA, first ? wanted.m_linkA : wanted.m_linkB);
    EXPECT_EQ(row.m_frictionIndex, wanted.m_frictionIndex);
    EXPECT_EQ(row.m_originalContactPoint, wanted.m_originalContactPoint);
    EXPECT_EQ(row.m_friction, wanted.m_friction);
    EXPECT_EQ(row.m_lowerLimit, wanted.m_lowerLimit);
    EXPECT_EQ(row.m_upperLimit, wanted.m_upperLimit);
    EXPECT_EQ(row.m_appliedImpulse, wanted.m_appliedImpulse);
    EXPECT_NEAR(row.m_jacDiagABInv, wanted.m_jacDiagABInv, 1e-10 * wanted.m_jacDiagABInv);
    EXPECT_NEAR(row.m_cfm, wanted.m_cfm, 1e-10 * wanted.m_cfm);
    EXPECT_NEAR(row.m_rhs, wanted.m_rhs, 1e-10 * (std::abs(wanted.m_rhs) + wanted.m_jacDiagABInv));
    const Eigen::Index n = inertia_.size();
    const auto of = [n](const btAlignedObjectArray<btScalar>& values, int k) {
      return VectorX(Eigen::Map<const VectorX>(&values[k], n));
    };
    const VectorX J = of(jacobians, at), response = of(responses, at);
    EXPECT_LT((of(m_data.m_jacobians, row.m_jacAindex) - J).norm(), 1e-10 * J.norm());
    EXPECT_LT((of(m_data.m_deltaVelocitiesUnitImpulse, row.m_jacAindex) - response).norm(), 1e-9 * response.norm());
    ++rows;
    feet_and_others |= row.m_linkA < 0 ? 1 : 2;
  }

  JointSpaceInertia& inertia_;
};

class ContactRowsTest : public testing::TestWithParam<const char*> {};

TEST_P(ContactRowsTest, AreThoseThatBulletMakes) {
  const RobotModel model = AnyRobot(GetParam());
  for (const char* terrain : {"flat", "rough"}) {
    SmallWorld<ComparedSolver> made(model, MakeTerrain(terrain, TerrainScale()).value(), StandingConfiguration(model));
    for (int k = 0; k < 1500 && !HasFailure(); ++k) made.world.stepSimulation(0.001, 0);  // the robot collapses
    EXPECT_GT(made.solver.rows, 1000);
    EXPECT_EQ(made.solver.feet_and_others, 3) << "base and links touch the ground";
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, ContactRowsTest, testing::Values("a1", "nao"),
                         [](const auto& i) { return std::string(i.param); });

TEST(AddJacobian, MakesRoomOfZeros) {
  btMultiBodyJacobianData data;
  EXPECT_EQ(AddJacobian(3, data), 0);
  data.m_jacobians[2] = 7.0;
  EXPECT_EQ(AddJacobian(2, data), 3);
  ASSERT_EQ(data.m_jacobians.size(), 5);
  EXPECT_EQ(data.m_jacobians[2], 7.0) << "the first stays";
  EXPECT_EQ(data.m_jacobians[3], 0.0);
  EXPECT_EQ(data.m_jacobians[4], 0.0);
}

// The body's velocity change has one place in the arrays of a step, for any number of its rows.
TEST(AddEmptyRow, RowsOfOneBodyShareItsChangeOfVelocity) {
  const RobotModel model = one_joint::Make(JointType::kPrismatic);
  VectorX q = VectorX::Zero(8);
  q[6] = 1.0;
  RobotBody robot(model, {.locked_dofs = {}, .q0 = q});
  robot.multibody().setCompanionId(-1);
  btMultiBodyConstraintArray rows;
  btMultiBodyJacobianData data;
  for (int k = 0; k < 2; ++k) AddEmptyRow(robot.multibody(), -1, rows, data);
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(data.m_deltaVelocities.size(), 7) << "six of the base, one of the joint";
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(rows[k].m_multiBodyA, &robot.multibody());
    EXPECT_EQ(rows[k].m_deltaVelAindex, 0);
    EXPECT_EQ(rows[k].m_jacDiagABInv, 1.0);
    EXPECT_EQ(rows[k].m_rhs, 0.0);
  }
}

}  // namespace
}  // namespace gaitwright::bullet
