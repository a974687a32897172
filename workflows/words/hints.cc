// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/hints.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

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

std::vector<std::string> HintsFor(const Refusal& refusal, const TaskScope& scope) {
  if (!refusal.say.empty()) return {refusal.say};
  if (refusal.reason == "range") return {};
  if (refusal.reason == "ambiguous") return {"one of them, or 'no' before what is meant instead"};
  if (refusal.reason == "place") return {KnownPlaces(scope)};
  std::vector<std::string> hints;
  if (!refusal.nearest.empty()) hints.push_back(fmt::format("to {}, the nearest that it can do", refusal.nearest));
  hints.push_back(fmt::format("what robot '{}' can do: {}", scope.robot, fmt::join(scope.Actions(), ", ")));
  return hints;
}

}  // namespace

Failure FailureOf(const Refusal& refusal, const TaskScope& scope) {
  const std::string part = refusal.part.empty() ? "the instruction" : fmt::format("'{}'", refusal.part);
  // What is wrong with the part goes on after it, what is wrong on the whole stands by itself.
  const bool whole =
      refusal.why.starts_with("robot '") || refusal.why.starts_with("'") || refusal.why.starts_with("there ");
  const std::string message = fmt::format("{}{} {}", part, whole ? ":" : "", refusal.why);
  return {FailureKind::kBadInput, refusal.reason, "Understand", message, HintsFor(refusal, scope)};
}

std::vector<std::string> HintsInWords(const std::vector<std::string>& hints, int footfalls) {
  std::vector<std::string> in_words;
  for (const std::string& hint : hints) {
    std::istringstream flags(hint);
    std::string flag, value, said;
    for (; hint.starts_with("--") && flags >> flag >> value;) {
      const double number = std::abs(std::strtod(value.c_str(), nullptr));
      if (flag == "--speed" || flag == "--lateral-speed") said = fmt::format("say 'at {:.4g} m/s' or slower", number);
      if (flag == "--step-length") said = fmt::format("say 'steps of {:.4g} m' or shorter", footfalls * number);
    }
    const bool is_option = hint.starts_with("--set ");
    if (!hint.starts_with("--") || is_option) said = hint;
    if (!said.empty()) in_words.push_back(said);
  }
  return in_words;
}

}  // namespace gaitwright::words
