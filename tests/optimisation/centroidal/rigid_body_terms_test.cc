// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_terms.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <set>
#include <utility>

#include "optimisation/centroidal/rigid_body_cost.h"
#include "optimisation/centroidal/rigid_body_motion.h"
#include "tests/optimisation/centroidal/own_variables.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"
#include "tests/optimisation/numerics/derivative_check.h"

namespace gaitwright {
namespace {

/// Whether the rows are within their bounds.
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
    for (const double t : {unknowns.nodes_s()[2], 0.21, 0.52}) {
      const Constraint clearance = terms.Clearance({t, {0.2, -0.1, 0.05}, Vector3(-0.6, 0.0, 0.8), 0.1});
      SCOPED_TRACE(clearance.name);
      ExpectDerivative(clearance.function, Own(clearance.variables, x));
    }
    const Constraint friction = terms.Friction(unknowns.BoundForces()[7], 8, 0.0);
    ExpectDerivative(friction.function, Own(friction.variables, x));
  }
}

TEST(RigidBodyTerms, ClearanceIsHowFarAPointOfTheBodyIsAlongThePlanesNormal) {
  const RigidBodyProblem problem = rigid_bodies::Trotter();
  const RigidBodyUnknowns unknowns(problem, 0.08, 3);
  const VectorX x = Random(unknowns, 7);
  const double t = unknowns.nodes_s()[3];
  const RigidClearance clearance{t, {0.2, -0.1, 0.05}, Vector3(-0.6, 0.0, 0.8), 0.1, "nose"};
  const Vector3 p_WQ = unknowns.CentreOfMass(t).At(x) + RotationOf(unknowns.Angles(3).At(x)) * clearance.p_CQ_B;
  const Constraint rows = RigidBodyTerms(problem, unknowns).Clearance(clearance);
  ASSERT_EQ(rows.lower.size(), 1);
  EXPECT_NEAR(ValueOf(rows, x)[0], clearance.normal_W.dot(p_WQ), 1e-12);
  EXPECT_DOUBLE_EQ(rows.lower[0], 0.1);
  EXPECT_NE(rows.name.find("nose"), std::string::npos);
}

TEST(RigidBodyTerms, OfABodyThatMovesInsideAndRollsHaveTheirDerivatives) {
  for (RigidBodyProblem problem : {rigid_bodies::Hopper(), rigid_bodies::Trotter(), rigid_bodies::SoledWalker()}) {
    rigid_bodies::AddLegMotion(problem, 30);
    rigid_bodies::AddRolling(problem);
    const RigidBodyUnknowns unknowns(problem, 0.08, 3);
    const RigidBodyTerms terms(problem, unknowns);
    const VectorX x = Random(unknowns, 6);
    for (std::size_t i = 0; i < unknowns.intervals(); ++i) {
      const Constraint turning = terms.Turning(i);
      SCOPED_TRACE(turning.name);
      ExpectDerivative(turning.function, Own(turning.variables, x));
    }
  }
}

/// Largest momentum and angle rows of Turning, over a motion that follows from varying forces on a stander.
std::pair<double, double> TurningOff(const RigidBodyProblem& problem, double spacing_s) {
  const RigidBodyUnknowns unknowns(problem, spacing_s, 2);
  VectorX x = rigid_bodies::Wavering(problem, unknowns);
  const RigidBodyMotion motion = MotionOf(problem, unknowns, x);
  for (std::size_t k = 1; k + 1 < unknowns.nodes_s().size(); ++k) {
    x.segment<3>(unknowns.Angles(k).parts[0].start) = motion.intervals[k].angles_rad;
    x.segment<3>(unknowns.Momentum(k).parts[0].start) = motion.intervals[k].momentum_W / unknowns.mean_inertia();
  }
  double momentum = 0.0, angles = 0.0;
  for (std::size_t i = 0; i + 1 < unknowns.intervals(); ++i) {
    const VectorX off = ValueOf(RigidBodyTerms(problem, unknowns).Turning(i), x);
    momentum = std::max(momentum, off.head<3>().norm());
    angles = std::max(angles, off.tail<3>().norm());
  }
  return {momentum, angles};
}

