// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace gaitwright::cli {

// One file compiles the reader and the writer of nlohmann::json for all verbs, since each takes a second to compile.

/// The text of a value, indented, with U+FFFD in place of bytes that are not UTF-8.
std::string JsonText(const nlohmann::ordered_json& json);

/// The value of a text that another part of the program wrote. @throws nlohmann::json::parse_error
nlohmann::ordered_json ParsedJson(const std::string& text);

/// Prints JsonText and an end of line on standard output.
void PrintJson(const nlohmann::ordered_json& json);

}  // namespace gaitwright::cli
