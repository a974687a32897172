// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/failure_json.h"

#include <nlohmann/json.hpp>
#include <variant>

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json ValueToJson(const Suggestion& suggestion) {
  if (const auto* number = std::get_if<double>(&suggestion.value)) return *number;
  if (const auto* text = std::get_if<std::string>(&suggestion.value)) return *text;
  return nullptr;
}

}  // namespace

std::string FailureJson(const Failure& failure) {
  Json hints = Json::array(), suggestions = Json::array();
  for (const Suggestion& suggestion : failure.suggestions) {
    hints.push_back(suggestion.text);
    if (suggestion.what.empty()) continue;
    suggestions.push_back({{"what", suggestion.what},
                           {"value", ValueToJson(suggestion)},
                           {"certainty", CertaintyName(suggestion.certainty)}});
  }
  Json json = {{"code", FailureCodeName(failure.code)},
               {"stage", failure.stage},
               {"message", failure.message},
               {"hints", hints},
               {"suggestions", suggestions}};
  if (failure.violation) {
    const Violation& v = *failure.violation;
    json["violation"] = {{"law", LawName(v.law)}, {"at_s", v.at_s},   {"where", v.where},
                         {"value", v.value},      {"limit", v.limit}, {"unit", v.unit}};
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gaitwright
