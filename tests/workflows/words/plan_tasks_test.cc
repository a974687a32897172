// SPDX-License-Identifier: BSD-3-Clause
// The repertoire as plans: audited, played and scored.
#include "workflows/words/plan_tasks.h"

#include <gtest/gtest.h>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/load_robot.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/plan_json.h"
#include "tests/workflows/words/done_in_words.h"
#include "workflows/words/places.h"
#include "workflows/words/task_scores.h"
#include "workflows/words/understand.h"

namespace gaitwright {
namespace {

Terrain WithMarkers() {
  Terrain terrain = FlatTerrain();
  terrain.markers = {{"red marker", {0.5, 0.0}}, {"door", {0.4, 0.5}}};
  return terrain;
}

Result<PlannedTasks> Planned(const std::string& robot, const std::string& text, const Terrain& terrain) {
  return PlannedInWords(LoadNamedRobot(robot).value(), text, terrain);
}

Done Do(const std::string& robot, const std::string& text) {
  return DoneInWords(LoadNamedRobot(robot).value(), text, WithMarkers());
}

/// Two instructions ask for the same, so that it is enough to plan and play one of them.
void ExpectSameTasks(const RobotModel& model, const Terrain& terrain, const std::string& one,
                     const std::string& other) {
  TaskScope scope = ScopeOf(model);
  scope.places = PlacesOf(terrain);
  const auto tasks = [&](const std::string& text) {
    std::vector<Task> read = words::UnderstandWords(text, scope).value().tasks;
    for (Task& task : read) task.words.clear();
    return read;
  };
  EXPECT_FALSE(tasks(one).empty());
  EXPECT_TRUE(tasks(one) == tasks(other)) << one << ' ' << other;
}

class Quadruped : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Robots, Quadruped, testing::Values("a1", "go1", "laikago", "mini_cheetah"),
                         [](const auto& robot) { return robot.param; });

/// Each phase ends when it is measured to be done, and the ZMP is where it should be at the end.
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

TEST_P(Quadruped, WalksBetweenOtherThings) {
  Do(GetParam(), "stand up, walk forward half a metre, turn left, step right 20 cm, then lie down");
}

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

TEST(Quadrupeds, A1WalksToAStepOfStairs) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const Terrain stairs = MakeTerrain("stairs", ScaleOf(a1)).value();
  for (const char* text : {"walk to the second step", "走到第二级台阶"}) {
    const Done done = DoneInWords(a1, text, stairs);
    const PlanarPose there = done.planned.plan.goal;
    const GroundPoint ground = GroundAt(stairs, {there.x_m, there.y_m});
    EXPECT_EQ(stairs.patches[static_cast<std::size_t>(ground.patch)].name, "step 2") << text;
  }
}

