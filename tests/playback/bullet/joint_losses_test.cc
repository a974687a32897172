// SPDX-License-Identifier: BSD-3-Clause
// Damping, dry friction and rotor inertia in the simulator.
#include "kinematics/model/joint_losses.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "playback/bullet/bullet_world.h"
#include "playback/control/joint_pd.h"
#include "tests/playback/one_joint.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

using one_joint::kInertia;

JointCommand Torques(const VectorX& tau) {
  const VectorX zero = VectorX::Zero(tau.size());
  return {zero, zero, tau, zero, zero};
}

/// One joint in free fall, with a rate at the start.
struct Falling {
  Falling(const RobotModel& robot, const WorldOptions& options, double rate)
      : model(robot), world(model, FlatTerrain(), Start(), options) {
    VectorX v = VectorX::Zero(7);
    v[6] = rate;
    world.SetState(Start(), v);
  }

  static VectorX Start() {
    VectorX q = VectorX::Zero(8);
    q[2] = 1000.0;
    q[6] = 1.0;
    return q;
  }

  /// The rate after some steps under a torque.
  double RateAfter(int steps, double torque = 0.0) {
    for (int k = 0; k < steps; ++k) world.Step(Torques(VectorX::Constant(1, torque)));
    return world.v()[6];
  }

  RobotModel model;
  BulletWorld world;
};

class OneJoint : public testing::TestWithParam<JointType> {
 protected:
  RobotModel model_ = one_joint::Make(GetParam());
  double h_ = WorldOptions().step_s;
};

TEST_P(OneJoint, WithoutLossesIsTheReducedInertia) {
  EXPECT_NEAR(Falling(model_, {}, 0.0).RateAfter(100, 2.0), 100 * h_ * 2.0 / kInertia, 1e-9);
}

TEST_P(OneJoint, RotorInertiaAddsToIt) {
  model_.motors[0].rotor_inertia = 0.3;
  Falling falling(model_, {}, 0.0);
  EXPECT_NEAR(falling.RateAfter(1, 2.0), h_ * 2.0 / (kInertia + 0.3), 1e-12);
  EXPECT_NEAR(falling.RateAfter(99, 2.0), 100 * h_ * 2.0 / (kInertia + 0.3), 1e-9);
  EXPECT_EQ(falling.world.tau()[0], 2.0);
  EXPECT_NEAR(Falling(model_, {}, 3.0).RateAfter(100), 3.0, 1e-9) << "it keeps its speed";
}

TEST_P(OneJoint, DampingDecaysAsTheImplicitSchemeDoes) {
  for (const double rotor : {0.0, 0.4}) {
    for (const double damping : {0.5, 50.0, 1e6}) {
      model_.joints[0].damping = damping;
      model_.motors[0].rotor_inertia = rotor;
      const double factor = 1.0 / (1.0 + h_ * damping / (kInertia + rotor));
      EXPECT_NEAR(Falling(model_, {}, 3.0).RateAfter(50), 3.0 * std::pow(factor, 50), 1e-9) << damping;
    }
  }
  model_.joints[0].damping = 0.5;
  model_.motors[0].rotor_inertia = 0.0;
  EXPECT_NEAR(Falling(model_, {}, 3.0).RateAfter(1000), 3.0 * std::exp(-0.5 / kInertia), 2e-3) << "and so in the limit";
}

TEST_P(OneJoint, DampingLetsItReachTheSpeedOfItsTorque) {
  model_.joints[0].damping = 4.0;
  EXPECT_NEAR(Falling(model_, {}, 0.0).RateAfter(6000, 2.0), 0.5, 1e-9);
}

TEST_P(OneJoint, DryFrictionHoldsUpToBreakaway) {
  model_.joints[0].friction = 1.0;
  Falling holds(model_, {}, 0.0);
  EXPECT_NEAR(holds.RateAfter(200, 0.999), 0.0, 1e-13);
  EXPECT_NEAR(holds.world.q()[7], 0.0, 1e-13);
  EXPECT_NEAR(holds.RateAfter(200, 1.5), 200 * h_ * 0.5 / kInertia, 1e-9) << "breaks away, and slides";
  EXPECT_NEAR(Falling(model_, {}, 0.0).RateAfter(200, -1.5), -200 * h_ * 0.5 / kInertia, 1e-9);
}

