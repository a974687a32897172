// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planning/plan/built_in_terrain.h"
#include "playback/bullet/condensed_solver_internal.h"
#include "playback/bullet/contact_rows_internal.h"
#include "playback/bullet/ground_internal.h"
#include "playback/bullet/joint_rows_internal.h"
#include "playback/engine/world_options.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright::bullet {
namespace {

/// Makes the rows of contacts twice, here and by Bullet, and compares them.
class ComparedSolver : public CondensedSolver {
 public:
  explicit ComparedSolver(JointSpaceInertia& inertia) : CondensedSolver(inertia), inertia_(inertia) {}

  int rows = 0, feet_and_others = 0;

 protected:
  void convertContacts(btPersistentManifold** manifolds, int num_manifolds, const btContactSolverInfo& info) override {
    btMultiBodyConstraintSolver::convertContacts(manifolds, num_manifolds, info);
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

/// A robot alone in a world of Bullet's.
template <class Solver>
struct SmallWorld {
  SmallWorld(const RobotModel& model, const Terrain& terrain, const VectorX& q0)
      : ground(terrain, WorldOptions(), Bumps()),
        body(model, {.locked_dofs = {}, .q0 = q0}),
        dispatcher(&configuration),
        solver(body.inertia()),
        world(&dispatcher, &broadphase, &solver, &configuration) {
    world.setGravity(btVector3(0.0, 0.0, -kGravity));
    world.getSolverInfo().m_globalCfm = WorldOptions().contact_cfm;
    world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    ground.AddTo(world);
    body.AddTo(world);
  }
  ~SmallWorld() {
    while (world.getNumMultiBodyConstraints() > 0) world.removeMultiBodyConstraint(world.getMultiBodyConstraint(0));
    world.removeMultiBody(&body.multibody());
    for (int i = world.getNumCollisionObjects() - 1; i >= 0; --i)
      world.removeCollisionObject(world.getCollisionObjectArray()[i]);
  }

  Ground ground;
  RobotBody body;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  Solver solver;
  btMultiBodyDynamicsWorld world;
};

class ContactRowsTest : public testing::TestWithParam<const char*> {};

TEST_P(ContactRowsTest, AreThoseThatBulletMakes) {
  const RobotModel model = AnyRobot(GetParam());
  for (const char* terrain : {"flat", "rough"}) {
    SmallWorld<ComparedSolver> made(model, MakeTerrain(terrain, TerrainScale()).value(), StandingConfiguration(model));
    for (int k = 0; k < 1500 && !HasFailure(); ++k) made.world.stepSimulation(0.001, 0);  // it falls in a heap
    EXPECT_GT(made.solver.rows, 1000);
    EXPECT_EQ(made.solver.feet_and_others, 3) << "base and links touch the ground";
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, ContactRowsTest, testing::Values("a1", "nao"),
                         [](const auto& i) { return std::string(i.param); });

/// One gear twice says nothing new; the impulses of the two are not unique, the motion is.
TEST(CondensedSolver, GearsThatDependOnEachOtherAreHeldStill) {
  const RobotModel model = AnyRobot("mimic");
  const auto follows =
      std::find_if(model.joints.begin(), model.joints.end(), [](const Joint& j) { return j.is_mimic; });
  ASSERT_NE(follows, model.joints.end());
  const int follower = static_cast<int>(follows - model.joints.begin());
  const int leader = model.dof_joint[static_cast<std::size_t>(follows->dof)];
  VectorX q = StandingConfiguration(model);
  q[2] += 50.0;
  const auto rate_after = [&](int gears) {
    SmallWorld<CondensedSolver> made(model, FlatTerrain(), q);
    std::vector<std::unique_ptr<GearRow>> rows;
    for (int k = 0; k < gears; ++k) {
      rows.push_back(std::make_unique<GearRow>(made.body, *follows, follower, leader));
      made.world.addMultiBodyConstraint(rows.back().get());
    }
    for (int k = 0; k < 100; ++k) {
      made.body.multibody().addJointTorque(leader, 0.01);
      made.world.stepSimulation(0.001, 0);
      for (const auto& row : rows) EXPECT_LT(std::abs(row->Error()), 1e-6);
    }
    return made.body.multibody().getJointVel(leader);
  };
  const double free = rate_after(0), geared = rate_after(1);
  EXPECT_GT(std::abs(free - geared), 1e-3 * std::abs(free));
  EXPECT_NEAR(rate_after(2), geared, 1e-6 * std::abs(geared));
}

}  // namespace
}  // namespace gaitwright::bullet
