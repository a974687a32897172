// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/dynamics.h"

#include <Eigen/Eigenvalues>

#include "kinematics/dynamics/foot_contact.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

class Dynamics : public testing::TestWithParam<const char*> {
 protected:
  RobotModel model_ = AnyRobot(GetParam());
  DynamicsScratch scratch_{model_}, other_{model_};
  RandomState random_{7};
};

constexpr double kStep = 1e-6;

TEST_P(Dynamics, JacobiansAreDerivatives) {
  MatrixX J(6, model_.nv()), J_C(3, model_.nv());
  for (int trial = 0; trial < 20; ++trial) {
    const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv());
    const int body = static_cast<int>(model_.bodies.size()) - 1;
    const Vector3 p_BQ = random_.Vector(3);
    ForwardVelocities(model_, q, v, scratch_);
    PointJacobian(model_, scratch_, body, p_BQ, J);
    CentreOfMassJacobian(model_, scratch_, J_C);
    EXPECT_LT((J * v - PointVelocity(scratch_, body, p_BQ)).norm(), 1e-12);
    const auto at = [&](double time_s) {
      ForwardKinematics(model_, Moved(q, v, time_s), other_);
      Pose X_BQ = Pose::Identity();
      X_BQ.translation() = p_BQ;
      Vector6 both;
      both << FramePose(other_, body, X_BQ).translation(), CentreOfMass(model_, other_);
      return both;
    };
    const Vector6 difference = (at(kStep) - at(-kStep)) / (2.0 * kStep);
    ASSERT_GT((J * v).norm(), 0.1);
    EXPECT_LT(((J * v).head<3>() - difference.head<3>()).norm(), 1e-7);
    EXPECT_LT((J_C * v - difference.tail<3>()).norm(), 1e-7);
  }
}

TEST_P(Dynamics, BiasAccelerationsAreDerivativesOfVelocities) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv());
  const int body = static_cast<int>(model_.bodies.size()) - 1;
  const Vector3 p_BQ(0.1, 0.2, 0.3);
  ForwardVelocities(model_, q, v, scratch_);
  const auto velocity = [&](double time_s) {
    ForwardVelocities(model_, Moved(q, v, time_s), v, other_);
    return PointVelocity(other_, body, p_BQ);
  };
  const Vector6 difference = (velocity(kStep) - velocity(-kStep)) / (2.0 * kStep);
  ASSERT_GT(difference.norm(), 0.1);
  EXPECT_LT((difference - PointBiasAcceleration(scratch_, body, p_BQ)).norm(), 1e-6);
}

TEST_P(Dynamics, JacobiansAreMadeOfTheScrewsOfTheJoints) {
  ForwardKinematics(model_, random_.Configuration(model_), scratch_);
  MatrixX S(6, static_cast<Eigen::Index>(model_.joints.size())), J(6, model_.nv());
  JointScrews(model_, scratch_, S);
  for (int body = 1; body < static_cast<int>(model_.bodies.size()); ++body) {
    const Vector3 p_BQ = random_.Vector(3);
    const Vector3 p_WQ =
        scratch_.p_WB[static_cast<std::size_t>(body)] + scratch_.R_WB[static_cast<std::size_t>(body)] * p_BQ;
    MatrixX made = MatrixX::Zero(6, model_.num_dofs());
    for (int i = body; i > 0; i = model_.joints[static_cast<std::size_t>(i - 1)].parent_body) {
      const Vector3 v = S.col(i - 1).head<3>(), w = S.col(i - 1).tail<3>();
      const int dof = model_.joints[static_cast<std::size_t>(i - 1)].dof;
      made.col(dof).head<3>() += v + w.cross(p_WQ);
      made.col(dof).tail<3>() += w;
    }
    PointJacobian(model_, scratch_, body, p_BQ, J);
    EXPECT_LT((J.rightCols(model_.num_dofs()) - made).cwiseAbs().maxCoeff(), 1e-12) << body;
  }
}

TEST_P(Dynamics, CentreOfMassJacobianAndBiasAreDerivatives) {
  MatrixX J(3, model_.nv());
  for (int trial = 0; trial < 10; ++trial) {
    const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv());
    const auto position = [&](Eigen::Index along, double step) {
      ForwardKinematics(model_, Moved(q, step * VectorX::Unit(model_.nv(), along), 1.0), other_);
      return CentreOfMass(model_, other_);
    };
    const auto velocity = [&](double time_s) -> Vector3 {
      ForwardVelocities(model_, Moved(q, v, time_s), v, other_);
      CentreOfMassJacobian(model_, other_, J);
      return J * v;
    };
    const Vector3 acceleration = (velocity(kStep) - velocity(-kStep)) / (2.0 * kStep);
    ForwardVelocities(model_, q, v, scratch_);
    ASSERT_GT(acceleration.norm(), 0.01);
    EXPECT_LT((acceleration - CentreOfMassBiasAcceleration(model_, scratch_)).norm(), 1e-6);
    CentreOfMassJacobian(model_, scratch_, J);
    for (Eigen::Index i = 0; i < model_.nv(); ++i) {
      const Vector3 difference = (position(i, kStep) - position(i, -kStep)) / (2.0 * kStep);
      EXPECT_LT((difference - J.col(i)).norm(), 1e-8) << "column " << i;
    }
  }
}

