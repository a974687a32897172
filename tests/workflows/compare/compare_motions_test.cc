// SPDX-License-Identifier: BSD-3-Clause
// Motions with known differences, which the test adds.
#include "workflows/compare/compare_motions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "kinematics/base/result.h"
#include "tests/playback/played.h"
#include "tests/playback/xml_check.h"
#include "workflows/compare/comparison_text.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

synthetic::Played SixStepWalker() { return synthetic::Walked(2, {.count = 6}); }

ComparedMotion PlanSide(const synthetic::Played& walker) {
  return ComparedPlan(walker.model, walker.plan, "plan.json");
}
ComparedMotion LogSide(const synthetic::Played& walker) { return ComparedLog(walker.model, walker.log, "log.json"); }

/// The log as an external table, with its clock advanced by `clock_offset_s`.
ComparedMotion TableSide(const synthetic::Played& walker, double clock_offset_s) {
  MotionTable table;
  for (const LogSample& sample : walker.log.samples) {
    table.time_s.push_back(sample.time_s + clock_offset_s);
    table.q.emplace_back(sample.q.tail(6));
    table.contact.push_back(sample.contact);
  }
  return ComparedTable(walker.model, table, "robot.csv");
}

const SeriesDifference& Base(const MotionComparison& c, std::size_t i) { return c.base.at(i); }

TEST(CompareMotions, APlanIsTheSameAsItselfToTheLast) {
  const synthetic::Played walker = SixStepWalker();
  const MotionComparison c = CompareMotions(PlanSide(walker), PlanSide(walker), {.align = "best", .tolerance = 0.0});
  EXPECT_TRUE(c.same()) << FirstDifferenceText(c);
  EXPECT_EQ(c.offset_s, 0.0);
  ASSERT_TRUE(c.best_offset);
  EXPECT_NEAR(c.best_offset->agreement, 1.0, 1e-12);
  ASSERT_EQ(c.joints.size(), 6U);
  for (const JointDifference& joint : c.joints) {
    EXPECT_EQ(joint.position.samples, c.samples);
    EXPECT_EQ(joint.position.largest, 0.0);
    EXPECT_EQ(joint.torque.largest, 0.0);
  }
  EXPECT_EQ(c.base.size(), 4U);
  EXPECT_EQ(c.feet.size(), 2U);
  EXPECT_GT(c.feet[0].timing.samples, 4);
  EXPECT_TRUE(c.words.empty());
}

TEST(CompareMotions, NamesTheJointThatDiffersFirstAndWhen) {
  const synthetic::Played walker = SixStepWalker();
  synthetic::Played other = walker;
  for (std::size_t k = 400; k < other.log.samples.size(); ++k) other.log.samples[k].q[7 + 3] += 0.03;  // from 2.0 s on
  for (std::size_t k = 500; k < other.log.samples.size(); ++k) other.log.samples[k].q[0] += 0.2;       // from 2.5 s on
  const MotionComparison c = CompareMotions(LogSide(walker), LogSide(other));
  ASSERT_FALSE(c.same());
  EXPECT_EQ(c.in_order[0].quantity, "position of right_x");
  EXPECT_DOUBLE_EQ(c.in_order[0].time_s, 2.0);
  EXPECT_NEAR(c.in_order[0].b - c.in_order[0].a, 0.03, 1e-12);
  EXPECT_EQ(c.in_order[1].time_s, 2.5);
  const double n = static_cast<double>(walker.log.samples.size());
  EXPECT_NEAR(c.joints[3].position.rms, 0.03 * std::sqrt((n - 400.0) / n), 1e-12);
  EXPECT_NEAR(c.joints[3].position.largest, 0.03, 1e-12);
  EXPECT_EQ(c.joints[2].position.largest, 0.0);
  EXPECT_NEAR(Base(c, 0).largest, 0.2, 1e-12);
  EXPECT_EQ(Base(c, 0).quantity, "x of the base");
  EXPECT_TRUE(synthetic::Says(FirstDifferenceText(c), "position of right_x differs first, at 2.000 s"))
      << FirstDifferenceText(c);
  EXPECT_TRUE(CompareMotions(LogSide(walker), LogSide(other), {.tolerance = 5.0}).same()) << "the tolerance scales";
}

