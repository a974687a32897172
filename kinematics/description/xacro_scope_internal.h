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

/// A property: a value, or the text of one that is evaluated when it is first asked for.
struct XacroProperty {
  XacroValue value;
  bool pending = false;    ///< the value is a text that is not evaluated yet
  bool resolving = false;  ///< it is being evaluated
  const tinyxml2::XMLElement* where = nullptr;
};

/// XML that <xacro:insert_block> inserts.
struct XacroBlock {
  const tinyxml2::XMLElement* element = nullptr;
  bool content_only = false;  ///< the children of the element, without itself
  bool expanded = false;      ///< it is copied as it is, since it was expanded where the macro was called
};

/// A parameter of a macro.
struct XacroParameter {
  enum class Kind { kValue, kBlock, kContent };

  std::string name;  ///< without `*` and `**`
  Kind kind = Kind::kValue;
  bool forwarded = false;  ///< `:=^`: a property of that name where the macro is called
  std::optional<std::string> default_text = std::nullopt;
};

/// A macro. The body belongs to the document that defines it.
struct XacroMacro {
  std::string name;
  std::vector<XacroParameter> parameters;
  const tinyxml2::XMLElement* body = nullptr;
  bool bare = false;  ///< defined without the prefix, so that it is called without it too
};

/// Names as they are seen in a file, a macro or a namespace.
struct XacroScope {
  XacroScope* parent = nullptr;  ///< where names are looked for that are not here
  XacroScope* caller = nullptr;  ///< what scope="parent" means
  std::map<std::string, XacroProperty> properties;
  std::map<std::string, XacroBlock> blocks;
  std::map<std::string, std::shared_ptr<const XacroMacro>> macros;
  std::map<std::string, std::unique_ptr<XacroScope>> namespaces;

  /// A property, by its name or NAMESPACE.NAME, and the scope that holds it; null where there is none.
  std::pair<XacroProperty*, XacroScope*> FindProperty(const std::string& name, XacroBudget& budget);
  /// A macro, by its name or NAMESPACE.NAME, and the scope in which its body is expanded; null where there is none.
  std::pair<std::shared_ptr<const XacroMacro>, XacroScope*> FindMacro(const std::string& name, XacroBudget& budget);
  const XacroBlock* FindBlock(const std::string& name, XacroBudget& budget) const;

  /// What can be found here, for messages; a thousand names at most.
  std::vector<std::string> PropertyNames() const;
  std::vector<std::string> MacroNames() const;
  std::vector<std::string> BlockNames() const;
};

/// The parameters of a macro, as its attribute `params` lists them. Throws XacroProblem `xacro_syntax`.
std::vector<XacroParameter> ParseXacroParameters(const std::string& text);

}  // namespace gaitwright
