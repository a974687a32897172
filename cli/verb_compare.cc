// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/compare_input.h"
#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "kinematics/base/file.h"
#include "playback/play/play.h"
#include "playback/score/agreement.h"
#include "workflows/compare/comparison_text.h"

namespace gaitwright::cli {
namespace {

struct CompareSettings {
  Common common;
  CompareFiles files;
  CompareOptions options;
  std::string report;
  bool require_same = false;

  OptionFields Fields() { return Joined({options.Fields(), files.units.UnitFields()}); }
};

void CheckComparePaths(const CompareSettings& a) {
  const CompareFiles& files = a.files;
  Paths paths;
  paths.Read("A", files.a);
  paths.Read("B", files.b);
  paths.Read("--plan", files.robot.plan);
  paths.Read("--columns", files.columns);
  paths.Read("--columns-b", files.columns_b);
  paths.Write("--report", a.report, {".html"});
  files.robot.robot.AddTo(paths);
  CheckPaths(paths);
}

/// Writes the page and prints the comparison. @param page makes the page; called only with --report.
template <class Page>
int PrintComparison(const CompareSettings& a, const std::string& text, const std::string& json_text, bool same,
                    Page page) {
  auto json = ParsedJson(json_text);
  json["files"] = nlohmann::ordered_json::object();
  if (!a.report.empty()) {
    const auto written = WriteFileAtomically(a.report, page());
    if (!written) return Report(written.failure(), a.common);
    json["files"]["report"] = a.report;
  }
  if (a.common.json) {
    PrintJson(json);
  } else if (a.common.quiet) {
    fmt::print("{}\n", same ? "same" : "different");
  } else {
    fmt::print("{}", text);
    if (!a.report.empty()) fmt::print("report  {}\n", a.report);
  }
  return a.require_same && !same ? kVerdictFail : kPass;
}

/// Agreement of two logs of the plan of --plan, such as logs of two engines.
std::optional<Agreement> AgreementOfLogs(const CompareInput& input) {
  if (!input.played || !input.a->log || !input.b->log) return std::nullopt;
  const std::string hash = MotionHash(*input.played);
  if (input.a->log->plan_hash != hash || input.b->log->plan_hash != hash) return std::nullopt;
  return AgreementOf(input.a->model, *input.played, *input.a->log, *input.b->log);
}

int RunCompare(CompareSettings& a) {
  ApplySets("--set", a.common.sets, a.Fields());
  CheckComparePaths(a);
  const Result<CompareInput> input = ReadCompareInput(a.files);
  if (!input) return Report(input.failure(), a.common);
  if (input->report_a) {
    const ReportComparison reports = CompareReports(*input->report_a, *input->report_b, a.options.tolerance);
    return PrintComparison(a, ComparisonText(reports), ComparisonJson(reports), reports.same(),
                           [&] { return ComparisonPage(reports); });
  }
  const MotionComparison motions = CompareMotions(*input->a, *input->b, a.options);
  const std::vector<MetricPair> metrics =
      MetricsOf(*input->a, *input->b, input->played ? &*input->played : nullptr, a.options.tolerance);
  std::string text = ComparisonText(motions, metrics);
  auto json = ParsedJson(ComparisonJson(motions, metrics));
  if (const std::optional<Agreement> agreement = AgreementOfLogs(*input)) {
    text += "playback: " + AgreementText(*agreement) + "\n";
    json["agreement"] = ParsedJson(AgreementJson(*agreement));
  }
  return PrintComparison(a, text, json.dump(), motions.same(),
                         [&] { return ComparisonPage(*input->a, *input->b, motions, metrics); });
}

}  // namespace

void AddCompare(Verb program, int& status) {
  auto a = std::make_shared<CompareSettings>();
  const Verb verb = program.AddVerb("compare", "Compare two plans, logs or reports, or a robot's log with its plan");
  AddText(verb, "A", "FILE", a->files.a,
          "A plan, a log, a report (output of 'walk --json' or 'play --json'), a CSV of a motion or a ROS joint "
          "trajectory.")
      .Require();
  AddText(verb, "B", "FILE", a->files.b, "The file to compare with A; differences are B - A.").Require();
  const OptionFields fields = a->Fields();
  AddField(verb, "--align", fields, "align");
  AddField(verb, "--tolerance", fields, "tolerance");
  verb.AddSwitch("--require-same", a->require_same,
                 "Exit with status 3 if any difference is beyond its tolerance; default: status 0.");
  AddText(verb, "--report", "FILE", a->report,
          "Write the comparison to this HTML file, with plots of both motions; default: none.");
  verb.SetGroup("Reading a CSV");
  AddText(verb, "--columns", "FILE", a->files.columns,
          "YAML file that maps the columns of a CSV, see docs/import.md; default: by the CSV's header.");
  AddText(verb, "--columns-b", "FILE", a->files.columns_b,
          "YAML file that maps the columns of B, if A and B are CSVs with different names or units; default: the file "
          "of --columns.");
  AddField(verb, "--quaternion-order", fields, "quaternion_order");
  AddField(verb, "--angle-unit", fields, "angle_unit");
  AddField(verb, "--length-unit", fields, "length_unit");
  AddField(verb, "--time-unit", fields, "time_unit");
  a->files.robot.AddTo(verb);
  AddCommon(verb, a->common,
            {"compare plan.json out/plan.json", "compare out/plan.json out/log.json --report compare.html",
             "compare plan.json motion.csv --align best"});
  AddOptionFlags(verb, fields, a->common.sets, a->common.json);
  SetWork(verb, a->common, status, [a] { return RunCompare(*a); });
}

}  // namespace gaitwright::cli
