// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/preflight/preflight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "planning/plan/plan_json.h"
#include "playback/play/play.h"
#include "tests/playback/xml_check.h"
#include "workflows/preflight/preflight_joints.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

struct Walked {
  RobotModel model;
  MotionPlan plan;
};

const Walked& AWalk() {
  static const Walked walked = [] {
    const RobotModel model = ChooseRobot("a1", "").value();
    WalkRequest request;
    request.command.distance_m = 0.3;
    return Walked{model, PlanWalk(model, request).value().motion.plan};
  }();
  return walked;
}

TrialsResult ResultOf(const Walked& walked, int n, int survived, double low, double high) {
  TrialsResult trials;
  trials.n = n;
  trials.survived = survived;
  trials.survival = static_cast<double>(survived) / n;
  trials.survival_low = low;
  trials.survival_high = high;
  trials.causes = {{"tipped <over>", n - survived}};
  trials.worst = {{18446744073709551615U, "base under 0.4 of its height"}};
  trials.passed = survived - 4;
  trials.different = n;
  trials.different_survived = survived;
  trials.different_passed = trials.passed;
  trials.options = {{"state", "true"}, {"command_delay_s", "0"}, {"play.friction", "0.4"}, {"sensors.seed", "0"}};
  trials.disturbances = "mass_scale: 1.1\nfriction: <0.5>\n";
  trials.plan_hash = MotionHash(walked.plan);
  trials.whole_plan_hash = PlanHash(walked.plan);
  trials.robot_hash = walked.model.hash;
  return trials;
}

Preflight Of(const PreflightInput& input, const Walked& walked = AWalk()) {
  return MakePreflight(walked.model, walked.plan, input).value();
}

bool Says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
bool Says(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) { return Says(line, part); });
}

TEST(PreflightOfAGoodPlan, IsAGoThatSaysWhatNobodyChecked) {
  const Preflight preflight = Of({});
  EXPECT_TRUE(preflight.go());
  EXPECT_EQ(preflight.robot_hash, AWalk().model.hash);
  EXPECT_EQ(preflight.plan_hash, MotionHash(AWalk().plan));
  EXPECT_EQ(preflight.whole_plan_hash, PlanHash(AWalk().plan));
  EXPECT_TRUE(Says(preflight.remarks, "no trials"));
  for (const char* law : {"torque_speed", "continuous_torque", "joint_acceleration", "joint_jerk", "start_posture",
                          "survival under disturbances", "self_collision"})
    EXPECT_TRUE(Says(preflight.not_checked, law)) << law;
  EXPECT_TRUE(Says(preflight.assumptions, "the assumed friction is 0.8"));
  EXPECT_TRUE(Says(preflight.assumptions, "without margin"));
  EXPECT_FALSE(preflight.audit.margins.empty());
}

TEST(PreflightOfAGoodPlan, StandsOnTheOptionsThatAreGiven) {
  PreflightInput input;
  input.audit.derate_torque = 0.9;
  input.audit.start = StartPosture{AWalk().plan.whole_body.q.front().tail(AWalk().model.num_dofs()), {}};
  const Preflight preflight = Of(input);
  EXPECT_TRUE(preflight.go());
  EXPECT_TRUE(Says(preflight.assumptions, "torque 0.9"));
  EXPECT_FALSE(Says(preflight.not_checked, "start_posture"));
  input.audit.start->joints[3] += 0.2;
  const Preflight jumps = Of(input);
  EXPECT_FALSE(jumps.go());
  EXPECT_TRUE(Says(jumps.reasons, "start posture: " + AWalk().model.dof_names[3]));
  EXPECT_TRUE(Says(jumps.remarks, "--approach"));
  EXPECT_FALSE(Says(jumps.remarks, "begin the plan at rest"));
}

TEST(PreflightOfAGoodPlan, SendsNoJointAnywhereForATiltedBase) {
  PreflightInput input;
  const VectorX first = AWalk().plan.whole_body.q.front().tail(AWalk().model.num_dofs());
  input.audit.start = StartPosture{first, Quaternion(Eigen::AngleAxisd(0.3, Vector3::UnitX()))};
  const Preflight tilted = Of(input);
  EXPECT_TRUE(Says(tilted.reasons, "start posture: base tilt"));
  EXPECT_TRUE(Says(tilted.remarks, "the measured base is tilted by 0.3 rad"));
  EXPECT_TRUE(Says(tilted.remarks, "level the robot"));
  EXPECT_FALSE(Says(tilted.remarks, "--approach"));
  input.approach = "no way is needed";
  EXPECT_TRUE(Says(Of(input).remarks, "no way is needed"));
  EXPECT_FALSE(Says(Of(input).remarks, "run it"));
  input.audit.start->joints[3] += 0.2;
  EXPECT_TRUE(Says(Of(input).remarks, "run it, and measure again")) << "both have to be mended";
  EXPECT_TRUE(Says(Of(input).remarks, "is tilted by"));
}

