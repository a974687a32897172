// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trials_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "kinematics/base/file.h"
#include "planning/plan/json_part_internal.h"
#include "playback/score/reason.h"
#include "playback/trials/wilson.h"
#include "workflows/study/trial.h"

namespace gaitwright {
namespace {

constexpr int kMaxCount = 1000000000;

JsonPart Needed(const JsonPart& object, const char* key) {
  if (!object.json().is_object()) object.Refuse("is not an object; a result of 'gaitwright trials' is needed");
  if (!object.Has(key) && object.Has("format"))
    object.Refuse(fmt::format("is a {}; a result of 'gaitwright trials' is needed", object.At("format").Text()));
  if (!object.Has(key)) object.Refuse(fmt::format("lacks the key '{}'", key));
  return object.At(key);
}

std::string TextOf(const JsonPart& part) {
  std::string text = part.Text();
  if (text.empty()) part.Refuse("is empty; a text is needed");
  return text;
}

std::vector<TrialsResult::Cause> CausesOf(const JsonPart& result) {
  const JsonPart given = Needed(result, "causes");
  if (!given.json().is_object()) given.Refuse("is not an object of counts");
  std::vector<TrialsResult::Cause> causes;
  for (const auto& [key, value] : given.json().items()) {
    if (!IsCauseOfFall(key)) given.Refuse(fmt::format("has '{}', which is not a cause of falls", key));
    causes.push_back({key, given.At(key).Whole(1, kMaxCount)});
  }
  return causes;
}

/// One row of `trials`.
struct TrialRow {
  bool survived = false, passed = false;
  std::string cause, log_hash;
};

std::vector<TrialRow> RowsOf(const JsonPart& result) {
  const JsonPart trials = Needed(result, "trials"), columns = Needed(trials, "columns");
  std::vector<std::string> names;
  for (const JsonPart& column : columns.List()) names.push_back(column.Text());
  const auto place = [&](const char* name) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) columns.Refuse(fmt::format("lacks the column '{}'", name));
    return static_cast<std::size_t>(at - names.begin());
  };
  const std::size_t survived = place("survived"), passed = place("passed"), cause = place("cause"),
                    log_hash = place("log_hash");
  std::vector<TrialRow> rows;
  for (const JsonPart& row : Needed(trials, "rows").List()) {
    const std::vector<JsonPart> cells = row.List();
    if (cells.size() != names.size())
      row.Refuse(fmt::format("has {} values for {} columns", cells.size(), names.size()));
    rows.push_back({cells[survived].Truth(), cells[passed].Truth(), cells[cause].Text(), TextOf(cells[log_hash])});
    if (rows.back().passed && !rows.back().survived) row.Refuse("passed every gate but did not survive");
  }
  return rows;
}

std::vector<TrialsResult::Worst> WorstOf(const JsonPart& result) {
  std::vector<TrialsResult::Worst> worst;
  if (!result.Has("worst")) return worst;
  for (const JsonPart& entry : result.At("worst").List()) {
    TrialsResult::Worst of_one;
    of_one.seed = Needed(entry, "seed").Natural();
    for (const char* key : {"reason", "cause"}) {
      if (of_one.words.empty() && entry.Has(key) && entry.At(key).json().is_string())
        of_one.words = entry.At(key).Text();
    }
    worst.push_back(of_one);
  }
  return worst;
}

/// Reads all options of a playback; all are required, so that the person who signs knows all of them.
OptionTexts OptionsOf(const JsonPart& result) {
  const JsonPart given = Needed(result, "options");
  if (!given.json().is_object()) given.Refuse("is not an object of options");
  PlayRequest request;
  for (const OptionField& field : request.Fields()) {
    if (!given.Has(field.key))
      given.Refuse(fmt::format("lacks '{}'; a result of this version contains every playback option", field.key));
  }
  OptionTexts options;
  for (const auto& [key, value] : given.json().items()) options.emplace_back(key, given.At(key).Text());
  return options;
}

std::string DisturbancesOf(const JsonPart& result) {
  const JsonPart given = Needed(result, "disturbances");
  std::string text = given.Text();
  PlayRequest request;
  const Result<Disturbances> read = ReadDisturbances(text, SensorFields(request), "disturbances");
  if (!read) given.Refuse(fmt::format("cannot be read: {}", read.failure().message));
  return text;
}

