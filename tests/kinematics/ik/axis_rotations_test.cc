// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/axis_rotations.h"

#include <cmath>
#include <numbers>

#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

constexpr double kPi = std::numbers::pi;

class AxisRotationsTest : public testing::Test {
 protected:
  Vector3 Unit() { return random_.Vector(3).normalized(); }
  Vector3 Any() { return random_.Vector(3); }
  double Angle() { return 3.0 * std::tanh(random_.Vector(1)[0]); }
  RandomState random_{7};
};

TEST_F(AxisRotationsTest, TurnedIsTheRotationMatrix) {
  for (int i = 0; i < 100; ++i) {
    const Vector3 axis = Unit(), u = Any();
    const double angle = Angle();
    EXPECT_LT((Turned(axis, angle, u) - RotationExp(angle * axis) * u).norm(), 1e-14);
  }
}

TEST_F(AxisRotationsTest, CosineSineHasTwoRootsOneOrNone) {
  const Angles two = SolveCosineSine(3.0, 4.0, 2.0, 0.0);
  ASSERT_EQ(two.count, 2);
  for (const double x : two.rad) EXPECT_NEAR(3.0 * std::cos(x) + 4.0 * std::sin(x), 2.0, 1e-14);
  EXPECT_EQ(SolveCosineSine(3.0, 4.0, 5.0, 0.0).count, 1);
  EXPECT_EQ(SolveCosineSine(3.0, 4.0, -5.0, 0.0).count, 1);
  EXPECT_EQ(SolveCosineSine(3.0, 4.0, 5.0 + 1e-9, 0.0).count, 0);
  EXPECT_EQ(SolveCosineSine(3.0, 4.0, std::nan(""), 0.0).count, 0);
  const Angles any = SolveCosineSine(0.0, 0.0, 0.0, 0.7);
  ASSERT_EQ(any.count, 1);
  EXPECT_EQ(any.rad[0], 0.7);
  EXPECT_EQ(SolveCosineSine(0.0, 0.0, 1.0, 0.7).count, 0);
}

TEST_F(AxisRotationsTest, AnglesAreFoundAgain) {
  for (int i = 0; i < 200; ++i) {
    const Vector3 axis = Unit(), u = Any(), h = Any();
    const double angle = Angle();
    const Vector3 v = Turned(axis, angle, u);
    EXPECT_NEAR(AngleAbout(axis, u, v, 0.0), angle, 1e-12);
    const Angles heights = AnglesToHeight(axis, u, h, h.dot(v), 0.0);
    const Angles distances = AnglesToDistance(axis, u, h, (v - h).norm(), 0.0);
    ASSERT_GE(heights.count, 1);
    ASSERT_GE(distances.count, 1);
    double nearest = 1.0;
    for (int k = 0; k < heights.count; ++k) {
      const double x = heights.rad[static_cast<std::size_t>(k)];
      EXPECT_NEAR(h.dot(Turned(axis, x, u)), h.dot(v), 1e-12);
      nearest = std::min(nearest, std::abs(WrapAngle(x - angle)));
    }
    EXPECT_LT(nearest, 1e-6);
    for (int k = 0; k < distances.count; ++k) {
      EXPECT_NEAR((Turned(axis, distances.rad[static_cast<std::size_t>(k)], u) - h).norm(), (v - h).norm(), 1e-12);
    }
  }
}

TEST_F(AxisRotationsTest, TwoTurnsBringOneVectorOntoAnother) {
  for (int i = 0; i < 200; ++i) {
    const Vector3 a = Unit(), b = Unit(), u = Any();
    const Vector3 v = Turned(a, Angle(), Turned(b, Angle(), u));
    const TwoTurns turns = TurnOnto(a, b, u, v, Vector2::Zero());
    ASSERT_EQ(turns.count, 2);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LT((Turned(a, turns.first[k], Turned(b, turns.second[k], u)) - v).norm(), 1e-11);
    }
    EXPECT_LT(TurnGap(a, b, u, v), 1e-12);
  }
}

TEST_F(AxisRotationsTest, TheGapIsTheAngleThatIsMissing) {
  // u is 0.3 rad from b, and b is 0.5 rad from a, so u can be 0.2 to 0.8 rad from a.
  const auto at = [](double angle) { return Vector3(std::sin(angle), 0.0, std::cos(angle)); };
  const Vector3 a = at(0.0), b = at(0.5), u = at(0.8);
  EXPECT_NEAR(TurnGap(a, b, u, at(0.9)), 0.1, 1e-14);
  EXPECT_NEAR(TurnGap(a, b, u, at(0.05)), 0.15, 1e-14);
  EXPECT_EQ(TurnGap(a, b, u, at(0.5)), 0.0);
  EXPECT_EQ(TurnOnto(a, b, u, at(0.9), Vector2::Zero()).count, 0);
}

TEST_F(AxisRotationsTest, AnyRotationIsMadeByPerpendicularNeighbours) {
  for (int i = 0; i < 300; ++i) {
    const Matrix3 turned = RotationExp(Any());
    const Vector3 x = turned.col(0), y = turned.col(1), z = turned.col(2);
    // Orthogonal axes, first and third equal, and NAO's: 45 degrees off perpendicular to the third.
    const std::array<std::array<Vector3, 3>, 3> triples = {
        {{z, x, y}, {z, x, z}, {Vector3((y - z).normalized()), x, y}}};
    const Matrix3 R = RotationExp(Any());
    for (const auto& axes : triples) {
      const ThreeTurns turns = DecomposeRotation(axes, R, Vector3::Zero());
      ASSERT_EQ(turns.count, 2);
      for (const Vector3& rad : turns.rad) {
        const Matrix3 made =
            RotationExp(rad[0] * axes[0]) * RotationExp(rad[1] * axes[1]) * RotationExp(rad[2] * axes[2]);
        EXPECT_LT((made - R).norm(), 1e-11);
      }
    }
  }
}

TEST_F(AxisRotationsTest, AxesInLineKeepTheFirstAngle) {
  const std::array<Vector3, 3> axes = {Vector3::UnitZ(), Vector3::UnitX(), Vector3::UnitY()};
  const Vector3 rad(0.4, 0.5 * kPi, -0.3);
  const Matrix3 R = RotationExp(rad[0] * axes[0]) * RotationExp(rad[1] * axes[1]) * RotationExp(rad[2] * axes[2]);
  const ThreeTurns turns = DecomposeRotation(axes, R, Vector3(0.4, 0.0, 0.0));
  ASSERT_GE(turns.count, 1);
  const Matrix3 made = RotationExp(turns.rad[0][0] * axes[0]) * RotationExp(turns.rad[0][1] * axes[1]) *
                       RotationExp(turns.rad[0][2] * axes[2]);
  EXPECT_LT((made - R).norm(), 1e-7);  // accuracy at a singularity
}

}  // namespace
}  // namespace gaitwright
