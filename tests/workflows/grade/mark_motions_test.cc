// SPDX-License-Identifier: BSD-3-Clause
// Plans, motions, parameters, planners and controllers: good, half good and bad ones, and ones that are not what they
// say.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kinematics/model/load_robot.h"
#include "planning/plan/plan_json.h"
#include "tests/workflows/grade/made_class.h"
#include "workflows/exchange/export_csv.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

const std::string kChecks =
    "checks: [{measure: pass, points: 5}, {measure: audit, points: 2}, {measure: goal_error_m, points: 3, full_at: "
    "0.05, "
    "none_at: 0.2}]}\n";
const std::string kTrot =
    "{name: trot, kind: plan, file: trot.json, points: 10, robot: a1, command: {speed_m_s: 0.3, distance_m: 0.3}, " +
    kChecks;

MotionPlan Trot(double speed_m_s, double distance_m, const std::string& robot = "a1") {
  WalkRequest request;
  request.command.speed_m_s = speed_m_s;
  request.command.distance_m = distance_m;
  const Result<PlannedWalk> planned = PlanWalk(LoadNamedRobot(robot).value(), request);
  if (!planned) throw std::logic_error(planned.failure().message);
  return planned->motion.plan;
}

/// The one that is asked for, made once.
const MotionPlan& GoodTrot() {
  static const MotionPlan plan = Trot(0.3, 0.3);
  return plan;
}

std::string GoodCsv() {
  const RobotModel model = LoadNamedRobot("a1").value();
  return MotionCsv(model, RowsOfPlan(model, GoodTrot(), UsualRate(GoodTrot())));
}

class MarkPlan : public MadeClass {
 protected:
  PartMark MarkOfPlan(const MotionPlan& plan) const { return MarkOfText(PlanToJson(plan)); }
  PartMark MarkOfText(const std::string& text) const {
    HandIn("ada", "trot.json", text);
    return Mark(kTrot, "ada");
  }
};

TEST_F(MarkPlan, TheOneThatIsAskedForGetsAllPoints) {
  const PartMark mark = MarkOfPlan(GoodTrot());
  EXPECT_EQ(mark.points, 10.0) << (mark.reasons.empty() ? "" : mark.reasons.front());
  ASSERT_EQ(mark.pages.size(), 1U);
  EXPECT_NE(mark.pages.front().html.find("<!DOCTYPE html>"), std::string::npos);
}

TEST_F(MarkPlan, OneThatBreaksLawsOrFallsLosesWhatThatIsWorth) {
  MotionPlan late = GoodTrot();
  for (VectorX& tau : late.whole_body.tau) tau *= 1.3;  // columns that disagree
  const PartMark mark = MarkOfPlan(late);
  EXPECT_EQ(mark.checks[1].points, 0.0);
  EXPECT_LT(mark.points, 10.0);
  EXPECT_NE(mark.reasons.back().find("the audit fails"), std::string::npos) << mark.reasons.back();
}

TEST_F(MarkPlan, OneForAnotherRobotGroundOrCommandGetsNothing) {
  ExpectNothing(MarkOfPlan(Trot(0.1, 0.1, "nao")), {"for robot 'nao'", "needs 'a1'"});
  ExpectNothing(MarkOfPlan(Trot(0.2, 0.3)), {"another command: speed_m_s is 0.2, not 0.3"});
  ExpectNothing(MarkOfPlan(Trot(0.3, 0.2)), {"another command: distance_m is 0.2, not 0.3"});
  MotionPlan ahead = GoodTrot();  // past what is to be walked over, if there were any
  for (VectorX& q : ahead.whole_body.q) q[0] += 3.0;
  ExpectNothing(MarkOfPlan(ahead), {"begins at x 3.00 m", "at the origin"});
  MotionPlan elsewhere = GoodTrot();
  elsewhere.terrain = FlatTerrain(2.0);
  ExpectNothing(MarkOfPlan(elsewhere), {"for ground 'flat'", "but this part needs"});
}

TEST_F(MarkPlan, OneThatSaysItIsAnotherIsFoundOut) {
  MotionPlan forged = Trot(0.1, 0.1, "nao");
  forged.robot = GoodTrot().robot;
  forged.robot_hash = GoodTrot().robot_hash;
  forged.parts = GoodTrot().parts;
  EXPECT_EQ(MarkOfPlan(forged).points, 0.0);
  MotionPlan near = Trot(0.3, 0.1);  // a shorter walk that says it is the whole one
  near.parts.front().command.distance_m = 0.3;
  const PartMark mark = MarkOfPlan(near);
  EXPECT_EQ(mark.checks[2].points, 0.0);
  EXPECT_NEAR(mark.checks[2].value.value_or(0.0), 0.2, 0.03);
  MotionPlan slow = Trot(0.05, 0.3);
  slow.parts.front().command.speed_m_s = 0.3;
  ExpectNothing(MarkOfPlan(slow), {"the plan takes", "at the commanded speed, at most 5.2 s are accepted"});
}

