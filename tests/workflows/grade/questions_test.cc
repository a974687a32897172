// SPDX-License-Identifier: BSD-3-Clause
// Each question against closed forms that are written here by another road.
#include "workflows/grade/questions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/ik/leg_chain.h"
#include "kinematics/ik/leg_ik.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

QuestionValue Answer(std::vector<int> shape, std::vector<double> numbers) {
  return {"answer", std::move(shape), std::move(numbers)};
}

Values Drawn(const std::string& name, const QuestionContext& context, int number = 0) {
  return DrawCase(QuestionOf(name), {}, context, 7, number);
}

double ErrorOf(const std::string& name, const QuestionContext& context, const Values& in, const QuestionValue& answer) {
  return QuestionOf(name).error(context, in, answer);
}

TEST(Questions, CasesAreTheSameForTheSameSeedAndOthersForAnother) {
  const QuestionContext context{6};
  for (const Question& question : Questions()) {
    if (question.needs_robot) continue;
    const Values a = DrawCase(question, {}, context, 7, 3), b = DrawCase(question, {}, context, 7, 3);
    const Values other = DrawCase(question, {}, context, 8, 3);
    ASSERT_EQ(a.size(), question.inputs.size()) << question.name;
    bool differs = false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].numbers, b[i].numbers) << question.name;
      EXPECT_EQ(static_cast<int>(a[i].numbers.size()), CountOf(a[i].shape)) << question.name;
      differs = differs || a[i].numbers != other[i].numbers;
    }
    EXPECT_TRUE(differs) << question.name;
  }
}

TEST(Questions, RangesOfARubricAreKept) {
  QuestionSetup setup;
  setup.inputs = {{"com_height_m", {0.25, 0.25}}};
  EXPECT_EQ(DrawCase(QuestionOf("dcm"), setup, {6}, 1, 0)[2].number(), 0.25);
}

TEST(Questions, AnotherShapeIsRefusedInWords) {
  const QuestionContext context{6};
  const Values in = Drawn("dcm_of_steps", context);
  try {
    ErrorOf("dcm_of_steps", context, in, Answer({2}, {0.0, 0.0}));
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "the answer is 2 numbers; 6 x 2 numbers are needed");
  }
}

TEST(Questions, ZmpOfThePendulum) {
  const Values in = Drawn("pendulum_zmp", {6});
  const double h = in[2].number();
  const std::vector<double> right = {in[0].numbers[0] - in[1].numbers[0] * h / 9.81,
                                     in[0].numbers[1] - in[1].numbers[1] * h / 9.81};
  EXPECT_LT(ErrorOf("pendulum_zmp", {6}, in, Answer({2}, right)), 1e-12);
  EXPECT_NEAR(ErrorOf("pendulum_zmp", {6}, in, Answer({2}, {right[0] + 0.1, right[1]})), 0.1, 1e-12);
}