TEST(PreflightOfAGoodPlan, SaysWhereAMeasuredQuaternionLikelyHasWFirst) {
  PreflightInput input;
  const VectorX first = AWalk().plan.whole_body.q.front().tail(AWalk().model.num_dofs());
  input.audit.start = StartPosture{first, Quaternion(0.0, 1.0, 0.0, 0.0)};  // 1, 0, 0, 0 taken for x, y, z, w
  const Preflight preflight = Of(input);
  EXPECT_TRUE(Says(preflight.reasons, "start posture: base tilt"));
  EXPECT_TRUE(Says(preflight.remarks, "seems to have w first"));
  EXPECT_TRUE(Says(PreflightText(preflight), "seems to have w first"));
  input.audit.start->R_WB = Quaternion(1.0, 0.0, 0.0, 0.0);
  EXPECT_TRUE(Of(input).go());
  EXPECT_FALSE(Says(Of(input).remarks, "w first"));
}

TEST(PreflightOfAPlanThatBeginsInMotion, AsksForOneThatBeginsAtRest) {
  Walked moving = AWalk();
  moving.plan.whole_body.v.front()[8] = 3.0;
  PreflightInput input;
  input.audit.start = StartPosture{moving.plan.whole_body.q.front().tail(moving.model.num_dofs()), {}};
  const Preflight preflight = Of(input, moving);
  EXPECT_FALSE(preflight.go());
  EXPECT_TRUE(Says(preflight.reasons, ", speed at"));
  EXPECT_TRUE(Says(preflight.remarks, "begin the plan at rest"));
  EXPECT_FALSE(Says(preflight.remarks, "--approach")) << "no way there mends it";
}

TEST(PreflightWithTrials, IsNoGoWhereTooFewSurvived) {
  PreflightInput input;
  input.trials = ResultOf(AWalk(), 500, 487, 0.9558, 0.9846);
  const Preflight good = Of(input);
  EXPECT_TRUE(good.go());
  EXPECT_TRUE(good.remarks.empty());
  EXPECT_FALSE(Says(good.not_checked, "survival"));
  EXPECT_TRUE(Says(PreflightText(good), "487 of 500 trials survived: 97.4 % (95 % interval 95.6 to 98.5 %)"));
  input.trials = ResultOf(AWalk(), 20, 19, 0.7639, 0.9911);
  EXPECT_FALSE(Of(input).go()) << "it may be chance";
  EXPECT_TRUE(Says(Of(input).reasons, "do not show whether 90 % survive: 19 of 20 trials survived"));
  input.options.least_survival = 0.75;
  EXPECT_TRUE(Of(input).go());
  input.options.least_survival = 0.96;
  EXPECT_FALSE(Of(input).go());
  EXPECT_TRUE(Says(Of(input).reasons, "19 of 20 trials survived"));
  EXPECT_TRUE(Says(Of(input).reasons, "at least 96 %"));
}

TEST(PreflightWithTrials, IsNoGoWithoutThoseThatAreAskedFor) {
  PreflightInput input;
  EXPECT_TRUE(Of(input).go()) << "whoever signs decides";
  input.options.fewest_trials = 100;
  EXPECT_FALSE(Of(input).go());
  EXPECT_TRUE(Says(Of(input).reasons, "100 different trials are required, but there are 0"));
  EXPECT_TRUE(Says(PreflightText(Of(input)), "a go requires 100 different trials"));
  input.trials = ResultOf(AWalk(), 99, 99, 0.9626, 1.0);
  EXPECT_FALSE(Of(input).go());
  input.trials = ResultOf(AWalk(), 100, 100, 0.963, 1.0);
  EXPECT_TRUE(Of(input).go());
}