/// An independent angular momentum about C: every body is replaced by points of mass m / 6 on the axes of its inertia
/// ellipsoid with the same mass, centre and inertia. Their velocities are finite differences.
TEST_P(Dynamics, CentroidalMomentumIsThatOfPointsOfMass) {
  for (int trial = 0; trial < 10; ++trial) {
    const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv());
    const auto points = [&](double time_s) {
      ForwardKinematics(model_, Moved(q, v, time_s), other_);
      std::vector<Vector3> at;
      for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
        const Body& body = model_.bodies[b];
        const Eigen::SelfAdjointEigenSolver<Matrix3> principal(body.I_C);
        for (int axis = 0; axis < 3; ++axis) {
          // A principal moment is the sum of the second moments along the two other axes. So the second moment along
          // this axis is half of the trace minus the moment.
          const double square = std::max(0.0, 0.5 * body.I_C.trace() - principal.eigenvalues()[axis]);
          const double reach = body.mass > 0.0 ? std::sqrt(3.0 * square / body.mass) : 0.0;
          for (const double side : {-1.0, 1.0}) {
            const Vector3 p_B = body.p_BC + side * reach * principal.eigenvectors().col(axis);
            at.push_back(other_.p_WB[b] + other_.R_WB[b] * p_B);
          }
        }
      }
      return at;
    };
    const std::vector<Vector3> before = points(-kStep), after = points(kStep), now = points(0.0);
    const Vector3 p_WC = CentreOfMass(model_, other_);
    Vector6 momentum = Vector6::Zero();
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Vector3 linear = model_.bodies[i / 6].mass / 6.0 * (after[i] - before[i]) / (2.0 * kStep);
      momentum.head<3>() += linear;
      momentum.tail<3>() += (now[i] - p_WC).cross(linear);
    }
    ForwardVelocities(model_, q, v, scratch_);
    ASSERT_GT(momentum.tail<3>().norm(), 1e-3);
    EXPECT_LT((momentum - CentroidalMomentum(model_, scratch_)).norm(), 1e-7 * (1.0 + momentum.norm()));
  }
}

TEST_P(Dynamics, CentroidalMomentumIsTheMassMatrixsRowsTakenToC) {
  MatrixX M;
  for (int trial = 0; trial < 20; ++trial) {
    const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv());
    MassMatrix(model_, q, scratch_, M);
    ForwardVelocities(model_, q, v, scratch_);
    const Vector6 about_O = (M * v).head<6>();
    const Vector3 p_OC = CentreOfMass(model_, scratch_) - scratch_.p_WB[0];
    Vector6 about_C = about_O;
    about_C.tail<3>() -= p_OC.cross(about_O.head<3>());
    ASSERT_GT(about_C.tail<3>().norm(), 1e-3);
    EXPECT_LT((about_C - CentroidalMomentum(model_, scratch_)).norm(), 1e-10 * (1.0 + about_O.norm()));
  }
}

TEST_P(Dynamics, JacobianRateIsTheJacobiansDerivative) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv());
  const Vector3 p_BQ(0.03, -0.02, 0.05);
  ForwardVelocities(model_, q, v, scratch_);
  MatrixX rate(6, model_.nv()), before(6, model_.nv()), after(6, model_.nv());
  for (int body = 0; body < static_cast<int>(model_.bodies.size()); ++body) {
    PointJacobianRate(model_, scratch_, body, p_BQ, rate);
    ForwardKinematics(model_, Moved(q, v, -kStep), other_);
    PointJacobian(model_, other_, body, p_BQ, before);
    ForwardKinematics(model_, Moved(q, v, kStep), other_);
    PointJacobian(model_, other_, body, p_BQ, after);
    EXPECT_LT(((after - before) / (2.0 * kStep) - rate).norm(), 1e-7 * (1.0 + rate.norm()));
    EXPECT_LT((rate * v - PointBiasAcceleration(scratch_, body, p_BQ)).norm(), 1e-10 * (1.0 + rate.norm()));
  }
}

