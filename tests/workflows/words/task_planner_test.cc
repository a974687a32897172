// SPDX-License-Identifier: BSD-3-Clause
// Postures and gestures as plans: audited, played and scored.
#include <gtest/gtest.h>

#include "tests/workflows/words/told_tasks.h"
#include "workflows/words/task_planner_internal.h"

namespace gaitwright {
namespace {

using tasks_in_words::Do, tasks_in_words::Planned;

class Quadruped : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Robots, Quadruped, testing::Values("a1", "go1", "laikago", "mini_cheetah"),
                         [](const auto& robot) { return robot.param; });

/// Each phase ends on its measured condition, and the final ZMP is at its planned position.
void ExpectStandsUpFromLyingInPhases(const RobotModel& model) {
  const Done done = DoneInWords(model, "stand up", FlatTerrain());
  const PlaybackLog& log = done.played.log;
  ASSERT_EQ(log.gates.size(), 4U);
  const std::vector<std::string> phases = {"init", "lift front", "lift rear", "balance"};
  for (std::size_t k = 0; k < phases.size(); ++k) {
    EXPECT_EQ(log.gates[k].phase, phases[k]);
    EXPECT_TRUE(log.gates[k].met) << phases[k];
  }
  const double error_m = ZmpErrorAtEnd(done);
  EXPECT_LT(error_m, 0.012);
  testing::Test::RecordProperty("zmp_error_mm", std::to_string(1e3 * error_m));
}

TEST_P(Quadruped, StandsUpFromLyingInPhases) { ExpectStandsUpFromLyingInPhases(LoadNamedRobot(GetParam()).value()); }

TEST_P(Quadruped, StandsUpFromLyingInPhasesFromItsUrdfAlone) {
  ExpectStandsUpFromLyingInPhases(LoadRobotFromText(LoadNamedRobot(GetParam()).value().urdf_text, "").value());
}

TEST_P(Quadruped, DoesWhatQuadrupedsDo) {
  const Done done =
      Do(GetParam(), "lie down, stand up, sit for 1 second, stand up, squat, bow, nod, and brace yourself");
  EXPECT_EQ(GaitNames(done.planned.plan.parts),
            "lie_down, init, lift front, lift rear, balance, sit, stand, stand_up, squat, bow, nod, brace");
}

TEST(Biped, BalancesOnEachFoot) {
  for (const char* foot : {"left", "right"}) {
    const Done done = Do("nao", std::string("stand on your ") + foot + " foot for 2 seconds");
    ASSERT_EQ(done.planned.plan.swings.size(), 1U);
  }
}

class WithArms : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Robots, WithArms, testing::Values("nao", "h1", "humanoid"),
                         [](const auto& robot) { return robot.param; });

TEST_P(WithArms, GesturesSquatsAndBows) {
  Do(GetParam(), "raise both arms, lower them, wave, squat while waving with your left hand, bow, and brace yourself");
}

TEST(Tasks, TooLargeValuesAreRefusedWithTheLargestAcceptedOne) {
  const Result<PlannedTasks> deep = Planned("nao", "squat 30 cm", FlatTerrain());
  ASSERT_FALSE(deep.ok());
  EXPECT_EQ(deep.failure().kind, FailureKind::kInfeasible);
  EXPECT_NE(deep.failure().message.find("task 1, 'squat 30 cm'"), std::string::npos);
  ASSERT_FALSE(deep.failure().suggestions.empty());
  EXPECT_NE(deep.failure().suggestions[0].text.find("the largest depth_m"), std::string::npos)
      << deep.failure().suggestions[0].text;
}

/// The largest bow that the suggestion names can be planned.
TEST(Tasks, ABowTooDeepIsRefusedWithTheRange) {
  const Result<PlannedTasks> deep = Planned("a1", "bow 60 degrees", FlatTerrain());
  ASSERT_FALSE(deep.ok());
  ASSERT_EQ(deep.failure().suggestions.size(), 1U);
  const std::string hint = deep.failure().suggestions[0].text, begin = "a bow of 1 to ";
  ASSERT_EQ(hint.find(begin), 0U) << hint;
  const std::string most = hint.substr(begin.size(), hint.find(" degrees") - begin.size());
  EXPECT_TRUE(Planned("a1", "bow " + most + " degrees", FlatTerrain()).ok()) << most;
}

/// Raising an arm on one foot makes the body lean farther than the ankle can turn.
TEST(PlanTasks, AMotionThatFailsAnAuditCheckIsRefusedWithItsTask) {
  const Result<PlannedTasks> planned =
      Planned("nao", "squat, then balance on the left foot for 3 seconds while raising the right arm", FlatTerrain());
  ASSERT_FALSE(planned.ok());
  const Failure& failure = planned.failure();
  EXPECT_EQ(failure.code, FailureCode::kJointPosition);
  for (const char* text : {"task 2", "balance", "RAnkleRoll"})
    EXPECT_NE(failure.message.find(text), std::string::npos) << failure.message;
  ASSERT_EQ(failure.suggestions.size(), 1U);
  EXPECT_NE(failure.suggestions[0].text.find("'then' instead of 'while'"), std::string::npos);
}

/// An equal posture needs no motion: the second task starts at the end of the first.
TEST(TaskPlanner, TasksEndOneAfterTheOther) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const Terrain ground = FlatTerrain();
  const TaskOptions options;
  tasks::TaskPlanner planner(a1, a1, ground, options);
  Task stand;
  stand.action = "stand";
  stand.parameters["duration_s"] = 0.5;
  for (int k = 0; k < 2; ++k) {
    const auto failure = planner.Add(stand);
    ASSERT_FALSE(failure) << failure->message;
  }
  ASSERT_EQ(planner.ends_s().size(), 2U);
  EXPECT_GE(planner.ends_s()[0], 0.5);
  EXPECT_NEAR(planner.ends_s()[1], 2.0 * planner.ends_s()[0], 0.02);
  EXPECT_TRUE(planner.notes().empty());
  const Result<MotionPlan> plan = planner.Finish();
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  EXPECT_NEAR(plan->whole_body.end_s(), planner.ends_s()[1], 0.02);
  const VectorX &first = plan->whole_body.q.front(), &last = plan->whole_body.q.back();
  EXPECT_LT((last - first).cwiseAbs().maxCoeff(), 1e-3) << "it stands as it stood";
}

}  // namespace
}  // namespace gaitwright
