// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/dynamics_derivatives.h"

#include "tests/kinematics/allocations.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

class DerivativesOfDynamics : public testing::TestWithParam<const char*> {
 protected:
  VectorX Tau(const VectorX& q, const VectorX& v, const VectorX& a) {
    VectorX tau;
    InverseDynamics(model_, q, v, a, scratch_, tau);
    return tau;
  }

  /// Largest difference as a share of the largest entry.
  static double Off(const MatrixX& is, const MatrixX& wanted) {
    return (is - wanted).cwiseAbs().maxCoeff() / wanted.cwiseAbs().maxCoeff();
  }

  RobotModel model_ = AnyRobot(GetParam());
  DynamicsScratch scratch_{model_};
  DynamicsDerivatives derivatives_{model_};
  InverseDynamicsDerivatives d_;
  RandomState random_{11};
};

TEST_P(DerivativesOfDynamics, TorquesAndMassMatrixAreThoseOfTheOtherFunctions) {
  for (int trial = 0; trial < 5; ++trial) {
    const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
    derivatives_.Compute(q, v, a, d_);
    MatrixX M;
    MassMatrix(model_, q, scratch_, M);
    EXPECT_LT(Off(d_.M, M), 1e-12);
    EXPECT_LT(Off(d_.tau, Tau(q, v, a)), 1e-12);
  }
}

TEST_P(DerivativesOfDynamics, AreThoseOfFiniteDifferences) {
  constexpr double kStep = 1e-6;
  for (int trial = 0; trial < 3; ++trial) {
    const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
    derivatives_.Compute(q, v, a, d_);
    MatrixX by_q(model_.nv(), model_.nv()), by_v = by_q;
    for (Eigen::Index k = 0; k < model_.nv(); ++k) {
      const VectorX along = VectorX::Unit(model_.nv(), k);
      by_q.col(k) = (Tau(Moved(q, along, kStep), v, a) - Tau(Moved(q, along, -kStep), v, a)) / (2.0 * kStep);
      by_v.col(k) = (Tau(q, v + kStep * along, a) - Tau(q, v - kStep * along, a)) / (2.0 * kStep);
    }
    EXPECT_LT(Off(d_.by_q, by_q), 1e-7);
    EXPECT_LT(Off(d_.by_v, by_v), 1e-7);
  }
}

TEST_P(DerivativesOfDynamics, PlaceAndSpeedOfTheBasesOriginAreWithoutEffect) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
  derivatives_.Compute(q, v, a, d_);
  EXPECT_EQ(d_.by_q.leftCols<3>().norm(), 0.0);
  EXPECT_EQ(d_.by_v.leftCols<3>().norm(), 0.0);
  const InverseDynamicsDerivatives here = d_;
  VectorX far = q, fast = v;
  far.head<3>() += Vector3(1.0, -2.0, 3.0);
  fast.head<3>() += Vector3(-4.0, 5.0, 6.0);
  derivatives_.Compute(far, fast, a, d_);
  EXPECT_LT(Off(d_.by_q, here.by_q), 1e-12);
  EXPECT_LT(Off(d_.by_v, here.by_v), 1e-12);
}

TEST_P(DerivativesOfDynamics, VelocityForcesAreOfSecondOrderInVelocity) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), none = VectorX::Zero(model_.nv());
  const VectorX still = Tau(q, none, none), moving = Tau(q, v, none);
  derivatives_.Compute(q, v, none, d_);
  // Euler's theorem for a function of degree two: its derivative along v is twice the function.
  EXPECT_LT((d_.by_v * v - 2.0 * (moving - still)).norm(), 1e-10 * moving.norm());
}

TEST_P(DerivativesOfDynamics, OfPointsAreThoseOfFiniteDifferences) {
  constexpr double kStep = 1e-6;
  const int body = static_cast<int>(model_.bodies.size()) - 1;
  const Vector3 p_BQ(0.1, -0.2, 0.3);
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
  // [velocity; acceleration] of the point.
  const auto motion = [&](const VectorX& at_q, const VectorX& at_v) {
    MatrixX J(6, model_.nv());
    ForwardVelocities(model_, at_q, at_v, scratch_);
    PointJacobian(model_, scratch_, body, p_BQ, J);
    VectorX both(12);
    both << PointVelocity(scratch_, body, p_BQ), J * a + PointBiasAcceleration(scratch_, body, p_BQ);
    return both;
  };
  derivatives_.Compute(q, v, a, d_);
  PointDerivatives point;
  derivatives_.DifferentiatePoint(body, p_BQ, point);
  MatrixX by_q(12, model_.nv()), by_v = by_q;
  for (Eigen::Index k = 0; k < model_.nv(); ++k) {
    const VectorX along = VectorX::Unit(model_.nv(), k);
    by_q.col(k) = (motion(Moved(q, along, kStep), v) - motion(Moved(q, along, -kStep), v)) / (2.0 * kStep);
    by_v.col(k) = (motion(q, v + kStep * along) - motion(q, v - kStep * along)) / (2.0 * kStep);
  }
  EXPECT_LT(Off(point.velocity_by_q, by_q.topRows(6)), 1e-7);
  EXPECT_LT(Off(point.acceleration_by_q, by_q.bottomRows(6)), 1e-7);
  EXPECT_LT(Off(point.acceleration_by_v, by_v.bottomRows(6)), 1e-7);
}

TEST_P(DerivativesOfDynamics, OfMomentumAreThoseOfFiniteDifferences) {
  constexpr double kStep = 1e-6;
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv());
  const auto momentum = [&](const VectorX& at_q, const VectorX& at_v) {
    ForwardVelocities(model_, at_q, at_v, scratch_);
    return CentroidalMomentum(model_, scratch_);
  };
  derivatives_.Compute(q, v, VectorX::Zero(model_.nv()), d_);
  MomentumDerivatives of;
  derivatives_.DifferentiateMomentum(of);
  EXPECT_LT((of.momentum - momentum(q, v)).norm(), 1e-12 * of.momentum.norm());
  EXPECT_LT((of.by_v * v - of.momentum).norm(), 1e-12 * of.momentum.norm()) << "it is linear in velocities";
  MatrixX by_q(6, model_.nv()), by_v = by_q;
  for (Eigen::Index k = 0; k < model_.nv(); ++k) {
    const VectorX along = VectorX::Unit(model_.nv(), k);
    by_q.col(k) = (momentum(Moved(q, along, kStep), v) - momentum(Moved(q, along, -kStep), v)) / (2.0 * kStep);
    by_v.col(k) = (momentum(q, v + kStep * along) - momentum(q, v - kStep * along)) / (2.0 * kStep);
  }
  EXPECT_LT(Off(of.by_q, by_q), 1e-7);
  EXPECT_LT(Off(of.by_v, by_v), 1e-7);
}

TEST_P(DerivativesOfDynamics, TheyAllocateNothingAfterTheFirstCall) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
  derivatives_.Compute(q, v, a, d_);
  PointDerivatives point;
  MomentumDerivatives momentum;
  derivatives_.DifferentiatePoint(1, Vector3::Ones(), point);
  derivatives_.DifferentiateMomentum(momentum);
  const long before = Allocations();
  derivatives_.Compute(q, v, a, d_);
  derivatives_.DifferentiatePoint(1, Vector3::Ones(), point);
  derivatives_.DifferentiateMomentum(momentum);
  EXPECT_EQ(Allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(Robots, DerivativesOfDynamics, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
