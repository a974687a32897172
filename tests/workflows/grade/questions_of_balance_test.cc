// SPDX-License-Identifier: BSD-3-Clause
// Each question is compared with closed forms that are derived independently here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/stability/polygon.h"
#include "tests/workflows/grade/asked_questions.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

TEST(QuestionsOfBalance, ZmpOfThePendulum) {
  const Values in = Drawn("pendulum_zmp", {6});
  const double h = in[2].number();
  const std::vector<double> right = {in[0].numbers[0] - in[1].numbers[0] * h / 9.81,
                                     in[0].numbers[1] - in[1].numbers[1] * h / 9.81};
  EXPECT_LT(ErrorOf("pendulum_zmp", {6}, in, Answer({2}, right)), 1e-12);
  EXPECT_NEAR(ErrorOf("pendulum_zmp", {6}, in, Answer({2}, {right[0] + 0.1, right[1]})), 0.1, 1e-12);
}

/// Each contact force acts where its line meets the ground; the ZMP is the mean of these points, weighted by the normal
/// forces.
TEST(QuestionsOfBalance, ZmpOfContactsIsTheWeightedMeanWhereTheirLinesMeetTheGround) {
  const QuestionContext context{5};
  const Values in = Drawn("contacts_zmp", context);
  Vector2 sum = Vector2::Zero();
  double weight = 0.0;
  for (int i = 0; i < 5; ++i) {
    const Vector3 p = in[0].Vec3(i), f = in[1].Vec3(i);
    sum += f.z() * (p.head<2>() - (p.z() - in[2].number()) / f.z() * f.head<2>());
    weight += f.z();
  }
  EXPECT_LT(ErrorOf("contacts_zmp", context, in, Answer({2}, {sum.x() / weight, sum.y() / weight})), 1e-12);
}

TEST(QuestionsOfBalance, CornersMayBeginAnywhereAndRepeat) {
  const QuestionContext context{4};
  Values in = {{"points_m", {4, 2}, {0, 0, 1, 0, 1, 1, 0, 1}}};
  EXPECT_LT(ErrorOf("support_polygon", context, in, Answer({4, 2}, {1, 1, 0, 1, 0, 0, 1, 0})), 1e-12);
  EXPECT_LT(ErrorOf("support_polygon", context, in, Answer({5, 2}, {1, 1, 0, 1, 0, 0, 1, 0, 1, 0})), 1e-12);
  EXPECT_GT(ErrorOf("support_polygon", context, in, Answer({4, 2}, {0, 0, 0, 1, 1, 1, 1, 0})), 0.5);  // clockwise
  EXPECT_TRUE(std::isinf(ErrorOf("support_polygon", context, in, Answer({3, 2}, {0, 0, 1, 0, 1, 1}))));
  EXPECT_TRUE(std::isinf(ErrorOf("support_polygon", context, in, Answer({0, 2}, {}))));
}

TEST(QuestionsOfBalance, OnePointToHullLiesOnAnEdge) {
  for (int number = 0; number < 20; ++number) {
    const Values in = Drawn("support_polygon", {6}, number);
    Polygon points;
    for (int i = 0; i < 6; ++i) points.push_back(in[0].Vec2(i));
    const Polygon hull = ConvexHull(points);
    EXPECT_EQ(SignedDistance(hull, points.back()), 0.0) << number;
    EXPECT_EQ(std::count(hull.begin(), hull.end(), points.back()), 0) << number;
  }
}

TEST(QuestionsOfBalance, CornersOfTheMarginAreAConvexPolygon) {
  for (int number = 0; number < 20; ++number) {
    const Values in = Drawn("support_margin", {7}, number);
    double least = 1e9;
    for (int i = 0; i < 7; ++i) {
      const Vector2 a = in[0].Vec2(i), b = in[0].Vec2((i + 1) % 7), c = in[0].Vec2((i + 2) % 7);
      EXPECT_GT((b - a).x() * (c - b).y() - (b - a).y() * (c - b).x(), 0.0);
      const Vector2 inward = Vector2(-(b - a).y(), (b - a).x()).normalized();
      least = std::min(least, inward.dot(in[1].Vec2() - a));
    }
    if (least > 0.0) {
      EXPECT_LT(ErrorOf("support_margin", {7}, in, Answer({}, {least})), 1e-12);
    }
  }
}

/// The moment about the ZMP has no horizontal part.
TEST(QuestionsOfBalance, AboutTheZmpOfAWrenchOnlyTheVerticalMomentIsLeft) {
  for (int number = 0; number < 10; ++number) {
    const Values in = Drawn("wrench_zmp", {6}, number);
    const double height = in[3].number();
    const Vector3 force = in[1].Vec3();
    // p with (n + (point - p) x f) horizontal part zero, solved by Cramer's rule from two linear equations.
    const Vector3 about_origin = in[2].Vec3() + in[0].Vec3().cross(force);
    const double x = (height * force.x() - about_origin.y()) / force.z();
    const double y = (height * force.y() + about_origin.x()) / force.z();
    const Vector3 left = about_origin - Vector3(x, y, height).cross(force);
    EXPECT_LT(left.head<2>().norm(), 1e-9);
    EXPECT_LT(ErrorOf("wrench_zmp", {6}, in, Answer({2}, {x, y})), 1e-9) << number;
    EXPECT_NEAR(ErrorOf("wrench_zmp", {6}, in, Answer({2}, {x + 0.01, y})), 0.01, 1e-9);
  }
}

TEST(QuestionsOfBalance, AnAnswerOfAnotherShapeIsRefused) {
  const Values in = Drawn("support_polygon", {5});
  EXPECT_THROW(ErrorOf("support_polygon", {5}, in, Answer({6}, std::vector<double>(6))), InvalidArgument);
  EXPECT_THROW(ErrorOf("support_margin", {5}, Drawn("support_margin", {5}), Answer({2}, {0.0, 0.0})), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
