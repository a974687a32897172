// SPDX-License-Identifier: BSD-3-Clause
// Each question is compared with closed forms that are derived independently here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/workflows/grade/asked_questions.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

/// Minimum jerk with a cubic bump, in explicit formulas.
TEST(QuestionsOfSwings, ASwingIsMinimumJerkAndABump) {
  const Values in = Drawn("swing", {6});
  const double T = in[3].number(), u = in[4].number() / T, lift = in[2].number();
  ASSERT_LE(u, 1.0);
  const double s = u * u * u * (10 - 15 * u + 6 * u * u), w = 1 - u;
  const double s1 = 30 * u * u * w * w, s2 = 60 * u * w * (1 - 2 * u);
  const double b = 64 * u * u * u * w * w * w, b1 = 192 * u * u * w * w * (1 - 2 * u);
  const double b2 = 384 * u * w * (1 - 5 * u + 5 * u * u);
  std::vector<double> right;
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 3; ++i) {
      const double distance = (in[1].Vec3() - in[0].Vec3())[i], up = i == 2 ? lift : 0.0;
      right.push_back(row == 0   ? in[0].Vec3()[i] + distance * s + up * b
                      : row == 1 ? (distance * s1 + up * b1) / T
                                 : (distance * s2 + up * b2) / (T * T));
    }
  }
  EXPECT_LT(ErrorOf("swing", {6}, in, Answer({3, 3}, right)), 1e-9);
}

/// A straight line in time, and a swing that goes up early.
TEST(QuestionsOfSwings, ASwingOverAStepIsJudgedByWhatItDoes) {
  for (int number = 0; number < 10; ++number) {
    const Values in = Drawn("swing_over_step", {6}, number);
    const Vector3 start = in[0].Vec3(), end = in[1].Vec3();
    std::vector<double> line, good;
    for (int i = 0; i <= 100; ++i) {
      const double u = i / 100.0;
      const Vector3 straight = start + u * (end - start);
      line.insert(line.end(), {straight.x(), straight.y(), straight.z()});
      // Up in the first third, over in the second, down in the last.
      const auto smooth = [](double x) {
        const double v = std::clamp(x, 0.0, 1.0);
        return v * v * v * (10 - 15 * v + 6 * v * v);
      };
      const double top = std::max(start.z(), end.z()) + in[3].number() + 0.02;
      const double z =
          u < 0.5 ? start.z() + smooth(u / 0.4) * (top - start.z()) : top + smooth((u - 0.6) / 0.4) * (end.z() - top);
      const double along = smooth((u - 0.15) / 0.7);
      good.insert(good.end(), {start.x() + along * (end - start).x(), start.y() + along * (end - start).y(), z});
    }
    EXPECT_GT(ErrorOf("swing_over_step", {6}, in, Answer({101, 3}, line)), 1e-3);
    EXPECT_LT(ErrorOf("swing_over_step", {6}, in, Answer({101, 3}, good)), 1e-6) << number;
  }
}

/// Rate and acceleration agree with finite differences of the value; the step is symmetric about its middle.
TEST(QuestionsOfSwings, TheMinimumJerkStepHasItsOwnDerivatives) {
  const auto value = [](double u) { return 10 * std::pow(u, 3) - 15 * std::pow(u, 4) + 6 * std::pow(u, 5); };
  constexpr double kDelta = 1e-4;
  for (int number = 0; number < 10; ++number) {
    const Values in = Drawn("minimum_jerk", {6}, number);
    const double u = in[0].number();
    const double rate = (value(u + kDelta) - value(u - kDelta)) / (2.0 * kDelta);
    const double acceleration = (value(u + kDelta) - 2.0 * value(u) + value(u - kDelta)) / (kDelta * kDelta);
    EXPECT_LT(ErrorOf("minimum_jerk", {6}, in, Answer({3}, {value(u), rate, acceleration})), 1e-5) << u;
    EXPECT_GT(ErrorOf("minimum_jerk", {6}, in, Answer({3}, {value(u), rate, acceleration + 0.1})), 0.09);
  }
}

/// A swing over a step that jumps to its end violates a rule by the size of the jump.
TEST(QuestionsOfSwings, AJumpIsAnErrorOfItsSize) {
  const Values in = Drawn("swing_over_step", {6});
  const Vector3 start = in[0].Vec3(), end = in[1].Vec3();
  std::vector<double> stays;
  for (int i = 0; i <= 100; ++i) stays.insert(stays.end(), {start.x(), start.y(), start.z()});
  EXPECT_GT(ErrorOf("swing_over_step", {6}, in, Answer({101, 3}, stays)), 0.9 * (end - start).norm())
      << "it never arrives";
}

}  // namespace
}  // namespace gaitwright
