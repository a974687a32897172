// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_problem.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <string>

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

TEST(RigidBodyProblem, RefusesWhatCannotBe) {
  const auto refusal = [](const std::function<void(RigidBodyProblem&)>& spoil) -> std::string {
    RigidBodyProblem problem = rigid_bodies::Walker();
    spoil(problem);
    try {
      CheckRigidBodyProblem(problem);
    } catch (const InvalidArgument& e) {
      return e.what();
    }
    return "none";
  };
  EXPECT_EQ(refusal([](auto& p) { p.mass_kg = 0.0; }), "rigid body: a mass of 0 kg");
  EXPECT_EQ(refusal([](auto& p) { p.inertia_B(0, 0) = 30.0; }), "rigid body: the inertia is none that a body can have");
  EXPECT_EQ(refusal([](auto& p) { p.duration_s = -1.0; }), "rigid body: a duration of -1 s");
  EXPECT_EQ(refusal([](auto& p) { p.goal.p_WC.x() = NAN; }), "rigid body: the goal state is not finite");
  EXPECT_EQ(refusal([](auto& p) { p.stances[1].foot = 2; }), "rigid body: stance 1 names foot 2 of 2");
  EXPECT_EQ(refusal([](auto& p) { p.stances[1].start_s = 0.2; }),
            "rigid body: stance 1 lasts from 0.2 to 1.2 s; foot 0 is free from 0.3 to 1.9 s");
  EXPECT_EQ(refusal([](auto& p) { p.stances[4].friction = 0.0; }), "rigid body: stance 4 has no friction");
  EXPECT_EQ(refusal([](auto& p) {
              p.stances[4].region_F = {{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}};
            }),
            "rigid body: the region of stance 4 is not convex");
  EXPECT_EQ(refusal([](auto& p) {
              p.way.time_s = {0.0, 1.0};
            }),
            "rigid body: the first guess of its way needs a place and angles for each of its times in turn");
  EXPECT_EQ(refusal([](auto& p) { p.feet[1].force_max_n = 0.0; }), "rigid body: foot 1 can carry nothing");
  EXPECT_EQ(refusal([](auto& p) { p.stances[2].end_s = p.stances[4].end_s = 1.8; }),
            "rigid body: no foot holds it at the end");
}

}  // namespace
}  // namespace gaitwright
