// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/loss_feed_forward.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playback/bullet/bullet_world.h"
#include "playback/control/joint_pd.h"
#include "tests/playback/one_joint.h"
#include "tests/playback/standing_plan.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

constexpr double kReach = 0.5, kPace = 4.0;  // amplitude [rad] and frequency [rad/s] of a periodic swing

RobotModel WithLosses() {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  model.joints[0].damping = 0.4;
  model.joints[0].friction = 0.3;
  model.motors[0].rotor_inertia = 0.2;
  return model;
}

/// One joint with a periodic swing, with the torque for a rigid body of its inertia.
MotionPlan Swinging() {
  MotionPlan plan;
  plan.terrain = FlatTerrain();
  WholeBodyTrajectory& w = plan.whole_body;
  w.step_s = 0.005;
  for (int k = 0; k <= 400; ++k) {
    const double t = w.step_s * k;
    VectorX q = VectorX::Zero(8), v = VectorX::Zero(7), a = v;
    q[2] = 1000.0;
    q[6] = 1.0;
    q[7] = kReach * (1.0 - std::cos(kPace * t));
    v[6] = kReach * kPace * std::sin(kPace * t);
    a[6] = kReach * kPace * kPace * std::cos(kPace * t);
    w.q.push_back(q);
    w.v.push_back(v);
    w.a.push_back(a);
    w.tau.push_back(VectorX::Constant(1, one_joint::kInertia * a[6]));
  }
  return plan;
}

/// Largest error of the joint in a playback with soft gains.
double TrackingError(const RobotModel& model, double share) {
  const MotionPlan plan = Swinging();
  GainOptions gains;
  gains.free_frequency_rad_s = 5.0;
  gains.loss_feed_forward = share;
  JointPd controller(model, plan, gains);
  BulletWorld world(model, plan.terrain, plan.whole_body.q.front(), {});
  world.SetState(plan.whole_body.q.front(), VectorX::Zero(7));
  double error = 0.0;
  for (int k = 0; k < 1990; ++k) {
    ControlInput input;
    input.time_s = 0.001 * k;
    world.Step(controller.Update(input));
    error = std::max(error, std::abs(world.q()[7] - kReach * (1.0 - std::cos(kPace * 0.001 * (k + 1)))));
  }
  return error;
}

TEST(LossFeedForward, IsWhatTheLossesTake) {
  const RobotModel model = WithLosses();
  GainOptions half;
  half.loss_feed_forward = 0.5;
  const LossFeedForward losses(model, half);
  VectorX tau = VectorX::Constant(1, 1.0);
  losses.AddInertia(VectorX::Constant(1, 3.0), tau);
  EXPECT_NEAR(tau[0], 1.0 + 0.5 * 0.2 * 3.0, 1e-15);
  losses.AddDrag(VectorX::Constant(1, -0.1), tau);
  EXPECT_NEAR(tau[0], 1.3 - 0.5 * (0.4 * 0.1 + 0.3 * std::tanh(1.0)), 1e-15);
  losses.AddDrag(VectorX::Zero(1), tau);
  EXPECT_NEAR(tau[0], 1.3 - 0.5 * (0.4 * 0.1 + 0.3 * std::tanh(1.0)), 1e-15) << "none at rest";
}

TEST(LossFeedForward, ChangesNoBitWhereNothingIsKnown) {
  const RobotModel a1 = standing::Load("a1");
  MotionPlan plan = standing::Plan(a1, 0.1);
  std::srand(2);
  for (VectorX& v : plan.whole_body.v) v.tail(12) = VectorX::Random(12);
  for (VectorX& a : plan.whole_body.a) a.tail(12) = VectorX::Random(12);
  GainOptions off;
  off.loss_feed_forward = 0.0;
  JointPd with(a1, plan), without(a1, plan, off);
  ControlInput input;
  input.time_s = 0.0312;
  EXPECT_EQ(with.Update(input).tau_ff, without.Update(input).tau_ff);
  RobotModel lossy = a1;
  lossy.joints[0].damping = 1.0;
  JointPd knows(lossy, plan);
  EXPECT_NE(knows.Update(input).tau_ff[0], without.Update(input).tau_ff[0]);
  EXPECT_EQ(knows.Update(input).tau_ff.tail(11), without.Update(input).tau_ff.tail(11));
}

TEST(LossFeedForward, KeepsAJointOnItsPlan) {
  EXPECT_LT(TrackingError(one_joint::Make(JointType::kRevolute), 1.0), 2e-3) << "without losses";
  EXPECT_LT(TrackingError(WithLosses(), 1.0), 5e-3) << "friction is made up for but near rest";
  RobotModel smooth = WithLosses();
  smooth.joints[0].friction = 0.0;
  EXPECT_LT(TrackingError(smooth, 1.0), 2e-3);
  EXPECT_GT(TrackingError(smooth, 0.0), 0.03);
  EXPECT_GT(TrackingError(WithLosses(), 0.0), 0.03);
}

TEST(LossFeedForward, OfASlideIsSmoothedByTheSizeOfItsLeg) {
  RobotModel model = *LoadRobotFromText(unusual::Telescopic(), "");
  int slide = 0;
  while (!model.LeaderOf(slide).is_prismatic()) ++slide;
  model.joints[static_cast<std::size_t>(model.dof_joint[static_cast<std::size_t>(slide)])].friction = 2.0;
  VectorX tau = VectorX::Zero(model.num_dofs()), v = tau;
  v[slide] = 0.05 * model.leg_length_m();
  GainOptions options;
  options.friction_speed_rad_s = 0.05;
  LossFeedForward(model, options).AddDrag(v, tau);
  EXPECT_NEAR(tau[slide], 2.0 * std::tanh(1.0), 1e-12);
}

TEST(LossFeedForward, RefusesWhatIsOutOfRange) {
  GainOptions options;
  options.loss_feed_forward = 1.5;
  EXPECT_THROW(LossFeedForward(standing::Load("a1"), options), InvalidArgument);
}

TEST(LossFeedForward, GainsKnowTheRotors) {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  const Gains plain = DeriveGains(model);
  model.motors[0].rotor_inertia = one_joint::kInertia;
  const Gains geared = DeriveGains(model);
  EXPECT_NEAR(plain.stiffness[0], one_joint::kInertia * 1600.0, 1e-6);
  EXPECT_NEAR(geared.stiffness[0], 2.0 * plain.stiffness[0], 1e-6);
  EXPECT_NEAR(geared.damping[0], 2.0 * plain.damping[0], 1e-6);
}

}  // namespace
}  // namespace gaitwright
