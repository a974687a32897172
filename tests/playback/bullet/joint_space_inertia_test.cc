// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "playback/bullet/joint_space_inertia_internal.h"
#include "playback/bullet/robot_body_internal.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright::bullet {
namespace {

/// Compares two independent methods: Bullet's articulated bodies and our composite bodies.
class JointSpaceInertiaTest : public testing::TestWithParam<const char*> {
 protected:
  JointSpaceInertiaTest() : model_(AnyRobot(GetParam())), random_(23) {}

  /// Every third joint is welded if `welded`.
  RobotBody Body(bool welded) {
    BodyOptions options;
    options.base_com_shift_B = {0.01, -0.02, 0.03};
    options.q0 = random_.Configuration(model_);
    for (int dof = 0; welded && dof < model_.num_dofs(); dof += 3) options.locked_dofs.push_back(dof);
    return RobotBody(model_, options);
  }

  /// Sets a random state, for which Bullet has computed its own factorisation.
  VectorX Move(RobotBody& body) {
    const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv());
    body.Accelerations(q, v, VectorX::Zero(model_.num_dofs()));
    body.inertia().Update();
    VectorX velocity = Eigen::Map<const VectorX>(body.multibody().getVelocityVector(), body.inertia().size());
    return velocity;
  }

  VectorX BulletsResponse(RobotBody& body, const VectorX& J) {
    VectorX response(J.size());
    btAlignedObjectArray<btScalar> scratch_r;
    btAlignedObjectArray<btVector3> scratch_v;
    body.multibody().calcAccelerationDeltasMultiDof(J.data(), response.data(), scratch_r, scratch_v);
    return response;
  }

  const RobotModel model_;
  RandomState random_;
};

TEST_P(JointSpaceInertiaTest, RespondsAsBulletsArticulatedBodiesDo) {
  for (const bool welded : {false, true}) {
    RobotBody body = Body(welded);
    JointSpaceInertia& inertia = body.inertia();
    for (int trial = 0; trial < 5; ++trial) {
      Move(body);
      for (int k = 0; k < inertia.size() + 5; ++k) {
        VectorX J = k < inertia.size() ? VectorX(VectorX::Unit(inertia.size(), k)) : random_.Vector(inertia.size());
        const VectorX wanted = BulletsResponse(body, J);
        ASSERT_GT(wanted.norm(), 0.0);
        EXPECT_NEAR(inertia.InverseAlong(J.data()), J.dot(wanted), 1e-10 * J.dot(wanted)) << k;
        inertia.factor().SolveUpper(J.data());
        inertia.factor().SolveLower(J.data());
        EXPECT_LT((J - wanted).norm(), 1e-10 * wanted.norm()) << "column " << k;
      }
    }
  }
}

TEST_P(JointSpaceInertiaTest, HasTheKineticEnergyOfOurOwnMassMatrix) {
  BodyOptions options;
  options.q0 = random_.Configuration(model_);
  RobotBody body(model_, options);
  DynamicsScratch scratch(model_);
  MatrixX M(model_.nv(), model_.nv());
  for (int trial = 0; trial < 5; ++trial) {
    const VectorX velocity = Move(body);
    VectorX q, v, momentum(velocity.size());
    body.GetState(q, v);
    Multiply(body.inertia().tree(), body.inertia().matrix(), velocity.data(), momentum.data());
    MassMatrix(model_, q, scratch, M);
    EXPECT_GT(v.dot(M * v), 0.1);
    EXPECT_NEAR(velocity.dot(momentum), v.dot(M * v), 1e-10 * v.dot(M * v));
  }
}

TEST_P(JointSpaceInertiaTest, PointsMoveAsBulletsContactsSay) {
  RobotBody body = Body(true);
  JointSpaceInertia& inertia = body.inertia();
  Move(body);
  btAlignedObjectArray<btScalar> scratch_r;
  btAlignedObjectArray<btVector3> scratch_v;
  btAlignedObjectArray<btMatrix3x3> scratch_m;
  for (int link = -1; link < body.multibody().getNumLinks(); ++link) {
    const Vector3 p_W = random_.Vector(3), direction_W = random_.Vector(3);
    VectorX J = VectorX::Zero(inertia.size()), wanted(inertia.size());
    inertia.FillPointJacobian(link, p_W, direction_W, J.data());
    body.multibody().fillContactJacobianMultiDof(link, ToBullet(p_W), ToBullet(direction_W), wanted.data(), scratch_r,
                                                 scratch_v, scratch_m);
    EXPECT_LT((J - wanted).norm(), 1e-12 * wanted.norm()) << link;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, JointSpaceInertiaTest, testing::ValuesIn(kAnyRobots),
                         [](const auto& i) { return std::string(i.param); });

}  // namespace
}  // namespace gaitwright::bullet
