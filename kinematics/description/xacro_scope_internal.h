// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/description/xacro_value_internal.h"

namespace gaitwright {

/// A property: a value, or a text that is evaluated at its first use.
struct XacroProperty {
  XacroValue value;
  bool pending = false;    ///< the value is a text that is not evaluated yet
  bool resolving = false;  ///< it is being evaluated
  const tinyxml2::XMLElement* where = nullptr;
};

/// XML that <xacro:insert_block> inserts.
struct XacroBlock {
  const tinyxml2::XMLElement* element = nullptr;
  bool content_only = false;  ///< inserts only the children of the element
  bool expanded = false;      ///< inserted unchanged, because it was expanded at the call of the macro
};

/// A parameter of a macro.
struct XacroParameter {
  enum class Kind { kValue, kBlock, kContent };

  std::string name;  ///< without `*` and `**`
  Kind kind = Kind::kValue;
  bool forwarded = false;  ///< `:=^`: uses the property of the same name at the call of the macro
  std::optional<std::string> default_text = std::nullopt;
};

/// A macro. The body belongs to the document that defines it.
struct XacroMacro {
  std::string name;
  std::vector<XacroParameter> parameters;
  const tinyxml2::XMLElement* body = nullptr;
  bool bare = false;  ///< defined without the prefix, so it is called without it too
};

/// The names that are visible in a file, a macro or a namespace.
struct XacroScope {
  XacroScope* parent = nullptr;  ///< searched for names that are not in this scope
  XacroScope* caller = nullptr;  ///< the scope of scope="parent"
  std::map<std::string, XacroProperty> properties;
  std::map<std::string, XacroBlock> blocks;
  std::map<std::string, std::shared_ptr<const XacroMacro>> macros;
  std::map<std::string, std::unique_ptr<XacroScope>> namespaces;

  /// A property, by its name or NAMESPACE.NAME, and the scope that contains it; null if it does not exist.
  std::pair<XacroProperty*, XacroScope*> FindProperty(const std::string& name, XacroBudget& budget);
  /// A macro, by its name or NAMESPACE.NAME, and the scope in which its body is expanded; null if it does not exist.
  std::pair<std::shared_ptr<const XacroMacro>, XacroScope*> FindMacro(const std::string& name, XacroBudget& budget);
  const XacroBlock* FindBlock(const std::string& name, XacroBudget& budget) const;

  /// The visible names, for messages; at most a thousand.
  std::vector<std::string> PropertyNames() const;
  std::vector<std::string> MacroNames() const;
  std::vector<std::string> BlockNames() const;
};

/// The parameters of a macro from its attribute `params`. Throws XacroProblem `xacro_syntax`.
std::vector<XacroParameter> ParseXacroParameters(const std::string& text);

}  // namespace gaitwright