TEST(Tasks, AreScoredByWhatWasDone) {
  const Done done = Do("a1", "bow, then nod, then squat");
  const TaskScores all = ScoreTasks(done.planned, done.played);
  EXPECT_EQ(all.done, 3);
  EXPECT_EQ(all.asked, 3);
  ASSERT_TRUE(all.stability_m && all.jerk_rad_s3);
  EXPECT_GT(*all.stability_m, 0.0);
  // What it takes at the least: to raise the body from the squat.
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

/// All feet on one step: whatever the ground below is like, it goes on from there.
TEST(OnStairs, GoesOnWhereAllFeetAreOnOneLevel) {
  const auto stairs = [](const std::string& parameters, const RobotModel& model) {
    return MakeTerrain("stairs:" + parameters, ScaleOf(model)).value();
  };
  const RobotModel nao = LoadNamedRobot("nao").value(), a1 = LoadNamedRobot("a1").value();
  const Done up = DoneInWords(
      nao, "walk to the first step, raise the right arm, walk to the second step, balance on your left foot, and squat",
      stairs("tread_m=0.2", nao));
  const VectorX standing = StandingConfiguration(nao), &end = up.played.log.samples.back().q;
  EXPECT_NEAR(end[2], standing[2] + 0.04, 0.01) << "two steps of 2 cm";
  const Done landing =
      DoneInWords(a1, "walk to the third step, bow, turn left, then lie down", stairs("landing_m=2", a1));
  for (const Foothold& foothold : landing.planned.plan.footsteps.footholds) {
    const bool later = foothold.touchdown_s > landing.planned.task_ends_s.front();
    EXPECT_TRUE(!later || foothold.patch == 3) << foothold.touchdown_s;
  }
  EXPECT_GT(landing.planned.plan.footsteps.footholds.back().foot, 3) << "it lies on the landing";
}

/// Up to the landing, and down on the side that the robot faces: ahead, or after a turn the way that it came.
TEST(OnStairs, AreClimbedAndGoneDown) {
  struct Case {
    const char *robot, *text, *patch;
  };
  const RobotModel a1 = LoadNamedRobot("a1").value();
  ExpectSameTasks(a1, MakeTerrain("stairs", ScaleOf(a1)).value(), "climb the stairs", "上楼");
  for (const Case& c :
       {Case{"a1", "climb the stairs", "step 3"}, Case{"a1", "climb the stairs, then go down the stairs", "ground"},
        Case{"a1", "上楼，转身，再下楼", "ground"}}) {
    const RobotModel model = LoadNamedRobot(c.robot).value();
    const Terrain stairs = MakeTerrain("stairs", ScaleOf(model)).value();
    const Done done = DoneInWords(model, c.text, stairs);
    const VectorX& q = done.played.log.samples.back().q;
    EXPECT_EQ(stairs.patches[static_cast<std::size_t>(GroundAt(stairs, {q[0], q[1]}).patch)].name, c.patch) << c.text;
    const auto& footholds = done.planned.plan.footsteps.footholds;
    const auto highest = std::max_element(footholds.begin(), footholds.end(), [](const auto& a, const auto& b) {
      return a.X_WF.translation().z() < b.X_WF.translation().z();
    });
    EXPECT_EQ(stairs.patches[static_cast<std::size_t>(highest->patch)].name, "step 3") << c.text;
  }
}

TEST(Quadrupeds, NothingIsDoneAfterAWalkThatEndsOnTwoSteps) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const Terrain stairs = MakeTerrain("stairs", ScaleOf(a1)).value();
  const Result<PlannedTasks> planned = PlannedInWords(a1, "walk to the second step, then bow", stairs);
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().code, FailureCode::kNotLevel);
  EXPECT_NE(planned.failure().message.find("task 2, 'bow'"), std::string::npos) << planned.failure().message;
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

/// The greatest speed of any joint coordinate outside the legs, by what the positions of two rows say.
double FastestGesture(const RobotModel& model, const MotionPlan& plan) {
  const WholeBodyTrajectory& w = plan.whole_body;
  const std::vector<bool> of_leg = DofsOfLegs(model);
  double fastest = 0.0;
  for (std::size_t k = 1; k < w.q.size(); ++k) {
    for (int d = 0; d < model.num_dofs(); ++d) {
      if (!of_leg[static_cast<std::size_t>(d)])
        fastest = std::max(fastest, std::abs(w.q[k][7 + d] - w.q[k - 1][7 + d]) / w.step_s);
    }
  }
  return fastest;
}

TEST(Tasks, GesturesOfOneWalkFollowEachOther) {
  for (const char* text : {"walk four steps while nodding and waving with your right hand",
                           "squat while raising your right arm and raising your left arm"}) {
    const Done done = Do("nao", text);
    EXPECT_LT(FastestGesture(done.planned.robot, done.planned.plan), 10.0) << text << ": nothing jumps";
  }
}

/// A raised arm has the body sway farther than NAO's ankles roll, unless the ZMP goes less far to the outside.
TEST(Tasks, AWalkIsMadeToGiveAGestureRoom) { Do("nao", "walk four steps while raising your right arm"); }

