// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "planning/audit/audit_report.h"
#include "playback/score/report_text.h"
#include "playback/score/stability_report.h"
#include "tests/playback/played.h"
#include "tests/workflows/formats/fits_shape.h"
#include "workflows/formats/result_shapes_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

AuditReport BrokenAudit() {
  AuditReport report;
  report.samples = 100;
  report.violations = {{Law::kJointTorque, 0.5, "knee", 30.0, 25.0, "N m"}};
  report.notes = {"a limit is a placeholder"};
  return report;
}

TEST(WalkShapes, AnAuditHasItsShape) {
  AuditReport report = BrokenAudit();
  EXPECT_EQ(Misfit(Json::parse(AuditJson(report)), AuditShape()), "");
  EXPECT_EQ(Json::parse(AuditJson(report)).at("verdict"), "fail");
  report.margins = {{Law::kJointTorque, 0.5, "knee", 20.0, 25.0, 5.0, {}, "N m"}};
  EXPECT_EQ(Misfit(Json::parse(AuditJson(report)), AuditShape()), "") << "with margins";
  report.violations.clear();
  EXPECT_EQ(Misfit(Json::parse(AuditJson(report)), AuditShape()), "");
}

/// The members that ReportJson writes are members of the result of a walk; the program adds others.
TEST(WalkShapes, AReportHasTheMembersOfAWalksResult) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  synthetic::Played sunk = walker;
  synthetic::Sink(sunk.log, 100, 0.1);
  for (const synthetic::Played& played : {walker, sunk}) {
    const Json report = Json::parse(ReportJson(Score(played.model, played.plan, played.log)));
    const DataShape shape = WalkResultShape();
    for (const auto& [key, value] : report.items()) EXPECT_EQ(Misfit(value, shape.At(key), key), "");
    EXPECT_TRUE(report.contains("metrics") && report.contains("score"));
  }
}

TEST(WalkShapes, MoreMembersComeBehindAndAreNeeded) {
  const DataShape shape = With(SurvivalMembers(), {{"n", shapes::Whole()}, shapes::Optional("note", shapes::Text())});
  EXPECT_EQ(shape.members.size(), 5U);
  const Json json = {{"survival", 0.5}, {"survival_low", 0.25}, {"survival_high", 0.75}, {"n", 4}};
  EXPECT_EQ(Misfit(json, shape), "");
  EXPECT_EQ(Misfit(Without(json, "n"), shape), "$ lacks n");
  EXPECT_EQ(Misfit(json, SurvivalMembers()), "$ has an unknown key n");
}

TEST(WalkShapes, FilesAreThoseOfTheirKindsAsFarAsWritten) {
  const DataShape files = FilesShape({"plan", "log"});
  EXPECT_EQ(Misfit(Json::object(), files), "");
  EXPECT_EQ(Misfit({{"log", "a.json"}}, files), "");
  EXPECT_EQ(Misfit({{"picture", "a.png"}}, files), "$ has an unknown key picture");
  EXPECT_EQ(Misfit({{"plan", 3}}, files), "$.plan is no text");
}

/// Every key of a result is unique, since otherwise a reader could not tell which value counts.
TEST(WalkShapes, NoResultHasAKeyTwice) {
  for (const DataShape& shape : {WalkResultShape(), DoResultShape(), AuditResultShape(), PreflightShape(),
                                 PlanResultShape(), TrialsResultShape(), SweepResultShape(), TuneResultShape(),
                                 ExportResultShape(), ImportResultShape(), ErrorShape()}) {
    const std::vector<std::string> keys = shape.Keys();
    EXPECT_EQ(std::set<std::string>(keys.begin(), keys.end()).size(), keys.size()) << keys.front();
  }
}

}  // namespace
}  // namespace gaitwright