/// Refuses counts that do not match the rows.
void CheckCounts(const JsonPart& part, const TrialsResult& result, const std::vector<TrialRow>& rows) {
  const auto hold = [&](int said, const std::string& what, auto is) {
    const auto counted = std::count_if(rows.begin(), rows.end(), is);
    if (said != counted)
      part.Refuse(fmt::format("says that {} of {} trials {}, but {} of its rows did", said, result.n, what, counted));
  };
  if (static_cast<std::size_t>(result.n) != rows.size())
    part.Refuse(fmt::format("says that there were {} trials, but has rows of {}", result.n, rows.size()));
  hold(result.survived, "survived", [](const TrialRow& row) { return row.survived; });
  hold(result.passed, "passed every gate", [](const TrialRow& row) { return row.passed; });
  int counted = 0;
  for (const TrialsResult::Cause& cause : result.causes) {
    hold(cause.count, fmt::format("fell as '{}'", cause.name),
         [&](const TrialRow& row) { return !row.survived && row.cause == cause.name; });
    counted += cause.count;
  }
  if (counted != result.n - result.survived)
    part.Refuse(fmt::format("has causes of {} falls, but {} trials fell", counted, result.n - result.survived));
}

/// Refuses an interval that does not match the counts.
void CheckInterval(const JsonPart& part, const TrialsResult& result) {
  constexpr double kRounded = 1e-3;
  const ShareInterval is = WilsonInterval(result.survived, result.n);
  if (std::abs(is.share - result.survival) <= kRounded && std::abs(is.low - result.survival_low) <= kRounded &&
      std::abs(is.high - result.survival_high) <= kRounded)
    return;
  part.Refuse(
      fmt::format("says a survival rate of {} in {} to {}, but {} of {} trials survived ({:.4g} in {:.4g} to {:.4g})",
                  result.survival, result.survival_low, result.survival_high, result.survived, result.n, is.share,
                  is.low, is.high));
}

/// Counts each log once, with the worst result of its trials.
void CountDifferent(const std::vector<TrialRow>& rows, TrialsResult& result) {
  std::map<std::string, TrialRow> logs;
  for (const TrialRow& row : rows) {
    TrialRow& counted = logs.emplace(row.log_hash, row).first->second;
    counted.survived = counted.survived && row.survived;
    counted.passed = counted.passed && row.passed;
  }
  result.different = static_cast<int>(logs.size());
  for (const auto& [hash, row] : logs) {
    result.different_survived += row.survived ? 1 : 0;
    result.different_passed += row.passed ? 1 : 0;
  }
}

TrialsResult Read(const JsonPart& part) {
  TrialsResult result;
  result.n = Needed(part, "n").Whole(1, kMaxCount);
  result.survived = Needed(part, "survived").Whole(0, kMaxCount);
  result.passed = Needed(part, "passed").Whole(0, kMaxCount);
  result.survival = Needed(part, "survival").NumberIn(0.0, 1.0);
  result.survival_low = Needed(part, "survival_low").NumberIn(0.0, 1.0);
  result.survival_high = Needed(part, "survival_high").NumberIn(0.0, 1.0);
  result.plan_hash = TextOf(Needed(part, "plan_hash"));
  result.whole_plan_hash = TextOf(Needed(part, "whole_plan_hash"));
  result.robot_hash = TextOf(Needed(part, "robot_hash"));
  if (part.Has("controller")) result.controller = part.At("controller").Text();
  if (part.Has("repeat")) result.repeat = part.At("repeat").Text();
  result.options = OptionsOf(part);
  result.disturbances = DisturbancesOf(part);
  result.causes = CausesOf(part);
  result.worst = WorstOf(part);
  const std::vector<TrialRow> rows = RowsOf(part);
  CheckCounts(part, result, rows);
  CheckInterval(part, result);
  CountDifferent(rows, result);
  return result;
}

}  // namespace

Result<TrialsResult> TrialsResultFromJson(const std::string& text, const std::string& source) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kTrialsResult,
                   "TrialsResult",
                   fmt::format("the trials' result '{}': {}", source, message),
                   {}};
  };
  try {
    const JsonPart::Json json = ParseJsonOnce(text);
    return Read(JsonPart(json));
  } catch (const JsonPart::Json::exception&) {
    return bad(ReasonNoJson(text));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

Result<TrialsResult> LoadTrialsResult(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  return TrialsResultFromJson(*text, path);
}

}  // namespace gaitwright
