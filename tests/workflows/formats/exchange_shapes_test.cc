// SPDX-License-Identifier: BSD-3-Clause
// The JSON of comparisons has the shapes of the schemas; `compare` adds the files.
#include <gtest/gtest.h>

#include "playback/score/report_text.h"
#include "playback/score/stability_report.h"
#include "tests/playback/played.h"
#include "tests/workflows/formats/fits_shape.h"
#include "workflows/compare/comparison_text.h"
#include "workflows/formats/result_shapes_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json WithFiles(const std::string& text) {
  Json json = Json::parse(text);
  json["files"] = Json::object();
  return json;
}

Json ComparedObject(const ComparedMotion& a, const ComparedMotion& b) {
  return WithFiles(ComparisonJson(CompareMotions(a, b), {}));
}

TEST(ExchangeShapes, AComparisonOfMotionsHasItsShapeWhateverTheSidesHave) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  synthetic::Played other = walker;
  for (LogSample& sample : other.log.samples) sample.q[8] += 0.2;
  MotionTable table;
  table.format = MotionFormat::kCsv;
  for (const LogSample& sample : walker.log.samples) {
    table.time_s.push_back(sample.time_s);
    table.q.emplace_back(sample.q.tail(6));
  }
  const ComparedMotion plan = ComparedPlan(walker.model, walker.plan, "a"),
                       log = ComparedLog(walker.model, other.log, "b"), csv = ComparedTable(walker.model, table, "c");
  for (const Json& json : {ComparedObject(plan, plan), ComparedObject(plan, log), ComparedObject(log, csv)})
    EXPECT_EQ(Misfit(json, MotionComparisonShape()), "");
  EXPECT_EQ(Misfit(Without(ComparedObject(plan, log), "alignment"), MotionComparisonShape()), "$ lacks alignment");
}

TEST(ExchangeShapes, AComparisonOfReportsHasItsShape) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  synthetic::Played sunk = walker;
  synthetic::Sink(sunk.log, 100, 0.1);
  const auto report = [](const synthetic::Played& played) {
    return ReportFromJson(ReportJson(Score(played.model, played.plan, played.log)), "report.json").value();
  };
  const ReportComparison c = CompareReports(report(walker), report(sunk), 0.05);
  EXPECT_EQ(Misfit(WithFiles(ComparisonJson(c)), ReportComparisonShape()), "");
}

}  // namespace
}  // namespace gaitwright