TEST(Tasks, AGestureThatAWalkHasNoRoomForIsRefused) {
  const Result<PlannedTasks> planned = Planned("nao", "turn left while raising both arms", FlatTerrain());
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().code, FailureCode::kJointPosition);
  EXPECT_NE(planned.failure().message.find("AnkleRoll"), std::string::npos) << planned.failure().message;
  ASSERT_EQ(planned.failure().suggestions.size(), 1U);
  Do("nao", "turn left, then raise both arms");
}

TEST(Tasks, APlaceIsWalkedTo) {
  const Done done = Do("a1", "walk to the red marker, then walk to the door");
  const VectorX& q = done.played.log.samples.back().q;
  EXPECT_LT((Vector2(q[0], q[1]) - Vector2(0.4, 0.5)).norm(), 0.05);
  ASSERT_EQ(done.planned.notes.size(), 1U);
  EXPECT_NE(done.planned.notes[0].find("turns left"), std::string::npos);
}

TEST(Tasks, WhatIsTooMuchIsToldWithTheMostThatIsNot) {
  const Result<PlannedTasks> deep = Planned("nao", "squat 30 cm", FlatTerrain());
  ASSERT_FALSE(deep.ok());
  EXPECT_EQ(deep.failure().kind, FailureKind::kInfeasible);
  EXPECT_NE(deep.failure().message.find("task 1, 'squat 30 cm'"), std::string::npos);
  ASSERT_FALSE(deep.failure().suggestions.empty());
  EXPECT_NE(deep.failure().suggestions[0].text.find("the largest depth_m"), std::string::npos)
      << deep.failure().suggestions[0].text;
}

/// What is told to be possible is.
TEST(Tasks, ABowTooDeepIsToldTheRange) {
  const Result<PlannedTasks> deep = Planned("a1", "bow 60 degrees", FlatTerrain());
  ASSERT_FALSE(deep.ok());
  ASSERT_EQ(deep.failure().suggestions.size(), 1U);
  const std::string hint = deep.failure().suggestions[0].text, begin = "a bow of 1 to ";
  ASSERT_EQ(hint.find(begin), 0U) << hint;
  const std::string most = hint.substr(begin.size(), hint.find(" degrees") - begin.size());
  EXPECT_TRUE(Planned("a1", "bow " + most + " degrees", FlatTerrain()).ok()) << most;
}

TEST(Tasks, AWalkTooFastOrTooLongOfStepIsToldWhatToSay) {
  struct Case {
    const char *robot, *walk, *too_much, *more;
  };
  for (const Case& c : {Case{"nao", "walk 20 cm ", "at 3 m/s", "' or slower"},
                        Case{"a1", "walk 4 ", "steps of 0.9 m", "' or shorter"}}) {
    const Result<PlannedTasks> fast = Planned(c.robot, std::string(c.walk) + c.too_much, FlatTerrain());
    ASSERT_FALSE(fast.ok()) << c.robot;
    const std::string &hint = fast.failure().suggestions.at(0).text, say = "say '";
    ASSERT_TRUE(hint.starts_with(say) && hint.ends_with(c.more)) << hint;
    const std::string said = hint.substr(say.size(), hint.find('\'', say.size()) - say.size());
    EXPECT_TRUE(Planned(c.robot, c.walk + said, FlatTerrain()).ok()) << c.robot << ": " << said;
  }
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

/// An arm that goes up while one foot bears all has the body lean farther than the ankle turns.
TEST(PlanTasks, AMotionThatBreaksALawOfTheAuditIsRefusedByTheTaskThatDoesIt) {
  const Result<PlannedTasks> planned =
      Planned("nao", "squat, then balance on the left foot for 3 seconds while raising the right arm", FlatTerrain());
  ASSERT_FALSE(planned.ok());
  const Failure& failure = planned.failure();
  EXPECT_EQ(failure.code, FailureCode::kJointPosition);
  for (const char* told : {"task 2", "balance", "RAnkleRoll"})
    EXPECT_NE(failure.message.find(told), std::string::npos) << failure.message;
  ASSERT_EQ(failure.suggestions.size(), 1U);
  EXPECT_NE(failure.suggestions[0].text.find("'then' instead of 'while'"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
