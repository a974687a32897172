// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// A body in free flight.
RigidBodyMotion Thrown(const Vector3& inertia, const Vector3& momentum, double duration_s) {
  RigidBodyMotion motion;
  motion.mass_kg = 2.0;
  motion.inertia_B = inertia.asDiagonal();
  RigidBodyInterval in;
  in.start_s = 0.0;
  in.end_s = duration_s;
  in.com = {Vector3(0.0, 0.0, 1.0), Vector3(0.5, 0.0, 2.0), Vector3(0.0, 0.0, -0.5 * kGravity), Vector3::Zero()};
  in.angles_rad = Vector3(0.2, 0.1, -0.3);
  in.momentum_W = momentum;
  motion.intervals = {in};
  return motion;
}

TEST(RigidBodyMotion, AThrownBodyKeepsItsMomentumAndItsEnergyOfTurning) {
  const RigidBodyMotion motion = Thrown({0.1, 0.2, 0.28}, {0.3, -0.2, 0.5}, 0.5);
  const auto energy = [&](const RigidBodySample& s) { return 0.5 * s.w_WB_B.dot(motion.inertia_B * s.w_WB_B); };
  const std::vector<RigidBodySample> samples = Sample(motion, 0.01);
  ASSERT_EQ(samples.size(), 51U);
  EXPECT_GT((samples.back().w_WB_B - samples.front().w_WB_B).norm(), 0.1);
  for (const RigidBodySample& s : samples) {
    EXPECT_NEAR(energy(s), energy(samples.front()), 1e-9);
    EXPECT_LT((s.momentum_W - samples.front().momentum_W).norm(), 1e-12);
    EXPECT_LT((s.a_WC + kGravity * Vector3::UnitZ()).norm(), 1e-12);
  }
  EXPECT_NEAR(samples.back().p_WC.z(), 1.0 + 2.0 * 0.5 - 0.5 * kGravity * 0.25, 1e-12);
}

TEST(RigidBodyMotion, TheTurningIsThatOfASymmetricTop) {
  // About its axis of symmetry, w precesses uniformly in the body, with (I1 - I3) / I1 of its spin.
  const Vector3 inertia(0.2, 0.2, 0.3), momentum(0.2, 0.1, 0.6);
  const RigidBodyMotion motion = Thrown(inertia, momentum, 0.4);
  const std::vector<RigidBodySample> samples = Sample(motion, 0.4);
  const Vector3 w = samples.front().w_WB_B;
  const double turned = 0.4 * w.z() * (inertia.x() - inertia.z()) / inertia.x();
  const Vector3 expected = Eigen::AngleAxisd(-turned, Vector3::UnitZ()) * w;
  EXPECT_GT((expected - w).norm(), 0.05);
  EXPECT_LT((samples.back().w_WB_B - expected).norm(), 1e-7);
}

/// A stander with varying forces.
struct Some {
  RigidBodyProblem problem = rigid_bodies::Stander();
  RigidBodyUnknowns unknowns{problem, 0.05, 3};
  VectorX x = rigid_bodies::Wavering(problem, unknowns);
  RigidBodyMotion motion = MotionOf(problem, unknowns, x);
};

TEST(RigidBodyMotion, IsTheUnknownsCentreOfMassAndForces) {
  const Some some;
  for (const RigidBodySample& s : Sample(some.motion, 0.013)) {
    EXPECT_LT((s.p_WC - some.unknowns.CentreOfMass(s.time_s).At(some.x)).norm(), 1e-9);
    Vector3 sum = Vector3::Zero();
    for (const Vector3& f : s.force_W) sum += f;
    EXPECT_LT((sum - 12.0 * (s.a_WC + kGravity * Vector3::UnitZ())).norm(), 1e-9 * sum.norm());
  }
}

TEST(RigidBodyMotion, VelocitiesAndMomentumAreContinuousAndIntegralsOfForces) {
  const Some some;
  const std::vector<RigidBodySample> samples = Sample(some.motion, 1e-3);
  for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
    const Vector3 v = (samples[k + 1].p_WC - samples[k - 1].p_WC) / 2e-3;
    EXPECT_LT((v - samples[k].v_WC).norm(), 1e-5);
    const Vector3 gained = samples[k + 1].momentum_W - samples[k].momentum_W;
    EXPECT_LT((gained / 1e-3 - 0.5 * (samples[k].torque_W + samples[k + 1].torque_W)).norm(), 1e-2);
  }
  EXPECT_GT(samples[300].torque_W.norm(), 0.5);
}

