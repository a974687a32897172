// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/ik/leg_chain.h"
#include "kinematics/ik/leg_ik.h"
#include "kinematics/model/load_robot.h"
#include "tests/workflows/grade/asked_questions.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

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

/// A joint beyond its limit gives an error as large as the violation, even if the foot pose is right.
TEST_P(LegQuestions, AJointBeyondItsLimitIsAnError) {
  const RobotModel model = LoadNamedRobot(GetParam()).value();
  const LegChain chain(model, 0);
  const QuestionContext context{6, &model, chain.num_coordinates()};
  Values in = Drawn("leg_ik", context);
  VectorX joints = 0.5 * (chain.lower + chain.upper);
  joints[0] = chain.upper[0] + 0.25;
  const Pose reached = chain.FootPose(joints);
  in[0].numbers = {0.0};
  for (int i = 0; i < 3; ++i) in[1].numbers[static_cast<std::size_t>(i)] = reached.translation()[i];
  if (in.size() > 2) {
    for (int i = 0; i < 9; ++i) in[2].numbers[static_cast<std::size_t>(i)] = reached.linear()(i / 3, i % 3);
  }
  const QuestionValue answer =
      Answer({static_cast<int>(joints.size())}, {joints.data(), joints.data() + joints.size()});
  EXPECT_NEAR(ErrorOf("leg_ik", context, in, answer), 0.25, 1e-6);
  QuestionValue wild = answer;
  wild.numbers[1] = 1e3;
  EXPECT_THROW(ErrorOf("leg_ik", context, in, wild), InvalidArgument) << "no angle of a joint";
  EXPECT_THROW(ErrorOf("leg_ik", context, in, Answer({1}, {0.0})), InvalidArgument);
}

INSTANTIATE_TEST_SUITE_P(Robots, LegQuestions, testing::Values("a1", "nao"));

}  // namespace
}  // namespace gaitwright
