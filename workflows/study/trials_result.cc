// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trials_result.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "kinematics/base/file.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

const Json& At(const Json& object, const char* key) {
  if (!object.is_object() || !object.contains(key)) throw InvalidArgument(fmt::format("lacks the key '{}'", key));
  return object.at(key);
}

int WholeOf(const Json& value, const std::string& what) {
  constexpr std::int64_t kMost = 1000000000;
  const bool whole = value.is_number_integer() && value <= kMost && value >= 0;
  if (!whole) {
    throw InvalidArgument(
        fmt::format("has '{}' of {}; a whole number from 0 to {} is needed", what, value.dump(), kMost));
  }
  return value.get<int>();
}

int WholeAt(const Json& object, const char* key) { return WholeOf(At(object, key), key); }

double ShareAt(const Json& object, const char* key) {
  const Json& value = At(object, key);
  if (!value.is_number() || !(value.get<double>() >= 0.0 && value.get<double>() <= 1.0))
    throw InvalidArgument(fmt::format("has '{}' of {}; a share from 0 to 1 is needed", key, value.dump()));
  return value.get<double>();
}

std::string TextAt(const Json& object, const char* key) {
  const Json& value = At(object, key);
  if (!value.is_string() || value.get<std::string>().empty())
    throw InvalidArgument(fmt::format("has '{}' of {}; a text is needed", key, value.dump()));
  return value.get<std::string>();
}

/// The first text and the first whole number of an object, whatever their keys.
TrialsResult::Cause CauseOf(const Json& object) {
  TrialsResult::Cause cause;
  bool counted = false;
  for (const auto& [key, value] : object.items()) {
    if (value.is_string() && cause.name.empty()) cause.name = value.get<std::string>();
    if (value.is_number_integer() && !counted) cause.count = WholeOf(value, key), counted = true;
  }
  if (cause.name.empty() || !counted) throw InvalidArgument("has an entry of 'causes' without a name and a count");
  return cause;
}

std::vector<TrialsResult::Cause> CausesOf(const Json& result) {
  std::vector<TrialsResult::Cause> causes;
  if (!result.contains("causes")) return causes;
  const Json& given = result.at("causes");
  if (!given.is_object() && !given.is_array())
    throw InvalidArgument("has 'causes' that are no list and no object of counts");
  for (const auto& [key, value] : given.items()) {
    if (value.is_object()) {
      causes.push_back(CauseOf(value));
    } else if (given.is_object() && value.is_number_integer()) {
      causes.push_back({key, WholeOf(value, key)});
    } else {
      throw InvalidArgument(fmt::format("has '{}' among its causes; a count is needed", value.dump()));
    }
  }
  return causes;
}

std::vector<TrialsResult::Worst> WorstOf(const Json& result) {
  std::vector<TrialsResult::Worst> worst;
  if (!result.contains("worst")) return worst;
  if (!result.at("worst").is_array()) throw InvalidArgument("has 'worst' that is no list");
  for (const Json& entry : result.at("worst")) {
    const Json& seed = At(entry, "seed");
    if (!seed.is_number_unsigned())
      throw InvalidArgument(fmt::format("has a seed of {} among its worst; a whole number is needed", seed.dump()));
    TrialsResult::Worst of_one;
    of_one.seed = seed.get<std::uint64_t>();
    for (const auto& [key, value] : entry.items()) {
      if (value.is_string() && of_one.words.empty()) of_one.words = value.get<std::string>();
    }
    worst.push_back(of_one);
  }
  return worst;
}

TrialsResult Read(const Json& json) {
  if (!json.is_object()) throw InvalidArgument("is no object; one that 'gaitwright trials' wrote is needed");
  TrialsResult result;
  result.n = WholeAt(json, "n");
  result.survived = WholeAt(json, "survived");
  result.survival = ShareAt(json, "survival");
  result.survival_low = ShareAt(json, "survival_low");
  result.survival_high = ShareAt(json, "survival_high");
  result.plan_hash = TextAt(json, "plan_hash");
  result.robot_hash = TextAt(json, "robot_hash");
  result.causes = CausesOf(json);
  result.worst = WorstOf(json);
  if (result.n < 1 || result.survived > result.n) {
    throw InvalidArgument(fmt::format(
        "says that {} of {} trials survived; one trial or more is needed, and no more survivors than trials",
        result.survived, result.n));
  }
  constexpr double kRounded = 1e-3;
  const double share = static_cast<double>(result.survived) / result.n;
  if (std::abs(share - result.survival) > kRounded || result.survival_low > result.survival + kRounded ||
      result.survival_high < result.survival - kRounded) {
    throw InvalidArgument(fmt::format("says a survival of {} in {} to {}, where {} of {} trials survived",
                                      result.survival, result.survival_low, result.survival_high, result.survived,
                                      result.n));
  }
  return result;
}

}  // namespace

Result<TrialsResult> TrialsResultFromJson(const std::string& text, const std::string& source) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   "trials_result",
                   "TrialsResult",
                   fmt::format("the trials' result '{}' {}", source, message),
                   {}};
  };
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return bad("is no JSON, or is cut short");
  try {
    return Read(json);
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  } catch (const nlohmann::json::exception&) {
    return bad("holds a number that is out of range");
  }
}

Result<TrialsResult> LoadTrialsResult(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  return TrialsResultFromJson(*text, path);
}

}  // namespace gaitwright
