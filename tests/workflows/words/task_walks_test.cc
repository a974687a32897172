// SPDX-License-Identifier: BSD-3-Clause
// Walks, turns and places as plans: audited, played and scored.
#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/body_tree.h"
#include "planning/plan/built_in_terrain.h"
#include "tests/workflows/words/told_tasks.h"
#include "workflows/words/plan_tasks_internal.h"

namespace gaitwright {
namespace {

using tasks_in_words::Do, tasks_in_words::ExpectSameTasks, tasks_in_words::Planned, tasks_in_words::WithMarkers;

class WalkingQuadruped : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Robots, WalkingQuadruped, testing::Values("a1", "go1", "laikago", "mini_cheetah"),
                         [](const auto& robot) { return robot.param; });

TEST_P(WalkingQuadruped, WalksBetweenOtherThings) {
  Do(GetParam(), "stand up, walk forward half a metre, turn left, step right 20 cm, then lie down");
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

/// With all feet on one step, the next task continues from there, whatever the ground below.
TEST(OnStairs, GoesOnWhereAllFeetAreOnOneLevel) {
  const auto stairs = [](const std::string& parameters, const RobotModel& model) {
    return MakeTerrain("stairs:" + parameters, ScaleOf(model)).value();
  };
  const RobotModel nao = LoadNamedRobot("nao").value(), a1 = LoadNamedRobot("a1").value();
  const Done up = DoneInWords(
      nao, "walk to the first step, raise the right arm, walk to the second step, balance on your left foot, and squat",
      stairs("tread_m=0.2", nao));
  const VectorX standing = StandingConfiguration(nao), &end = up.played.log.samples.back().q;
  EXPECT_NEAR(up.planned.plan.footsteps.footholds.back().X_WF.translation().z(), 0.04, 1e-6) << "two steps of 2 cm";
  EXPECT_NEAR(end[2], 0.04 + standing[2], 0.15 * standing[2]) << "the body may be lower than in standing";
  const Done landing =
      DoneInWords(a1, "walk to the third step, bow, turn left, then lie down", stairs("landing_m=2", a1));
  for (const Foothold& foothold : landing.planned.plan.footsteps.footholds) {
    const bool later = foothold.touchdown_s > landing.planned.task_ends_s.front();
    EXPECT_TRUE(!later || foothold.patch == 3) << foothold.touchdown_s;
  }
  EXPECT_GT(landing.planned.plan.footsteps.footholds.back().foot, 3) << "it lies on the landing";
}

/// Up to the landing, and down on the side that the robot faces: forward, or back after a turn.
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

/// The largest speed of the joints outside the legs, from the positions of two rows.
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

/// With a raised arm, the body sways farther than NAO's ankles can roll, unless the ZMP stays farther inward.
TEST(Tasks, AWalkIsMadeToGiveAGestureRoom) { Do("nao", "walk four steps while raising your right arm"); }

TEST(Tasks, AGestureThatAWalkHasNoRoomForIsRefused) {
  const Result<PlannedTasks> planned = Planned("nao", "turn left while raising both arms", FlatTerrain());
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().code, FailureCode::kJointTorque);
  EXPECT_NE(planned.failure().message.find("KneePitch"), std::string::npos) << planned.failure().message;
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

TEST(Tasks, AWalkTooFastOrWithTooLongStepsIsRefusedWithASuggestion) {
  struct Case {
    const char *robot, *walk, *too_much, *more;
  };
  for (const Case& c : {Case{"nao", "walk 60 cm ", "at 3 m/s", "' or slower"},
                        Case{"a1", "walk 4 ", "steps of 0.9 m", "' or shorter"}}) {
    const Result<PlannedTasks> fast = Planned(c.robot, std::string(c.walk) + c.too_much, FlatTerrain());
    ASSERT_FALSE(fast.ok()) << c.robot;
    const std::string &hint = fast.failure().suggestions.at(0).text, say = "say '";
    ASSERT_TRUE(hint.starts_with(say) && hint.ends_with(c.more)) << hint;
    const std::string said = hint.substr(say.size(), hint.find('\'', say.size()) - say.size());
    EXPECT_TRUE(Planned(c.robot, c.walk + said, FlatTerrain()).ok()) << c.robot << ": " << said;
  }
}

/// Leg joints keep their standing positions; other joints stay at their last positions.
TEST(TaskWalks, APosedRobotStandsWithItsArmsElsewhere) {
  const RobotModel nao = LoadNamedRobot("nao").value();
  const VectorX moved = nao.standing_joints + VectorX::Constant(nao.num_dofs(), 0.1);
  const RobotModel posed = tasks::Posed(nao, moved);
  const std::vector<bool> of_leg = DofsOfLegs(nao);
  int others = 0;
  for (int dof = 0; dof < nao.num_dofs(); ++dof) {
    const bool leg = of_leg[static_cast<std::size_t>(dof)];
    EXPECT_EQ(posed.standing_joints[dof], leg ? nao.standing_joints[dof] : moved[dof]);
    others += leg ? 0 : 1;
  }
  EXPECT_GT(others, 4);
}

}  // namespace
}  // namespace gaitwright