TEST(CompareMotions, AttitudeIsTheAngleBetweenTheTwo) {
  const synthetic::Played walker = SixStepWalker();
  synthetic::Played other = walker;
  for (LogSample& sample : other.log.samples) sample.q.segment<4>(3) << 0.0, std::sin(0.1), 0.0, -std::cos(0.1);
  const MotionComparison c = CompareMotions(LogSide(walker), LogSide(other));
  EXPECT_EQ(Base(c, 3).quantity, "attitude of the base");
  EXPECT_NEAR(Base(c, 3).largest, 0.2, 1e-9);
  EXPECT_NEAR(Base(c, 3).rms, 0.2, 1e-9) << "the sign of a quaternion says nothing";
}

TEST(CompareMotions, FindsTheOffsetOfAForeignClock) {
  const synthetic::Played walker = SixStepWalker();
  for (const double clock_offset_s : {0.0, 37.25, -3.0017}) {
    const MotionComparison c = CompareMotions(PlanSide(walker), TableSide(walker, clock_offset_s));
    EXPECT_EQ(c.aligned_by, "best");
    EXPECT_NEAR(c.offset_s, clock_offset_s, 2e-4);
    EXPECT_GT(c.best_offset->agreement, 0.99);
    for (const JointDifference& joint : c.joints) EXPECT_LT(joint.position.largest, 2e-3) << joint.joint;
    EXPECT_TRUE(c.base.empty()) << "the table says nothing of the base";
    EXPECT_EQ(c.joints[0].torque.samples, 0);
    EXPECT_EQ(c.feet.size(), 2U);
  }
}

TEST(CompareMotions, FindsTheOffsetOfALogThatWasCutShort) {
  const synthetic::Played walker = SixStepWalker();
  synthetic::Played cut = walker;
  cut.log.samples.erase(cut.log.samples.begin() + 450, cut.log.samples.end());
  cut.log.samples.erase(cut.log.samples.begin(), cut.log.samples.begin() + 100);
  const MotionComparison c = CompareMotions(PlanSide(walker), TableSide(cut, 5.0));
  EXPECT_NEAR(c.offset_s, 5.0, 2e-4);
  EXPECT_EQ(c.in_order.at(0).quantity, "end of the motion");
  EXPECT_NEAR(c.in_order.at(0).b, 0.005 * 449, 1e-3);
}

TEST(CompareMotions, AlignsAsRequested) {
  const synthetic::Played walker = SixStepWalker();
  const ComparedMotion plan = PlanSide(walker), table = TableSide(walker, 40.0);
  EXPECT_NEAR(CompareMotions(plan, table, {.align = "start"}).offset_s, 40.0, 1e-12);
  try {
    CompareMotions(plan, table, {.align = "none"});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_TRUE(synthetic::Says(error.what(), "do not overlap in time")) << error.what();
    EXPECT_TRUE(synthetic::Says(error.what(), "'robot.csv' from 40.000")) << error.what();
  }
  EXPECT_THROW(CompareMotions(plan, table, {.align = "backwards"}), InvalidArgument);
  EXPECT_THROW(CompareMotions(plan, table, {.tolerance = -1.0}), InvalidArgument);
}

TEST(CompareMotions, TakesAPlansTorqueAtTheMiddleOfTheLogsInterval) {
  synthetic::Played walker = SixStepWalker();
  WholeBodyTrajectory& body = walker.plan.whole_body;
  for (std::size_t k = 0; k < body.tau.size(); ++k) body.tau[k].setConstant(10.0 * static_cast<double>(k));
  for (std::size_t k = 1; k < body.tau.size(); ++k)  // the mean over the interval before the sample
    walker.log.samples[k].tau.setConstant(10.0 * static_cast<double>(k) - 5.0);
  walker.log.samples[0].tau.setZero();
  const MotionComparison c = CompareMotions(PlanSide(walker), LogSide(walker));
  for (const JointDifference& joint : c.joints) EXPECT_LT(joint.torque.largest, 1e-6) << joint.joint;
  const MotionComparison turned = CompareMotions(LogSide(walker), PlanSide(walker));
  for (const JointDifference& joint : turned.joints) EXPECT_LT(joint.torque.largest, 1e-6) << joint.joint;
}