TEST_P(OneJoint, DryFrictionBringsItToRestAndNoFarther) {
  model_.joints[0].friction = 1.0;
  Falling slides(model_, {}, 0.1);
  EXPECT_NEAR(slides.RateAfter(40), 0.1 - 40 * h_ / kInertia, 1e-12);
  EXPECT_NEAR(slides.RateAfter(60), 0.0, 1e-13);
  EXPECT_NEAR(slides.RateAfter(100, 0.9), 0.0, 1e-13);
  EXPECT_NEAR(Falling(model_, {}, -0.1).RateAfter(40), -0.1 + 40 * h_ / kInertia, 1e-12);
}

TEST_P(OneJoint, LossesNeverAddEnergy) {
  std::srand(3);
  for (int trial = 0; trial < 30; ++trial) {
    const VectorX of = VectorX::Random(5).array().abs();
    model_.joints[0].damping = trial % 3 == 0 ? 0.0 : std::pow(10.0, 6.0 * of[0] - 2.0);
    model_.joints[0].friction = trial % 4 == 0 ? 0.0 : std::pow(10.0, 4.0 * of[1] - 2.0);
    model_.motors[0].rotor_inertia = trial % 2 == 0 ? 0.0 : of[2];
    WorldOptions coarse;
    coarse.step_s = 0.001 + 0.009 * of[3];
    Falling falling(model_, coarse, 6.0 * of[4] - 3.0);
    double before = std::abs(falling.world.v()[6]);
    for (int k = 0; k < 100; ++k) {
      const double now = std::abs(falling.RateAfter(1));
      ASSERT_LE(now, before * (1.0 + 1e-12) + 1e-13) << "trial " << trial;
      before = now;
    }
  }
}

TEST_P(OneJoint, SwitchesAndDisturbances) {
  model_.joints[0].damping = 2.0;
  model_.joints[0].friction = 0.5;
  model_.motors[0].rotor_inertia = 0.3;
  WorldOptions options;
  options.joint_losses = false;
  EXPECT_NEAR(Falling(model_, options, 3.0).RateAfter(10, 1.0), 3.0 + 10 * h_ / kInertia, 1e-9);
  options.joint_friction_nm = 0.25;
  options.rotor_inertia_kg_m2 = 0.2;
  EXPECT_NEAR(Falling(model_, options, 3.0).RateAfter(10, 1.0), 3.0 + 10 * h_ * 0.75 / (kInertia + 0.2), 1e-9);
  options.joint_losses = true;
  model_.joints[0].damping = 0.0;
  EXPECT_NEAR(Falling(model_, options, 3.0).RateAfter(10, 1.0), 3.0 + 10 * h_ * 0.25 / (kInertia + 0.5), 1e-9);
}

