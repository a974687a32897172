// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers>

#include "kinematics/spatial/rotation.h"
#include "optimisation/trajectory/turning_chart_internal.h"
#include "tests/optimisation/numerics/derivative_check.h"

namespace gaitwright {
namespace {

using First = TurningChart::First;

class Charts : public testing::TestWithParam<First> {};
INSTANTIATE_TEST_SUITE_P(All, Charts, testing::Values(First::kYaw, First::kPitch, First::kRoll));

const Matrix3& Tilted() {
  static const Matrix3 R = RotationExp({0.3, -0.2, 0.5});
  return R;
}

AngleJet JetAt(const VectorX& x) { return {x.segment<3>(0), x.segment<3>(3), x.segment<3>(6)}; }

const VectorX& Anywhere() {
  static const VectorX x = (VectorX(9) << 2.1, -0.6, 0.8, 1.3, -2.2, 0.7, 9.0, -4.0, 6.0).finished();
  return x;
}

TEST_P(Charts, DerivativesAreThoseOfFiniteDifferences) {
  const TurningChart chart(GetParam(), Tilted());
  ExpectDerivative(
      [&](const VectorX& x, VectorX& value, MatrixX* J) {
        const ChartedTurn turn = chart.At(JetAt(x)), here = chart.At(JetAt(Anywhere()));
        value.resize(9);
        value << RotationLog(turn.R * here.R.transpose()), turn.w, turn.alpha;
        if (J == nullptr) return;
        J->topLeftCorner<3, 3>() = turn.E;
        J->block<3, 3>(3, 0) = turn.w_by_x;
        J->block<3, 3>(3, 3) = turn.E;
        J->block<3, 3>(6, 0) = turn.alpha_by_x;
        J->block<3, 3>(6, 3) = turn.alpha_by_rate;
        J->block<3, 3>(6, 6) = turn.E;
      },
      Anywhere());
}

TEST_P(Charts, RatesAreThoseOfTheMotion) {
  const TurningChart chart(GetParam(), Tilted());
  const AngleJet at = JetAt(Anywhere());
  constexpr double kStep = 1e-5;
  const auto moved = [&](double t) {
    return chart.At(
        {at.x + t * at.rate + 0.5 * t * t * at.acceleration, at.rate + t * at.acceleration, at.acceleration});
  };
  const ChartedTurn now = moved(0.0), before = moved(-kStep), after = moved(kStep);
  EXPECT_LT((RotationLog(after.R * before.R.transpose()) / (2.0 * kStep) - now.w).norm(), 1e-6);
  EXPECT_LT(((after.w - before.w) / (2.0 * kStep) - now.alpha).norm(), 1e-6);
}

TEST_P(Charts, GiveTheAnglesBack) {
  const TurningChart chart(GetParam(), Tilted());
  AngleJet jet = JetAt(Anywhere());
  jet.x[0] += 4.0 * std::numbers::pi;
  const ChartedTurn turn = chart.At(jet);
  const AngleJet back = chart.JetOf(turn.R, turn.w, turn.alpha, jet.x + Vector3(1.0, 0.0, -1.0));
  EXPECT_LT((back.x - jet.x).norm(), 1e-12);
  EXPECT_LT((back.rate - jet.rate).norm(), 1e-12);
  EXPECT_LT((back.acceleration - jet.acceleration).norm(), 1e-10);
}

TEST(TurningChart, PutsTheAxisOfASomersaultFirst) {
  std::vector<Matrix3> flip, turn;
  for (int k = 0; k <= 20; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 20.0;
    flip.push_back(RotationExp(angle * Vector3::UnitY()));
    turn.push_back(RotationExp(angle * Vector3::UnitZ()));
  }
  Vector3 x = Vector3::Zero();
  const TurningChart flips = TurningChart::For(flip, Matrix3::Identity());
  for (const Matrix3& R : flip) x = flips.AnglesOf(R, x);
  EXPECT_LT((x - Vector3(2.0 * std::numbers::pi, 0.0, 0.0)).norm(), 1e-9);
  const TurningChart turns = TurningChart::For(turn, Matrix3::Identity());
  x.setZero();
  for (const Matrix3& R : turn) x = turns.AnglesOf(R, x);
  EXPECT_LT((x - Vector3(2.0 * std::numbers::pi, 0.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((turns.At({.x = Vector3(0.3, 0.0, 0.0)}).R - RotationExp({0.0, 0.0, 0.3})).norm(), 1e-12);
}

}  // namespace
}  // namespace gaitwright