TEST(PreflightWithTrials, CountsEachPlaybackOnce) {
  PreflightInput input;
  input.trials = ResultOf(AWalk(), 500, 500, 0.9924, 1.0);
  EXPECT_TRUE(Of(input).go());
  input.trials->different = input.trials->different_survived = input.trials->different_passed = 1;
  const Preflight one = Of(input);
  EXPECT_FALSE(one.go());
  const std::string counted =
      "500 of 500 trials survived, but 499 only repeat others exactly; counting each once, 1 of 1 did: 100.0 % (95 % "
      "interval 20.7 to 100.0 %)";
  EXPECT_TRUE(Says(one.reasons, "the trials do not show whether 90 % survive: " + counted + "; more different trials"));
  EXPECT_TRUE(Says(PreflightText(one), "496 of 500 trials also passed every gate, but 499 only repeat others"));
  const Json different = Json::parse(PreflightJson(one)).at("trials").at("different");
  EXPECT_EQ(different.at("n"), 1);
  EXPECT_NEAR(different.at("survival_low"), 0.2065, 1e-4);
  input.trials->different = 50;
  input.trials->different_survived = 40;
  EXPECT_TRUE(Says(Of(input).reasons, "40 of 50 did: 80.0 %")) << "though of all more survived";
}

TEST(PreflightWithTrials, RefusesThoseOfAnotherPlanOrRobot) {
  PreflightInput input;
  input.trials = ResultOf(AWalk(), 10, 10, 0.72, 1.0);
  input.trials->plan_hash = "other";
  const auto of_plan = MakePreflight(AWalk().model, AWalk().plan, input);
  ASSERT_FALSE(of_plan);
  EXPECT_TRUE(Says(of_plan.failure().message, "another plan"));
  EXPECT_TRUE(Says(of_plan.failure().message, "'other'"));
  EXPECT_TRUE(Says(of_plan.failure().message, MotionHash(AWalk().plan)));
  input.trials->robot_hash = "mine";
  const auto of_robot = MakePreflight(AWalk().model, AWalk().plan, input);
  ASSERT_FALSE(of_robot);
  EXPECT_TRUE(Says(of_robot.failure().message, "another robot"));
}

/// The plan of the trials with one change, so that the trials belong to another plan.
void ExpectOther(const std::function<void(MotionPlan&)>& change, const std::string& part) {
  Walked changed = AWalk();
  change(changed.plan);
  PreflightInput input;
  input.trials = ResultOf(AWalk(), 500, 487, 0.9558, 0.9846);
  const auto refused = MakePreflight(changed.model, changed.plan, input);
  ASSERT_FALSE(refused) << part;
  EXPECT_TRUE(Says(refused.failure().message, "another plan: their " + part)) << refused.failure().message;
}

TEST(PreflightWithTrials, HoldsThemAgainstTheWholePlan) {
  ExpectOther([](MotionPlan& plan) { plan.terrain.patches.front().friction = 0.4; }, "plan_hash");
  ExpectOther([](MotionPlan& plan) { plan.footsteps.footholds.back().X_WF.translation().x() += 1e-9; }, "plan_hash");
  ExpectOther([](MotionPlan& plan) { plan.whole_body.wrenches[7][0].force_W.z() += 1e-9; }, "plan_hash");
  ExpectOther([](MotionPlan& plan) { plan.goal.x_m += 0.1; }, "whole_plan_hash");
  ExpectOther([](MotionPlan& plan) { plan.swings.front().lift_m += 0.01; }, "whole_plan_hash");
}

TEST(PreflightWithTrials, SaysWhatTheyWerePlayedUnderAndWhatAGoAsksFor) {
  PreflightInput input;
  input.options.least_survival = 0.85;
  input.trials = ResultOf(AWalk(), 500, 487, 0.9558, 0.9846);
  const Preflight preflight = Of(input);
  const std::string text = PreflightText(preflight), page = PreflightPage(preflight);
  const Json json = Json::parse(PreflightJson(preflight));
  const Json& trials = json.at("trials");
  for (const char* part :
       {"483 of 500 trials also passed every gate: 96.6 %", "a go requires a survival rate of at least 85 %",
        "state true", "sensors not used", "command_delay_s 0", "play.friction 0.4 (default 0)"}) {
    EXPECT_TRUE(Says(text, part)) << part;
    EXPECT_TRUE(Says(page, part)) << part;
  }
  EXPECT_TRUE(Says(text, "      friction: <0.5>\n")) << "disturbances";
  EXPECT_TRUE(Says(page, "friction: &lt;0.5&gt;"));
  EXPECT_EQ(json.at("least_survival"), 0.85);
  EXPECT_EQ(trials.at("passed"), 483);
  EXPECT_NEAR(trials.at("pass_share"), 0.966, 1e-12);
  EXPECT_EQ(trials.at("conditions").back(), (Json{{"key", "play.friction"}, {"value", "0.4"}, {"usual", "0"}}));
  EXPECT_TRUE(Says(PreflightText(Of({})), "a go requires a survival rate of at least 90 %"))
      << "whether or not there are trials";
  EXPECT_TRUE(Says(PreflightPage(Of({})), "a go requires a survival rate of at least 90 %"));
  EXPECT_EQ(Json::parse(PreflightJson(Of({}))).at("least_survival"), 0.9);
}

