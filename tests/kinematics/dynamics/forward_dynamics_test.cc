// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/forward_dynamics.h"

#include <Eigen/Cholesky>

#include "kinematics/base/result.h"
#include "tests/kinematics/allocations.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

class ForwardDynamicsOf : public testing::TestWithParam<const char*> {
 protected:
  RobotModel model_ = AnyRobot(GetParam());
  DynamicsScratch scratch_{model_};
  ForwardDynamics forward_{model_};
  RandomState random_{13};
};

TEST_P(ForwardDynamicsOf, IsTheInverseOfInverseDynamics) {
  for (int trial = 0; trial < 10; ++trial) {
    const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
    VectorX tau, back;
    InverseDynamics(model_, q, v, a, scratch_, tau);
    forward_.Compute(q, v, tau, back);
    EXPECT_LT((back - a).norm(), 1e-8 * a.norm());
  }
}

TEST_P(ForwardDynamicsOf, IsTheSolutionWithTheMassMatrixAndRotors) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), tau = random_.Vector(model_.nv());
  const VectorX rotors = random_.Vector(model_.num_dofs()).cwiseAbs();
  MatrixX M;
  VectorX bias, a;
  MassMatrix(model_, q, scratch_, M);
  M.diagonal().tail(model_.num_dofs()) += rotors;
  InverseDynamics(model_, q, v, VectorX::Zero(model_.nv()), scratch_, bias);
  const VectorX wanted = M.ldlt().solve(tau - bias);
  forward_.Compute(q, v, tau, a, rotors);
  EXPECT_LT((a - wanted).norm(), 1e-9 * wanted.norm());
}

TEST_P(ForwardDynamicsOf, WithoutTorqueTheRobotFallsFreely) {
  const VectorX q = random_.Configuration(model_), none = VectorX::Zero(model_.nv());
  VectorX a;
  forward_.Compute(q, none, none, a);
  EXPECT_LT((a.head<3>() + kGravity * Vector3::UnitZ()).norm(), 1e-9);
  EXPECT_LT(a.tail(model_.nv() - 3).norm(), 1e-7);
}

TEST_P(ForwardDynamicsOf, AllocatesNothingAfterTheFirstCall) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), tau = random_.Vector(model_.nv());
  VectorX a;
  forward_.Compute(q, v, tau, a);
  const long before = Allocations();
  forward_.Compute(q, v, tau, a);
  EXPECT_EQ(Allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(Robots, ForwardDynamicsOf, testing::ValuesIn(kAnyRobots));

TEST(ForwardDynamics, AJointThatMovesNothingIsNamed) {
  RobotModel model = AnyRobot("a1");
  model.bodies.back().mass = 0.0;
  model.bodies.back().I_C.setZero();
  RandomState random(17);
  VectorX a;
  ForwardDynamics forward(model);
  try {
    forward.Compute(random.Configuration(model), VectorX::Zero(model.nv()), VectorX::Zero(model.nv()), a);
    FAIL() << "no acceleration is right";
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find(model.joints.back().name), std::string::npos);
  }
}

}  // namespace
}  // namespace gaitwright