TEST(CompareMotions, TellsLateAndMissingContacts) {
  const synthetic::Played walker = SixStepWalker();
  synthetic::Played late = walker;
  int moved = -1;
  for (StanceRecord& stance : late.log.stances) {
    if (moved >= 0 || stance.foot != 1 || stance.touchdown_s < 1.0) continue;
    stance.touchdown_s += 0.08;
    moved = stance.foot;
  }
  ASSERT_EQ(moved, 1);
  const MotionComparison c = CompareMotions(PlanSide(walker), LogSide(late));
  EXPECT_NEAR(c.feet[1].timing.largest, 0.08, 1e-9) << "late is positive";
  EXPECT_EQ(c.feet[0].timing.largest, 0.0);
  EXPECT_EQ(c.in_order.at(0).quantity, "touch-down of right");
  EXPECT_EQ(CompareMotions(LogSide(late), PlanSide(walker)).feet[1].timing.largest, -c.feet[1].timing.largest);

  synthetic::Played hopping = walker;
  std::erase_if(hopping.log.stances, [](const StanceRecord& s) { return s.foot == 0 && s.touchdown_s > 2.0; });
  const MotionComparison missing = CompareMotions(PlanSide(walker), LogSide(hopping));
  EXPECT_EQ(missing.feet[0].unmatched, missing.feet[0].stances_a - missing.feet[0].stances_b);
  EXPECT_GT(missing.feet[0].unmatched, 0);
  EXPECT_EQ(missing.in_order.at(0).quantity, "contact of left");
}

TEST(CompareMotions, ALogMayGoOnBehindItsPlanButNotEndBeforeIt) {
  const synthetic::Played walker = SixStepWalker();
  synthetic::Played longer = walker, shorter = walker;
  for (int k = 1; k <= 100; ++k) {
    longer.log.samples.push_back(longer.log.samples.back());
    longer.log.samples.back().time_s += 0.005;
  }
  for (StanceRecord& stance : longer.log.stances) {
    if (stance.liftoff_s > walker.log.samples.back().time_s - 1e-9) stance.liftoff_s = longer.log.samples.back().time_s;
  }
  EXPECT_TRUE(CompareMotions(PlanSide(walker), LogSide(longer)).same());
  EXPECT_FALSE(CompareMotions(LogSide(walker), LogSide(longer)).same()) << "of two logs both are held to it";
  shorter.log.samples.resize(300);
  const MotionComparison c = CompareMotions(PlanSide(walker), LogSide(shorter));
  ASSERT_EQ(c.in_order.size(), 1U) << FirstDifferenceText(c);
  EXPECT_EQ(c.in_order[0].quantity, "end of the motion");
}

TEST(CompareMotions, NamesFeetThatOnlyOneSideHas) {
  const synthetic::Played walker = SixStepWalker();
  synthetic::Played renamed = walker;
  const std::string lost = walker.model.feet[1].name;
  renamed.model.feet[1].name = "paw";
  const MotionComparison c = CompareMotions(PlanSide(walker), PlanSide(renamed));
  ASSERT_EQ(c.feet.size(), 1U);
  ASSERT_EQ(c.notes.size(), 2U);
  EXPECT_TRUE(c.notes[0].ends_with(": " + lost)) << c.notes[0];
  EXPECT_TRUE(c.notes[1].ends_with(": paw")) << c.notes[1];
  EXPECT_TRUE(CompareMotions(PlanSide(walker), PlanSide(walker)).notes.empty());
}