TEST_P(OneJoint, AShareOfTheTorqueArrivesAndTheMotorsOwnIsReported) {
  WorldOptions weak;
  weak.torque_scale = 0.9;
  Falling falling(model_, weak, 0.0);
  EXPECT_NEAR(falling.RateAfter(10, 2.0), 10 * h_ * 0.9 * 2.0 / kInertia, 1e-9);
  EXPECT_EQ(falling.world.tau()[0], 2.0);
  EXPECT_NEAR(falling.RateAfter(10, 50.0), 10 * h_ * 0.9 * 12.0 / kInertia, 1e-9) << "its limit is the motor's";

  JointCommand pulls = Torques(VectorX::Constant(1, 1.0));
  pulls.q[0] = 0.02;
  pulls.stiffness[0] = 200.0;
  pulls.damping[0] = 3.0;
  Falling held(model_, weak, 0.0);
  for (int k = 0; k < 20; ++k) {
    const double before = held.world.v()[6];
    held.world.Step(pulls);
    const double tau = held.world.tau()[0];
    EXPECT_NEAR(tau, 1.0 + 200.0 * (0.02 - held.world.q()[7]) - 3.0 * held.world.v()[6], 1e-9);
    EXPECT_NEAR(held.world.v()[6] - before, h_ * 0.9 * tau / kInertia, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, OneJoint, testing::Values(JointType::kPrismatic, JointType::kRevolute),
                         [](const auto& i) { return i.param == JointType::kPrismatic ? "slide" : "hinge"; });

/// A named robot whose joints get losses of all kinds.
RobotModel Rubbing(const std::string& name, double friction = 0.05) {
  RobotModel model = standing::Load(name);
  model.motors.resize(model.dof_names.size());
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    model.joints[i].damping = 0.02 + 0.01 * static_cast<double>(i % 5);
    model.joints[i].friction = friction * (1.0 + static_cast<double>(i % 3));
  }
  for (std::size_t d = 0; d < model.motors.size(); ++d)
    model.motors[d].rotor_inertia = 0.002 * static_cast<double>(d % 4);
  return model;
}

class WholeRobot : public testing::TestWithParam<const char*> {};

/// (M + J + h d) a = tau - c - d v - f sign(v), from our own mass matrix and inverse dynamics. This includes NAO's
/// geared hips, whose losses add up.
TEST_P(WholeRobot, OneStepIsTheSolutionOfOurOwnDynamics) {
  RobotModel model = Rubbing(GetParam(), 0.005);
  const int n = model.num_dofs();
  const double h = WorldOptions().step_s;
  DynamicsScratch scratch(model);
  MatrixX M(model.nv(), model.nv());
  VectorX force(model.nv());
  MassMatrix(model, StandingConfiguration(model), scratch, M);
  const MatrixX mobility = M.inverse();
  for (Joint& joint : model.joints) {  // NAO's hands are very light: friction would stop them at once
    if (h * joint.friction * mobility(6 + joint.dof, 6 + joint.dof) > 0.5) joint.friction = 0.0;
  }
  std::srand(17);
  for (int trial = 0; trial < 10; ++trial) {
    VectorX q = StandingConfiguration(model) + 0.1 * VectorX::Random(model.nq());
    for (int dof = 0; dof < n; ++dof) {  // away from the stops
      const double low = model.dof_lower(dof), high = model.dof_upper(dof);
      q[7 + dof] = std::clamp(q[7 + dof], low + 0.1 * (high - low), high - 0.1 * (high - low));
    }
    q[2] += 5.0;
    q.segment<4>(3).normalize();
    VectorX v = VectorX::Random(model.nv());
    for (int dof = 0; dof < n; ++dof) v[6 + dof] += std::copysign(2.0, v[6 + dof]);  // sliding
    VectorX tau = 0.02 * VectorX::Random(n);
    for (int dof = 0; dof < n; ++dof) {
      if (LossesOf(model, dof).friction == 0.0) tau[dof] = 0.0;
    }
    BulletWorld world(model, FlatTerrain(), q, {});
    world.SetState(q, v);
    world.Step(Torques(tau));

    InverseDynamics(model, q, v, VectorX::Zero(model.nv()), scratch, force);
    force = -force;
    MassMatrix(model, q, scratch, M);
    const VectorX plain = M.lu().solve(force + (VectorX(model.nv()) << VectorX::Zero(6), tau).finished());
    AddRotorInertia(model, M);
    for (int dof = 0; dof < n; ++dof) {
      const JointLosses losses = LossesOf(model, dof);
      const double rate = v[6 + dof];
      M(6 + dof, 6 + dof) += h * losses.damping;
      force[6 + dof] += tau[dof] - losses.damping * rate - losses.friction * (rate > 0.0 ? 1.0 : -1.0);
    }
    const VectorX a = M.lu().solve(force);
    EXPECT_GT((a - plain).tail(n).lpNorm<Eigen::Infinity>(), 1.0) << "they matter";
    EXPECT_LT(((world.v() - v) / h - a).tail(n).lpNorm<Eigen::Infinity>(), 1e-7 * a.lpNorm<Eigen::Infinity>());
  }
}

TEST_P(WholeRobot, ItsMotionDiesAwayWithoutEnergyFromNowhere) {
  const RobotModel model = Rubbing(GetParam(), 0.01);
  VectorX q = StandingConfiguration(model), v = VectorX::Zero(model.nv());
  q[2] += 100.0;
  std::srand(5);
  v.tail(model.num_dofs()) = 2.0 * VectorX::Random(model.num_dofs());
  BulletWorld world(model, FlatTerrain(), q, {});
  world.SetState(q, v);
  DynamicsScratch scratch(model);
  MatrixX M(model.nv(), model.nv());
  const auto energy = [&] {  // of the motion relative to the common centre of mass, with the rotors
    MassMatrix(model, world.q(), scratch, M);
    AddRotorInertia(model, M);
    ForwardVelocities(model, world.q(), world.v(), scratch);
    const Vector3 momentum = CentroidalMomentum(model, scratch).head<3>();
    return 0.5 * world.v().dot(M * world.v()) - 0.5 * momentum.squaredNorm() / model.total_mass_kg;
  };
  const double first = energy();
  double before = first;
  for (int k = 0; k < 500; ++k) {
    world.Step(Torques(VectorX::Zero(model.num_dofs())));
    const double now = energy();
    ASSERT_LT(now, before + 1e-4 * first) << "at step " << k;
    before = now;
  }
  EXPECT_LT(before, 0.5 * first);
}

/// Contacts, motors and losses together: fifty iterations give the result of five thousand.
TEST_P(WholeRobot, IterationsAreEnoughOnTheGround) {
  const RobotModel model = Rubbing(GetParam());
  const MotionPlan plan = standing::Plan(model, 1.0);
  WorldOptions many;
  many.solver_iterations = 5000;
  BulletWorld usual(model, plan.terrain, plan.whole_body.q.front(), {});
  BulletWorld exact(model, plan.terrain, plan.whole_body.q.front(), many);
  JointPd controller(model, plan);
  double moved = 0.0;
  for (int k = 0; k < 300; ++k) {
    JointCommand command = controller.Update({});
    command.q.array() += 0.03 * std::sin(0.02 * k);
    usual.Step(command);
    exact.Step(command);
    moved = std::max(moved, usual.v().tail(model.num_dofs()).lpNorm<Eigen::Infinity>());
    ASSERT_LT((usual.tau() - exact.tau()).lpNorm<Eigen::Infinity>(), 0.02 * exact.tau().lpNorm<Eigen::Infinity>()) << k;
  }
  EXPECT_GT(moved, 0.1);
  EXPECT_LT((usual.q() - exact.q()).lpNorm<Eigen::Infinity>(), 1e-5);
}

TEST_P(WholeRobot, StuckJointsCarryItWithoutMotors) {
  const RobotModel model = Rubbing(GetParam(), 100.0);
  const VectorX q0 = StandingConfiguration(model);
  BulletWorld world(model, FlatTerrain(), q0, {});
  for (int k = 0; k < 300; ++k) world.Step(Torques(VectorX::Zero(model.num_dofs())));
  EXPECT_LT((world.q() - q0).lpNorm<Eigen::Infinity>(), 1e-3);
  WorldOptions without;
  without.joint_losses = false;
  BulletWorld limp(model, FlatTerrain(), q0, without);
  for (int k = 0; k < 300; ++k) limp.Step(Torques(VectorX::Zero(model.num_dofs())));
  EXPECT_GT((limp.q() - q0).lpNorm<Eigen::Infinity>(), 0.1);
}

TEST_P(WholeRobot, WeldedJointsLoseNothing) {
  const RobotModel model = Rubbing(GetParam());
  const MotionPlan plan = standing::Plan(model, 1.0);
  WorldOptions welded;
  for (int dof = 0; dof < model.num_dofs(); ++dof) welded.locked_dofs.push_back(dof);
  BulletWorld world(model, plan.terrain, plan.whole_body.q.front(), welded);
  for (int k = 0; k < 100; ++k) world.Step(Torques(plan.whole_body.tau.front()));
  EXPECT_EQ(world.tau().norm(), 0.0);
  EXPECT_LT((world.q() - plan.whole_body.q.front()).lpNorm<Eigen::Infinity>(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Robots, WholeRobot, testing::Values("a1", "nao"), [](const auto& i) { return i.param; });

}  // namespace
}  // namespace gaitwright
