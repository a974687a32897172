// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "kinematics/base/text.h"
#include "kinematics/description/xacro_scope_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostXacroNames = 1000;
constexpr std::string_view kParameterBlanks = " \t\r\n";

bool IsParameterBlank(const std::string& text, std::size_t at) {
  return kParameterBlanks.find(text[at]) != std::string_view::npos;
}

/// The namespace of a dotted name, searched from a scope upward, and the name in this namespace.
std::pair<XacroScope*, std::string> XacroNamespaceOf(XacroScope* scope, const std::string& name, XacroBudget& budget) {
  const std::size_t first = name.find('.');
  if (first == std::string::npos) return {nullptr, name};
  for (XacroScope* at = scope; at != nullptr; at = at->parent) {
    budget.Spend(1);
    const auto found = at->namespaces.find(name.substr(0, first));
    if (found == at->namespaces.end()) continue;
    XacroScope* space = found->second.get();
    std::string rest = name.substr(first + 1);
    for (std::size_t dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
      const auto inner = space->namespaces.find(rest.substr(0, dot));
      if (inner == space->namespaces.end()) break;
      space = inner->second.get();
      rest = rest.substr(dot + 1);
    }
    return {space, rest};
  }
  return {nullptr, name};
}

/// The names in a table of each scope; names in a namespace begin with NAMESPACE.
template <class Table>
std::vector<std::string> XacroNamesUpward(const XacroScope* scope, Table XacroScope::*table) {
  std::vector<std::string> names;
  for (; scope != nullptr; scope = scope->parent) {
    for (const auto& [name, value] : scope->*table) {
      if (names.size() < kMostXacroNames) names.push_back(name);
    }
    for (const auto& [prefix, space] : scope->namespaces) {
      for (const auto& [name, value] : (*space).*table) {
        if (names.size() < kMostXacroNames) names.push_back(prefix + "." + name);
      }
    }
  }
  return names;
}

/// The end of a default: the next blank outside quotes, `${}` and `$()`.
std::size_t ParameterDefaultEnd(const std::string& text, std::size_t from) {
  std::size_t at = from;
  while (at < text.size() && !IsParameterBlank(text, at)) {
    const bool group = text[at] == '$' && at + 1 < text.size() && (text[at + 1] == '{' || text[at + 1] == '(');
    char closing = '\0';
    if (text[at] == '\'' || text[at] == '"') closing = text[at];
    if (group) closing = text[at + 1] == '{' ? '}' : ')';
    const std::size_t close = closing == '\0' ? at : text.find(closing, at + 1);
    if (close == std::string::npos) {
      throw XacroProblem{FailureCode::kXacroSyntax, fmt::format("params: the default '{}' has no closing {}",
                                                                Shortened(text.substr(from)), closing)};
    }
    at = close + 1;
  }
  return at;
}

}  // namespace

std::pair<XacroProperty*, XacroScope*> XacroScope::FindProperty(const std::string& name, XacroBudget& budget) {
  for (XacroScope* at = this; at != nullptr; at = at->parent) {
    budget.Spend(1);
    const auto found = at->properties.find(name);
    if (found != at->properties.end()) return {&found->second, at};
  }
  const auto [space, inner] = XacroNamespaceOf(this, name, budget);
  if (space == nullptr) return {nullptr, nullptr};
  const auto found = space->properties.find(inner);
  if (found == space->properties.end()) return {nullptr, nullptr};
  return {&found->second, space};
}

std::pair<std::shared_ptr<const XacroMacro>, XacroScope*> XacroScope::FindMacro(const std::string& name,
                                                                                XacroBudget& budget) {
  for (XacroScope* at = this; at != nullptr; at = at->parent) {
    budget.Spend(1);
    const auto found = at->macros.find(name);
    if (found != at->macros.end()) return {found->second, this};
  }
  const auto [space, inner] = XacroNamespaceOf(this, name, budget);
  if (space == nullptr) return {nullptr, nullptr};
  const auto found = space->macros.find(inner);
  if (found == space->macros.end()) return {nullptr, nullptr};
  return {found->second, space};
}

const XacroBlock* XacroScope::FindBlock(const std::string& name, XacroBudget& budget) const {
  for (const XacroScope* at = this; at != nullptr; at = at->parent) {
    budget.Spend(1);
    const auto found = at->blocks.find(name);
    if (found != at->blocks.end()) return &found->second;
  }
  return nullptr;
}

std::vector<std::string> XacroScope::PropertyNames() const { return XacroNamesUpward(this, &XacroScope::properties); }
std::vector<std::string> XacroScope::MacroNames() const { return XacroNamesUpward(this, &XacroScope::macros); }
std::vector<std::string> XacroScope::BlockNames() const { return XacroNamesUpward(this, &XacroScope::blocks); }

std::vector<XacroParameter> ParseXacroParameters(const std::string& text) {
  std::vector<XacroParameter> parameters;
  for (std::size_t at = text.find_first_not_of(kParameterBlanks); at != std::string::npos && at < text.size();
       at = text.find_first_not_of(kParameterBlanks, at)) {
    XacroParameter parameter;
    std::size_t end = std::min(text.find_first_of(" \t\r\n:=", at), text.size());
    parameter.name = text.substr(at, end - at);
    const std::size_t stars = std::min<std::size_t>(parameter.name.find_first_not_of('*'), 2);
    if (stars > 0) {
      parameter.kind = stars == 1 ? XacroParameter::Kind::kBlock : XacroParameter::Kind::kContent;
      parameter.name.erase(0, stars);
    }
    if (end < text.size() && !IsParameterBlank(text, end)) {
      const std::size_t from = text.find_first_not_of(":=", end);
      if (text[end] == ':' && (end + 1 >= text.size() || text[end + 1] != '=')) {
        throw XacroProblem{FailureCode::kXacroSyntax,
                           fmt::format("params: '{}:' is not understood; a default is written "
                                       "'{}:=VALUE'",
                                       Shortened(parameter.name), Shortened(parameter.name))};
      }
      end = from == std::string::npos ? text.size() : ParameterDefaultEnd(text, from);
      std::string value = from == std::string::npos ? "" : text.substr(from, end - from);
      parameter.forwarded = value.starts_with('^');
      if (!parameter.forwarded) parameter.default_text = value;
      if (value.starts_with("^|")) parameter.default_text = value.substr(2);
      if (stars > 0)
        throw XacroProblem{FailureCode::kXacroSyntax,
                           fmt::format("params: the block '{}' cannot have a default", parameter.name)};
    }
    const bool twice = std::any_of(parameters.begin(), parameters.end(),
                                   [&](const XacroParameter& other) { return other.name == parameter.name; });
    if (parameter.name.empty() || twice || parameters.size() >= 1000) {
      throw XacroProblem{FailureCode::kXacroSyntax,
                         fmt::format("params: the parameter '{}' {}", Shortened(parameter.name),
                                     parameter.name.empty() ? "has no name"
                                     : twice                ? "appears twice"
                                                            : "exceeds the limit of 1000 parameters")};
    }
    parameters.push_back(std::move(parameter));
    at = end;
  }
  return parameters;
}

}  // namespace gaitwright
