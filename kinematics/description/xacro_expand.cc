// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_expander_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;
using tinyxml2::XMLNode;

constexpr std::string_view kXacroPrefix = "xacro:";
constexpr int kMostXacroAttributes = 1000;
constexpr std::size_t kDeepestXacroElement = 90;  // tinyxml2 reads 100
constexpr std::size_t kMostMacroCallsShown = 6;

/// Size of a text with XML escapes [byte].
std::size_t EscapedXmlSize(const std::string& text) {
  const auto escaped = std::count_if(
      text.begin(), text.end(), [](char c) { return std::string_view("&<>\"'").find(c) != std::string_view::npos; });
  return text.size() + 5 * static_cast<std::size_t>(escaped);
}

std::size_t DepthInResult(const XMLNode* node) {
  std::size_t depth = 0;
  for (; node != nullptr; node = node->Parent()) ++depth;
  return depth;
}

}  // namespace

XacroValue XacroExpander::Evaluated(const std::string& text, XacroScope& scope) {
  if (text.find('$') == std::string::npos) return XacroText(text);
  XacroScopeContext context(*this, scope, *at_);
  return EvaluateXacroText(text, context);
}

std::string XacroExpander::Printed(const std::string& text, XacroScope& scope) {
  return text.find('$') == std::string::npos ? text : XacroPrinted(Evaluated(text, scope), budget_);
}

std::string XacroExpander::PrintedAttribute(const Element& element, const char* name, XacroScope& scope) {
  return Printed(NeededXacroAttribute(element, name), scope);
}

XMLElement& XacroExpander::AppendElement(const std::string& name, Node& out) {
  budget_.Visit();
  const std::size_t depth = DepthInResult(&out);
  if (depth > kDeepestXacroElement)
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("the result has more than {} nested elements", kDeepestXacroElement)};
  budget_.Write(2 * name.size() + 8 + 8 * depth);
  XMLElement* made = out.GetDocument()->NewElement(name.c_str());
  out.InsertEndChild(made);
  return *made;
}

void XacroExpander::SetAttribute(Element& element, const std::string& name, const std::string& value) {
  budget_.Write(name.size() + EscapedXmlSize(value) + 4);
  element.SetAttribute(name.c_str(), value.c_str());
}

void XacroExpander::AppendText(const std::string& text, bool cdata, Node& out) {
  budget_.Visit();
  budget_.Write(EscapedXmlSize(text) + 16);
  tinyxml2::XMLText* made = out.GetDocument()->NewText(text.c_str());
  made->SetCData(cdata);
  out.InsertEndChild(made);
}

/// Appends an expanded node unchanged.
void XacroExpander::CopyExpanded(const Node& node, Node& out) {
  const XacroBudget::Level level(budget_);
  if (const tinyxml2::XMLText* text = node.ToText()) return AppendText(text->Value(), text->CData(), out);
  const XMLElement* element = node.ToElement();
  if (element == nullptr) return;
  XMLElement& made = AppendElement(element->Name(), out);
  for (const XMLAttribute* attribute = element->FirstAttribute(); attribute != nullptr; attribute = attribute->Next())
    SetAttribute(made, attribute->Name(), attribute->Value());
  for (const XMLNode* child = node.FirstChild(); child != nullptr; child = child->NextSibling())
    CopyExpanded(*child, made);
}

/// Appends the evaluated attributes of an element. @param names_itself  skips `xacro:name`.
void XacroExpander::CopyAttributes(const Element& element, Element& made, XacroScope& scope, bool names_itself) {
  int count = 0;
  for (const XMLAttribute* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
    const std::string name = attribute->Name();
    if (name == "xmlns:xacro" || (names_itself && name == "xacro:name")) continue;
    if (name.starts_with(kXacroPrefix)) {
      throw XacroProblem{
          FailureCode::kUnknownAttribute,
          fmt::format("the attribute '{}' is not known; use <xacro:attribute> to add an attribute", name)};
    }
    if (++count > kMostXacroAttributes)
      throw XacroProblem{FailureCode::kXacroLimit, fmt::format("it has more than {} attributes", kMostXacroAttributes)};
    SetAttribute(made, name, Printed(attribute->Value(), scope));
  }
}

