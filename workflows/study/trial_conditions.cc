// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trial_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "workflows/study/trial.h"
#include "workflows/walk/idle_options.h"

namespace gaitwright {
namespace {

constexpr char kState[] = "state", kDelay[] = "command_delay_s", kSensors[] = "sensors";
constexpr char kNotSaid[] = "not said";

bool IsSeed(const std::string& key) { return key.ends_with(".seed"); }
bool IsOfSensors(const std::string& key) { return key.starts_with("sensors."); }

/// An option that is always reported.
OptionChange Always(const OptionTexts& options, const OptionFields& usual, const std::string& key) {
  const auto field = std::find_if(usual.begin(), usual.end(), [&](const OptionField& f) { return f.key == key; });
  const auto said =
      std::find_if(options.begin(), options.end(), [&](const auto& option) { return option.first == key; });
  return {key, said == options.end() ? kNotSaid : said->second, OptionText(*field)};
}

/// The sensor values that differ from those of a built-in set.
std::vector<OptionChange> UnlikeKind(const std::string& kind, const OptionTexts& options) {
  SensorOptions of_kind = SensorsOfKind(kind);
  std::vector<OptionChange> unlike = ChangesFrom(Prefixed(kSensors, of_kind.Fields()), options);
  std::erase_if(unlike, [](const OptionChange& change) { return IsSeed(change.key); });
  return unlike;
}

void AddSensors(const OptionTexts& options, const std::string& state, std::vector<OptionChange>& conditions) {
  const bool said = std::any_of(options.begin(), options.end(), [](const auto& o) { return IsOfSensors(o.first); });
  if (state == StateSourceNames().front() || !said) {
    const std::string value = said ? "not used" : kNotSaid;
    conditions.push_back({kSensors, value, value});
    return;
  }
  std::string nearest;
  std::vector<OptionChange> unlike;
  for (const std::string& kind : SensorKinds()) {
    std::vector<OptionChange> other = UnlikeKind(kind, options);
    if (!nearest.empty() && other.size() >= unlike.size()) continue;
    nearest = kind;
    unlike = std::move(other);
  }
  conditions.push_back({kSensors, nearest, SensorKinds().front()});
  conditions.insert(conditions.end(), unlike.begin(), unlike.end());
}

}  // namespace

std::vector<OptionChange> TrialConditions(const OptionTexts& options, const std::string& disturbances) {
  PlayRequest request;
  const OptionFields usual = request.Fields();
  std::vector<OptionChange> conditions = {Always(options, usual, kState)};
  AddSensors(options, conditions.front().value, conditions);
  conditions.push_back(Always(options, usual, kDelay));
  for (const OptionChange& change : ChangesFrom(usual, options)) {
    const bool known = change.key == kState || change.key == kDelay || IsOfSensors(change.key) || IsSeed(change.key);
    if (!known) conditions.push_back(change);
  }
  for (const auto& [key, value] : options) {
    const auto is = [&key = key](const OptionField& field) { return field.key == key; };
    if (std::none_of(usual.begin(), usual.end(), is)) conditions.push_back({key, value, ""});
  }
  if (const Result<Disturbances> drawn = ReadDisturbances(disturbances, SensorFields(request), "the result")) {
    std::erase_if(conditions, [&](const OptionChange& c) { return !DrawnInPlaceOf(*drawn, {c.key}).empty(); });
  }
  return conditions;
}

namespace {

/// A playback request with these options, as far as this program knows them.
PlayRequest RequestOf(const std::string& controller, const OptionTexts& options) {
  PlayRequest request;
  request.controller = controller;
  OptionFields fields = request.Fields();
  for (const auto& [key, value] : options) {
    const auto is = [&key = key](const OptionField& field) { return field.key == key; };
    if (std::any_of(fields.begin(), fields.end(), is)) SetOption(fields, key, value);
  }
  return request;
}

}  // namespace

std::string FlagsOf(const std::string& controller, const OptionTexts& options, const std::vector<std::string>& drawn) {
  const PlayRequest request = RequestOf(controller, options);
  std::string flags = controller == PlayRequest().controller ? "" : " --controller " + controller;
  for (const OptionChange& condition : TrialConditions(options)) {
    if (condition.value == condition.usual || condition.usual.empty() || condition.value == kNotSaid) continue;
    if (FirstIdle(request, {condition.key}, drawn)) continue;
    flags += condition.key == kSensors ? fmt::format(" --sensors {}", condition.value)
                                       : fmt::format(" --set {}={}", condition.key, condition.value);
  }
  return flags.empty() ? "" : flags.substr(1);
}

std::string ConditionText(const OptionChange& condition) {
  std::string text = fmt::format("{} {}", condition.key, condition.value);
  if (condition.value == condition.usual) return text;
  return text +
         (condition.usual.empty() ? " (not known to this program)" : fmt::format(" (default {})", condition.usual));
}

}  // namespace gaitwright
