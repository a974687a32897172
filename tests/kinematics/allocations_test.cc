// SPDX-License-Identifier: BSD-3-Clause
// Functions for control loops allocate no memory after their scratch is created.
#include "tests/kinematics/allocations.h"

#include <functional>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/ik/whole_body_ik.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

class NoAllocations : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const long before = Allocations();
    const MatrixX seen = MatrixX::Zero(5, 5);
    ASSERT_GT(Allocations(), before) << "the counter does not count";
  }

  /// Allocations of the second call; the first call may resize its arguments.
  static long OfSecond(const std::function<void()>& call) {
    call();
    const long before = Allocations();
    call();
    return Allocations() - before;
  }

  RobotModel model_ = AnyRobot(GetParam());
  DynamicsScratch scratch_{model_};
  RandomState random_{3};
};

TEST_P(NoAllocations, Dynamics) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
  const int body = static_cast<int>(model_.bodies.size()) - 1;
  MatrixX M, J(6, model_.nv()), J_C(3, model_.nv()), S(6, static_cast<Eigen::Index>(model_.joints.size()));
  VectorX tau;
  Vector3 point;
  Vector6 twist;
  const Vector3 p_BQ(0.1, 0.2, 0.3);
  EXPECT_EQ(OfSecond([&] { ForwardKinematics(model_, q, scratch_); }), 0);
  EXPECT_EQ(OfSecond([&] { ForwardVelocities(model_, q, v, scratch_); }), 0);
  EXPECT_EQ(OfSecond([&] { PointJacobian(model_, scratch_, body, p_BQ, J); }), 0);
  EXPECT_EQ(OfSecond([&] { JointScrews(model_, scratch_, S); }), 0);
  EXPECT_EQ(OfSecond([&] { PointJacobianRate(model_, scratch_, body, p_BQ, J); }), 0);
  EXPECT_EQ(OfSecond([&] { twist = PointVelocity(scratch_, body, p_BQ); }), 0);
  EXPECT_EQ(OfSecond([&] { twist = PointBiasAcceleration(scratch_, body, p_BQ); }), 0);
  EXPECT_EQ(OfSecond([&] { point = CentreOfMass(model_, scratch_); }), 0);
  EXPECT_EQ(OfSecond([&] { CentreOfMassJacobian(model_, scratch_, J_C); }), 0);
  EXPECT_EQ(OfSecond([&] { point = CentreOfMassBiasAcceleration(model_, scratch_); }), 0);
  EXPECT_EQ(OfSecond([&] { twist = CentroidalMomentum(model_, scratch_); }), 0);
  EXPECT_EQ(OfSecond([&] { InverseDynamics(model_, q, v, a, scratch_, tau); }), 0);
  EXPECT_EQ(OfSecond([&] { MassMatrix(model_, q, scratch_, M); }), 0);
}

TEST_P(NoAllocations, WholeBodyIk) {
  const VectorX standing = StandingConfiguration(model_);
  ForwardKinematics(model_, standing, scratch_);
  BodyTarget target;
  target.p_WC = CentreOfMass(model_, scratch_) + Vector3(0.004, 0.003, -0.005);
  for (const Foot& foot : model_.feet) {
    const Pose X_WF = FramePose(scratch_, foot.body, foot.X_BF);
    FootTarget wanted;
    wanted.p_WF = X_WF.translation();
    wanted.R_WF = wanted.R_anchor = X_WF.linear();
    target.feet.push_back(wanted);
  }
  WholeBodyIk ik(model_);
  VectorX q, v, a;
  int iterations = 0;
  EXPECT_EQ(OfSecond([&] {
              q = standing;
              const Result<int> solved = ik.SolvePosition(target, q);
              iterations = solved.ok() ? *solved : -1;
            }),
            0);
  EXPECT_GT(iterations, 0);
  EXPECT_EQ(OfSecond([&] { ik.SolveRates(target, q, v, a); }), 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, NoAllocations, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
