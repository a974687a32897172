// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/preflight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "playback/bullet/play.h"
#include "tests/playback/xml_check.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

using Json = nlohmann::json;

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
  trials.plan_hash = MotionHash(walked.plan);
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
  EXPECT_TRUE(Says(preflight.remarks, "no trials"));
  for (const char* law : {"torque_speed", "continuous_torque", "joint_acceleration", "joint_jerk", "start_posture",
                          "survival under disturbances", "self_collision"})
    EXPECT_TRUE(Says(preflight.not_checked, law)) << law;
  EXPECT_TRUE(Says(preflight.assumptions, "friction is at least 0.8"));
  EXPECT_TRUE(Says(preflight.assumptions, "no reserve"));
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
}

TEST(PreflightWithTrials, IsNoGoWhereTooFewSurvived) {
  PreflightInput input;
  input.trials = ResultOf(AWalk(), 500, 487, 0.9558, 0.9846);
  const Preflight good = Of(input);
  EXPECT_TRUE(good.go());
  EXPECT_TRUE(good.remarks.empty());
  EXPECT_FALSE(Says(good.not_checked, "survival"));
  EXPECT_TRUE(
      Says(PreflightText(good), "487 of 500 trials survived: 97.4 %, and with 95 % certainty from 95.6 to 98.5 %"));
  input.trials = ResultOf(AWalk(), 20, 19, 0.7639, 0.9911);
  EXPECT_TRUE(Of(input).go());
  EXPECT_TRUE(Says(Of(input).remarks, "leave open whether 90 %"));
  input.options.least_survival = 0.96;
  EXPECT_FALSE(Of(input).go());
  EXPECT_TRUE(Says(Of(input).reasons, "19 of 20 trials survived"));
  EXPECT_TRUE(Says(Of(input).reasons, "at least 96 %"));
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

TEST(PreflightOfABrokenPlan, NamesWhatForbidsItFirst) {
  Walked broken = AWalk();
  for (Joint& joint : broken.model.joints) joint.velocity_limit = 1e-3;
  const Preflight preflight = Of({}, broken);
  EXPECT_FALSE(preflight.go());
  EXPECT_TRUE(Says(preflight.reasons.front(), "joint velocity: "));
  EXPECT_TRUE(Says(preflight.reasons.back(), "more broken limits"));
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
                           "Taken for granted", "Not checked", "487 of 500"})
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
