// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/hints.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <variant>

namespace gaitwright::words {
namespace {

std::string KnownPlaces(const TaskScope& scope) {
  std::string known;
  for (const PlaceName& place : scope.places) {
    const std::string numbers = place.number > 0 ? fmt::format(" (1 to {})", place.number) : "";
    known += fmt::format("{}'{}'{}", known.empty() ? "" : ", ", place.name, numbers);
  }
  if (!known.empty()) return "a place of this ground: " + known;
  return "--terrain with a ground that has places: a file with markers, or stairs, whose steps have names";
}

std::vector<Suggestion> HintsFor(const Refusal& refusal, const TaskScope& scope) {
  if (!refusal.say.empty()) return {refusal.say};
  if (refusal.code == FailureCode::kRange) return {};
  if (refusal.code == FailureCode::kAmbiguous) return {"use only one of them, or put 'no' before the correct one"};
  if (refusal.code == FailureCode::kPlace) return {KnownPlaces(scope)};
  std::vector<Suggestion> suggestions;
  if (!refusal.nearest.empty())
    suggestions.push_back(fmt::format("to {}, the nearest that it can do", refusal.nearest));
  suggestions.push_back(fmt::format("what robot '{}' can do: {}", scope.robot, fmt::join(scope.Actions(), ", ")));
  return suggestions;
}

}  // namespace

Failure FailureOf(const Refusal& refusal, const TaskScope& scope) {
  const std::string part = refusal.part.empty() ? "the instruction" : fmt::format("'{}'", refusal.part);
  const std::string message = fmt::format("{}{} {}", part, refusal.is_sentence ? ":" : "", refusal.why);
  return {FailureKind::kBadInput, refusal.code, "Understand", message, HintsFor(refusal, scope)};
}

std::vector<Suggestion> SuggestionsInWords(const std::vector<Suggestion>& suggestions, int footfalls) {
  std::vector<Suggestion> in_words;
  for (Suggestion said : suggestions) {
    const double* value = std::get_if<double>(&said.value);
    const double number = value != nullptr ? std::abs(*value) : 0.0;
    if (said.what == "speed" || said.what == "lateral-speed") {
      said.text = fmt::format("say 'at {:.4g} m/s' or slower", number);
    } else if (said.what == "step-length") {
      said.text = fmt::format("say 'steps of {:.4g} m' or shorter", footfalls * number);
    } else if (said.what == "yaw-rate") {
      continue;  // no words set the yaw rate
    }
    in_words.push_back(std::move(said));
  }
  return in_words;
}

}  // namespace gaitwright::words
