// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/sweep_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "planning/plan/json_part_internal.h"
#include "playback/play/make_world.h"
#include "playback/score/agreement.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

std::string OrEmpty(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : ""; }

/// A cell; quoted if it contains a comma, a quote or a line end (RFC 4180).
std::string Cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string Row(const std::vector<std::string>& cells) {
  std::string row;
  for (const std::string& cell : cells) row += (row.empty() ? "" : ",") + Cell(cell);
  return row + "\n";
}

bool PlaysInTwo(const Study& study) { return study.play.play.world.engine == "both"; }

/// Verdict and score of each engine; empty if only one has played.
std::vector<std::string> EngineCells(const PointOutcome& o) {
  std::vector<std::string> cells;
  for (const std::string& name : EngineNames()) {
    const auto of = std::find_if(o.engines.begin(), o.engines.end(), [&](const auto& v) { return v.engine == name; });
    const bool has_played = of != o.engines.end();
    cells.push_back(has_played ? VerdictName(*of) : "");
    cells.push_back(has_played ? fmt::format("{}", of->score) : "");
  }
  return cells;
}

std::vector<std::string> Heads(const Study& study) {
  std::vector<std::string> heads = {"point"};
  for (const StudyAxis& axis : study.axes) heads.push_back(axis.key);
  heads.insert(heads.end(), {"status", "code", "score"});
  heads.insert(heads.end(), study.metrics.begin(), study.metrics.end());
  heads.emplace_back("fell_at_s");
  if (PlaysInTwo(study)) {
    for (const std::string& name : EngineNames()) heads.insert(heads.end(), {name + "_verdict", name + "_score"});
  }
  if (study.trials > 0) {
    heads.insert(heads.end(), {"trials", "survived", "survival", "survival_low", "survival_high", "trial_score_mean"});
  }
  heads.emplace_back("reason");
  return heads;
}

std::vector<std::string> Cells(const Study& study, const PointOutcome& o) {
  std::vector<std::string> cells = {std::to_string(o.point)};
  cells.insert(cells.end(), study.points[o.point].begin(), study.points[o.point].end());
  cells.insert(cells.end(), {StatusName(o.status), o.code, OrEmpty(o.score)});
  for (std::size_t k = 0; k < study.metrics.size(); ++k)
    cells.push_back(k < o.metrics.size() ? OrEmpty(o.metrics[k]) : "");
  cells.push_back(OrEmpty(o.fell_at_s));
  if (PlaysInTwo(study)) {
    const std::vector<std::string> of_engines = EngineCells(o);
    cells.insert(cells.end(), of_engines.begin(), of_engines.end());
  }
  if (study.trials > 0 && o.survival) {
    const PointSurvival& s = *o.survival;
    cells.insert(cells.end(), {std::to_string(s.trials), std::to_string(s.survived)});
    for (const double figure : {s.share, s.low, s.high, s.score_mean}) cells.push_back(fmt::format("{}", figure));
  } else if (study.trials > 0) {
    cells.insert(cells.end(), 6, "");
  }
  cells.push_back(o.reason);
  return cells;
}

/// A value as JSON; a number if the axis has numbers.
Json ValueJson(const StudyAxis& axis, const std::string& value) {
  if (axis.numbers) return Json::parse(value);
  return value == "true" || value == "false" ? Json(value == "true") : Json(value);
}

Json AxisJson(const StudyAxis& axis) {
  Json values = Json::array();
  for (const std::string& value : axis.values) values.push_back(ValueJson(axis, value));
  return {{"key", axis.key},
          {"unit", axis.unit},
          {"from", axis.numbers ? Json(axis.low) : Json()},
          {"to", axis.numbers ? Json(axis.high) : Json()},
          {"values", axis.is_range() ? Json() : values}};
}

Json ValuesJson(const Study& study, std::size_t point) {
  Json values = Json::object();
  for (std::size_t k = 0; k < study.axes.size(); ++k)
    values[study.axes[k].key] = ValueJson(study.axes[k], study.points[point][k]);
  return values;
}

Json EnginesJson(const std::vector<EngineVerdict>& engines) {
  Json json = Json::array();
  for (const EngineVerdict& v : engines)
    json.push_back({{"engine", v.engine}, {"verdict", VerdictName(v)}, {"score", v.score}, {"cause", v.cause}});
  return json;
}

