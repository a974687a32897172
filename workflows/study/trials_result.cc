// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trials_result.h"

#include <fmt/format.h>

#include <cmath>

#include "kinematics/base/file.h"
#include "planning/plan/json_part_internal.h"
#include "playback/trials/wilson.h"

namespace gaitwright {
namespace {

constexpr int kMost = 1000000000;

JsonPart Needed(const JsonPart& object, const char* key) {
  if (!object.json().is_object()) object.Refuse("is no object; one that 'gaitwright trials' wrote is needed");
  if (!object.Has(key)) object.Refuse(fmt::format("lacks the key '{}'", key));
  return object.At(key);
}

std::string TextOf(const JsonPart& part) {
  const std::string text = part.Text();
  if (text.empty()) part.Refuse("is empty; a text is needed");
  return text;
}

/// The first text and the first whole number of an object, whatever their keys.
TrialsResult::Cause CauseOf(const JsonPart& part) {
  TrialsResult::Cause cause;
  bool counted = false;
  for (const auto& [key, value] : part.json().items()) {
    if (value.is_string() && cause.name.empty()) cause.name = value.get<std::string>();
    if (!value.is_number_integer() || counted) continue;
    cause.count = part.At(key).Whole(0, kMost);
    counted = true;
  }
  if (cause.name.empty() || !counted) part.Refuse("has no name and count");
  return cause;
}

std::vector<TrialsResult::Cause> CausesOf(const JsonPart& result) {
  std::vector<TrialsResult::Cause> causes;
  if (!result.Has("causes")) return causes;
  const JsonPart given = result.At("causes");
  if (given.json().is_object()) {
    for (const auto& [key, value] : given.json().items()) causes.push_back({key, given.At(key).Whole(0, kMost)});
    return causes;
  }
  for (const JsonPart& entry : given.List()) {
    if (!entry.json().is_object()) entry.Refuse("is no object with a name and a count");
    causes.push_back(CauseOf(entry));
  }
  return causes;
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

OptionTexts OptionsOf(const JsonPart& result) {
  const JsonPart given = Needed(result, "options");
  if (!given.json().is_object()) given.Refuse("is no object of options");
  OptionTexts options;
  for (const auto& [key, value] : given.json().items()) options.emplace_back(key, given.At(key).Text());
  return options;
}

void CheckFigures(const JsonPart& part, const TrialsResult& result) {
  if (result.survived > result.n) {
    part.Refuse(fmt::format("says that {} of {} trials survived; there are no more survivors than trials",
                            result.survived, result.n));
  }
  if (result.passed > result.survived) {
    part.Refuse(fmt::format("says that {} trials passed every gate, where {} survived; no more can", result.passed,
                            result.survived));
  }
  constexpr double kRounded = 1e-3;
  const ShareInterval is = WilsonInterval(result.survived, result.n);
  if (std::abs(is.share - result.survival) > kRounded || std::abs(is.low - result.survival_low) > kRounded ||
      std::abs(is.high - result.survival_high) > kRounded) {
    part.Refuse(
        fmt::format("says a survival of {} in {} to {}, where {} of {} trials survived ({:.4g} in {:.4g} to "
                    "{:.4g})",
                    result.survival, result.survival_low, result.survival_high, result.survived, result.n, is.share,
                    is.low, is.high));
  }
  for (const TrialsResult::Cause& cause : result.causes) {
    if (cause.count > result.n)
      part.Refuse(fmt::format("says that {} of {} trials ended as '{}'", cause.count, result.n, cause.name));
  }
}

TrialsResult Read(const JsonPart& part) {
  TrialsResult result;
  result.n = Needed(part, "n").Whole(1, kMost);
  result.survived = Needed(part, "survived").Whole(0, kMost);
  result.passed = Needed(part, "passed").Whole(0, kMost);
  result.survival = Needed(part, "survival").NumberIn(0.0, 1.0);
  result.survival_low = Needed(part, "survival_low").NumberIn(0.0, 1.0);
  result.survival_high = Needed(part, "survival_high").NumberIn(0.0, 1.0);
  result.plan_hash = TextOf(Needed(part, "plan_hash"));
  result.whole_plan_hash = TextOf(Needed(part, "whole_plan_hash"));
  result.robot_hash = TextOf(Needed(part, "robot_hash"));
  if (part.Has("controller")) result.controller = part.At("controller").Text();
  if (part.Has("disturbances")) result.disturbances = part.At("disturbances").Text();
  if (part.Has("repeat")) result.repeat = part.At("repeat").Text();
  result.options = OptionsOf(part);
  result.causes = CausesOf(part);
  result.worst = WorstOf(part);
  CheckFigures(part, result);
  return result;
}

}  // namespace

Result<TrialsResult> TrialsResultFromJson(const std::string& text, const std::string& source) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   "trials_result",
                   "TrialsResult",
                   fmt::format("the trials' result '{}': {}", source, message),
                   {}};
  };
  try {
    const JsonPart::Json json = ParseJsonOnce(text);
    return Read(JsonPart(json));
  } catch (const JsonPart::Json::exception&) {
    return bad(WhyNoJson(text));
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
