// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_terms.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "optimisation/centroidal/rigid_body_cost.h"
#include "optimisation/centroidal/rigid_body_motion.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"
#include "tests/optimisation/numerics/derivative_check.h"

namespace gaitwright {
namespace {

/// Unknowns of a size that a motion may have.
VectorX Random(const RigidBodyUnknowns& unknowns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> draw(-0.3, 0.3);
  VectorX x(unknowns.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = draw(random);
  return x;
}

VectorX Own(const std::vector<int>& variables, const VectorX& x) {
  VectorX own(static_cast<Eigen::Index>(variables.size()));
  for (std::size_t i = 0; i < variables.size(); ++i) own[static_cast<Eigen::Index>(i)] = x[variables[i]];
  return own;
}

VectorX ValueOf(const Constraint& rows, const VectorX& x) {
  VectorX value;
  rows.function(Own(rows.variables, x), value, nullptr);
  return value;
}

/// Whether the rows are within their ends.
bool Met(const Constraint& rows, const VectorX& x) {
  const VectorX value = ValueOf(rows, x);
  return (value.array() <= rows.upper.array()).all() && (value.array() >= rows.lower.array()).all();
}

TEST(TurningRate, HasItsDerivatives) {
  Matrix3 inertia;
  inertia << 1.0, 0.1, -0.2, 0.1, 2.0, 0.05, -0.2, 0.05, 2.5;
  const VectorFunction rate = [&](const VectorX& x, VectorX& value, MatrixX* J) {
    const TurningRate turning = TurningRateOf(inertia.inverse(), x.head<3>(), x.tail<3>());
    value = turning.rate;
    if (J != nullptr) *J << turning.by_angles, turning.by_momentum;
  };
  VectorX x(6);
  x << 0.3, -0.4, 1.1, 0.5, -0.7, 0.9;
  ExpectDerivative(rate, x);
}

TEST(TurningRate, IsWhatTheInertiaMakesOfTheMomentum) {
  const Matrix3 inertia = Vector3(1.0, 2.0, 2.5).asDiagonal();
  const Vector3 angles(0.3, -0.4, 1.1), momentum(0.5, -0.7, 0.9);
  const Vector3 rates = AngleRates(inertia.inverse(), angles, momentum);
  const Vector3 w_B = BodyRatesByAngleRates(angles) * rates;
  EXPECT_LT((rates - TurningRateOf(inertia.inverse(), angles, momentum).rate).norm(), 1e-12);
  EXPECT_LT((RotationOf(angles) * inertia * w_B - momentum).norm(), 1e-12);
}

TEST(RigidBodyTerms, HaveTheirDerivatives) {
  for (const RigidBodyProblem& problem :
       {rigid_bodies::Hopper(), rigid_bodies::Trotter(), rigid_bodies::SoledWalker()}) {
    const RigidBodyUnknowns unknowns(problem, 0.08, 3);
    const RigidBodyTerms terms(problem, unknowns);
    const VectorX x = Random(unknowns, 5);
    for (std::size_t i = 0; i < unknowns.intervals(); ++i) {
      const Constraint turning = terms.Turning(i);
      SCOPED_TRACE(turning.name);
      ExpectDerivative(turning.function, Own(turning.variables, x));
    }
    for (const double t : {0.16, 0.21, 0.52}) {
      for (std::size_t s = 1; s < problem.stances.size(); ++s) {
        const Constraint reach = terms.Reach(s, t, 0.0);
        SCOPED_TRACE(reach.name);
        ExpectDerivative(reach.function, Own(reach.variables, x));
      }
    }
    const Constraint friction = terms.Friction(unknowns.BoundForces()[7], 8, 0.0);
    ExpectDerivative(friction.function, Own(friction.variables, x));
  }
}

TEST(RigidBodyTerms, TurningIsZeroForAMotionThatFollowsFromItsForces) {
  const RigidBodyProblem problem = rigid_bodies::Stander();
  // Of order four: over intervals of half the length the angles are off by a 32nd.
  double last = 0.0;
  for (const double spacing : {0.08, 0.04}) {
    const RigidBodyUnknowns unknowns(problem, spacing, 2);
    VectorX x = rigid_bodies::Wavering(problem, unknowns);
    const RigidBodyMotion motion = MotionOf(problem, unknowns, x);
    for (std::size_t k = 1; k + 1 < unknowns.breaks_s().size(); ++k) {
      x.segment<3>(unknowns.Angles(k).parts[0].start) = motion.intervals[k].angles_rad;
      x.segment<3>(unknowns.Momentum(k).parts[0].start) = motion.intervals[k].momentum_W / unknowns.mean_inertia();
    }
    double momentum = 0.0, angles = 0.0;
    for (std::size_t i = 0; i + 1 < unknowns.intervals(); ++i) {
      const VectorX off = ValueOf(RigidBodyTerms(problem, unknowns).Turning(i), x);
      momentum = std::max(momentum, off.head<3>().norm());
      angles = std::max(angles, off.tail<3>().norm());
    }
    EXPECT_LT(momentum, 1e-12);
    EXPECT_GT(angles, 1e-12);
    EXPECT_TRUE(last == 0.0 || angles < last / 16.0) << angles << " after " << last;
    last = angles;
  }
}

TEST(RigidBodyTerms, APyramidHoldsNothingBeyondTheConeAndAllOfItsEdges) {
  const RigidBodyProblem problem = rigid_bodies::Hopper();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  for (const int sides : {4, 8, 16}) {
    const Constraint rows = RigidBodyTerms(problem, unknowns).Friction({0, 0, 1, AffineVector::Unknown(0)}, sides, 0.0);
    int inside = 0;
    constexpr int kDirections = 720;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * M_PI * i / kDirections;
      const auto force = [&](double share) -> VectorX {
        return Vector3(share * 0.6 * std::cos(angle), share * 0.6 * std::sin(angle), 1.0);
      };
      EXPECT_FALSE(Met(rows, force(1.0 + 1e-9)));
      EXPECT_TRUE(Met(rows, force(std::cos(M_PI / sides) - 1e-9)));
      if (Met(rows, force(1.0 - 1e-9))) ++inside;
    }
    EXPECT_EQ(inside, sides);
    EXPECT_TRUE(Met(rows, Vector3(0.6 - 1e-9, 0.0, 1.0)));
    EXPECT_FALSE(Met(rows, Vector3(0.0, 0.0, -1e-6)));
    EXPECT_TRUE(Met(rows, Vector3(0.0, 0.0, 50.0)));
    EXPECT_FALSE(Met(rows, Vector3(0.0, 0.0, 52.0)));  // of 10000 N over 20 kg
  }
}

TEST(RigidBodyTerms, FrictionIsInTheFootholdsFrame) {
  RigidBodyProblem problem = rigid_bodies::Hopper();
  problem.stances[0].X_WF.linear() = Eigen::AngleAxisd(0.5, Vector3::UnitY()).toRotationMatrix();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const Constraint rows = RigidBodyTerms(problem, unknowns).Friction({0, 0, 1, AffineVector::Unknown(0)}, 8, 0.0);
  EXPECT_TRUE(Met(rows, problem.stances[0].X_WF.linear() * Vector3(0.59, 0.0, 1.0)));
  EXPECT_FALSE(Met(rows, problem.stances[0].X_WF.linear() * Vector3(0.61, 0.0, 1.0)));
}

TEST(RigidBodyTerms, AFootholdsRegionIsItsPolygon) {
  RigidBodyProblem problem = rigid_bodies::Hopper();
  problem.stances[1].region_F = {{-0.1, -0.2}, {0.3, -0.2}, {0.0, 0.4}};
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const Constraint rows = RigidBodyTerms(problem, unknowns).Region(1);
  VectorX x = VectorX::Zero(unknowns.size());
  const auto at = [&](double u, double v) {
    x.segment<2>(unknowns.Foothold(1).parts[0].start) = Vector2(u, v);
    return Met(rows, x);
  };
  EXPECT_TRUE(at(0.0, 0.0));
  EXPECT_TRUE(at(0.0, 0.39));
  EXPECT_FALSE(at(-0.1, 0.39));
  EXPECT_FALSE(at(0.0, -0.21));
  EXPECT_FALSE(at(0.2, 0.1));
}

TEST(RigidBodyCost, IsZeroForStandingWithSteadyForcesAndGrowsWithWhatItWeighs) {
  RigidBodyProblem problem = rigid_bodies::Walker(0.0);
  problem.stances = {problem.stances[0], problem.stances[3]};
  problem.stances[0].end_s = problem.stances[1].end_s = problem.duration_s;
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  VectorX x = VectorX::Zero(unknowns.size());
  for (std::size_t i = 2; i < unknowns.breaks_s().size(); ++i)
    x.segment<3>(unknowns.ControlPoint(i)) = problem.start.p_WC;
  for (const BoundForce& force : unknowns.BoundForces()) {
    if (force.force.parts.size() == 1) x[force.force.parts[0].start + 2] = 0.5;
  }
  const auto cost = [&](const RigidBodyWeights& weights, const VectorX& at) {
    double sum = 0.0;
    for (const Residual& residual : RigidBodyCost(problem, unknowns, weights)) {
      VectorX value;
      residual.function(Own(residual.variables, at), value, nullptr);
      sum += value.squaredNorm();
    }
    return sum;
  };
  EXPECT_NEAR(cost({}, x), 0.0, 1e-12);
  VectorX tilted = x;
  for (std::size_t k = 1; k + 1 < unknowns.breaks_s().size(); ++k) tilted[unknowns.Angles(k).parts[0].start + 1] = 0.2;
  // The integral of 0.04 over 1.9 s, but for the ends, which are level.
  const double ends = unknowns.breaks_s()[1];
  EXPECT_NEAR(cost({.tilt = 2.0}, tilted), 2.0 * 0.04 * (1.9 - ends), 1e-9);
}

}  // namespace
}  // namespace gaitwright
