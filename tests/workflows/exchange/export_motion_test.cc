// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/export_motion.h"

#include <gtest/gtest.h>

#include "tests/playback/xml_check.h"
#include "tests/workflows/exchange/quoted_walker.h"
#include "workflows/exchange/motion_plots.h"

namespace gaitwright {
namespace {

TEST(ExportMotion, SaysWhatAFormatLeavesOut) {
  const QuotedWalker walker;
  const ExportedMotion yaml = ExportPlan(walker.model, walker.plan, ExportFormat::kTrajectoryYaml, 0.0, "a.yaml");
  EXPECT_EQ(yaml.rate_hz, 200.0);
  ASSERT_EQ(yaml.notes.size(), 1U);
  EXPECT_EQ(yaml.notes[0], "the motion of the base is left out: a joint trajectory cannot contain it");
  const ExportedMotion odd = ExportPlan(walker.model, walker.plan, ExportFormat::kCsv, 7.0, "a.csv");
  ASSERT_EQ(odd.notes.size(), 1U);
  EXPECT_TRUE(odd.notes[0].starts_with("the last row is 0.0142857 s after the plan's end")) << odd.notes[0];
  EXPECT_NEAR(odd.end_s, 19.0 / 7.0, 1e-12);
  const ExportedMotion log = ExportLog(walker.model, walker.log, nullptr, ExportFormat::kCsv, 7.0, "a.csv");
  ASSERT_EQ(log.notes.size(), 1U);
  EXPECT_EQ(log.notes[0], "the last 0.128571 s are left out, so that all steps are equal");
}

TEST(ExportMotion, SaysWhatIsTooLongToBeReadBack) {
  const synthetic::Played walker = synthetic::Walked(4, {.count = 8});
  const double duration_s = walker.plan.whole_body.end_s() - walker.plan.whole_body.start_s;
  ASSERT_GT(10000.0 * duration_s * 63.0, 3e6) << "values";
  const ExportedMotion yaml = ExportPlan(walker.model, walker.plan, ExportFormat::kTrajectoryYaml, 10000.0, "a.yaml");
  ASSERT_EQ(yaml.notes.size(), 2U);
  EXPECT_EQ(yaml.notes[1],
            "it is larger than 'import' accepts: use a lower --rate-hz, or the formats joint-trajectory-json or csv, "
            "which may be longer");
  const ExportedMotion json = ExportPlan(walker.model, walker.plan, ExportFormat::kTrajectoryJson, 10000.0, "a.json");
  EXPECT_EQ(json.notes.size(), 1U);
}

TEST(ExportMotion, RefusesALogOfAnotherRobotOrPlan) {
  QuotedWalker walker;
  walker.log.robot_hash = "abc";
  const std::string why =
      RefusalText([&] { ExportLog(walker.model, walker.log, nullptr, ExportFormat::kCsv, 0.0, "a"); });
  EXPECT_TRUE(synthetic::Says(why, "the log is of robot 'block_biped' (abc)")) << why;
  walker.log.robot_hash = "";
  walker.log.plan_hash = "other";
  const std::string plan =
      RefusalText([&] { ExportLog(walker.model, walker.log, &walker.plan, ExportFormat::kCsv, 0.0, "a"); });
  EXPECT_TRUE(synthetic::Says(plan, "the log was played from plan other")) << plan;
  EXPECT_TRUE(synthetic::Says(RefusalText([] { ExportFormatOf("cvs"); }), "the nearest is 'csv'"));
}

TEST(ExportMotion, DrawsOneMotionAndTwoOverEachOther) {
  const QuotedWalker walker;
  const ExportedMotion plots = ExportPlan(walker.model, walker.plan, ExportFormat::kSvg, 0.0, "plots");
  ASSERT_EQ(plots.files.size(), 7U);
  EXPECT_EQ(plots.files[0].path, "plots/top_view.svg");
  for (const OutputFile& file : plots.files) {
    EXPECT_EQ(XmlFault(file.text), "") << file.path;
    EXPECT_FALSE(synthetic::Says(file.text, "nan")) << file.path;
  }
  const MotionRows plan = RowsOfPlan(walker.model, walker.plan, 200.0),
                   log = RowsOfLog(walker.model, walker.log, 200.0);
  const std::vector<Plot> both = MotionPlots({{"A", &walker.model, &plan}, {"B", &walker.model, &log}}, 1.0, "here");
  const std::string& positions = both[4].svg;
  EXPECT_EQ(both[4].name, "joint_positions");
  EXPECT_TRUE(synthetic::Says(positions, "planned") && synthetic::Says(positions, "measured")) << "broad and thin";
  EXPECT_FALSE(synthetic::Says(plots.files[4].text, "class=\"dcm planned\"")) << "one alone is thin";
  EXPECT_TRUE(synthetic::Says(both[3].svg, "here"));
}

TEST(ExportMotion, EachFormatHasAName) {
  const std::vector<std::string>& names = ExportFormatNames();
  ASSERT_EQ(names.size(), 10U);
  for (std::size_t k = 0; k < names.size(); ++k) EXPECT_EQ(static_cast<std::size_t>(ExportFormatOf(names[k])), k);
  EXPECT_EQ(ExportFormatOf("npz"), ExportFormat::kNpz);
  EXPECT_EQ(ExportFormatOf("mjcf"), ExportFormat::kMjcf);
}

}  // namespace
}  // namespace gaitwright
