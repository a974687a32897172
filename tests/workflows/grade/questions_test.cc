// SPDX-License-Identifier: BSD-3-Clause
// Each question is compared with closed forms that are derived independently here.
#include "workflows/grade/questions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/workflows/grade/asked_questions.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

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

TEST(Questions, NothingIsRightWhereTheAnswerIsNoNumber) {
  const Values in = {{"com_m", {3}, {0, 0, 1}}, {"velocity_m_s", {3}, {1, 0, 0}}, {"com_height_m", {}, {-1.0}}};
  EXPECT_TRUE(std::isinf(ErrorOf("dcm", {6}, in, Answer({2}, {42, 42}))));
}

/// Integrates the differential equation in small steps.
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

}  // namespace
}  // namespace gaitwright