TEST(CompareMotions, NamesRobotsJointsAndOptionsThatAreNotTheSame) {
  const synthetic::Played biped = SixStepWalker(), quadruped = synthetic::Walked(4, {.count = 2});
  const MotionComparison c = CompareMotions(PlanSide(biped), PlanSide(quadruped));
  EXPECT_TRUE(c.joints.empty());
  EXPECT_EQ(c.joints_only_a.size(), 6U);
  EXPECT_EQ(c.joints_only_b.size(), 12U);
  EXPECT_EQ(c.words.at(0).key, "robot");
  EXPECT_EQ(c.words.at(0).b, "block_quadruped");
  EXPECT_TRUE(synthetic::Says(ComparisonText(c, {}), "only in B: front_left_x"));

  synthetic::Played other = biped;
  other.plan.provenance.options = {{"swing.height_m", "0.08"}};
  other.plan.parts.front().gait.name = "amble";
  const MotionComparison words = CompareMotions(PlanSide(biped), PlanSide(other));
  ASSERT_EQ(words.words.size(), 2U);
  EXPECT_EQ(words.words[0].key, "gaits");
  EXPECT_EQ(words.words[1].key, "swing.height_m");
  EXPECT_EQ(words.words[1].a, "");
  EXPECT_EQ(words.words[1].b, "0.08");
}

TEST(CompareMotions, OptionsOfOneSideAloneAreReportedInOneLine) {
  const synthetic::Played planned = SixStepWalker();
  synthetic::Played imported = planned;
  synthetic::Played first = planned;
  first.plan.provenance.options = {{"gait", "trot"},           {"terrain", ""},      {"swing.height_m", "0.08"},
                                   {"swing.clearance_m", "0"}, {"pipeline.on", "1"}, {"seed", "3"}};
  imported.plan.provenance.options = {{"format", "csv"}, {"lift_m", "0"}, {"pipeline.on", "0"}};
  const MotionComparison c = CompareMotions(PlanSide(first), PlanSide(imported));
  const FoldedWords folded = Folded(c.words);
  EXPECT_EQ(folded.only_a, "gait, swing.*, seed");
  EXPECT_EQ(folded.only_b, "format, lift_m");
  ASSERT_EQ(folded.each.size(), 1U) << "a group that both have is told option by option";
  EXPECT_EQ(folded.each[0].key, "pipeline.on");
  const std::string text = ComparisonText(c, {});
  EXPECT_TRUE(synthetic::Says(text, "  options only in A: gait, swing.*, seed\n")) << text;
  EXPECT_FALSE(synthetic::Says(text, "against -")) << text;
  EXPECT_TRUE(synthetic::Says(ComparisonJson(c, {}), "swing.clearance_m")) << "programs are told all";
  EXPECT_TRUE(synthetic::Says(ComparisonPage(PlanSide(first), PlanSide(imported), c, {}), "gait, swing.*, seed"));
}

TEST(CompareMotions, IsReportedInJsonAndDrawnOnAPage) {
  const synthetic::Played walker = SixStepWalker();
  synthetic::Played other = walker;
  for (std::size_t k = 400; k < other.log.samples.size(); ++k) other.log.samples[k].q[7 + 3] += 0.03;
  const ComparedMotion a = PlanSide(walker), b = LogSide(other);
  const MotionComparison c = CompareMotions(a, b);
  const std::vector<MetricPair> metrics = MetricsOf(a, b, nullptr, 0.05);
  EXPECT_GT(metrics.size(), 15U) << "a log is scored by its plan";
  const Json json = Json::parse(ComparisonJson(c, metrics));
  EXPECT_EQ(json.at("same"), false);
  EXPECT_EQ(json.at("first_difference").at("quantity"), "position of right_x");
  EXPECT_EQ(json.at("joints").at("right_x").at("position").at("unit"), "m");
  EXPECT_NEAR(json.at("joints").at("right_x").at("position").at("largest"), 0.03, 1e-3);
  EXPECT_EQ(json.at("alignment").at("by"), "none");
  EXPECT_TRUE(json.at("metrics").contains("com_error_rms_m") || !json.at("metrics").empty());
  const std::string page = ComparisonPage(a, b, c, metrics);
  EXPECT_EQ(XmlFault(page), "");
  EXPECT_TRUE(synthetic::Says(page, "<figure id=\"joint_positions\">"));
  EXPECT_TRUE(synthetic::Says(page, "differs first"));
  EXPECT_FALSE(synthetic::Says(page, "http"));
  EXPECT_EQ(page, ComparisonPage(a, b, c, metrics));
}

}  // namespace
}  // namespace gaitwright