void XacroExpander::ExpandNodes(const Node* first, Node& out, XacroScope& scope) {
  for (const XMLNode* node = first; node != nullptr; node = node->NextSibling()) {
    if (const tinyxml2::XMLText* text = node->ToText()) {
      AppendText(text->CData() ? text->Value() : Printed(text->Value(), scope), text->CData(), out);
    } else if (const XMLElement* element = node->ToElement()) {
      ExpandElement(*element, out, scope);
    }
  }
}

/// The element's name without `xacro:`; "" if it is not an element of xacro.
std::string XacroExpander::XacroWord(const Element& element, const Node& out, XacroScope& scope) {
  std::string name = element.Name();
  if (name.starts_with(kXacroPrefix)) return name.substr(kXacroPrefix.size());
  if (!FileOf(element).bare_tags) return "";
  const bool has_name = element.Attribute("name") != nullptr;
  const bool at_root = &out == result_.RootElement();
  const bool known = name == "insert_block"                  ? has_name
                     : name == "if" || name == "unless"      ? element.Attribute("value") != nullptr
                     : name == "property" || name == "macro" ? has_name && at_root
                     : name == "include"                     ? element.Attribute("filename") != nullptr && at_root
                                                             : false;
  if (known) return name;
  const auto macro = scope.FindMacro(name, budget_).first;
  return macro != nullptr && macro->bare ? name : "";
}

void XacroExpander::ExpandElement(const Element& element, Node& out, XacroScope& scope) {
  const XacroBudget::Level level(budget_);
  budget_.Visit();
  const Element* outer = at_;
  at_ = &element;
  const std::string word = XacroWord(element, out, scope);
  if (word.empty()) {
    XMLElement& made = AppendElement(element.Name(), out);
    CopyAttributes(element, made, scope, false);
    ExpandNodes(element.FirstChild(), made, scope);
  } else if (const Directive directive = DirectiveOf(word)) {
    (this->*directive)(element, out, scope);
  } else {
    CallMacro(element, word, out, scope);
  }
  at_ = outer;
}

/// Refuses given arguments that no file uses, because they may be misspelt.
void XacroExpander::CheckArguments() const {
  for (const auto& [name, value] : given_) {
    if (used_.contains(name)) continue;
    const std::vector<std::string> known(used_.begin(), used_.end());
    throw XacroProblem{FailureCode::kUnknownArgument,
                       fmt::format("the argument '{}' is given, but the description has no argument of this name{}",
                                   Shortened(name), NearestOrAll(name, known))};
  }
}

std::string XacroExpander::ExpandRoot(const std::string& text, const std::string& path) {
  const XacroFile& file = Parse(text, path);
  const XMLElement& root = *file.xml.RootElement();
  at_ = &root;
  if (std::string_view(root.Name()).starts_with(kXacroPrefix))
    throw XacroProblem{FailureCode::kNotUrdf,
                       "the root is an element of xacro; a description needs <robot> as its root"};
  result_.InsertEndChild(result_.NewDeclaration("xml version=\"1.0\" encoding=\"utf-8\""));
  XMLElement& made = AppendElement(root.Name(), result_);
  including_.push_back(&file);
  ExpandNodes(root.FirstChild(), made, globals_);
  CopyAttributes(root, made, globals_, false);
  CheckArguments();
  tinyxml2::XMLPrinter printer;
  result_.Print(&printer);
  std::string expanded = printer.CStr();
  if (!IsPlainText(expanded))
    throw XacroProblem{FailureCode::kNotText,
                       "the result is not valid UTF-8 text: it has control characters or incomplete characters"};
  return expanded;
}

std::vector<Suggestion> XacroExpander::CallHints() const {
  std::vector<Suggestion> suggestions;
  for (auto call = calls_.rbegin(); call != calls_.rend() && suggestions.size() < kMostMacroCallsShown; ++call)
    suggestions.push_back(fmt::format("called by <{}> in {}", (*call)->Name(), PlaceOf(**call)));
  return suggestions;
}

Result<std::string> XacroExpander::Expand(const std::string& text, const std::string& path) {
  try {
    return ExpandRoot(text, path);
  } catch (const XacroProblem& problem) {
    const std::string place = at_ == nullptr ? "" : fmt::format("{}: <{}>: ", PlaceOf(*at_), at_->Name());
    return Failure{FailureKind::kBadInput, problem.code, "ExpandXacro", place + problem.message, CallHints()};
  }
}

}  // namespace gaitwright
