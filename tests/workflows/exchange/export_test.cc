// SPDX-License-Identifier: BSD-3-Clause
// What is exported is read back by other roads and is the plan as it is sampled.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "planning/plan/sample_plan.h"
#include "tests/playback/played.h"
#include "tests/playback/xml_check.h"
#include "workflows/exchange/export_csv.h"
#include "workflows/exchange/export_motion.h"
#include "workflows/exchange/export_trajectory.h"
#include "workflows/exchange/joint_trajectory.h"
#include "workflows/exchange/motion_columns.h"
#include "workflows/exchange/motion_plots.h"

namespace gaitwright {
namespace {

/// A biped that walks, one of its joints turning, with a name that CSV and YAML must quote.
struct Walker : synthetic::Played {
  Walker() : Played(synthetic::Walked(2, {.count = 2})) {
    model.joints[1].type = JointType::kRevolute;
    model.joints[2].name = model.dof_names[2] = "left, \"z\"";
  }
};

template <class Call>
std::string Refusal(Call call) {
  try {
    call();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

bool Same(const VectorX& a, const VectorX& b) { return a.size() == b.size() && a == b; }

TEST(MotionRows, OfAPlanAreItsOwnRowsAtItsOwnRateAndInterpolatedBetween) {
  const Walker walker;
  const MotionRows own = RowsOfPlan(walker.model, walker.plan, UsualRate(walker.plan));
  ASSERT_EQ(own.size(), walker.plan.whole_body.size());
  for (int k = 0; k < own.size(); ++k) {
    const auto row = static_cast<std::size_t>(k);
    EXPECT_LT((own.q[row] - walker.plan.whole_body.q[row]).norm(), 1e-12);
    EXPECT_LT((own.tau[row] - walker.plan.whole_body.tau[row]).norm(), 1e-9);
  }
  const MotionRows fine = RowsOfPlan(walker.model, walker.plan, 1000.0);
  EXPECT_EQ(fine.size(), 5 * (own.size() - 1) + 1);
  WholeBodySample sample;
  SampleWholeBody(walker.plan.whole_body, fine.time_s[777], sample);
  EXPECT_TRUE(Same(fine.q[777], sample.q) && Same(fine.v[777], sample.v) && Same(fine.a[777], sample.a));
  EXPECT_GT((fine.q[777] - own.q[777 / 5]).norm(), 1e-6) << "between two nodes it is neither";
}

TEST(MotionRows, AreEvenlySpacedAtRatesThatDoNotMeetTheEndToo) {
  const std::vector<double> before = TimesAtRate(1.0, 2.05, 10.0),
                            behind = TimesAtRate(1.0, 2.05, 10.0, LastTime::kBehindEnd);
  ASSERT_EQ(before.size(), 11U);
  EXPECT_EQ(before[3], 1.3);
  EXPECT_DOUBLE_EQ(before.back(), 2.0);
  ASSERT_EQ(behind.size(), 12U);
  EXPECT_DOUBLE_EQ(behind.back(), 2.1);
  for (const LastTime last : {LastTime::kBeforeEnd, LastTime::kBehindEnd})
    EXPECT_EQ(TimesAtRate(0.0, 0.3, 10.0, last).size(), 4U) << "no second row for the same end";
  EXPECT_EQ(Refusal([] { TimesAtRate(0.0, 1.0, 0.0); }), "the rate is 0 Hz; accepted: 0.1 to 10000 Hz");
}

TEST(MotionRows, OfAPlanGoOnToRestBehindItsEndAndOfALogEndBeforeIt) {
  const Walker walker;  // of 2.7 s
  const MotionRows plan = RowsOfPlan(walker.model, walker.plan, 333.0),
                   log = RowsOfLog(walker.model, walker.log, 155.0);
  ASSERT_EQ(plan.size(), 901);
  ASSERT_EQ(log.size(), 419);
  EXPECT_NEAR(plan.time_s.back(), 900.0 / 333.0, 1e-12);
  EXPECT_NEAR(log.time_s.back(), 418.0 / 155.0, 1e-12);
  EXPECT_TRUE(Same(plan.q.back(), walker.plan.whole_body.q.back()));
  EXPECT_EQ(plan.v.back().norm(), 0.0);
  EXPECT_EQ(plan.contact.back(), walker.plan.schedule.phases.back().stance);
  for (const MotionRows* rows : {&plan, &log}) {
    const double step_s = rows->time_s[1] - rows->time_s[0];
    for (std::size_t k = 1; k < rows->time_s.size(); ++k)
      ASSERT_NEAR(rows->time_s[k] - rows->time_s[k - 1], step_s, 1e-9) << k;
  }
}

TEST(MotionRows, OfALogAreItsSamplesAndAreNotMadeDenser) {
  const Walker walker;
  const MotionRows own = RowsOfLog(walker.model, walker.log, 200.0);
  ASSERT_EQ(own.time_s.size(), walker.log.samples.size());
  EXPECT_TRUE(Same(own.q[100], walker.log.samples[100].q));
  EXPECT_EQ(own.contact[100], walker.log.samples[100].contact);
  EXPECT_TRUE(own.a.empty()) << "nothing measures accelerations";
  const MotionRows half = RowsOfLog(walker.model, walker.log, 100.0);
  EXPECT_TRUE(Same(half.q[50], walker.log.samples[100].q)) << "a sample that is met is not interpolated";
  const MotionRows odd = RowsOfLog(walker.model, walker.log, 160.0);
  const VectorX middle = 0.5 * (walker.log.samples[2].q + walker.log.samples[3].q);
  EXPECT_LT((odd.q[2] - middle).norm(), 1e-12) << "2 / 160 Hz is half way between samples 2 and 3";
  const std::string why = Refusal([&] { RowsOfLog(walker.model, walker.log, 400.0); });
  EXPECT_TRUE(synthetic::Says(why, "400 Hz is above the log's rate of 200 Hz")) << why;
}

TEST(MotionCsvText, IsReadBackExactlyAtAnyRate) {
  const Walker walker;
  for (const double rate_hz : {200.0, 333.0}) {
    const MotionRows rows = RowsOfPlan(walker.model, walker.plan, rate_hz);
    const std::string text = MotionCsv(walker.model, rows);
    EXPECT_EQ(text, MotionCsv(walker.model, rows));
    const Result<CsvTable> table = ParseCsvTable(text, "motion.csv");
    ASSERT_TRUE(table) << table.failure().message;
    EXPECT_EQ(table->columns, MotionCsvColumns(walker.model));
    const Result<MotionTable> read = MotionFromCsv(walker.model, *table, {}, {});
    ASSERT_TRUE(read) << read.failure().message;
    ASSERT_EQ(read->rows(), rows.size());
    EXPECT_EQ(read->time_s, rows.time_s);
    for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
      ASSERT_TRUE(Same(read->q[k], rows.q[k].tail(6)) && Same(read->v[k], rows.v[k].tail(6))) << k;
      ASSERT_TRUE(Same(read->a[k], rows.a[k].tail(6)) && Same(read->base_rate[k], rows.v[k].head(6))) << k;
      ASSERT_TRUE(Same(read->base_acceleration[k], rows.a[k].head(6))) << k;
      ASSERT_TRUE(Same(read->tau[k], rows.tau[k]) && read->base_m[k] == rows.q[k].head<3>()) << k;
      ASSERT_EQ(read->contact[k], rows.contact[k]) << k;
    }
  }
}

TEST(MotionCsvText, NamesItsColumnsWithTheirUnits) {
  const Walker walker;
  const std::string text = MotionCsv(walker.model, RowsOfPlan(walker.model, walker.plan, 100.0));
  const std::string head = text.substr(0, text.find('\n'));
  EXPECT_TRUE(
      head.starts_with("time_s,base_x_m,base_y_m,base_z_m,base_qx,base_qy,base_qz,base_qw,q_left_x_m,q_left_y_rad,"
                       "\"q_left, \"\"z\"\"_m\""))
      << head;
  EXPECT_TRUE(head.ends_with("tau_right_z_n,contact_left,contact_right")) << head;
  EXPECT_TRUE(synthetic::Says(head, "v_left_y_rad_s,") && synthetic::Says(head, "tau_left_y_nm,")) << head;
}

TEST(MotionCsvText, LeavesOutWhatThereIsNotAndRefusesWhatIsNotFinite) {
  Walker walker;
  walker.plan.whole_body.tau.clear();
  MotionRows rows = RowsOfPlan(walker.model, walker.plan, 100.0);
  EXPECT_FALSE(synthetic::Says(MotionCsv(walker.model, rows), "tau_"));
  rows.q[3][7] = NAN;
  EXPECT_EQ(Refusal([&] { MotionCsv(walker.model, rows); }),
            "column 'q_left_x_m' is nan at 0.03 s; only finite numbers are exported");
}

TEST(JointTrajectoryText, IsReadBackExactlyAsYaml) {
  const Walker walker;
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 250.0);
  const Result<MotionTable> read =
      ParseJointTrajectory(walker.model, JointTrajectoryYaml(walker.model, rows), "trajectory.yaml", {});
  ASSERT_TRUE(read) << read.failure().message;
  ASSERT_EQ(read->rows(), rows.size());
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    EXPECT_NEAR(read->time_s[k], rows.time_s[k] - rows.time_s.front(), 0.6e-9) << "whole nanoseconds";
    ASSERT_TRUE(Same(read->q[k], rows.q[k].tail(6)) && Same(read->v[k], rows.v[k].tail(6))) << k;
    ASSERT_TRUE(Same(read->tau[k], rows.tau[k])) << k;
  }
}

TEST(JointTrajectoryText, IsTheSameMessageAsJson) {
  const Walker walker;
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 250.0);
  const auto json = nlohmann::json::parse(JointTrajectoryJson(walker.model, rows));
  EXPECT_EQ(json.at("header").dump(), R"({"frame_id":"","stamp":{"nanosec":0,"sec":0}})");
  EXPECT_EQ(json.at("joint_names"), nlohmann::json(walker.model.dof_names));
  ASSERT_EQ(json.at("points").size(), rows.time_s.size());
  const nlohmann::json& point = json.at("points").at(333);
  EXPECT_EQ(point.at("time_from_start"), (nlohmann::json{{"sec", 1}, {"nanosec", 332000000}}));
  for (int dof = 0; dof < 6; ++dof) {
    EXPECT_EQ(point.at("positions").at(static_cast<std::size_t>(dof)), rows.q[333][7 + dof]);
    EXPECT_EQ(point.at("accelerations").at(static_cast<std::size_t>(dof)), rows.a[333][6 + dof]);
    EXPECT_EQ(point.at("effort").at(static_cast<std::size_t>(dof)), rows.tau[333][dof]);
  }
}