TEST(RigidBodyTerms, TurningIsZeroForAMotionThatFollowsFromItsForces) {
  RigidBodyProblem moving = rigid_bodies::Stander(), rolling = rigid_bodies::Stander();
  rigid_bodies::AddLegMotion(moving, 81);
  rigid_bodies::AddRolling(rolling);
  for (const RigidBodyProblem& problem : {rigid_bodies::Stander(), moving, rolling}) {
    // Of order four: for half the interval length, the error of the angles is 1/32.
    const auto [momentum, angles] = TurningOff(problem, 0.08);
    const auto [momentum_finer, angles_finer] = TurningOff(problem, 0.04);
    EXPECT_LT(std::max(momentum, momentum_finer), 1e-12);
    EXPECT_GT(angles_finer, 1e-12);
    EXPECT_LT(angles_finer, angles / 16.0);
  }
}

/// The rows of a problem at the unknowns of a motion of another problem.
TEST(RigidBodyTerms, TurningSeesWhatMovesInsideAndWhereContactsWent) {
  const RigidBodyProblem still = rigid_bodies::Stander();
  RigidBodyProblem moving = still, rolling = still;
  rigid_bodies::AddLegMotion(moving, 41);
  rigid_bodies::AddRolling(rolling);
  const RigidBodyUnknowns unknowns(still, 0.08, 2);
  const VectorX x = rigid_bodies::Wavering(still, unknowns);
  const LegMomentum inner(moving);
  const double mean = unknowns.mean_inertia(), from = unknowns.nodes_s()[1], to = unknowns.nodes_s()[2];
  const VectorX alone = ValueOf(RigidBodyTerms(still, unknowns).Turning(1), x);
  const VectorX within = ValueOf(RigidBodyTerms(moving, unknowns).Turning(1), x);
  EXPECT_GT((within - alone).head<3>().norm(), 1e-3);
  EXPECT_LT(((within - alone).head<3>() - (inner.At(to) - inner.At(from)) / mean).norm(), 1e-12);
  const VectorX rolled = ValueOf(RigidBodyTerms(rolling, unknowns).Turning(1), x);
  EXPECT_GT((rolled - alone).head<3>().norm(), 1e-4);
}

/// Separate forces: unknown 3 i belongs to point i.
std::vector<BoundForce> ForcesOn(std::size_t points, std::size_t at_node) {
  std::vector<BoundForce> forces;
  for (std::size_t i = 0; i < points; ++i)
    forces.push_back({0, i, at_node, AffineVector::Unknown(static_cast<int>(3 * i))});
  return forces;
}

TEST(RigidBodyTerms, MotorsHoldWhatIsWithinTheirLimitsAtTheNearestOfTheirTimes) {
  RigidBodyProblem problem = rigid_bodies::Hopper();
  constexpr double kMost = 300.0;
  rigid_bodies::AddMotors(problem, kMost);
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const double weight = problem.mass_kg * kGravity;
  for (std::size_t k = 0; unknowns.nodes_s()[k] < problem.stances[0].end_s; ++k) {
    const double at = unknowns.nodes_s()[k] / problem.stances[0].end_s;
    const double share = at < 0.25 ? 1.0 : at < 0.75 ? 0.8 : 0.6;
    const Constraint rows = RigidBodyTerms(problem, unknowns).Motors(ForcesOn(1, k));
    EXPECT_TRUE(Met(rows, Vector3(0.0, 0.0, (share * kMost - 0.01) / weight))) << at;
    EXPECT_FALSE(Met(rows, Vector3(0.0, 0.0, (share * kMost + 0.01) / weight))) << at;
    EXPECT_TRUE(Met(rows, Vector3(0.0, 0.0, (-0.5 * share * kMost + 0.01) / weight))) << at;
    EXPECT_FALSE(Met(rows, Vector3(0.0, 0.0, (-0.5 * share * kMost - 0.01) / weight))) << at;
    EXPECT_TRUE(Met(rows, Vector3((share * kMost - 0.01) / weight, 0.0, 0.0))) << at;
    EXPECT_FALSE(Met(rows, Vector3((share * kMost + 0.01) / weight, 0.0, 0.0))) << at;
  }
}