TEST_F(MarkPlan, WhatIsNoPlanGetsNothing) {
  const std::string whole = PlanToJson(GoodTrot());
  ExpectNothing(MarkOfText(whole.substr(0, whole.size() / 2)), {"'trot.json'"});
  ExpectNothing(MarkOfText("{\"verdict\": \"pass\", \"score\": 100}"), {"'trot.json'"});
  ExpectNothing(MarkOfText(std::string(100000, '[')), {"'trot.json'"});
  auto json = nlohmann::ordered_json::parse(whole);
  json["whole_body"]["q"][0][0] = nullptr;
  ExpectNothing(MarkOfText(json.dump()), {"'trot.json'"});
}

TEST_F(MarkPlan, OneThatLastsTooLongIsNotPlayed) {
  HandIn("ada", "trot.json", PlanToJson(GoodTrot()));
  std::string part = kTrot;
  part.insert(1, "limits: {motion_s: 0.5}, ");
  ExpectNothing(Mark(part, "ada"), {"the motion lasts 3.5 s; at most 0.5 s"});
}

using MarkMotion = MadeClass;

TEST_F(MarkMotion, ATableOfJointsIsPlayedLikeAPlan) {
  const std::string part =
      "{name: csv, kind: motion, file: m.csv, points: 10, robot: a1, command: {goal_x_m: 0.3}, " + kChecks;
  HandIn("ada", "m.csv", GoodCsv());
  const PartMark mark = Mark(part, "ada");
  EXPECT_EQ(mark.points, 10.0) << (mark.reasons.empty() ? "" : mark.reasons.front());
  HandIn("eve", "m.csv", "time_s,verdict\n0,1\n1,1\n");
  ExpectNothing(Mark(part, "eve"), {"m.csv"});
  HandIn("bob", "m.csv", "time_s,q_FL_hip_joint_rad\n0,nan\n");
  ExpectNothing(Mark(part, "bob"), {"m.csv"});
}

const std::string kTune =
    "{name: tune, kind: parameters, file: t.yaml, points: 4, robot: a1, gait: trot, command: {speed_m_s: [0.2, 0.4], "
    "distance_m: "
    "0.3}, runs: 2, trials: 2, options: [gait.cycle_s, swing.*], checks: [{measure: pass, points: 2, none_at: 0}, "
    "{measure: survival, "
    "points: 2, none_at: 0}]}\n";

TEST_F(MarkMotion, ParametersArePlannedWithAndTried) {
  HandIn("ada", "t.yaml", "gait.cycle_s: 0.5\nswing.height_m: 0.06\n");
  const PartMark mark = Mark(kTune, "ada");
  EXPECT_EQ(mark.points, 4.0) << (mark.reasons.empty() ? "" : mark.reasons.front());
  EXPECT_EQ(mark.pages.size(), 2U);
  HandIn("eve", "t.yaml", "play.friction: 3\n");
  ExpectNothing(Mark(kTune, "eve"), {"the option 'play.friction' must not be set"});
  HandIn("eve", "t.yaml", "gait.duty_factor: 0.6\n");
  ExpectNothing(Mark(kTune, "eve"), {"the option 'gait.duty_factor' must not be set"});
  HandIn("eve", "t.yaml", "gait.cicle_s: 0.6\n");
  ExpectNothing(Mark(kTune, "eve"), {"'t.yaml', line 1", "'gait.cycle_s'"});
  HandIn("eve", "t.yaml", "swing.height_m: .nan\n");
  ExpectNothing(Mark(kTune, "eve"), {"'t.yaml', line 1"});
}

class MarkCodeOfMotions : public MadeClass {
 protected:
  void SetUp() override {
    if (!CanRunCode(true)) GTEST_SKIP() << WhyNotConfined();
  }
};

const std::string kSteps =
    "{name: steps, kind: planner, file: work.py, points: 4, robot: nao, command: {goal_x_m: [0.08, 0.12]}, "
    "checks: [{measure: pass, points: 3}, {measure: goal_error_m, points: 1, full_at: 0.02}]}\n";

/// A planner that goes a share of the way.
std::string Planner(double share) {
  return fmt::format(
      "import gaitwright as gw\n"
      "def plan_steps(robot, terrain, goal):\n"
      "    assert terrain.ground_at(0.0, 0.0) is not None\n"
      "    standing = {{f: gw.RobotState(robot).contact_frame(f)[:2, 3] for f in robot.feet[:2]}}\n"
      "    way = goal[0] * {}\n"
      "    places = [min(0.04 * (i + 1), way) for i in range(int(way / 0.04 + 0.999))]\n"
      "    for i, x in enumerate(places + places[-1:]):\n"
      "        foot = robot.feet[i % 2]\n"
      "        yield foot, standing[foot][0] + x, standing[foot][1], 0.0\n",
      share);
}

