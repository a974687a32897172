// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_problem.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

TEST(RigidBodyProblem, AnglesAreRollPitchAndYaw) {
  const double quarter = std::numbers::pi / 2.0;
  EXPECT_LT((RotationOf({quarter, 0.0, 0.0}) * Vector3::UnitY() - Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((RotationOf({0.0, quarter, 0.0}) * Vector3::UnitZ() - Vector3::UnitX()).norm(), 1e-12);
  EXPECT_LT((RotationOf({0.0, 0.0, quarter}) * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_NEAR(YawOf(RotationOf({0.3, 0.4, 0.7})), 0.7, 1e-12);
}

TEST(RigidBodyProblem, BodyRatesFollowFromAngleRates) {
  const Vector3 angles(0.3, -0.4, 1.2), rates(0.5, 0.7, -0.9);
  constexpr double kStep = 1e-6;
  const Matrix3 before = RotationOf(angles - kStep * rates), after = RotationOf(angles + kStep * rates);
  const Vector3 turned = RotationLog(before.transpose() * after) / (2.0 * kStep);
  EXPECT_GT((turned - rates).norm(), 0.1);
  EXPECT_LT((BodyRatesByAngleRates(angles) * rates - turned).norm(), 1e-8);
}

TEST(RigidBodyProblem, ABoxHoldsWhatIsNoFartherThanItsHalfSize) {
  const std::vector<WorkspaceSide> box = BoxAbout({0.1, 0.2, -0.5}, {0.2, 0.1, 0.05});
  const auto holds = [&](const Vector3& p) {
    return std::all_of(box.begin(), box.end(), [&](const WorkspaceSide& s) { return s.normal.dot(p) <= s.offset; });
  };
  EXPECT_TRUE(holds({0.29, 0.11, -0.46}));
  EXPECT_FALSE(holds({0.31, 0.2, -0.5}));
  EXPECT_FALSE(holds({0.1, 0.09, -0.5}));
  EXPECT_FALSE(holds({0.1, 0.2, -0.44}));
}

TEST(RigidBodyProblem, TheBodiesOfTheTestsAreInOrder) {
  for (const RigidBodyProblem& problem :
       {rigid_bodies::Hopper(), rigid_bodies::Walker(), rigid_bodies::Trotter(), rigid_bodies::SoledWalker()})
    EXPECT_NO_THROW(CheckRigidBodyProblem(problem));
}

/// The refusal of a walker's problem with an error.
std::string RefusalOf(const std::function<void(RigidBodyProblem&)>& spoil) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  spoil(problem);
  try {
    CheckRigidBodyProblem(problem);
  } catch (const InvalidArgument& e) {
    return e.what();
  }
  return "none";
}

TEST(RigidBodyProblem, RefusesInnerMotionThatIsNone) {
  EXPECT_EQ(RefusalOf([](auto& p) { rigid_bodies::AddLegMotion(p, 2); }), "none");
  const std::string momentum =
      "rigid body: the leg angular momentum needs two or more finite values with their rates, or none";
  EXPECT_EQ(RefusalOf([](auto& p) { p.leg_momentum_W = p.leg_torque_W = {Vector3::Zero()}; }), momentum);
  const auto spoilt = [&](const std::function<void(RigidBodyProblem&)>& spoil) {
    return RefusalOf([&](auto& p) {
      rigid_bodies::AddLegMotion(p, 5);
      spoil(p);
    });
  };
  EXPECT_EQ(spoilt([](auto& p) { p.leg_torque_W.pop_back(); }), momentum);
  EXPECT_EQ(spoilt([](auto& p) { p.leg_momentum_W.clear(); }), momentum);
  EXPECT_EQ(spoilt([](auto& p) { p.leg_momentum_W[3].y() = NAN; }), momentum);
  EXPECT_EQ(spoilt([](auto& p) { p.leg_torque_W[4].z() = INFINITY; }), momentum);
}

TEST(RigidBodyProblem, RefusesContactsThatMoveNowhere) {
  EXPECT_EQ(RefusalOf([](auto& p) { rigid_bodies::AddRolling(p); }), "none");
  const std::string moved = "rigid body: moving contacts need two or more finite positions, or none";
  EXPECT_EQ(RefusalOf([](auto& p) { p.stances[2].moved_W = {Vector3::Zero()}; }), moved);
  EXPECT_EQ(RefusalOf([](auto& p) { p.stances[2].moved_W = {Vector3::Zero(), {NAN, 0.0, 0.0}}; }), moved);
}

TEST(RigidBodyProblem, RefusesMotorsThatAreNone) {
  EXPECT_EQ(RefusalOf([](auto& p) { rigid_bodies::AddMotors(p, 100.0); }), "none");
  const auto spoilt = [](const std::function<void(MotorLimits&)>& spoil) {
    return RefusalOf([&](auto& p) {
      rigid_bodies::AddMotors(p, 100.0);
      spoil(p.stances[3].motors[1]);
    });
  };
  const std::string none =
      "rigid body: the motor limits of stance 3 have wrong sizes, a value that is not finite, or a lower limit above "
      "the upper one";
  EXPECT_EQ(spoilt([](auto& m) { m.by_force = MatrixX::Ones(2, 6); }), none);
  EXPECT_EQ(spoilt([](auto& m) { m.lower = VectorX::Zero(3); }), none);
  EXPECT_EQ(spoilt([](auto& m) { m.upper = VectorX::Ones(1); }), none);
  EXPECT_EQ(spoilt([](auto& m) { m.by_force(0, 1) = NAN; }), none);
  EXPECT_EQ(spoilt([](auto& m) { m.upper[1] = m.lower[1] - 1.0; }), none);
  EXPECT_EQ(spoilt([](auto& m) { m.upper[1] = NAN; }), none);
}

TEST(RigidBodyProblem, RefusesSwingsThatNoFootMakes) {
  const auto swings = [](std::size_t from, std::size_t to, double lift_m = 0.1) {
    return RefusalOf([&](auto& p) { p.swings = {{0, 1, 0.1}, {from, to, lift_m}}; });
  };
  EXPECT_EQ(swings(3, 4), "none");
  const auto refused = [](int from, int to) {
    return "rigid body: the swing from stance " + std::to_string(from) + " to " + std::to_string(to) +
           " needs two stances of one foot in order, a finite lift and a cruise share of 0 to below 1";
  };
  EXPECT_EQ(swings(1, 4), refused(1, 4)) << "another foot's";
  EXPECT_EQ(swings(2, 1), refused(2, 1)) << "backwards";
  EXPECT_EQ(swings(1, 1), refused(1, 1));
  EXPECT_EQ(swings(4, 5), refused(4, 5)) << "there are five";
  EXPECT_EQ(swings(3, 4, NAN), refused(3, 4));
}

TEST(RigidBodyProblem, InnerMomentumIsHermitesCubic) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  EXPECT_EQ(LegMomentum().At(0.3).norm() + LegMomentum(problem).RateAt(0.3).norm(), 0.0);
  const Vector3 a(0.3, -0.2, 0.1), b(-0.4, 0.5, 0.2), c(0.7, 0.1, -0.6), d(-0.2, 0.3, 0.4);
  const auto value = [&](double t) -> Vector3 { return a + t * (b + t * (c + t * d)); };
  const auto rate = [&](double t) -> Vector3 { return b + t * (2.0 * c + 3.0 * t * d); };
  for (int k = 0; k < 5; ++k) {
    problem.leg_momentum_W.push_back(value(problem.duration_s * k / 4));
    problem.leg_torque_W.push_back(rate(problem.duration_s * k / 4));
  }
  const LegMomentum cubic(problem);
  for (double t = 0.0; t < problem.duration_s; t += 0.0371) {
    EXPECT_LT((cubic.At(t) - value(t)).norm(), 1e-12) << t;
    EXPECT_LT((cubic.RateAt(t) - rate(t)).norm(), 1e-11) << t;
  }
  problem = rigid_bodies::Walker();
  rigid_bodies::AddLegMotion(problem, 6);
  const LegMomentum any(problem);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const double t = problem.duration_s * k / 5;
    EXPECT_LT((any.At(t) - problem.leg_momentum_W[static_cast<std::size_t>(k)]).norm(), 1e-12);
    EXPECT_LT((any.RateAt(t) - problem.leg_torque_W[static_cast<std::size_t>(k)]).norm(), 1e-12);
  }
  for (const double t : {0.1, 0.5, 1.3})
    EXPECT_LT(((any.At(t + kStep) - any.At(t - kStep)) / (2.0 * kStep) - any.RateAt(t)).norm(), 1e-8);
}

TEST(RigidBodyProblem, AStanceKnowsHowFarItsContactsHaveMovedAndItsMotors) {
  RigidStance stance;
  stance.start_s = 1.0;
  stance.end_s = 3.0;
  EXPECT_EQ(stance.MovedAt(2.0).norm(), 0.0);
  EXPECT_EQ(stance.MotorsAt(2.0), nullptr);
  stance.moved_W = {{0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}, {0.01, 0.04, 0.0}};
  EXPECT_EQ(stance.MovedAt(1.0), stance.moved_W[0]);
  EXPECT_EQ(stance.MovedAt(3.0), stance.moved_W[2]);
  EXPECT_EQ(stance.MovedAt(9.0), stance.moved_W[2]);
  EXPECT_LT((stance.MovedAt(1.25) - Vector3(0.0025, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((stance.MovedAt(2.75) - Vector3(0.01, 0.03, 0.0)).norm(), 1e-15);
  stance.motors.assign(3, {MatrixX::Zero(1, 3), VectorX::Zero(1), VectorX::Zero(1)});
  const std::vector<std::pair<double, std::size_t>> nearest = {{0.0, 0}, {1.0, 0}, {1.49, 0}, {1.51, 1},
                                                               {2.4, 1}, {2.6, 2}, {3.0, 2},  {4.0, 2}};
  for (const auto& [time_s, at] : nearest) EXPECT_EQ(stance.MotorsAt(time_s), &stance.motors[at]) << time_s;
  const MotorLimits unlimited{MatrixX(0, 3), VectorX(0), VectorX(0)};
  stance.motors.assign(3, unlimited);
  EXPECT_EQ(stance.MotorsAt(2.0), nullptr) << "no motor has a limit";
}

TEST(RigidBodyProblem, ATrajectoryIsLinearBetweenItsTimes) {
  const BodyTrajectory trajectory{{0.0, 1.0, 3.0},
                                  {{0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, {1.0, 4.0, 1.0}},
                                  {{0.0, 0.0, 0.0}, {0.0, 0.2, 0.0}, {0.0, 0.2, 0.8}}};
  EXPECT_LT((trajectory.PlaceAt(0.25) - Vector3(0.25, 0.0, 1.0)).norm(), 1e-15);
  EXPECT_LT((trajectory.PlaceAt(1.0) - Vector3(1.0, 0.0, 1.0)).norm(), 1e-15);
  EXPECT_LT((trajectory.PlaceAt(2.5) - Vector3(1.0, 3.0, 1.0)).norm(), 1e-15);
  EXPECT_LT((trajectory.AnglesAt(2.0) - Vector3(0.0, 0.2, 0.4)).norm(), 1e-15);
  EXPECT_EQ(trajectory.PlaceAt(-1.0), trajectory.p_WC.front());
  EXPECT_EQ(trajectory.PlaceAt(5.0), trajectory.p_WC.back());
  EXPECT_EQ(trajectory.AnglesAt(5.0), trajectory.angles_rad.back());
}

TEST(RigidBodyProblem, RefusesWhatCannotBe) {
  EXPECT_EQ(RefusalOf([](auto& p) { p.mass_kg = 0.0; }), "rigid body: the mass is 0 kg; it must be finite and above 0");
  EXPECT_EQ(RefusalOf([](auto& p) { p.inertia_B(0, 0) = 30.0; }),
            "rigid body: the inertia matrix is not physical (not symmetric positive definite, or violates the triangle "
            "inequality)");
  EXPECT_EQ(RefusalOf([](auto& p) { p.duration_s = -1.0; }),
            "rigid body: the duration is -1 s; it must be finite and above 0");
  EXPECT_EQ(RefusalOf([](auto& p) { p.goal.p_WC.x() = NAN; }), "rigid body: the goal state is not finite");
  EXPECT_EQ(RefusalOf([](auto& p) { p.stances[1].foot = 2; }),
            "rigid body: stance 1 names foot 2, but there are 2 feet");
  EXPECT_EQ(RefusalOf([](auto& p) { p.stances[1].start_s = 0.2; }),
            "rigid body: stance 1 lasts from 0.2 to 1.2 s, but foot 0 is free only from 0.3 to 1.9 s");
  EXPECT_EQ(RefusalOf([](auto& p) { p.stances[4].friction = 0.0; }),
            "rigid body: stance 4 has the friction coefficient 0; it must be above 0");
  EXPECT_EQ(RefusalOf([](auto& p) {
              p.stances[4].region_F = {{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}};
            }),
            "rigid body: the region of stance 4 is not convex");
  EXPECT_EQ(RefusalOf([](auto& p) {
              p.path.time_s = {0.0, 1.0};
            }),
            "rigid body: the initial guess of the path needs rising times, with a position and angles for each");
  EXPECT_EQ(RefusalOf([](auto& p) { p.feet[1].force_max_n = 0.0; }),
            "rigid body: foot 1 cannot carry any load; it needs a contact point and a largest force above 0");
  EXPECT_EQ(RefusalOf([](auto& p) { p.stances[2].end_s = p.stances[4].end_s = 1.8; }),
            "rigid body: no foot is on the ground at the end");
}

}  // namespace
}  // namespace gaitwright
