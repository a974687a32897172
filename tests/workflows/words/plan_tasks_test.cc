// SPDX-License-Identifier: BSD-3-Clause
// The repertoire as plans: audited, played and scored.
#include "workflows/words/plan_tasks.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "planning/plan/plan_json.h"
#include "tests/workflows/words/told_tasks.h"
#include "workflows/words/task_scores.h"

namespace gaitwright {
namespace {

using tasks_in_words::Do, tasks_in_words::ExpectSameTasks, tasks_in_words::Planned, tasks_in_words::WithMarkers;

TEST(Biped, NaoDoesFiveThingsInBothLanguages) {
  const std::string english =
      "Walk forward two steps, raise the right arm, turn left 45 degrees, wave with the left hand and bow.";
  ExpectSameTasks(LoadNamedRobot("nao").value(), WithMarkers(), english,
                  "先向前走两步，举起右手，再向左转四十五度，挥挥左手，最后鞠躬。");
  Do("nao", english);
}

TEST(Quadrupeds, A1DoesFiveThingsInBothLanguages) {
  const std::string english = "Get up, trot half a metre, turn right, bow twice, and then sit down.";
  ExpectSameTasks(LoadNamedRobot("a1").value(), WithMarkers(), english, "起来，小跑半米，向右转，鞠躬两次，然后坐下。");
  Do("a1", english);
}

TEST(Tasks, AreScoredByWhatWasDone) {
  const Done done = Do("a1", "bow, then nod, then squat");
  const TaskScores all = ScoreTasks(done.planned, done.played);
  EXPECT_EQ(all.done, 3);
  EXPECT_EQ(all.asked, 3);
  ASSERT_TRUE(all.stability_m && all.jerk_rad_s3);
  EXPECT_GT(*all.stability_m, 0.0);
  // Lower bound: the energy to raise the body from the squat.
  const auto& com = done.planned.plan.centroidal.p_WC;
  double lowest = com.back().z();
  for (const Vector3& p : com) lowest = std::min(lowest, p.z());
  EXPECT_GT(all.energy_j, 0.8 * done.planned.robot.weight_n() * (com.back().z() - lowest));
  PlayRequest pushed;
  pushed.play.push_force_W = {0.0, 1000.0, 0.0};
  pushed.play.push_at_s = 0.5 * (done.planned.task_ends_s[0] + done.planned.task_ends_s[1]);
  const PlayedWalk fell = *PlayWalk(done.planned.robot, done.planned.plan, pushed);
  ASSERT_FALSE(fell.report.pass);
  EXPECT_EQ(ScoreTasks(done.planned, fell).done, 1) << TaskScoresText(ScoreTasks(done.planned, fell));
}

TEST(Tasks, TheSameTasksGiveTheSamePlan) {
  const auto plan = [] { return PlanToJson(Planned("nao", "wave, then walk two steps", FlatTerrain())->plan); };
  EXPECT_EQ(plan(), plan());
}

TEST(Tasks, APlanThatLiesIsReadBackWhole) {
  const Result<PlannedTasks> planned = Planned("a1", "stand up", FlatTerrain());
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  const Result<MotionPlan> read = PlanFromJson(PlanToJson(planned->plan), "plan");
  ASSERT_TRUE(read.ok()) << read.failure().message;
  EXPECT_EQ(PlanToJson(*read), PlanToJson(planned->plan));
  EXPECT_EQ(read->gates, planned->plan.gates);
  const Result<RobotModel> robot = RobotOf(*read);
  ASSERT_TRUE(robot.ok()) << robot.failure().message;
  EXPECT_EQ(robot->feet.size(), 5U);
}

}  // namespace
}  // namespace gaitwright