TEST_F(MarkCodeOfMotions, APlannerIsWalkedOver) {
  const PartMark good = MarkCode(kSteps, Planner(1.0));
  EXPECT_EQ(good.points, 4.0) << (good.reasons.empty() ? "" : good.reasons.front());
  const PartMark half = MarkCode(kSteps, Planner(0.5));
  EXPECT_EQ(half.checks[1].points, 0.0);
  EXPECT_GT(half.checks[1].value.value_or(0.0), 0.03);
}

/// 12 cm are asked for; from 2 to 10 cm off, points fall off evenly.
TEST_F(MarkCodeOfMotions, WhatGoesPartOfTheWayGetsItsShare) {
  const std::string part =
      "{name: steps, kind: planner, file: work.py, points: 3, robot: nao, command: {goal_x_m: 0.12}, "
      "checks: [{measure: goal_error_m, points: 3, full_at: 0.02, none_at: 0.1}]}\n";
  double fewer = 0.0;
  for (const double share : {0.35, 0.5, 0.75}) {
    SCOPED_TRACE(share);
    const PartMark mark = MarkCode(part, Planner(share));
    const double error_m = mark.checks.at(0).value.value_or(-1.0);
    EXPECT_NEAR(error_m, 0.12 * (1.0 - share), 0.015);
    EXPECT_NEAR(mark.points, 3.0 * (0.1 - error_m) / 0.08, 0.01);
    EXPECT_GT(mark.points, fewer);
    EXPECT_LT(mark.points, 3.0);
    EXPECT_FALSE(mark.reasons.empty());
    fewer = mark.points;
  }
}

TEST_F(MarkCodeOfMotions, StepsThatAreNoneAreToldSo) {
  const auto gives = [&](const std::string& steps) {
    return MarkCode(kSteps, "def plan_steps(robot, terrain, goal):\n    return " + steps + "\n");
  };
  ExpectNothing(gives("[]"), {"the planner gave no steps"});
  ExpectNothing(gives("[('tail', 0, 0, 0)]"), {"a foot 'tail'; there are 'l_ankle', 'r_ankle'"});
  ExpectNothing(gives("[('l_ankle', float('nan'), 0, 0)]"), {"step 1, x is nan"});
  ExpectNothing(gives("[('l_ankle', 0, 0)]"), {"the submission says: ValueError"});
  ExpectNothing(gives("[('l_ankle', 0, 0, 0)] * 5000"), {"more than 1000 steps"});
  ExpectNothing(gives("[('l_ankle', 0, 0, 0)] * 500"), {"500 steps, which last 300.0 s; at most 60 s"});
  ExpectNothing(gives("[('l_ankle', 5.0, 0, 0)]"), {"pass is 0"});
}

const std::string kControl =
    "{name: control, kind: controller, file: work.py, points: 4, robot: a1, gait: trot, command: {speed_m_s: 0.3, "
    "distance_m: 0.2}, "
    "trials: 1, checks: [{measure: stands, points: 2}, {measure: survival, points: 2}]}\n";

std::string ControllerThat(const std::string& update) {
  return "import gaitwright as gw, numpy as np, time\n"
         "class Own(gw.Controller):\n"
         "    def __init__(self, plan):\n"
         "        super().__init__()\n"
         "        self.plan, self.gains = plan, gw.derive_gains(plan.robot)\n"
         "    def update(self, now):\n"
         "        wanted = self.plan.at(now.time_s + now.step_s)\n"
         "        " +
         update +
         "\n"
         "        return gw.JointCommand(wanted['q'][7:], wanted['v'][6:], wanted['tau'], *self.gains)\n"
         "make_controller = Own\n";
}

TEST_F(MarkCodeOfMotions, AControllerIsAskedEachStep) {
  const PartMark good =
      MarkCode(kControl, ControllerThat("assert now.forces_n.shape == (4, 3) and len(now.contact) == 4"));
  EXPECT_EQ(good.points, 4.0) << (good.reasons.empty() ? "" : good.reasons.front());
  const PartMark limp = MarkCode(kControl, ControllerThat("return gw.JointCommand(np.zeros(12))"));
  ExpectNothing(limp, {"stands is 0", "0 of 1 trials survived", "trial 1: under ", "the robot fell while settling"});
}

TEST_F(MarkCodeOfMotions, AControllerThatFailsGetsNothing) {
  const auto does = [&](const std::string& what) { return MarkCode(kControl, ControllerThat(what)); };
  ExpectNothing(does("return gw.JointCommand(np.full(12, np.nan))"),
                {"the controller at 0.000 s: the answer[0, 0] is nan"});
  ExpectNothing(does("return gw.JointCommand(np.zeros(3))"), {"5 x 12 numbers are needed"});
  ExpectNothing(does("return gw.JointCommand(np.zeros(12), stiffness=-np.ones(12))"),
                {"negative stiffness or damping"});
  ExpectNothing(does("return {'score': 100}"), {"the submission says"});
  ExpectNothing(does("if now.time_s > 0.1: raise ValueError('enough')"), {"ValueError: enough"});
  ExpectNothing(MarkCode(kControl, "def make_controller(plan): return 3\n"), {"gave no controller"});
}

}  // namespace
}  // namespace gaitwright
