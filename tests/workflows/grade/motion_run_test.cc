// SPDX-License-Identifier: BSD-3-Clause
// Runs drawn from a rubric, and goals of commands.
#include "workflows/grade/motion_run.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

const RobotModel& RunModel() {
  static const RobotModel model = LoadNamedRobot("a1").value();
  return model;
}

RubricPart DrawnPart() {
  RubricPart part;
  part.name = "walks";
  part.motion.robot = "a1";
  part.motion.gait = "trot";
  part.motion.command = {{"speed_m_s", {0.2, 0.4}}, {"distance_m", {0.5, 0.5}}};
  part.motion.play_numbers = {{"play.mass_scale", {0.9, 1.1}}};
  part.motion.runs = 12;
  return part;
}

TEST(DrawRuns, AreTheSameForOneSeedAndOthersForAnother) {
  const auto speeds = [](std::uint64_t seed) {
    std::vector<double> drawn;
    for (const MotionRun& run : DrawRuns(DrawnPart(), RunModel(), seed)) drawn.push_back(run.walk.command.speed_m_s);
    return drawn;
  };
  EXPECT_EQ(speeds(7), speeds(7));
  EXPECT_NE(speeds(7), speeds(8));
}

// The values drawn for a run do not depend on the number of runs.
TEST(DrawRuns, ARunDoesNotChangeWithTheNumberOfRuns) {
  RubricPart few = DrawnPart();
  few.motion.runs = 2;
  const auto some = DrawRuns(few, RunModel(), 7), all = DrawRuns(DrawnPart(), RunModel(), 7);
  ASSERT_EQ(some.size(), 2U);
  ASSERT_EQ(all.size(), 12U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(some[k].walk.command, all[k].walk.command);
    EXPECT_EQ(some[k].seed, all[k].seed);
  }
}

TEST(DrawRuns, NumbersAreInTheirRangesOnAGrid) {
  double least = 1.0, most = 0.0;
  for (const MotionRun& run : DrawRuns(DrawnPart(), RunModel(), 3)) {
    const double speed = run.walk.command.speed_m_s, scale = run.play.play.world.mass_scale;
    EXPECT_GE(speed, 0.2);
    EXPECT_LE(speed, 0.4);
    EXPECT_NEAR(speed * 1e4, std::round(speed * 1e4), 1e-6) << "what the title tells";
    EXPECT_GE(scale, 0.9);
    EXPECT_LE(scale, 1.1);
    EXPECT_EQ(run.walk.command.distance_m, 0.5) << "not drawn";
    EXPECT_EQ(run.walk.gait, "trot");
    least = std::min(least, speed);
    most = std::max(most, speed);
  }
  EXPECT_GT(most - least, 0.05) << "twelve draws differ";
}

TEST(DrawRuns, TheTitleTellsWhatWasDrawn) {
  RubricPart part = DrawnPart();
  const auto runs = DrawRuns(part, RunModel(), 3);
  EXPECT_EQ(runs[1].title.find("run 2: flat, speed_m_s="), 0U) << runs[1].title;
  EXPECT_NE(runs[1].title.find("play.mass_scale="), std::string::npos);
  EXPECT_EQ(runs[1].title.find("distance_m"), std::string::npos) << "it is the same in each run";
  part.motion.runs = 1;
  EXPECT_EQ(DrawRuns(part, RunModel(), 3)[0].title.find("flat, "), 0U) << "a single run has no number";
}

TEST(DrawRuns, AWrongRubricIsNamedByItsPart) {
  RubricPart part = DrawnPart();
  part.motion.terrain = "nowhere";
  try {
    DrawRuns(part, RunModel(), 1);
    ADD_FAILURE() << "a terrain that does not exist was taken";
  } catch (const InvalidArgument& error) {
    EXPECT_EQ(std::string(error.what()).find("part 'walks' of the rubric: "), 0U) << error.what();
  }
  part = DrawnPart();
  part.motion.play_numbers = {{"play.mass_scale", {50.0, 50.0}}};
  EXPECT_THROW(DrawRuns(part, RunModel(), 1), InvalidArgument);
}

TEST(GoalOf, AStraightWalkEndsInItsDirection) {
  WalkCommand command;
  command.distance_m = 2.0;
  command.speed_m_s = 0.3;
  command.lateral_speed_m_s = 0.4;
  const PlanarPose goal = GoalOf(RunModel(), command);
  EXPECT_NEAR(goal.x_m, 1.2, 1e-12);
  EXPECT_NEAR(goal.y_m, 1.6, 1e-12);
  EXPECT_EQ(goal.yaw_rad, 0.0);
}

// At 1 m/s and pi rad/s, half a circle of radius 1 / pi is 1 m long: it ends 2 / pi to the left, with the opposite
// heading.
TEST(GoalOf, AnArcEndsOnItsCircle) {
  WalkCommand command;
  command.distance_m = 1.0;
  command.speed_m_s = 1.0;
  command.yaw_rate_rad_s = M_PI;
  const PlanarPose goal = GoalOf(RunModel(), command);
  EXPECT_NEAR(goal.x_m, 0.0, 1e-12);
  EXPECT_NEAR(goal.y_m, 2.0 / M_PI, 1e-12);
  EXPECT_NEAR(goal.yaw_rad, M_PI, 1e-12);
}

TEST(GoalOf, AGoalIsItselfAndStepsHaveNone) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kGoal;
  command.goal_x_m = 1.0;
  command.goal_y_m = -0.5;
  command.goal_yaw_rad = 0.25;
  EXPECT_EQ(GoalOf(RunModel(), command), (PlanarPose{1.0, -0.5, 0.25}));
  for (const auto extent : {WalkCommand::Extent::kSteps, WalkCommand::Extent::kDuration}) {
    command.extent = extent;
    EXPECT_THROW(GoalOf(RunModel(), command), InvalidArgument);
  }
}

}  // namespace
}  // namespace gaitwright
