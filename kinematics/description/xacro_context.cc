// SPDX-License-Identifier: BSD-3-Clause
// Access of expressions and substitutions to the description around them.
#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_expander_internal.h"

namespace gaitwright {
namespace {

const std::vector<std::string> kXacroSubstitutions = {"arg", "dirname", "env", "eval", "find", "optenv"};

/// `$(eval ...)`: arguments are names, before properties.
class XacroArgumentContext : public XacroScopeContext {
 public:
  using XacroScopeContext::XacroScopeContext;

  std::optional<XacroValue> Property(const std::string& name) override {
    const auto argument = expander_.arguments().find(name);
    if (argument == expander_.arguments().end()) return XacroScopeContext::Property(name);
    expander_.UseArgument(name);
    return XacroLiteral(argument->second);
  }

  std::optional<XacroValue> Call(const std::string& function, const std::vector<XacroValue>& arguments) override {
    std::optional<XacroValue> value = XacroScopeContext::Call(function, arguments);
    return value && function == "arg" ? XacroLiteral(*value->text()) : value;
  }
};

/// The texts of a function's arguments. Refuses a wrong number of arguments.
std::vector<std::string> TextsOfCall(const std::string& function, const std::vector<XacroValue>& arguments,
                                     std::size_t least, std::size_t most) {
  std::vector<std::string> texts;
  for (const XacroValue& argument : arguments) {
    if (argument.text() == nullptr)
      RefuseXacroType(fmt::format("{}() takes texts, not a {}", function, XacroKind(argument)));
    texts.push_back(*argument.text());
  }
  if (texts.size() < least || texts.size() > most)
    RefuseXacroType(fmt::format("{}() does not take {} arguments", function, texts.size()));
  return texts;
}

}  // namespace

XacroValue XacroExpander::Resolve(const std::string& name, XacroProperty& property, XacroScope& owner) {
  if (!property.pending) return property.value;
  if (property.resolving) {
    const auto first = std::find(resolving_.begin(), resolving_.end(), name);
    const std::vector<std::string> circle(first, resolving_.end());
    throw XacroProblem{FailureCode::kXacroRecursion,
                       fmt::format("the property '{}' depends on itself, through {} ({})", Shortened(name),
                                   QuotedList(circle), PlaceOf(*property.where))};
  }
  property.resolving = true;
  resolving_.push_back(name);
  try {
    XacroScopeContext context(*this, owner, *property.where);
    XacroValue value = EvaluateXacroText(*property.value.text(), context);
    property.value = value.text() != nullptr ? XacroLiteral(*value.text()) : std::move(value);
  } catch (XacroProblem& problem) {
    constexpr int kMostNamed = 3;  // number of properties in the message, from the error outward
    if (properties_named_++ < kMostNamed)
      problem.message += fmt::format("; the property '{}' is defined in {}", Shortened(name), PlaceOf(*property.where));
    throw;
  }
  resolving_.pop_back();
  property.resolving = property.pending = false;
  return property.value;
}

const std::string& XacroExpander::Argument(const std::string& name) {
  const auto argument = arguments_.find(name);
  used_.insert(name);
  if (argument != arguments_.end()) return argument->second;
  std::vector<std::string> names;
  for (const auto& [known, value] : arguments_) names.push_back(known);
  throw XacroProblem{FailureCode::kXacroArgument,
                     fmt::format("the argument '{}' has no value; give it with --xacro-arg {}=VALUE, or define it with "
                                 "<xacro:arg> before its use{}",
                                 Shortened(name), Shortened(name), NearestOrAll(name, names))};
}

std::optional<XacroValue> XacroScopeContext::Property(const std::string& name) {
  const auto [property, owner] = scope_.FindProperty(name, budget);
  if (property == nullptr) return std::nullopt;
  return expander_.Resolve(name, *property, *owner);
}

std::string XacroExpander::FoundPackage(const Element& element, const std::string& name) const {
  const Result<std::string> folder = sources_.find_package(name, FolderOf(element));
  if (folder) return *folder;
  std::string message = folder.failure().message;
  for (const Suggestion& hint : folder.failure().suggestions) message += "; " + hint.text;
  throw XacroProblem{FailureCode::kNoPackage, message};
}

std::optional<XacroValue> XacroScopeContext::Call(const std::string& function,
                                                  const std::vector<XacroValue>& arguments) {
  if (function == "load_yaml") {
    const std::string path = TextsOfCall(function, arguments, 1, 1)[0];
    return expander_.LoadYamlFile(XacroExpander::PathBeside(where_, path));
  }
  if (function == "abs_filename")
    return XacroText(XacroExpander::PathBeside(where_, TextsOfCall(function, arguments, 1, 1)[0]));
  if (function == "arg") return XacroText(expander_.Argument(TextsOfCall(function, arguments, 1, 1)[0]));
  if (function == "find" || function == "env")
    return XacroText(Substitution(function, TextsOfCall(function, arguments, 1, 1)));
  if (function == "optenv") return XacroText(Substitution(function, TextsOfCall(function, arguments, 1, 2)));
  if (function == "dirname") return XacroText(Substitution(function, TextsOfCall(function, arguments, 0, 0)));
  if (function == "message" || function == "warning" || function == "error") return XacroValue{std::string()};
  if (function != "fatal") return std::nullopt;
  std::string message;
  for (const XacroValue& part : arguments) message += (message.empty() ? "" : " ") + XacroPrinted(part, budget);
  throw XacroProblem{FailureCode::kXacroFatal, fmt::format("the description reports an error: {}", Shortened(message)),
                     true};
}

std::string XacroScopeContext::Substitution(const std::string& command, const std::vector<std::string>& words) {
  const auto need = [&, count = words.size()](std::size_t least, std::size_t most) {
    if (count >= least && count <= most) return;
    throw XacroProblem{FailureCode::kUnknownSubstitution,
                       fmt::format("'$({})' does not take {} words", command, count)};
  };
  if (command == "arg") {
    need(1, 1);
    return expander_.Argument(words[0]);
  }
  if (command == "find") {
    need(1, 1);
    return expander_.FoundPackage(where_, words[0]);
  }
  if (command == "dirname") {
    need(0, 0);
    const std::string folder = XacroExpander::FolderOf(where_);
    return folder.empty() ? "." : folder;
  }
  if (command != "env" && command != "optenv") {
    throw XacroProblem{FailureCode::kUnknownSubstitution,
                       fmt::format("'$({} ...)' is not supported; supported: {}", Shortened(command),
                                   QuotedList(kXacroSubstitutions))};
  }
  need(1, command == "env" ? 1 : 1000);
  if (const auto value = expander_.sources().environment(words[0])) return *value;
  if (command == "env") {
    throw XacroProblem{FailureCode::kNoVariable,
                       fmt::format("the environment variable '{}' is not set", Shortened(words[0]))};
  }
  std::string usual;
  for (std::size_t i = 1; i < words.size(); ++i) usual += (i == 1 ? "" : " ") + words[i];
  return usual;
}

XacroValue XacroScopeContext::EvalSubstitution(const std::string& expression) {
  XacroArgumentContext context(expander_, scope_, where_);
  return EvaluateXacro(expression, context);
}

}  // namespace gaitwright