TEST(RigidBodyTerms, MotorsSeeAllPointsOfASole) {
  RigidBodyProblem problem = rigid_bodies::SoledWalker();
  // One motor that rotates the sole about its heel: forces on the toes act with their lever arm.
  RigidStance& stance = problem.stances[0];
  MotorLimits limits{MatrixX::Zero(1, 12), VectorX::Constant(1, -5.0), VectorX::Constant(1, 5.0)};
  for (Eigen::Index i = 0; i < 4; ++i) {
    const Vector3& corner = problem.feet[0].contacts_F[static_cast<std::size_t>(i)];
    limits.by_force(0, 3 * i + 2) = corner.x() + 0.06;
  }
  stance.motors = {limits};
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const Constraint rows = RigidBodyTerms(problem, unknowns).Motors(ForcesOn(4, 1));
  ASSERT_EQ(rows.variables.size(), 12U);
  const double toe = 5.0 / (0.16 * problem.mass_kg * kGravity);  // [m g] on one of them
  VectorX f = VectorX::Zero(12);
  f[8] = f[11] = 10.0;  // on the heel
  f[2] = 0.999 * toe;
  EXPECT_TRUE(Met(rows, f));
  f[5] = 0.002 * toe;
  EXPECT_FALSE(Met(rows, f)) << "together with the other toe";
  f[2] = -1.001 * toe - f[5];
  EXPECT_FALSE(Met(rows, f));
}

TEST(RigidBodyTerms, MotorsHaveTheirDerivativesAndForcesOfANodeComeInTheOrderOfTheirPoints) {
  for (RigidBodyProblem problem : {rigid_bodies::Trotter(), rigid_bodies::SoledWalker()}) {
    rigid_bodies::AddMotors(problem, 60.0);
    const RigidBodyUnknowns unknowns(problem, 0.1, 3);
    const std::vector<BoundForce>& forces = unknowns.BoundForces();
    const VectorX x = Random(unknowns, 9);
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (std::size_t i = 0; i < forces.size();) {
      const std::size_t points =
          problem.feet[static_cast<std::size_t>(problem.stances[forces[i].stance].foot)].contacts_F.size();
      ASSERT_LE(i + points, forces.size());
      EXPECT_TRUE(seen.insert({forces[i].stance, forces[i].at_node}).second) << "they stand together";
      for (std::size_t p = 0; p < points; ++p) {
        EXPECT_EQ(forces[i + p].point, p);
        EXPECT_EQ(forces[i + p].stance, forces[i].stance);
        EXPECT_EQ(forces[i + p].at_node, forces[i].at_node);
      }
      const auto first = forces.begin() + static_cast<std::ptrdiff_t>(i);
      const Constraint motors =
          RigidBodyTerms(problem, unknowns).Motors({first, first + static_cast<std::ptrdiff_t>(points)});
      SCOPED_TRACE(motors.name);
      if (!motors.variables.empty()) ExpectDerivative(motors.function, Own(motors.variables, x));
      i += points;
    }
    EXPECT_GT(seen.size(), 10U);
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
    EXPECT_FALSE(Met(rows, Vector3(0.0, 0.0, 52.0)));  // 10000 N over 20 kg
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
  for (std::size_t i = 2; i < unknowns.nodes_s().size(); ++i)
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
  for (std::size_t k = 1; k + 1 < unknowns.nodes_s().size(); ++k) tilted[unknowns.Angles(k).parts[0].start + 1] = 0.2;
  // The integral of 0.04 over 1.9 s, less the ends, which are level.
  const double ends = unknowns.nodes_s()[1];
  EXPECT_NEAR(cost({.tilt = 2.0}, tilted), 2.0 * 0.04 * (1.9 - ends), 1e-9);

  const auto moved = [&](const Vector3& by) {
    VectorX at = x;
    for (std::size_t i = 0; i < unknowns.nodes_s().size(); ++i) {
      if (unknowns.ControlPoint(i) >= 0) at.segment<3>(unknowns.ControlPoint(i)) += by;
    }
    return at;
  };
  const auto path_alone = [&](double weight, const VectorX& at) {
    return cost({.path = weight}, at) - cost({.path = 0.0}, at);
  };
  EXPECT_EQ(path_alone(1.0, moved({0.0, 0.1, 0.0})), 0.0) << "no way to follow";
  problem.path = {{0.0, 1.9}, {problem.start.p_WC, problem.start.p_WC}, {Vector3::Zero(), Vector3::Zero()}};
  EXPECT_EQ(path_alone(1.0, moved({0.1, 0.0, 0.1})), 0.0) << "sooner or higher is as well";
  const double lateral = path_alone(1.0, moved({0.0, 0.1, 0.0}));
  EXPECT_GT(lateral, 0.01 * 1.5);
  EXPECT_LT(lateral, 0.01 * 1.9);
  EXPECT_NEAR(path_alone(3.0, moved({0.0, -0.2, 0.0})), 12.0 * lateral, 1e-9);
}

}  // namespace
}  // namespace gaitwright
