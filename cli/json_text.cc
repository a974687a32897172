// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/json_text_internal.h"

namespace gaitwright::cli {

std::string JsonText(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

nlohmann::ordered_json ParsedJson(const std::string& text) { return nlohmann::ordered_json::parse(text); }

void PrintJson(const nlohmann::ordered_json& json) { fmt::print("{}\n", JsonText(json)); }

}  // namespace gaitwright::cli