/// The gain of angular momentum of body and legs since the start equals the integral of the contact torques, by
/// Simpson's rule over small steps.
TEST(RigidBodyMotion, BoxAndWhatMovesInsideGainTheImpulseOfTorquesAtContactsThatMove) {
  Some some;
  rigid_bodies::AddLegMotion(some.problem, 41);
  rigid_bodies::AddRolling(some.problem);
  const RigidBodyUnknowns unknowns(some.problem, 0.05, 3);
  const RigidBodyMotion motion = MotionOf(some.problem, unknowns, rigid_bodies::Wavering(some.problem, unknowns));
  const LegMomentum inner(some.problem);
  const std::vector<RigidBodySample> samples = Sample(motion, 2.5e-4);
  const auto torque = [&](const RigidBodySample& s) -> Vector3 {
    const RigidBodyInterval& in = motion.intervals[s.interval];
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < in.forces.size(); ++i) {
      const RigidStance& stance = some.problem.stances[in.forces[i].stance];
      // Between nodes, contacts move uniformly.
      const double u = (s.time_s - in.start_s) / (in.end_s - in.start_s);
      const Vector3 moved = (1.0 - u) * stance.MovedAt(in.start_s) + u * stance.MovedAt(in.end_s);
      sum += (stance.X_WF.translation() + moved - s.p_WC).cross(s.force_W[i]);
    }
    return sum;
  };
  Vector3 impulse = Vector3::Zero(), without = Vector3::Zero();
  for (std::size_t k = 2; k < samples.size(); k += 2) {
    const double h = samples[k].time_s - samples[k - 2].time_s;
    impulse += h / 6.0 * (torque(samples[k - 2]) + 4.0 * torque(samples[k - 1]) + torque(samples[k]));
    const Vector3 gained = samples[k].momentum_W - samples[0].momentum_W;
    const Vector3 within = inner.At(samples[k].time_s) - inner.At(0.0);
    ASSERT_LT((gained + within - impulse).norm(), 1e-6) << samples[k].time_s;
    EXPECT_LT((samples[k].torque_W - torque(samples[k]) + inner.RateAt(samples[k].time_s)).norm(), 1e-9);
    without = gained - impulse;
  }
  EXPECT_GT(without.norm(), 0.02) << "what moves inside counts";
  EXPECT_GT(impulse.norm(), 0.02);
}

TEST(RigidBodyMotion, BalancesForcesAndTorquesWhateverItsUnknowns) {
  const Some some;
  const RigidBodyFaults faults = FaultsOf(some.problem, some.motion, 1e-3);
  EXPECT_LT(faults.force_balance, 1e-12);
  EXPECT_LT(faults.torque_balance, 1e-4);
  EXPECT_GT(faults.goal, 0.01);  // these forces rotate it
}

TEST(RigidBodyMotion, FaultsAreFound) {
  Some some;
  RigidBodyMotion broken = some.motion;
  broken.intervals[6].forces[0].from_W.x() += 11.772;  // a tenth of the weight
  EXPECT_NEAR(FaultsOf(some.problem, broken, 1e-3).force_balance, 0.1, 5e-3);
  broken.intervals[6].forces[0].from_W.x() += 35.316;
  EXPECT_NEAR(FaultsOf(some.problem, broken, 1e-3).friction, 0.4 - 0.6 * 0.25, 0.03);
  broken.intervals[6].forces[0].from_W.z() -= 47.088;
  EXPECT_NEAR(FaultsOf(some.problem, broken, 1e-3).unilateral, 0.4 - 0.25, 0.03);
  broken = some.motion;
  broken.intervals[6].momentum_W.y() += 0.1;  // a jump: 100 N m in 1 ms, over 117.72 N; it turns the next interval
  EXPECT_GT(FaultsOf(some.problem, broken, 1e-3).torque_balance, 100.0 / 117.72);
  const double reach = FaultsOf(some.problem, some.motion, 1e-3).reach_m;
  broken = some.motion;
  for (Pose& X_WF : broken.X_WF) X_WF.translation().z() -= 1.0;
  EXPECT_NEAR(FaultsOf(some.problem, broken, 1e-3).reach_m, reach + 1.0, 0.2);
  some.problem.stances[1].region_F = {{-0.01, -0.01}, {0.01, -0.01}, {0.01, 0.01}, {-0.01, 0.01}};
  broken = some.motion;
  broken.X_WF[1] = some.problem.stances[1].X_WF;
  broken.X_WF[1].translation().x() += 0.05;
  EXPECT_NEAR(FaultsOf(some.problem, broken, 1e-3).foothold_m, 0.04, 1e-12);
}

}  // namespace
}  // namespace gaitwright