TEST(PreflightAsText, HasTheMarginsOfEachJointAsThePageDoes) {
  const Preflight preflight = Of({});
  const JointMargins table = JointMarginsOf(preflight.audit.margins);
  EXPECT_EQ(table.headings, (std::vector<std::string>{"position", "speed", "torque"}));
  ASSERT_EQ(table.rows.size(), AWalk().model.dof_names.size());
  std::istringstream lines(PreflightText(preflight));
  std::map<std::string, std::string> found;
  for (std::string line; std::getline(lines, line);) {
    for (const JointMargins::Row& row : table.rows) {
      if (line.starts_with("  " + row.joint + " ")) found[row.joint] = line;
    }
  }
  for (const JointMargins::Row& row : table.rows) {
    for (const std::string& cell : row.cells) EXPECT_TRUE(Says(found[row.joint], cell)) << row.joint;
    EXPECT_FALSE(row.broken[2]);
  }
}

TEST(PreflightOfABrokenPlan, NamesWhatForbidsItFirst) {
  Walked broken = AWalk();
  for (Joint& joint : broken.model.joints) joint.velocity_limit = 1e-3;
  const Preflight preflight = Of({}, broken);
  EXPECT_FALSE(preflight.go());
  EXPECT_TRUE(Says(preflight.reasons.front(), "joint velocity: "));
  EXPECT_TRUE(Says(preflight.reasons.back(), "more violations"));
  EXPECT_LE(preflight.reasons.size(), 9U);
  EXPECT_TRUE(Says(PreflightText(preflight), "PREFLIGHT: NO-GO"));
  EXPECT_TRUE(Says(PreflightPage(preflight), ">NO-GO<"));
  EXPECT_EQ(Json::parse(PreflightJson(preflight)).at("verdict"), "no-go");
}

TEST(PreflightPages, AreWholeAndHoldEveryLimitAndLinesToSign) {
  PreflightInput input;
  input.trials = ResultOf(AWalk(), 500, 487, 0.9558, 0.9846);
  const Preflight preflight = Of(input);
  const std::string page = PreflightPage(preflight);
  EXPECT_EQ(XmlFault(page), "");
  EXPECT_EQ(page, PreflightPage(Of(input))) << "the same bytes";
  for (const char* part : {">GO<", "@page{size:A4", "signature", "tipped &lt;over&gt;", "seed 18446744073709551615",
                           "Assumptions", "Not checked", "487 of 500"})
    EXPECT_TRUE(Says(page, part)) << part;
  for (const AuditMargin& m : TightestOfEachLaw(preflight.audit.margins))
    EXPECT_TRUE(Says(page, "<td>" + LawWords(m.law) + "</td>")) << m.law;
  for (const std::string& joint : AWalk().model.dof_names) EXPECT_TRUE(Says(page, "<td>" + joint + "</td>")) << joint;
  for (const char* never : {"http", "<script", "nan", " 1</td>", "inf"}) EXPECT_FALSE(Says(page, never)) << never;
  EXPECT_TRUE(Says(PreflightPage(Of({})), "<b>None.</b>"));
}

TEST(PreflightAsJson, HoldsTheAuditTheTightestLimitsAndTheTrials) {
  PreflightInput input;
  input.trials = ResultOf(AWalk(), 500, 487, 0.9558, 0.9846);
  const Preflight preflight = Of(input);
  const Json json = Json::parse(PreflightJson(preflight, {{"report", "page.html"}}));
  EXPECT_EQ(json.at("verdict"), "go");
  EXPECT_EQ(json.at("audit").at("verdict"), "pass");
  EXPECT_EQ(json.at("audit").at("margins").size(), preflight.audit.margins.size());
  EXPECT_EQ(json.at("limits").size(), TightestOfEachLaw(preflight.audit.margins).size());
  EXPECT_EQ(json.at("trials").at("survived"), 487);
  EXPECT_EQ(json.at("trials").at("worst").at(0).at("seed"), 18446744073709551615U);
  EXPECT_EQ(json.at("files").at("report"), "page.html");
  EXPECT_TRUE(Json::parse(PreflightJson(Of({}))).at("trials").is_null());
}

}  // namespace
}  // namespace gaitwright