/// Each contact's vertical force is level with the ground where its line meets it; the mean of those by their weight.
TEST(Questions, ZmpOfContactsIsTheWeightedMeanWhereTheirLinesMeetTheGround) {
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

TEST(Questions, NothingIsRightWhereTheAnswerIsNoNumber) {
  const Values in = {{"com_m", {3}, {0, 0, 1}}, {"velocity_m_s", {3}, {1, 0, 0}}, {"com_height_m", {}, {-1.0}}};
  EXPECT_TRUE(std::isinf(ErrorOf("dcm", {6}, in, Answer({2}, {42, 42}))));
}

TEST(Questions, CornersMayBeginAnywhereAndRepeat) {
  const QuestionContext context{4};
  Values in = {{"points_m", {4, 2}, {0, 0, 1, 0, 1, 1, 0, 1}}};
  EXPECT_LT(ErrorOf("support_polygon", context, in, Answer({4, 2}, {1, 1, 0, 1, 0, 0, 1, 0})), 1e-12);
  EXPECT_LT(ErrorOf("support_polygon", context, in, Answer({5, 2}, {1, 1, 0, 1, 0, 0, 1, 0, 1, 0})), 1e-12);
  EXPECT_GT(ErrorOf("support_polygon", context, in, Answer({4, 2}, {0, 0, 0, 1, 1, 1, 1, 0})), 0.5);  // clockwise
  EXPECT_TRUE(std::isinf(ErrorOf("support_polygon", context, in, Answer({3, 2}, {0, 0, 1, 0, 1, 1}))));
  EXPECT_TRUE(std::isinf(ErrorOf("support_polygon", context, in, Answer({0, 2}, {}))));
}

TEST(Questions, OnePointToHullLiesOnAnEdge) {
  for (int number = 0; number < 20; ++number) {
    const Values in = Drawn("support_polygon", {6}, number);
    Polygon points;
    for (int i = 0; i < 6; ++i) points.push_back(in[0].Vec2(i));
    const Polygon hull = ConvexHull(points);
    EXPECT_EQ(SignedDistance(hull, points.back()), 0.0) << number;
    EXPECT_EQ(std::count(hull.begin(), hull.end(), points.back()), 0) << number;
  }
}

TEST(Questions, CornersOfTheMarginAreAConvexPolygon) {
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

/// By small steps of its differential equation.
TEST(Questions, TheDcmOfStepsEndsOnTheLastZmp) {
  const QuestionContext context{3};
  const Values in = Drawn("dcm_of_steps", context);
  const double omega = std::sqrt(9.81 / in[2].number()), step_s = in[1].number();
  std::vector<double> starts(6);
  Vector2 next = in[0].Vec2(2);
  for (int i = 2; i >= 0; --i) {
    constexpr int kSteps = 100000;
    for (int k = 0; k < kSteps; ++k) next -= step_s / kSteps * omega * (next - in[0].Vec2(i));
    starts[static_cast<std::size_t>(2 * i)] = next.x();
    starts[static_cast<std::size_t>(2 * i + 1)] = next.y();
  }
  EXPECT_LT(ErrorOf("dcm_of_steps", context, in, Answer({3, 2}, starts)), 1e-4);
  EXPECT_LT(ErrorOf("dcm_at", context, {in[0], in[1], in[2], {"times_s", {3}, {0.0, step_s, 2.0 * step_s}}},
                    Answer({3, 2}, starts)),
            1e-4);
}

TEST(Questions, TheBodyFollowsTheDcm) {
  const Values in = Drawn("com_along_dcm", {6});
  const double omega = std::sqrt(9.81 / in[3].number());
  Vector2 c = in[0].Vec2(), xi = in[1].Vec2();
  constexpr int kSteps = 200000;
  const double h = in[4].number() / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    c += h * omega * (xi - c);
    xi += h * omega * (xi - in[2].Vec2());
  }
  EXPECT_LT(ErrorOf("com_along_dcm", {6}, in, Answer({2}, {c.x(), c.y()})), 1e-4);
}

TEST(Questions, GainsHaveAsManyNumbersAsThePreview) {
  const Values in = Drawn("preview_gains", {6});
  const int count = QuestionOf("preview_gains").shape({6}, in).front();
  EXPECT_EQ(count, 4 + static_cast<int>(std::lround(in[2].number() / in[1].number())));
  EXPECT_NEAR(ErrorOf("preview_gains", {6}, in, Answer({count}, std::vector<double>(static_cast<std::size_t>(count)))),
              1.0, 1e-9);
}

/// Minimum jerk with a cubic bump, written out.
TEST(Questions, ASwingIsMinimumJerkAndABump) {
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
      const double way = (in[1].Vec3() - in[0].Vec3())[i], up = i == 2 ? lift : 0.0;
      right.push_back(row == 0   ? in[0].Vec3()[i] + way * s + up * b
                      : row == 1 ? (way * s1 + up * b1) / T
                                 : (way * s2 + up * b2) / (T * T));
    }
  }
  EXPECT_LT(ErrorOf("swing", {6}, in, Answer({3, 3}, right)), 1e-9);
}

/// A straight line in time, and a swing that goes up early.
TEST(Questions, ASwingOverAStepIsJudgedByWhatItDoes) {
  for (int number = 0; number < 10; ++number) {
    const Values in = Drawn("swing_over_step", {6}, number);
    const Vector3 start = in[0].Vec3(), end = in[1].Vec3();
    std::vector<double> line, good;
    for (int i = 0; i <= 100; ++i) {
      const double u = i / 100.0, s = u * u * u * (10 - 15 * u + 6 * u * u);
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
      (void)s;
      good.insert(good.end(), {start.x() + along * (end - start).x(), start.y() + along * (end - start).y(), z});
    }
    EXPECT_GT(ErrorOf("swing_over_step", {6}, in, Answer({101, 3}, line)), 1e-3);
    EXPECT_LT(ErrorOf("swing_over_step", {6}, in, Answer({101, 3}, good)), 1e-6) << number;
  }
}

class LegQuestions : public testing::TestWithParam<const char*> {};

TEST_P(LegQuestions, ALegIsAnsweredByTheProgramsOwn) {
  const RobotModel model = LoadNamedRobot(GetParam()).value();
  const QuestionContext context{6, &model, LegChain(model, 0).num_coordinates()};
  for (int number = 0; number < 5; ++number) {
    const Values in = Drawn("leg_ik", context, number);
    const LegIk ik(model, static_cast<int>(in[0].number()));
    Pose target = Pose::Identity();
    target.translation() = in[1].Vec3();
    if (in.size() > 2)
      target.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(in[2].numbers.data());
    const Result<LegIk::Solution> solved = ik.Solve(target);
    ASSERT_TRUE(solved.ok()) << solved.failure().message;
    const VectorX& q = solved->joints;
    const QuestionValue answer = Answer({static_cast<int>(q.size())}, {q.data(), q.data() + q.size()});
    EXPECT_LT(ErrorOf("leg_ik", context, in, answer), 1e-6);
    QuestionValue off = answer;
    off.numbers[0] += 0.1;
    EXPECT_GT(ErrorOf("leg_ik", context, in, off), 1e-3);
    const Vector3 p = ik.FootPose(q).translation();
    EXPECT_LT(ErrorOf("leg_fk", context, {in[0], {"joints_rad", answer.shape, answer.numbers}},
                      Answer({3}, {p.x(), p.y(), p.z()})),
              1e-12);
    EXPECT_EQ(in[0].word, LegChain(model, static_cast<int>(in[0].number())).foot_name);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, LegQuestions, testing::Values("a1", "nao"));

}  // namespace
}  // namespace gaitwright
