// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/body_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimisation/centroidal/plan_rigid_body.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// The hopper with another flight, which begins at 0.5 s, and a foot with this largest force.
RigidBodyProblem Hopping(double flight_s, double most_n) {
  RigidBodyProblem problem = rigid_bodies::Hopper();
  problem.stances[1].start_s = 0.5 + flight_s;
  problem.stances[1].end_s = problem.duration_s = 1.0 + flight_s;
  problem.feet[0].force_max_n = most_n;
  return problem;
}

/// Distance of the farthest corner of the hopper's box from the centre of mass.
double HopperReach() { return Vector3(0.25, 0.15, 0.78).norm(); }

TEST(BodyLimits, ProblemsWithMotionsAreNotRefused) {
  for (const RigidBodyProblem& problem :
       {rigid_bodies::Hopper(), rigid_bodies::Walker(), rigid_bodies::Trotter(), Hopping(0.25, 1e3)})
    EXPECT_FALSE(ReasonBeyondLegs(problem).has_value());
}

TEST(BodyLimits, AFlightMayBeAsLongAsTheStrokeAndTheForceAllow) {
  constexpr double kMass = 20.0, kMost = 600.0;
  const double gains = kMost / kMass - kGravity, reach = HopperReach();
  // Pushing for half a second takes longer than the stroke.
  const double gives = std::sqrt(2.0 * gains * reach);
  ASSERT_LT(gives, 0.5 * gains);
  const double longest = (gives + std::sqrt(gives * gives + 2.0 * kGravity * reach)) / kGravity;
  EXPECT_FALSE(ReasonBeyondLegs(Hopping(longest - 1e-3, kMost)).has_value());
  const std::optional<Failure> failure = ReasonBeyondLegs(Hopping(longest + 1e-3, kMost));
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->kind, FailureKind::kInfeasible);
  EXPECT_EQ(failure->code, FailureCode::kFlightTooLong);
  EXPECT_NE(failure->message.find("push with 600 N over 0.83 m and 0.50 s"), std::string::npos) << failure->message;
  EXPECT_NE(failure->suggestions[0].text.find(" s at most"), std::string::npos);
}

TEST(BodyLimits, AShortSupportGivesNoMoreThanItsTime) {
  // 1 N more than the weight, for 0.5 s.
  const double most = 20.0 * kGravity + 1.0, gives = 0.5 / 20.0;
  const double longest = (gives + std::sqrt(gives * gives + 2.0 * kGravity * HopperReach())) / kGravity;
  EXPECT_FALSE(ReasonBeyondLegs(Hopping(longest - 1e-3, most)).has_value());
  EXPECT_TRUE(ReasonBeyondLegs(Hopping(longest + 1e-3, most)).has_value());
  EXPECT_TRUE(ReasonBeyondLegs(Hopping(0.6, 0.5 * 20.0 * kGravity)).has_value()) << "half of the weight";
}

TEST(BodyLimits, ALandingHighUpTakesMoreSpeed) {
  RigidBodyProblem problem = Hopping(0.5, 1e3);
  EXPECT_FALSE(ReasonBeyondLegs(problem).has_value());
  problem.stances[1].X_WF.translation().z() += 5.0;
  problem.goal.p_WC.z() += 5.0;
  const std::optional<Failure> failure = ReasonBeyondLegs(problem);
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->code, FailureCode::kFlightTooLong);
}

TEST(BodyLimits, WithoutFrictionTheBodyCannotMoveForward) {
  RigidBodyProblem problem = rigid_bodies::Walker(0.6);
  const double t = problem.duration_s, up = std::sqrt(2.0 * kGravity * Vector3(0.25, 0.35, 0.8).norm());
  const double least = 0.6 / (t * (0.25 * kGravity * t + up));
  for (RigidStance& stance : problem.stances) stance.friction = 1.01 * least;
  EXPECT_FALSE(ReasonBeyondLegs(problem).has_value());
  for (RigidStance& stance : problem.stances) stance.friction = 0.99 * least;
  const std::optional<Failure> failure = ReasonBeyondLegs(problem);
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->code, FailureCode::kTooLittleFriction);
  EXPECT_NE(failure->message.find("0.60 m from rest to rest in 1.90 s"), std::string::npos) << failure->message;
}

}  // namespace
}  // namespace gaitwright
