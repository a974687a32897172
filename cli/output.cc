// SPDX-License-Identifier: BSD-3-Clause
#include "cli/output.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "kinematics/base/file.h"
#include "planning/plan/parts_text.h"
#include "planning/plan/plan_json.h"
#include "playback/log/log_json.h"
#include "playback/report/plot_style.h"
#include "playback/report/plots.h"
#include "playback/score/agreement.h"
#include "playback/score/report_text.h"
#include "playback/trials/trial_outcome.h"

namespace gaitwright::cli {
namespace {

/// The values that a trial drew, by name; empty for a playback that is not a trial.
std::vector<std::pair<std::string, std::string>> DrawnOf(const PlaybackLog& log) {
  constexpr char kTrial[] = "trial.";
  std::vector<std::pair<std::string, std::string>> drawn;
  for (const auto& [key, text] : log.options) {
    if (key.starts_with(kTrial)) drawn.emplace_back(key.substr(sizeof(kTrial) - 1), text);
  }
  return drawn;
}

/// "mass_scale 0.9079, friction 0.5676"; the start positions of single joints are only in the output of --json and in
/// the log.
std::string DrawnText(const std::vector<std::pair<std::string, std::string>>& drawn) {
  std::string line;
  for (const auto& [name, text] : drawn) {
    if (name.starts_with("start.joint.")) continue;
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", name, *end == 0 ? fmt::format("{:.4g}", value) : text);
  }
  return line;
}

/// Adds the result of each engine, if two engines have played.
void AddEngines(const Judged& judged, nlohmann::ordered_json& json) {
  json["engine"] = EngineOf(judged.played.log);
  const SecondPlayback* second = judged.played.second.get();
  if (second == nullptr) return;
  json["engines"] = nlohmann::ordered_json::array();
  const ScoredPlayback* const both[] = {&judged.played, second};
  for (const ScoredPlayback* played : both) {
    auto one = ParsedJson(ReportJson(played->report));
    one.erase("robot");
    one["engine"] = EngineOf(played->log);
    one["log_hash"] = SamplesHash(played->log);
    one["playback_realtime_factor"] = played->realtime_factor;
    json["engines"].push_back(std::move(one));
  }
  json["agreement"] = ParsedJson(AgreementJson(second->agreement));
}

}  // namespace

void Outputs::AddTo(Verb verb) {
  verb.SetGroup("Output");
  AddText(verb, "--out-dir", "FOLDER", folder,
          "Folder for plan.json, log.json and report.html, created if missing; default out.");
  AddText(verb, "--plot-dir", "FOLDER", plot_folder,
          "Also write the plots into this folder, as SVG files; default: none.");
}

void Outputs::AddPathsTo(Paths& paths) const {
  paths.Write("the plan of --out-dir", PathOf(plan), {".json"});
  paths.Write("the log of --out-dir", PathOf(log), {".json"});
  paths.Write("the second log of --out-dir", PathOf(second_log), {".json"});
  paths.Write("the report of --out-dir", PathOf(report), {".html"});
  paths.plot_folder = plot_folder;
}

std::string Outputs::PathOf(const std::string& name) const {
  return name.empty() ? "" : (std::filesystem::path(folder) / name).string();
}

Result<Files> WriteOutputs(const Judged& judged, const Outputs& outputs) {
  const std::filesystem::path plot_folder(outputs.plot_folder);
  Files files;
  std::vector<OutputFile> texts;
  const auto render = [&](const char* kind, const std::string& name, const auto& text) {
    if (name.empty()) return;
    files.emplace_back(kind, outputs.PathOf(name));
    texts.push_back({files.back().second, text()});
  };
  render("plan", outputs.plan, [&] { return PlanToJson(judged.plan); });
  render("log", outputs.log, [&] { return LogToJson(judged.played.log); });
  if (judged.played.second != nullptr)
    render("second_log", outputs.second_log, [&] { return LogToJson(judged.played.second->log); });
  render("report", outputs.report, [&] { return WalkReport(judged); });
  if (!outputs.plot_folder.empty()) {
    for (const Plot& plot : MakePlots(judged.model, judged.plan, judged.played.log, judged.played.report))
      texts.push_back({(plot_folder / (plot.name + ".svg")).string(), StandaloneSvg(plot.svg)});
    files.emplace_back("plots", outputs.plot_folder);
  }
  const auto written = WriteFilesTogether(texts);
  if (!written) return written.failure();
  if (judged.played.second == nullptr && !outputs.folder.empty() && !outputs.second_log.empty()) {
    std::error_code none_of_it;  // a log of an older plan, if there is one
    std::filesystem::remove(outputs.PathOf(outputs.second_log), none_of_it);
  }
  return files;
}

void PrintJudged(const Judged& judged, const Files& files, const Common& common,
                 const std::vector<std::pair<std::string, std::string>>& more) {
  if (common.json) {
    auto json = nlohmann::ordered_json::object();
    for (const auto& [key, text] : more) json[key] = ParsedJson(text);
    auto report = ParsedJson(ReportJson(judged.played.report));
    if (json.contains("notes")) {
      for (auto& note : report["notes"]) json["notes"].push_back(std::move(note));
      report.erase("notes");
    }
    json.update(report);
    json["audit"] = ParsedJson(AuditJson(judged.audit));
    json["warnings"] = judged.plan.warnings;
    json["adjustments"] = ParsedJson(AdjustmentsJson(judged.plan.adjustments));
    const StabilityReport& decisive = judged.played.decisive().report;
    json["verdict"] = judged.pass() ? "pass" : "fail";
    json["score"] = decisive.score;
    json["reason"] = decisive.pass && !judged.pass() ? judged.objection() : decisive.reason;
    AddEngines(judged, json);
    const auto drawn = DrawnOf(judged.played.log);
    for (const auto& [name, text] : drawn) json["drawn"][name] = text;
    json["log_hash"] = SamplesHash(judged.played.log);
    json["planning_cpu_s"] = judged.planning_cpu_s;
    json["playback_realtime_factor"] = judged.played.realtime_factor;
    json["files"] = nlohmann::ordered_json::object();
    for (const auto& [kind, path] : files) json["files"][kind] = path;
    PrintJson(json);
    return;
  }
  if (common.quiet) {
    fmt::print("{}\n", judged.pass() ? "pass" : "fail");
    return;
  }
  if (!judged.objection().empty() && judged.played.pass()) fmt::print("FAIL   {}; in physics:\n", judged.objection());
  const SecondPlayback* second = judged.played.second.get();
  fmt::print("{}", second == nullptr ? ReportText(judged.played.report)
                                     : ReportText(judged.played.report, second->report, second->agreement));
  if (const std::string parts = PartsText(judged.plan.parts); !parts.empty()) fmt::print("\nparts: {}\n", parts);
  fmt::print("\n{}", AuditText(judged.audit));
  for (const Adjustment& adjustment : judged.plan.adjustments) fmt::print("adjusted: {}\n", AdjustmentText(adjustment));
  for (const std::string& warning : judged.plan.warnings) fmt::print("warning: {}\n", warning);
  if (const auto drawn = DrawnOf(judged.played.log); !drawn.empty()) {
    fmt::print("drawn: {}\nlog hash {}\n", DrawnText(drawn), SamplesHash(judged.played.log));
  }
  if (judged.planning_cpu_s > 0.0) fmt::print("planned in {:.2f} s of CPU, ", judged.planning_cpu_s);
  fmt::print("played at {:.1f} times real time\n", judged.played.realtime_factor);
  for (const auto& [kind, path] : files) fmt::print("{:<7} {}\n", kind == "second_log" ? "log" : kind, path);
}

}  // namespace gaitwright::cli
