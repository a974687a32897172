// SPDX-License-Identifier: BSD-3-Clause
// Calls of macros.
#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_expander_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;
using ParameterKind = XacroParameter::Kind;

constexpr std::size_t kMostMacroCalls = 100;  // largest depth of nested calls
constexpr std::size_t kStepsOfCall = 100;     // steps of a call, in addition to the steps of its expressions

std::vector<std::string> NamesOfMacroValues(const XacroMacro& macro) {
  std::vector<std::string> names;
  for (const XacroParameter& parameter : macro.parameters) {
    if (parameter.kind == ParameterKind::kValue) names.push_back(parameter.name);
  }
  return names;
}

/// The property of a parameter. A text that is a number becomes that number.
XacroProperty MacroParameterOf(XacroValue value, const XMLElement& where) {
  if (value.text() != nullptr) value = XacroLiteral(*value.text());
  return {std::move(value), false, false, &where};
}

}  // namespace

void XacroExpander::GiveAttributes(const Element& element, const XacroMacro& macro, XacroScope& local,
                                   XacroScope& scope) {
  const bool is_call = std::string(element.Name()) == "xacro:call";
  const std::vector<std::string> names = NamesOfMacroValues(macro);
  for (const XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    const std::string name = a->Name();
    if (name.starts_with("xmlns") || (is_call && name == "macro")) continue;
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw XacroProblem{FailureCode::kMacroParameter,
                         fmt::format("the macro '{}' ({}) has no parameter '{}'{}", macro.name, PlaceOf(*macro.body),
                                     Shortened(name), NearestOrAll(name, names))};
    }
    local.properties[name] = MacroParameterOf(Evaluated(a->Value(), scope), element);
  }
}

void XacroExpander::GiveBlocks(const XacroMacro& macro, const Element& expanded, XacroScope& local) {
  const XMLElement* block = expanded.FirstChildElement();
  std::size_t blocks = 0;
  for (const XacroParameter& parameter : macro.parameters) {
    if (parameter.kind == ParameterKind::kValue) continue;
    ++blocks;
    if (block == nullptr) {
      throw XacroProblem{
          FailureCode::kMacroParameter,
          fmt::format("the macro '{}' ({}) needs an element for its block '{}{}', but the call has {}", macro.name,
                      PlaceOf(*macro.body), parameter.kind == ParameterKind::kBlock ? "*" : "**", parameter.name,
                      blocks == 1 ? "none" : fmt::format("only {}", blocks - 1))};
    }
    local.blocks[parameter.name] = {block, parameter.kind == ParameterKind::kContent, true};
    block = block->NextSiblingElement();
  }
  if (block != nullptr) {
    throw XacroProblem{FailureCode::kMacroParameter,
                       fmt::format("the macro '{}' ({}) has {} blocks; the element <{}> in the call is too much",
                                   macro.name, PlaceOf(*macro.body), blocks, block->Name())};
  }
}

void XacroExpander::GiveDefaults(const XacroMacro& macro, XacroScope& local, XacroScope& scope) {
  std::vector<std::string> missing;
  for (const XacroParameter& parameter : macro.parameters) {
    if (parameter.kind != ParameterKind::kValue || local.properties.contains(parameter.name)) continue;
    const auto [outer, owner] =
        parameter.forwarded ? scope.FindProperty(parameter.name, budget_) : std::pair<XacroProperty*, XacroScope*>{};
    if (outer != nullptr) {
      local.properties[parameter.name] = MacroParameterOf(Resolve(parameter.name, *outer, *owner), *macro.body);
    } else if (parameter.default_text) {
      local.properties[parameter.name] = MacroParameterOf(Evaluated(*parameter.default_text, scope), *macro.body);
    } else {
      missing.push_back(parameter.name);
    }
  }
  if (!missing.empty()) {
    throw XacroProblem{FailureCode::kMacroParameter,
                       fmt::format("the macro '{}' ({}) is called without {} {}", macro.name, PlaceOf(*macro.body),
                                   missing.size() == 1 ? "its parameter" : "its parameters", QuotedList(missing))};
  }
}

void XacroExpander::CallMacro(const Element& element, const std::string& name, Node& out, XacroScope& scope) {
  const auto [macro, seen] = scope.FindMacro(name, budget_);
  if (macro == nullptr) {
    std::string hint = NearestOrAll(name, scope.MacroNames());
    if (hint.empty()) hint = "; define a macro before its call, here or in an included file";
    throw XacroProblem{FailureCode::kUnknownMacro,
                       fmt::format("the macro '{}' is not defined{}", Shortened(name), hint)};
  }
  if (calls_.size() >= kMostMacroCalls) {
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("more than {} nested macro calls; check whether '{}' calls itself endlessly",
                                   kMostMacroCalls, macro->name)};
  }
  budget_.Spend(kStepsOfCall);
  XacroScope local;
  local.parent = seen;
  local.caller = &scope;
  GiveAttributes(element, *macro, local, scope);
  tinyxml2::XMLDocument blocks;  // must exist until the body is expanded
  XMLElement& expanded = *blocks.NewElement("blocks");
  blocks.InsertEndChild(&expanded);
  ExpandNodes(element.FirstChild(), expanded, scope);
  GiveBlocks(*macro, expanded, local);
  GiveDefaults(*macro, local, scope);
  calls_.push_back(&element);
  ExpandNodes(macro->body->FirstChild(), out, local);
  calls_.pop_back();
}

}  // namespace gaitwright