TEST(JointTrajectoryText, IsReadBackExactlyAsJson) {
  const Walker walker;
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 250.0);
  const Result<MotionTable> read =
      ParseJointTrajectoryJson(walker.model, JointTrajectoryJson(walker.model, rows), "trajectory.json", {});
  ASSERT_TRUE(read) << read.failure().message;
  ASSERT_EQ(read->rows(), rows.size());
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    ASSERT_TRUE(Same(read->q[k], rows.q[k].tail(6)) && Same(read->v[k], rows.v[k].tail(6))) << k;
    ASSERT_TRUE(Same(read->tau[k], rows.tau[k])) << k;
  }
}

TEST(JointTrajectoryText, HasDecimalsThatEveryReaderTakesForSuch) {
  Walker walker;
  MotionRows rows = RowsOfPlan(walker.model, walker.plan, 250.0);
  rows.q[0].tail(6) << 2.0, 1e-5, -0.0, 1e20, 0.1, -3.0;
  const std::string yaml = JointTrajectoryYaml(walker.model, rows);
  EXPECT_TRUE(synthetic::Says(yaml, "- positions: [2.0, 1.0e-05, 0.0, 1.0e+20, 0.1, -3.0]\n")) << yaml.substr(0, 400);
}

TEST(JointTrajectoryText, OfALogHasEmptyAccelerations) {
  const Walker walker;
  const MotionRows rows = RowsOfLog(walker.model, walker.log, 100.0);
  const auto json = nlohmann::json::parse(JointTrajectoryJson(walker.model, rows));
  EXPECT_TRUE(json.at("points").at(0).at("accelerations").empty());
  EXPECT_EQ(json.at("points").at(0).at("effort").size(), 6U);
}

TEST(ExportMotion, SaysWhatAFormatLeavesOut) {
  const Walker walker;
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
  Walker walker;
  walker.log.robot_hash = "abc";
  const std::string why = Refusal([&] { ExportLog(walker.model, walker.log, nullptr, ExportFormat::kCsv, 0.0, "a"); });
  EXPECT_TRUE(synthetic::Says(why, "the log is of robot 'block_biped' (abc)")) << why;
  walker.log.robot_hash = "";
  walker.log.plan_hash = "other";
  const std::string plan =
      Refusal([&] { ExportLog(walker.model, walker.log, &walker.plan, ExportFormat::kCsv, 0.0, "a"); });
  EXPECT_TRUE(synthetic::Says(plan, "the log was played from plan other")) << plan;
  EXPECT_TRUE(synthetic::Says(Refusal([] { ExportFormatOf("cvs"); }), "the nearest is 'csv'"));
}

TEST(ExportMotion, DrawsOneMotionAndTwoOverEachOther) {
  const Walker walker;
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

}  // namespace
}  // namespace gaitwright
