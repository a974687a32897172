// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/xacro.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "kinematics/base/file.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_expander_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostXacroBytes = std::size_t{16} << 20;  // size of one file [byte]

/// The text without its XML comments.
std::string WithoutXmlComments(const std::string& text) {
  std::string rest;
  std::size_t at = 0;
  for (std::size_t open = text.find("<!--"); open != std::string::npos; open = text.find("<!--", at)) {
    rest.append(text, at, open - at);
    const std::size_t close = text.find("-->", open + 4);
    if (close == std::string::npos) return rest;
    at = close + 3;
  }
  return rest.append(text, at);
}

/// The text of a file. Unless `strict`, an encoding other than UTF-8 is accepted.
Result<std::string> ReadXacroText(const std::string& path, bool strict) {
  Result<std::string> text = ReadFile(path, kMostXacroBytes);
  if (text || strict || text.failure().code != FailureCode::kNotText) return text;
  const Result<std::string> bytes = ReadBytes(path, kMostXacroBytes);
  const std::optional<std::string> converted = bytes ? InUtf8(*bytes) : std::nullopt;
  return converted ? Result<std::string>(*converted) : text;
}

}  // namespace

bool IsXacro(const std::string& text) {
  const std::string rest = WithoutXmlComments(text);
  constexpr std::string_view kSigns[] = {"<xacro:", "${", "$(find ", "$(arg ", "$(env ", "$(optenv ", "$(eval "};
  return std::any_of(std::begin(kSigns), std::end(kSigns),
                     [&](std::string_view sign) { return rest.find(sign) != std::string::npos; });
}

Result<std::string> ExpandXacroText(const std::string& text, const std::string& path,
                                    const std::map<std::string, std::string>& arguments, const XacroSources& sources) {
  return XacroExpander(sources, arguments).Expand(text, path);
}

Result<std::string> ExpandXacro(const XacroRequest& request) {
  XacroSources sources;
  sources.read = [&](const std::string& path) { return ReadXacroText(path, request.strict); };
  Result<std::string> text = sources.read(request.path);
  if (!text) return text;
  sources.find_package = [&](const std::string& package, const std::string& folder) {
    return FindPackage(package, folder, request.packages);
  };
  sources.environment = [](const std::string& name) -> std::optional<std::string> {
    const char* value = std::getenv(name.c_str());
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
  };
  return ExpandXacroText(*text, request.path, request.arguments, sources);
}

}  // namespace gaitwright
