// SPDX-License-Identifier: BSD-3-Clause
// Expressions of xacro as trees: the part of Python's expressions that robot descriptions use.
#pragma once

#include <string>
#include <vector>

#include "kinematics/description/xacro_value_internal.h"

namespace gaitwright {

/// A word, number, text or operator of an expression.
struct XacroToken {
  enum class Kind { kName, kNumber, kText, kOperator, kEnd };

  Kind kind = Kind::kEnd;
  std::string text;  ///< as it was written; of a text what is between the quotes
  XacroValue value;  ///< of a number
  std::size_t at = 0;
};

/// The tokens of an expression, with one of kind kEnd behind them. Throws XacroProblem `xacro_syntax`.
std::vector<XacroToken> XacroTokens(const std::string& expression);

/// What a node of an expression's tree does with its children.
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
  kSlice,          ///< container, first, last; a constant None stands for one that is left out
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

/// The tree of an expression. Throws XacroProblem `xacro_syntax` naming what is not understood.
XacroNode ParseXacroExpression(const std::string& expression);

}  // namespace gaitwright
