// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/description/xacro_value_internal.h"

namespace gaitwright {

/// Access of an expression to the description around it.
class XacroContext {
 public:
  explicit XacroContext(XacroBudget& work) : budget(work) {}
  XacroContext(const XacroContext&) = delete;
  XacroContext& operator=(const XacroContext&) = delete;
  virtual ~XacroContext() = default;

  /// The value of a property NAME or NAMESPACE.NAME; nothing if it does not exist.
  virtual std::optional<XacroValue> Property(const std::string& name) = 0;
  /// The properties that Property finds, for messages.
  virtual std::vector<std::string> PropertyNames() const = 0;
  /// Calls a function that reads files or arguments, such as load_yaml; nothing for an unknown function.
  virtual std::optional<XacroValue> Call(const std::string& function, const std::vector<XacroValue>& arguments) = 0;
  /// The text of `$(COMMAND WORDS)`.
  virtual std::string Substitution(const std::string& command, const std::vector<std::string>& words) = 0;
  /// The value of `$(eval EXPRESSION)`, in which arguments can be used as names.
  virtual XacroValue EvalSubstitution(const std::string& expression) = 0;

  XacroBudget& budget;
};

/// The functions of Call that CallXacroFunction does not have, for messages.
inline const std::vector<std::string> kXacroFileFunctions = {
    "load_yaml", "arg", "find", "env", "optenv", "dirname", "abs_filename", "message", "warning", "error", "fatal"};

/// The value of an expression, the text between `${` and `}`. Throws XacroProblem.
XacroValue EvaluateXacro(const std::string& expression, XacroContext& context);

/// The value of a text with `${expression}`, `$(substitution)` and the escapes `$${` and `$$(`. If the text is one
/// expression, it is the value of this expression. Otherwise it is the text with the values printed.
XacroValue EvaluateXacroText(const std::string& text, XacroContext& context);

/// `left OPERATOR right` of + - * / // % **, as Python computes it.
XacroValue XacroArithmetic(const std::string& operation, const XacroValue& left, const XacroValue& right,
                           XacroBudget& budget);

/// `left OPERATOR right` of == != < <= > >= in, not in, is, is not.
bool XacroCompared(const std::string& operation, const XacroValue& left, const XacroValue& right, XacroBudget& budget);

/// `FORMAT % value` with the conversions of C.
std::string XacroFormatted(const std::string& format, const XacroValue& value, XacroBudget& budget);

/// The arguments of a call, those without a name and those with one.
struct XacroArguments {
  std::vector<XacroValue> unnamed;
  std::vector<std::pair<std::string, XacroValue>> named;
};

/// `FORMAT.format(arguments)` with the fields {}, {0} and {name}, each with a format of a number or text, as Python has
/// it.
XacroValue FormatXacroText(const std::string& format, const XacroArguments& arguments, XacroBudget& budget);

/// Calls a function of Python or of its module math; nothing for an unknown function.
std::optional<XacroValue> CallXacroFunction(const std::string& name, const std::vector<XacroValue>& arguments,
                                            XacroBudget& budget);

/// The names of the functions of CallXacroFunction.
std::vector<std::string> XacroFunctionNames();

/// Calls a method of a text, list or dictionary.
XacroValue CallXacroMethod(const XacroValue& object, const std::string& name, const std::vector<XacroValue>& arguments,
                           XacroBudget& budget);

/// The items of a `for` loop: the items of a list, the keys of a dictionary, or the characters of a text.
std::vector<XacroValue> XacroItems(const XacroValue& value, XacroBudget& budget);

/// Throws XacroProblem `xacro_type`: "OPERATION needs ...".
[[noreturn]] void RefuseXacroType(const std::string& message);

}  // namespace gaitwright