Json PointJson(const Study& study, const PointOutcome& o) {
  Json metrics = Json::object();
  for (std::size_t k = 0; k < study.metrics.size(); ++k)
    metrics[study.metrics[k]] = k < o.metrics.size() ? JsonOrNull(o.metrics[k]) : Json();
  Json json = {{"point", o.point},
               {"values", ValuesJson(study, o.point)},
               {"status", StatusName(o.status)},
               {"verdict", o.status == PointStatus::kPass ? "pass" : "fail"},
               {"audit_pass", o.status == PointStatus::kRefused ? Json() : Json(o.audit_pass())},
               {"score", JsonOrNull(o.score)},
               {"code", o.code},
               {"reason", o.reason},
               {"fell_at_s", JsonOrNull(o.fell_at_s)},
               {"metrics", metrics}};
  if (!o.engines.empty()) json["engines"] = EnginesJson(o.engines);
  if (study.trials == 0) return json;
  for (const char* key : {"trials", "survived", "survival", "survival_low", "survival_high", "trial_score_mean"})
    json[key] = Json();
  if (!o.survival) return json;
  const PointSurvival& s = *o.survival;
  json["trials"] = s.trials;
  json["survived"] = s.survived;
  json["survival"] = s.share;
  json["survival_low"] = s.low;
  json["survival_high"] = s.high;
  json["trial_score_mean"] = s.score_mean;
  return json;
}

Json CountsJson(const SweepSummary& summary, std::size_t points) {
  Json counts = {{"points", points}};
  for (const PointStatus status : kPointStatuses) counts[StatusName(status)] = summary.Count(status);
  return counts;
}

}  // namespace

std::string SweepCsv(const Study& study, const std::vector<PointOutcome>& outcomes) {
  std::string csv = Row(Heads(study));
  for (const PointOutcome& outcome : outcomes) csv += Row(Cells(study, outcome));
  return csv;
}

std::string SweepJson(const Study& study, const std::vector<PointOutcome>& outcomes, const WrittenFiles& files) {
  const SweepSummary summary = SummaryOf(outcomes);
  Json axes = Json::array(), points = Json::array(), failures = Json::array(), written = Json::object();
  for (const StudyAxis& axis : study.axes) axes.push_back(AxisJson(axis));
  for (const PointOutcome& outcome : outcomes) points.push_back(PointJson(study, outcome));
  for (const FailureGroup& group : FailureGroups(study, outcomes)) {
    failures.push_back({{"status", StatusName(group.status)},
                        {"code", group.code},
                        {"points", group.points},
                        {"where", group.where},
                        {"example", group.example}});
  }
  for (const auto& [kind, path] : files) written[kind] = path;
  const Json json = {{"robot", study.model.name},
                     {"axes", axes},
                     {"points", points},
                     {"best", summary.best ? PointJson(study, outcomes[*summary.best]) : Json()},
                     {"best_play_flags", summary.best ? Json(PlayFlags(study, *summary.best)) : Json()},
                     {"counts", CountsJson(summary, outcomes.size())},
                     {"failures", failures},
                     {"files", written}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string PlayFlags(const Study& study, std::size_t point) {
  std::string flags;
  for (std::size_t k = 0; k < study.axes.size(); ++k) {
    const std::string& key = study.axes[k].key;
    if (!ShapesThePlan(key))
      flags += fmt::format("{}--set {}={}", flags.empty() ? "" : " ", key, study.points[point][k]);
  }
  return flags;
}

std::string EnginesText(const std::vector<PointOutcome>& outcomes) {
  const EngineCounts counts = CountEngines(outcomes);
  if (counts.points() == 0) return "";
  return fmt::format("{} points pass in both, {} only in {}, {} only in {}, {} in neither", counts.both_pass,
                     counts.first_alone, EngineTitle(counts.first), counts.second_alone, EngineTitle(counts.second),
                     counts.none_pass);
}

std::string SweepText(const Study& study, const std::vector<PointOutcome>& outcomes) {
  const SweepSummary summary = SummaryOf(outcomes);
  std::string text = fmt::format("{}: {} points: {} pass, {} fail a gate, {} fell, {} fail the audit, {} refused\n",
                                 study.model.name, outcomes.size(), summary.Count(PointStatus::kPass),
                                 summary.Count(PointStatus::kGateMissed), summary.Count(PointStatus::kFell),
                                 summary.Count(PointStatus::kAuditFailed), summary.Count(PointStatus::kRefused));
  if (summary.best) {
    const PointOutcome& best = outcomes[*summary.best];
    text += fmt::format("best    {}: score {:.1f}", PointText(study.axes, study.points[*summary.best]),
                        best.score.value_or(0.0));
    if (best.survival) {
      text += fmt::format(", {} of {} trials survived ({:.1f} % to {:.1f} %)", best.survival->survived,
                          best.survival->trials, 100.0 * best.survival->low, 100.0 * best.survival->high);
    }
    text += "\n";
  } else {
    text += "best    none: no plan passes its audit\n";
  }
  if (const std::string engines = EnginesText(outcomes); !engines.empty()) text += "engines " + engines + "\n";
  for (const FailureGroup& group : FailureGroups(study, outcomes)) {
    text += fmt::format("{} of {} points {} at {}\n    {}\n", group.points.size(), outcomes.size(),
                        StatusName(group.status) + (group.code.empty() ? "" : " (" + group.code + ")"), group.where,
                        group.example);
  }
  return text;
}

}  // namespace gaitwright
