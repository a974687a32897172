// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "kinematics/description/xacro.h"

namespace gaitwright {

using TextFiles = std::map<std::string, std::string>;

/// Sources with these files, with packages in /packages/NAME for the given names, and with one environment variable.
inline XacroSources SourcesWith(const TextFiles& files, const std::vector<std::string>& packages = {}) {
  XacroSources sources;
  sources.read = [files](const std::string& path) -> Result<std::string> {
    const auto file = files.find(path);
    if (file != files.end()) return file->second;
    return Failure{FailureKind::kBadInput, FailureCode::kNoSuchFile, "File", "no such file: '" + path + "'", {}};
  };
  sources.find_package = [packages](const std::string& name, const std::string&) -> Result<std::string> {
    for (const std::string& package : packages) {
      if (package == name) return "/packages/" + name;
    }
    return Failure{FailureKind::kBadInput,
                   FailureCode::kNoPackage,
                   "FindPackage",
                   "the package '" + name + "' is not found",
                   {"give its folder as " + name + "=DIR"}};
  };
  sources.environment = [](const std::string& name) -> std::optional<std::string> {
    return name == "ROBOT" ? std::optional<std::string>("bot") : std::nullopt;
  };
  return sources;
}

/// The content of the root <r> of an expanded description, without blanks between elements, or "CODE: MESSAGE".
inline std::string InnerXacro(const std::string& inside, const TextFiles& files = {},
                              const std::map<std::string, std::string>& arguments = {}) {
  const Result<std::string> expanded =
      ExpandXacroText("<r xmlns:xacro='http://www.ros.org/wiki/xacro'>" + inside + "</r>", "robot.xacro", arguments,
                      SourcesWith(files, {"bot"}));
  if (!expanded) return FailureCodeName(expanded.failure().code) + ": " + expanded.failure().message;
  const std::size_t open = expanded->find("<r"), from = expanded->find('>', open) + 1, to = expanded->rfind("</r>");
  if (to == std::string::npos) return "";
  std::string inner = expanded->substr(from, to - from);
  for (std::size_t end = inner.find('\n'); end != std::string::npos; end = inner.find('\n'))
    inner.erase(end, inner.find_first_not_of(" \n", end) == std::string::npos
                         ? std::string::npos
                         : inner.find_first_not_of(" \n", end) - end);
  return inner;
}

/// The printed value of one expression.
inline std::string ValueOfXacro(const std::string& expression) {
  std::string escaped;
  for (const char c : expression) {
    if (c == '<') {
      escaped += "&lt;";
    } else {
      escaped += c;
    }
  }
  std::string value = InnerXacro("${" + escaped + "}");
  for (std::size_t at = value.find("&gt;"); at != std::string::npos; at = value.find("&gt;")) value.replace(at, 4, ">");
  return value;
}

}  // namespace gaitwright
