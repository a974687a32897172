// SPDX-License-Identifier: BSD-3-Clause
// Properties of Bullet's world only; tests of all engines are in tests/playback/engine.
#include "playback/bullet/bullet_world.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playback/control/joint_pd.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

JointCommand HoldAt(const RobotModel& model, const VectorX& joints, double stiffness, double damping) {
  const VectorX zero = VectorX::Zero(model.num_dofs());
  return {joints, zero, zero, VectorX::Constant(model.num_dofs(), stiffness),
          VectorX::Constant(model.num_dofs(), damping)};
}

class BulletWorldTest : public ::testing::TestWithParam<const char*> {
 protected:
  const RobotModel model_ = standing::Load(GetParam());
  const VectorX zero_v_ = VectorX::Zero(model_.nv());
};

TEST_P(BulletWorldTest, ForwardDynamicsFedToOurInverseDynamicsReturnsTheTorques) {
  BulletWorld world(model_, FlatTerrain(), StandingConfiguration(model_), {});
  DynamicsScratch scratch(model_);
  std::srand(7);
  for (int k = 0; k < 20; ++k) {
    VectorX q = StandingConfiguration(model_) + VectorX::Random(model_.nq());
    q.segment<4>(3).normalize();
    const VectorX v = 3.0 * VectorX::Random(model_.nv()), tau = 5.0 * VectorX::Random(model_.num_dofs());
    const VectorX a = world.Accelerations(q, v, tau);
    VectorX generalised(model_.nv());
    InverseDynamics(model_, q, v, a, scratch, generalised);
    EXPECT_GT(a.norm(), 1.0);
    EXPECT_LT(generalised.head<6>().lpNorm<Eigen::Infinity>(), 1e-9);
    EXPECT_LT((generalised.tail(model_.num_dofs()) - tau).lpNorm<Eigen::Infinity>(), 1e-9);
  }
}

TEST_P(BulletWorldTest, GearsFollow) {
  BulletWorld world(model_, FlatTerrain(), StandingConfiguration(model_), {});
  for (int k = 0; k < 1000; ++k) {
    const VectorX swing = VectorX::Constant(model_.num_dofs(), -0.2 * std::sin(0.01 * k));
    world.Step(HoldAt(model_, model_.standing_joints + swing, 50.0, 1.0));
    ASSERT_LT(world.gear_error(), 1e-5);
  }
}

TEST_P(BulletWorldTest, IterationsAreEnough) {
  const MotionPlan plan = standing::Plan(model_, 1.0);
  WorldOptions many;
  many.solver_iterations = 5000;
  BulletWorld usual(model_, plan.terrain, plan.whole_body.q.front(), {});
  BulletWorld exact(model_, plan.terrain, plan.whole_body.q.front(), many);
  JointPd controller(model_, plan);
  for (int k = 0; k < 300; ++k) {
    JointCommand command = controller.Update({});
    command.q.array() += 0.03 * std::sin(0.02 * k);
    usual.Step(command);
    exact.Step(command);
    ASSERT_LT((usual.tau() - exact.tau()).lpNorm<Eigen::Infinity>(), 0.02 * exact.tau().lpNorm<Eigen::Infinity>());
  }
  EXPECT_LT((usual.q() - exact.q()).lpNorm<Eigen::Infinity>(), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Robots, BulletWorldTest, ::testing::Values("a1", "nao"),
                         [](const auto& i) { return i.param; });

}  // namespace
}  // namespace gaitwright
