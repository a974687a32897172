// SPDX-License-Identifier: BSD-3-Clause
// The elements of xacro other than macros and included files.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_expander_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

/// Refuses the name of a property that expressions cannot use.
void CheckXacroName(const std::string& name) {
  if (!name.empty() && name.find_first_of(" \t\r\n${}") == std::string::npos) return;
  throw XacroProblem{FailureCode::kBadName,
                     fmt::format("'{}' is not a valid name; a name has no blanks, '$', '{{' or '}}'", Shortened(name))};
}

/// Refuses a name of a generated element or attribute that is not valid in XML or has the prefix of xacro.
void CheckMadeName(const std::string& name) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
  };
  const auto is_part = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == ':';
  };
  const bool fine = !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), is_part);
  if (fine && name.find("xacro:") == std::string::npos) return;
  throw XacroProblem{FailureCode::kBadName, fmt::format("'{}' is not a valid XML name here", Shortened(name))};
}

}  // namespace

void CheckXacroAttributes(const XMLElement& element, const std::vector<std::string>& known) {
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    const std::string name = a->Name();
    if (name.starts_with("xmlns") || std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw XacroProblem{FailureCode::kUnknownAttribute,
                       fmt::format("the attribute '{}' is not known{}", Shortened(name), NearestOrAll(name, known))};
  }
}

std::string NeededXacroAttribute(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  if (value == nullptr)
    throw XacroProblem{FailureCode::kXacroMissing, fmt::format("the attribute '{}' is missing", name)};
  return value;
}

bool XacroTruthOfText(const XacroValue& value, const std::string& what) {
  const std::string* text = value.text();
  if (text == nullptr) return XacroTruth(value);
  const std::string word = Trimmed(*text);
  if (word == "true" || word == "True") return true;
  if (word == "false" || word == "False") return false;
  if (const auto whole = XacroWholeOf(word)) return *whole != 0;
  throw XacroProblem{FailureCode::kXacroCondition,
                     fmt::format("{} is '{}', which is not true, false or a whole number", what, Shortened(*text))};
}

XacroExpander::Directive XacroExpander::DirectiveOf(const std::string& word) {
  static const std::map<std::string, Directive> directives = {{"if", &XacroExpander::If},
                                                              {"unless", &XacroExpander::Unless},
                                                              {"insert_block", &XacroExpander::InsertBlock},
                                                              {"attribute", &XacroExpander::MakeAttribute},
                                                              {"element", &XacroExpander::MakeElement},
                                                              {"call", &XacroExpander::CallNamed},
                                                              {"arg", &XacroExpander::DefineArgument},
                                                              {"property", &XacroExpander::DefineProperty},
                                                              {"macro", &XacroExpander::DefineMacro},
                                                              {"include", &XacroExpander::Include}};
  const auto known = directives.find(word);
  return known == directives.end() ? nullptr : known->second;
}

bool XacroExpander::Condition(const Element& element, XacroScope& scope) {
  CheckXacroAttributes(element, {"value"});
  const std::string text = NeededXacroAttribute(element, "value");
  return XacroTruthOfText(Evaluated(text, scope), fmt::format("the condition '{}'", Shortened(text)));
}

void XacroExpander::If(const Element& element, Node& out, XacroScope& scope) {
  if (Condition(element, scope)) ExpandNodes(element.FirstChild(), out, scope);
}

void XacroExpander::Unless(const Element& element, Node& out, XacroScope& scope) {
  if (!Condition(element, scope)) ExpandNodes(element.FirstChild(), out, scope);
}

void XacroExpander::InsertBlock(const Element& element, Node& out, XacroScope& scope) {
  CheckXacroAttributes(element, {"name"});
  const std::string name = PrintedAttribute(element, "name", scope);
  const XacroBlock* found = scope.FindBlock(name, budget_);
  if (found == nullptr) {
    throw XacroProblem{FailureCode::kUnknownBlock, fmt::format("the block '{}' is not defined{}", Shortened(name),
                                                               NearestOrAll(name, scope.BlockNames()))};
  }
  const XacroBlock block = *found;
  if (!block.expanded) {
    if (block.content_only) return ExpandNodes(block.element->FirstChild(), out, scope);
    return ExpandElement(*block.element, out, scope);
  }
  if (!block.content_only) return CopyExpanded(*block.element, out);
  for (const Node* child = block.element->FirstChild(); child != nullptr; child = child->NextSibling())
    CopyExpanded(*child, out);
}

