// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "kinematics/description/xacro_evaluate_internal.h"

namespace gaitwright {

inline XacroValue WholeValue(std::int64_t number) { return {number}; }
inline XacroValue RealValue(double number) { return {number}; }
inline XacroValue TextValue(const std::string& text) { return {text}; }
inline XacroValue ListValue(std::vector<XacroValue> items) {
  XacroBudget budget;
  return XacroListOf(std::move(items), budget);
}
inline XacroValue DictValue(std::vector<std::pair<XacroValue, XacroValue>> entries) {
  XacroBudget budget;
  return XacroDictOf(std::move(entries), budget);
}

/// A value in a list, as printed by Python's repr(): 1, 1.0, '1' and True differ.
inline std::string ReprOf(const XacroValue& value) {
  XacroBudget budget;
  const std::string list = XacroPrinted(ListValue({value}), budget);
  return list.substr(1, list.size() - 2);
}

/// The problem that a call throws, or a failed test.
template <class Call>
XacroProblem ProblemOf(const Call& call) {
  try {
    call();
  } catch (const XacroProblem& problem) {
    return problem;
  }
  ADD_FAILURE() << "the call throws no XacroProblem";
  return {};
}

/// A context with given properties and functions. It records the requests.
class MadeXacroContext : public XacroContext {
 public:
  MadeXacroContext() : XacroContext(work_) {}

  std::optional<XacroValue> Property(const std::string& name) override {
    const auto found = properties.find(name);
    return found == properties.end() ? std::nullopt : std::optional<XacroValue>(found->second);
  }
  std::vector<std::string> PropertyNames() const override {
    std::vector<std::string> names;
    for (const auto& [name, value] : properties) names.push_back(name);
    return names;
  }
  std::optional<XacroValue> Call(const std::string& function, const std::vector<XacroValue>& arguments) override {
    if (function != "given") return std::nullopt;
    return ListValue(arguments);
  }
  std::string Substitution(const std::string& command, const std::vector<std::string>& words) override {
    std::string text = "<" + command;
    for (const std::string& word : words) text += "|" + word;
    return text + ">";
  }
  XacroValue EvalSubstitution(const std::string& expression) override {
    evaluated.push_back(expression);
    return WholeValue(static_cast<std::int64_t>(expression.size()));
  }

  std::map<std::string, XacroValue> properties;
  std::vector<std::string> evaluated;

 private:
  XacroBudget work_;
};

}  // namespace gaitwright
