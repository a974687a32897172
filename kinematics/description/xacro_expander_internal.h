// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kinematics/description/xacro.h"
#include "kinematics/description/xacro_evaluate_internal.h"
#include "kinematics/description/xacro_scope_internal.h"

namespace gaitwright {

/// A file of the description. The user data of its document points to it.
struct XacroFile {
  std::string path;
  tinyxml2::XMLDocument xml;
  bool bare_tags = false;  ///< elements without the prefix may be of xacro, because the root declares the namespace
};

/// Expands one description. The elements of the files are not changed; the result is a separate document.
///
/// = Notation =  `element` is an element of a file. Its expansion is appended to `out`. Its names are searched in
/// `scope`. Functions throw XacroProblem; its place is that of `at_`, the element that is being expanded.
class XacroExpander {
 public:
  XacroExpander(const XacroSources& sources, const std::map<std::string, std::string>& arguments)
      : sources_(sources), given_(arguments), arguments_(arguments) {}

  Result<std::string> Expand(const std::string& text, const std::string& path);

  // Access for expressions.
  XacroBudget& budget() { return budget_; }
  const std::map<std::string, std::string>& arguments() const { return arguments_; }
  const XacroSources& sources() const { return sources_; }
  XacroValue Resolve(const std::string& name, XacroProperty& property, XacroScope& owner);
  const std::string& Argument(const std::string& name);
  XacroValue LoadYamlFile(const std::string& path);
  static std::string PathBeside(const tinyxml2::XMLElement& element, const std::string& path);
  static std::string FolderOf(const tinyxml2::XMLElement& element);
  std::string FoundPackage(const tinyxml2::XMLElement& element, const std::string& name) const;
  void UseArgument(const std::string& name) { used_.insert(name); }

 private:
  using Node = tinyxml2::XMLNode;
  using Element = tinyxml2::XMLElement;
  using Directive = void (XacroExpander::*)(const Element&, Node& out, XacroScope& scope);

  // xacro_expand.cc: elements and text.
  std::string ExpandRoot(const std::string& text, const std::string& path);
  void ExpandNodes(const Node* first, Node& out, XacroScope& scope);
  void ExpandElement(const Element& element, Node& out, XacroScope& scope);
  void CopyAttributes(const Element& element, Element& made, XacroScope& scope, bool names_itself);
  void CopyExpanded(const Node& node, Node& out);
  Element& AppendElement(const std::string& name, Node& out);
  void SetAttribute(Element& element, const std::string& name, const std::string& value);
  void AppendText(const std::string& text, bool cdata, Node& out);
  std::string XacroWord(const Element& element, const Node& out, XacroScope& scope);
  XacroValue Evaluated(const std::string& text, XacroScope& scope);
  std::string Printed(const std::string& text, XacroScope& scope);
  std::string PrintedAttribute(const Element& element, const char* name, XacroScope& scope);
  void CheckArguments() const;

  // xacro_directives.cc: conditions, blocks, and elements and attributes with computed names.
  static Directive DirectiveOf(const std::string& word);
  bool Condition(const Element& element, XacroScope& scope);
  void If(const Element& element, Node& out, XacroScope& scope);
  void Unless(const Element& element, Node& out, XacroScope& scope);
  void InsertBlock(const Element& element, Node& out, XacroScope& scope);
  void MakeAttribute(const Element& element, Node& out, XacroScope& scope);
  void MakeElement(const Element& element, Node& out, XacroScope& scope);
  void CallNamed(const Element& element, Node& out, XacroScope& scope);
  void DefineArgument(const Element& element, Node& out, XacroScope& scope);
  void DefineProperty(const Element& element, Node& out, XacroScope& scope);
  void DefineMacro(const Element& element, Node& out, XacroScope& scope);

  // xacro_call.cc: macros.
  void CallMacro(const Element& element, const std::string& name, Node& out, XacroScope& scope);
  void GiveAttributes(const Element& element, const XacroMacro& macro, XacroScope& local, XacroScope& scope);
  void GiveBlocks(const XacroMacro& macro, const Element& expanded, XacroScope& local);
  void GiveDefaults(const XacroMacro& macro, XacroScope& local, XacroScope& scope);

  // xacro_include.cc: files.
  const XacroFile& Parse(const std::string& text, const std::string& path);
  std::string PathOfUrl(const Element& element, const std::string& url) const;
  void Include(const Element& element, Node& out, XacroScope& scope);

  static const XacroFile& FileOf(const Element& element);
  static std::string PlaceOf(const Element& element);
  std::vector<Suggestion> CallHints() const;

  const XacroSources& sources_;
  XacroBudget budget_;
  const std::map<std::string, std::string>& given_;
  std::map<std::string, std::string> arguments_;  ///< given arguments and defaults
  std::set<std::string> used_;                    ///< arguments that the files declare or read
  std::map<std::string, std::unique_ptr<XacroFile>> files_;
  std::map<std::string, std::string> yaml_;  ///< texts by path
  std::size_t bytes_read_ = 0;
  std::vector<const XacroFile*> including_;  ///< files that are being expanded, outer ones first
  std::vector<const Element*> calls_;        ///< calls of macros that are being expanded, outer ones first
  std::vector<std::string> resolving_;       ///< properties that are being evaluated, outer ones first
  int properties_named_ = 0;                 ///< number of properties in the message of a failure
  const Element* at_ = nullptr;
  XacroScope globals_;
  tinyxml2::XMLDocument result_;
};

/// The context of expressions: the names of a scope, and the file of an element for paths.
class XacroScopeContext : public XacroContext {
 public:
  XacroScopeContext(XacroExpander& expander, XacroScope& scope, const tinyxml2::XMLElement& where)
      : XacroContext(expander.budget()), expander_(expander), scope_(scope), where_(where) {}

  std::optional<XacroValue> Property(const std::string& name) override;
  std::vector<std::string> PropertyNames() const override { return scope_.PropertyNames(); }
  std::optional<XacroValue> Call(const std::string& function, const std::vector<XacroValue>& arguments) override;
  std::string Substitution(const std::string& command, const std::vector<std::string>& words) override;
  XacroValue EvalSubstitution(const std::string& expression) override;

 protected:
  XacroExpander& expander_;

 private:
  XacroScope& scope_;
  const tinyxml2::XMLElement& where_;
};

/// Throws XacroProblem if the element has an attribute that is not in `known`.
void CheckXacroAttributes(const tinyxml2::XMLElement& element, const std::vector<std::string>& known);

/// The unevaluated text of an attribute. Throws XacroProblem if it is missing.
std::string NeededXacroAttribute(const tinyxml2::XMLElement& element, const char* name);

/// A text as truth value: true, false or a whole number. Throws XacroProblem naming `what`.
bool XacroTruthOfText(const XacroValue& value, const std::string& what);

/// The value of a YAML text with the units of xacro, such as `!degrees 90`.
XacroValue XacroFromYaml(const std::string& text, XacroContext& context);

}  // namespace gaitwright