void XacroExpander::MakeAttribute(const Element& element, Node& out, XacroScope& scope) {
  CheckXacroAttributes(element, {"name", "value"});
  const std::string name = PrintedAttribute(element, "name", scope);
  CheckMadeName(name);
  if (out.ToElement() == nullptr) throw XacroProblem{FailureCode::kXacroMissing, "it must be inside another element"};
  SetAttribute(*out.ToElement(), name, PrintedAttribute(element, "value", scope));
}

void XacroExpander::MakeElement(const Element& element, Node& out, XacroScope& scope) {
  const std::string name = PrintedAttribute(element, "xacro:name", scope);
  CheckMadeName(name);
  Element& made = AppendElement(name, out);
  CopyAttributes(element, made, scope, true);
  ExpandNodes(element.FirstChild(), made, scope);
}

void XacroExpander::CallNamed(const Element& element, Node& out, XacroScope& scope) {
  std::string name = PrintedAttribute(element, "macro", scope);
  if (name.starts_with("xacro:")) name.erase(0, 6);
  CallMacro(element, name, out, scope);
}

void XacroExpander::DefineArgument(const Element& element, Node&, XacroScope& scope) {
  CheckXacroAttributes(element, {"name", "default"});
  const std::string name = PrintedAttribute(element, "name", scope);
  used_.insert(name);
  if (element.Attribute("default") == nullptr || arguments_.contains(name)) return;
  arguments_[name] = PrintedAttribute(element, "default", scope);
}

void XacroExpander::DefineProperty(const Element& element, Node&, XacroScope& scope) {
  CheckXacroAttributes(element, {"name", "value", "default", "scope", "lazy_eval", "remove"});
  const std::string name = PrintedAttribute(element, "name", scope);
  CheckXacroName(name);
  const char *value = element.Attribute("value"), *usual = element.Attribute("default");
  const std::string where = element.Attribute("scope") == nullptr ? "local" : element.Attribute("scope");
  const auto switched = [&](const char* key, bool absent) {
    const char* text = element.Attribute(key);
    return text == nullptr ? absent : XacroTruthOfText(Evaluated(text, scope), fmt::format("'{}'", key));
  };
  if (where != "local" && where != "parent" && where != "global") {
    throw XacroProblem{FailureCode::kXacroScope, fmt::format("the scope '{}' is not known; the scopes are {}",
                                                             Shortened(where), QuotedList({"parent", "global"}))};
  }
  XacroScope& target = where == "global"                              ? globals_
                       : where == "parent" && scope.caller != nullptr ? *scope.caller
                                                                      : scope;
  if (switched("remove", false)) {
    target.properties.erase(name);
    target.blocks.erase(name);
    return;
  }
  if (usual != nullptr && value == nullptr) {
    if (scope.FindProperty(name, budget_).first != nullptr) return;
    value = usual;
  }
  if (value == nullptr) {
    target.blocks[name] = {&element, true, false};
    return;
  }
  const std::string text = value;
  const bool lazy = where == "local" && switched("lazy_eval", true) && text.find('$') != std::string::npos;
  XacroValue held = lazy ? XacroText(text) : Evaluated(text, scope);
  if (!lazy && held.text() != nullptr) held = XacroLiteral(*held.text());
  target.properties[name] = {std::move(held), lazy, false, &element};
}

void XacroExpander::DefineMacro(const Element& element, Node&, XacroScope& scope) {
  CheckXacroAttributes(element, {"name", "params"});
  XacroMacro macro;
  macro.name = NeededXacroAttribute(element, "name");
  if (macro.name.starts_with("xacro:")) macro.name.erase(0, 6);
  CheckXacroName(macro.name);
  if (DirectiveOf(macro.name) != nullptr)
    throw XacroProblem{FailureCode::kBadName,
                       fmt::format("'{}' cannot be the name of a macro: it is a xacro directive", macro.name)};
  macro.parameters = ParseXacroParameters(element.Attribute("params") == nullptr ? "" : element.Attribute("params"));
  macro.body = &element;
  macro.bare = std::string(element.Name()) == "macro";
  scope.macros[macro.name] = std::make_shared<const XacroMacro>(macro);
}

}  // namespace gaitwright
