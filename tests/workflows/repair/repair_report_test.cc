// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/repair_report_internal.h"

namespace gaitwright {
namespace {

MotionFindings SomeFindings() {
  MotionFindings findings;
  findings.format = MotionFormat::kFramesCsv;
  findings.rows = 201;
  findings.duration_s = 2.0;
  findings.smoothing_hz = 6.0;
  findings.contacts.short_swings = 2;
  findings.rested.motion.step_s = 0.01;
  findings.rested.file_s.assign(301, 0.0);
  findings.rested.stood_start_s = 1.2;
  findings.rested.slowed_end_s = 0.6;
  findings.clean.lift_m = 0.013;
  findings.clean.stances = {{0, 0.5, 1.5, 0.041, 0.0, 0.0}, {1, 0.0, 2.0, 1e-5, 0.0, 0.0}};
  LeftOutPart leap{0.5, 1.25, Pose::Identity(), "no motion was found there"};
  leap.moved.translation() = Vector3(0.2, 0.0, 0.0);
  findings.left_out = {leap};
  findings.parted = {{"'hand' and 'hip'", 0.037, 0.25, 0.75}};
  findings.other_contacts = {{"knee", 1.0, 1.5}};
  findings.not_audited = "it has no feet";
  return findings;
}

TEST(RepairReport, SaysEachChangeInWords) {
  const RobotModel& model = NamedRobot("a1");
  const std::string text = RepairText({model, SomeFindings()});
  for (const char* part :
       {"other contact: link 'knee' is on the ground from 1.00 to 1.50 s of the file",
        "left out: 0.50 to 1.25 s of the file, because no motion was found there; the robot stands instead",
        "and what follows is moved",
        "parted: 'hand' and 'hip' overlap by up to 37.0 mm between 0.25 and 0.75 s in the file",
        "a1: 201 rows of frames-csv, 2.000 s", "before: cannot be audited: it has no feet",
        "smoothed: positions were smoothed above 6 Hz", "0 short stances and 2 short swings were removed",
        "stood: 1.20 s were added at the start", "slowed: the last 0.30 s take 0.60 s",
        "lifted: the base was moved up by 13.0 mm, because the feet sink into the ground"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_NE(text.find("pinned: foot '" + model.feet[0].name + "' from 0.50 to 1.50 s, moved by up to 41.0 mm"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("pinned: foot '" + model.feet[1].name), std::string::npos) << "it hardly moved";
}

TEST(RepairReport, HasTheSameAsData) {
  const auto json = nlohmann::json::parse(RepairJson({NamedRobot("a1"), SomeFindings()}));
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_TRUE(json["before"].is_null());
  EXPECT_FALSE(json.contains("after"));
  std::vector<std::string> kinds;
  for (const auto& change : json["changes"]) kinds.push_back(change["what"]);
  EXPECT_EQ(kinds, (std::vector<std::string>{"smoothed", "contacts", "other_contact", "stood", "slowed", "left_out",
                                             "lifted", "pinned", "parted"}));
  EXPECT_NEAR(json["changes"][5]["by"].get<double>(), 0.75, 1e-12);
  EXPECT_NEAR(json["changes"][7]["by"].get<double>(), 0.041, 1e-12);
  EXPECT_EQ(json["changes"][8]["where"], "'hand' and 'hip'");
}

}  // namespace
}  // namespace gaitwright
