// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/function_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string_view>

#include "tests/architecture/rules_table.h"

namespace gaitwright::architecture {
namespace {

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t IndentOf(const std::string& line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// Whether a declaration may begin after this line.
bool EndsAStatement(const std::string& line) {
  static const std::regex kBefore(R"(^\s*$|[;{}:]\s*$|^\s*(//|#|template|\[\[))");
  return std::regex_search(line, kBefore);
}

/// Whether the text of lines that end with an opening brace starts a function.
bool BeginsAFunction(const std::string& head) {
  static const std::regex kOther(
      R"(^(namespace|struct|class|enum|union|extern|if|else|for|while|switch|do|return|case|default|try|catch|\})\b)");
  static const std::regex kLambda(R"(\[[^\]]*\]\s*[({])");
  static const std::regex kSignature(R"(\)( const| noexcept| override| final)*( : .*| -> .*)? \{$)");
  const std::string before = head.substr(0, head.find('('));
  return before.size() < head.size() && before.find(" = ") == std::string::npos && !std::regex_search(head, kOther) &&
         !std::regex_search(head, kLambda) && std::regex_search(head, kSignature);
}

/// The number of parameters in the first parentheses of a signature.
int ParametersOf(const std::string& head) {
  const std::string_view call = "operator()";
  const std::size_t operator_at = head.find(call);
  const std::size_t from = head.find('(', operator_at == std::string::npos ? 0 : operator_at + call.size());
  int depth = 0, angles = 0, commas = 0;
  bool empty = true;
  for (std::size_t k = from; k < head.size(); ++k) {
    const char c = head[k];
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
    if (depth == 0) break;
    if (c == '<') ++angles;
    if (c == '>' && head[k - 1] != '-') --angles;
    if (c == ',' && depth == 1 && angles == 0) ++commas;
    if (k > from && c != ' ') empty = false;
  }
  return empty ? 0 : commas + 1;
}

std::string NameOf(const std::string& head) {
  std::string name = head.substr(0, head.find('('));
  if (const std::size_t blank = name.find_last_of(" *&"); blank != std::string::npos) name = name.substr(blank + 1);
  return name;
}

bool IsExempt(const std::vector<Exempt>& table, const std::string& file, const std::string& name) {
  return std::any_of(table.begin(), table.end(),
                     [&](const Exempt& exempt) { return exempt.file == file && exempt.name == name; });
}

/// Tables of options are data, with one row per option.
bool IsTable(const std::string& name) { return name.ends_with("Fields"); }

}  // namespace

std::vector<FunctionSize> FunctionsOf(const std::string& text) {
  const std::vector<std::string> lines = LinesOf(text);
  std::vector<FunctionSize> functions;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].ends_with(" {")) continue;
    std::size_t first = i;
    while (first > 0 && !EndsAStatement(lines[first - 1])) --first;
    const std::string indent(IndentOf(lines[first]), ' ');
    std::string head;
    for (std::size_t k = first; k <= i; ++k) head += (k > first ? " " : "") + lines[k].substr(IndentOf(lines[k]));
    if (!BeginsAFunction(head)) continue;
    const auto end = std::find(lines.begin() + static_cast<std::ptrdiff_t>(i), lines.end(), indent + "}");
    if (end == lines.end()) continue;
    functions.push_back({NameOf(head), static_cast<int>(first) + 1,
                         static_cast<int>(end - lines.begin()) - static_cast<int>(first) + 1, ParametersOf(head)});
  }
  return functions;
}

std::vector<std::string> FunctionBreaches(const std::string& file, const std::string& text) {
  std::vector<std::string> breaches;
  for (const FunctionSize& function : FunctionsOf(text)) {
    if (function.lines > kLongestFunction && !IsTable(function.name) &&
        !IsExempt(kLongFunctions, file, function.name)) {
      breaches.push_back(fmt::format("{}:{}: '{}' has {} lines; at most {}", file, function.line, function.name,
                                     function.lines, kLongestFunction));
    }
    if (function.parameters > kMostParameters && !IsExempt(kManyParameters, file, function.name)) {
      breaches.push_back(fmt::format("{}:{}: '{}' has {} parameters; at most {}", file, function.line, function.name,
                                     function.parameters, kMostParameters));
    }
  }
  return breaches;
}

}  // namespace gaitwright::architecture
