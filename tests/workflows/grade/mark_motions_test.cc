// SPDX-License-Identifier: BSD-3-Clause
// Plans, motions, parameters, planners and controllers: good, partly good, bad and falsified ones.
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

/// The requested plan, made once.
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

TEST_F(MarkPlan, APlanThatViolatesConstraintsOrFallsLosesTheirMarks) {
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
  MotionPlan moved = GoodTrot();  // starts beyond the obstacles, if there were any
  for (VectorX& q : moved.whole_body.q) q[0] += 3.0;
  ExpectNothing(MarkOfPlan(moved), {"begins at x 3.00 m", "at the origin"});
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
  MotionPlan near = Trot(0.3, 0.1);  // a shorter walk that claims to be the whole one
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

}  // namespace
}  // namespace gaitwright
