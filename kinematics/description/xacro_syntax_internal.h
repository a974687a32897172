// SPDX-License-Identifier: BSD-3-Clause
// Expressions of xacro as trees. They are the subset of Python's expressions that robot descriptions use.
#pragma once

#include <string>
#include <vector>

#include "kinematics/description/xacro_value_internal.h"

namespace gaitwright {

/// A word, number, text or operator of an expression.
struct XacroToken {
  enum class Kind { kName, kNumber, kText, kOperator, kEnd };

  Kind kind = Kind::kEnd;
  std::string text;  ///< as in the source; for a text, the part between the quotes
  XacroValue value;  ///< value of a number
  std::size_t at = 0;
};

/// The tokens of an expression, followed by one of kind kEnd. Throws XacroProblem `xacro_syntax`.
std::vector<XacroToken> XacroTokens(const std::string& expression);

/// Operation of a node of an expression's tree on its children.
enum class XacroNodeKind {
  kConstant,       ///< value
  kName,           ///< text
  kList,           ///< children: items
  kDict,           ///< children: key, value, key, value ...
  kUnary,          ///< operators[0] is '-', '+' or 'not'; one child
  kChain,          ///< children joined from the left by the operators + - * / // %
  kPower,          ///< two children
  kCompare,        ///< children compared with their neighbours by the operators
  kAnd,            ///< children
  kOr,             ///< children
  kChoice,         ///< condition, value if true, value if false
  kMember,         ///< text is the member's name; one child
  kIndex,          ///< container, index
  kSlice,          ///< container, first, last; a constant None for an omitted bound
  kCall,           ///< callee, then the arguments; operators: the keyword of each argument, or ""
  kComprehension,  ///< text is the variable; value, list, condition
};

/// A node of an expression's tree.
struct XacroNode {
  XacroNodeKind kind = XacroNodeKind::kConstant;
  std::string text;
  XacroValue value;
  std::vector<XacroNode> children;
  std::vector<std::string> operators;
};

/// The tree of an expression. Throws XacroProblem `xacro_syntax` with the part that is not understood.
XacroNode ParseXacroExpression(const std::string& expression);

}  // namespace gaitwright