TEST_P(Dynamics, MassMatrixAgreesWithInverseDynamics) {
  MatrixX M;
  VectorX tau, bias;
  for (int trial = 0; trial < 20; ++trial) {
    const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
    MassMatrix(model_, q, scratch_, M);
    InverseDynamics(model_, q, v, a, scratch_, tau);
    InverseDynamics(model_, q, v, VectorX::Zero(model_.nv()), scratch_, bias);
    EXPECT_LT((M * a + bias - tau).norm(), 1e-10);
    EXPECT_LT((M - M.transpose()).norm(), 1e-12);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixX>(M).eigenvalues().minCoeff(), 0.0);
    ForwardVelocities(model_, q, v, scratch_);
    EXPECT_LT(((M * v).head<3>() - CentroidalMomentum(model_, scratch_).head<3>()).norm(), 1e-10);
  }
}

/// The mass matrix contains the inertia about the base's origin. About the centre of mass, it is smaller by m |p|^2 1 -
/// m p p^T (Steiner).
TEST_P(Dynamics, LockedInertiaIsTheMassMatrixsShiftedToTheCentreOfMass) {
  MatrixX M;
  for (int trial = 0; trial < 20; ++trial) {
    MassMatrix(model_, random_.Configuration(model_), scratch_, M);
    const Vector3 p_OC = CentreOfMass(model_, scratch_) - scratch_.p_WB[0];
    const Matrix3 shift = model_.total_mass_kg * (p_OC.squaredNorm() * Matrix3::Identity() - p_OC * p_OC.transpose());
    ASSERT_GT(shift.norm(), 1e-4);
    const Matrix3 inertia = LockedInertia(model_, scratch_);
    EXPECT_LT((inertia - (M.block<3, 3>(3, 3) - shift)).norm(), 1e-10 * inertia.norm());
    EXPECT_LT((inertia - inertia.transpose()).norm(), 1e-12);
    const Vector3 main = Eigen::SelfAdjointEigenSolver<Matrix3>(inertia).eigenvalues();
    EXPECT_GT(main[0], 0.0);
    EXPECT_LE(main[2], main[0] + main[1] + 1e-12) << "no body has that";
  }
}

/// The angular momentum of a rigid robot is that of its inertia for any axis of rotation.
TEST_P(Dynamics, LockedInertiaIsWhatTheMomentumOfAStiffRobotIs) {
  const VectorX q = random_.Configuration(model_);
  VectorX v = VectorX::Zero(model_.nv());
  v.head<6>() = random_.Vector(6);
  ForwardVelocities(model_, q, v, scratch_);
  const Vector3 momentum = CentroidalMomentum(model_, scratch_).tail<3>();
  ASSERT_GT(momentum.norm(), 1e-3);
  EXPECT_LT((LockedInertia(model_, scratch_) * v.segment<3>(3) - momentum).norm(), 1e-10 * (1.0 + momentum.norm()));
}

TEST_P(Dynamics, PowerIsTheRateOfEnergy) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
  VectorX tau;
  InverseDynamics(model_, q, v, a, scratch_, tau);
  const auto energy = [&](double time_s) {
    const VectorX mean_v = v + 0.5 * time_s * a, end_v = v + time_s * a;
    ForwardVelocities(model_, Moved(q, mean_v, time_s), end_v, other_);
    return MechanicalEnergy(model_, other_);
  };
  const double rate = (energy(1e-5) - energy(-1e-5)) / 2e-5;
  ASSERT_GT(std::abs(rate), 0.1);
  EXPECT_NEAR(rate, v.dot(tau), 1e-5 * std::abs(rate));
}

TEST_P(Dynamics, PointWrenchIsTheTransposedJacobian) {
  const VectorX q = random_.Configuration(model_);
  ForwardKinematics(model_, q, scratch_);
  const int body = static_cast<int>(model_.bodies.size()) - 1;
  const Vector6 wrench = random_.Vector(6);
  MatrixX J(6, model_.nv());
  PointJacobian(model_, scratch_, body, Vector3::Zero(), J);
  VectorX tau = VectorX::Zero(model_.nv());
  AddPointWrench(model_, scratch_, body, scratch_.p_WB[static_cast<std::size_t>(body)], wrench, tau);
  EXPECT_LT((J.transpose() * wrench - tau).norm(), 1e-12);
}

TEST_P(Dynamics, HeldWeightIsInverseDynamicsAtRest) {
  const VectorX q = random_.Configuration(model_), still = VectorX::Zero(model_.nv());
  VectorX at_rest, held = VectorX::Ones(model_.nv());
  InverseDynamics(model_, q, still, still, scratch_, at_rest);
  ForwardKinematics(model_, q, other_);
  AddHeldWeight(model_, other_, -2.0, held);
  EXPECT_LT((held + 2.0 * at_rest - VectorX::Ones(model_.nv())).norm(), 1e-10 * (1.0 + at_rest.norm()));
}

INSTANTIATE_TEST_SUITE_P(Robots, Dynamics, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
