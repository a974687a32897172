// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/non_finite.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_evaluate_internal.h"
#include "kinematics/description/xacro_syntax_internal.h"

namespace gaitwright {
namespace {

std::optional<XacroValue> XacroConstant(const std::string& name) {
  if (name == "pi") return XacroValue{std::numbers::pi};
  if (name == "e") return XacroValue{std::numbers::e};
  if (name == "tau") return XacroValue{2.0 * std::numbers::pi};
  if (name == "inf") return XacroValue{kInfinity};
  if (name == "nan") return XacroValue{kNaN};
  if (name == "true") return XacroValue{true};
  if (name == "false") return XacroValue{false};
  return std::nullopt;
}

/// Position in a sequence; a negative index counts from the end. Refuses an index outside the sequence.
std::size_t PlaceInSequence(std::size_t size, const XacroValue& index, const std::string& kind) {
  if (index.whole() == nullptr)
    RefuseXacroType(fmt::format("the index of a {} must be a whole number, not a {}", kind, XacroKind(index)));
  const std::int64_t place = *index.whole() < 0 ? *index.whole() + static_cast<std::int64_t>(size) : *index.whole();
  if (place < 0 || place >= static_cast<std::int64_t>(size))
    throw XacroProblem{FailureCode::kXacroIndex,
                       fmt::format("index {} is outside a {} of size {}", *index.whole(), kind, size)};
  return static_cast<std::size_t>(place);
}

/// A bound of a slice, limited to the sequence.
std::size_t SliceBound(std::size_t size, const XacroValue& bound, std::size_t absent) {
  if (bound.is_none()) return absent;
  if (bound.whole() == nullptr) RefuseXacroType("the bounds of a slice must be whole numbers");
  const std::int64_t length = static_cast<std::int64_t>(size);
  const std::int64_t place = *bound.whole() < 0 ? *bound.whole() + length : *bound.whole();
  return static_cast<std::size_t>(std::clamp<std::int64_t>(place, 0, length));
}

/// Computes the value of a tree.
class XacroEvaluator {
 public:
  explicit XacroEvaluator(XacroContext& context) : context_(context) {}

  XacroValue Value(const XacroNode& node) {
    const XacroBudget::Level level(context_.budget);
    context_.budget.Spend(1);
    switch (node.kind) {
      case XacroNodeKind::kConstant:
        return node.value;
      case XacroNodeKind::kName:
        return NameValue(node.text);
      case XacroNodeKind::kList:
        return XacroListOf(Values(node, 0), context_.budget);
      case XacroNodeKind::kDict:
        return DictValue(node);
      case XacroNodeKind::kUnary:
        return UnaryValue(node);
      case XacroNodeKind::kChain:
        return ChainValue(node);
      case XacroNodeKind::kPower:
        return PowerValue(node);
      case XacroNodeKind::kCompare:
        return CompareValue(node);
      case XacroNodeKind::kAnd:
        return LogicValue(node, false);
      case XacroNodeKind::kOr:
        return LogicValue(node, true);
      case XacroNodeKind::kChoice:
        return Value(node.children[XacroTruth(Value(node.children[0])) ? 1 : 2]);
      case XacroNodeKind::kMember:
        return MemberValue(node);
      case XacroNodeKind::kIndex:
        return IndexValue(node);
      case XacroNodeKind::kSlice:
        return SliceValue(node);
      case XacroNodeKind::kCall:
        return CallValue(node);
      case XacroNodeKind::kComprehension:
        return ComprehensionValue(node);
    }
    return {};
  }

 private:
  std::vector<XacroValue> Values(const XacroNode& node, std::size_t from) {
    std::vector<XacroValue> values;
    for (std::size_t i = from; i < node.children.size(); ++i) values.push_back(Value(node.children[i]));
    return values;
  }

  /// A variable of a comprehension, a property, or a constant of mathematics, in this order.
  std::optional<XacroValue> Known(const std::string& name) {
    const auto local = std::find_if(locals_.rbegin(), locals_.rend(), [&](const auto& l) { return l.first == name; });
    if (local != locals_.rend()) return local->second;
    if (auto property = context_.Property(name)) {
      if (property->text() != nullptr) context_.budget.Spend(property->text()->size() / 16);
      return property;
    }
    return XacroConstant(name);
  }

  XacroValue NameValue(const std::string& name) {
    if (auto known = Known(name)) return *known;
    throw XacroProblem{FailureCode::kUnknownProperty, fmt::format("the property '{}' is not defined{}", Shortened(name),
                                                                  NearestHint(name, context_.PropertyNames()))};
  }

  XacroValue DictValue(const XacroNode& node) {
    std::vector<std::pair<XacroValue, XacroValue>> entries;
    for (std::size_t i = 0; i + 1 < node.children.size(); i += 2)
      entries.emplace_back(Value(node.children[i]), Value(node.children[i + 1]));
    return XacroDictOf(std::move(entries), context_.budget);
  }

  XacroValue UnaryValue(const XacroNode& node) {
    const XacroValue value = Value(node.children[0]);
    if (node.operators[0] == "not") return {!XacroTruth(value)};
    const XacroValue sign{node.operators[0] == "-" ? std::int64_t{-1} : std::int64_t{1}};
    if (value.is_real()) return {node.operators[0] == "-" ? -*XacroNumber(value) : *XacroNumber(value)};
    if (!XacroNumber(value))
      RefuseXacroType(
          fmt::format("'{}' needs a number, not a {}{}", node.operators[0], XacroKind(value), Quoted(value)));
    return XacroArithmetic("*", sign, value, context_.budget);
  }

  XacroValue ChainValue(const XacroNode& node) {
    XacroValue value = Value(node.children[0]);
    for (std::size_t i = 1; i < node.children.size(); ++i)
      value = XacroArithmetic(node.operators[i - 1], value, Value(node.children[i]), context_.budget);
    return value;
  }

  XacroValue PowerValue(const XacroNode& node) {
    const XacroValue base = Value(node.children[0]);
    return XacroArithmetic("**", base, Value(node.children[1]), context_.budget);
  }

  XacroValue CompareValue(const XacroNode& node) {
    XacroValue left = Value(node.children[0]);
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      XacroValue right = Value(node.children[i]);
      if (!XacroCompared(node.operators[i - 1], left, right, context_.budget)) return {false};
      left = std::move(right);
    }
    return {true};
  }

  /// The first operand whose truth is `decides`, else the last operand.
  XacroValue LogicValue(const XacroNode& node, bool decides) {
    XacroValue value;
    for (const XacroNode& operand : node.children) {
      value = Value(operand);
      if (XacroTruth(value) == decides) return value;
    }
    return value;
  }

  /// "a.b.c" for a name and its members, "" for other nodes.
  static std::string DottedName(const XacroNode& node) {
    if (node.kind == XacroNodeKind::kName) return node.text;
    if (node.kind != XacroNodeKind::kMember) return "";
    const std::string owner = DottedName(node.children[0]);
    return owner.empty() ? "" : owner + "." + node.text;
  }

  /// Whether a node is "math", "xacro" or "python", and no property has that name.
  bool IsModule(const XacroNode& node) {
    return node.kind == XacroNodeKind::kName &&
           (node.text == "math" || node.text == "xacro" || node.text == "python") && !Known(node.text);
  }

  XacroValue MemberValue(const XacroNode& node) {
    const XacroNode& owner = node.children[0];
    if (IsModule(owner)) {
      if (auto constant = XacroConstant(node.text)) return *constant;
      throw XacroProblem{FailureCode::kUnknownProperty,
                         fmt::format("'{}.{}' is not known", owner.text, Shortened(node.text))};
    }
    const std::string dotted = DottedName(node);
    if (!dotted.empty() && !Known(dotted.substr(0, dotted.find('.')))) {
      if (auto property = context_.Property(dotted)) return *property;
      if (owner.kind == XacroNodeKind::kName) return NameValue(dotted);
    }
    const XacroValue value = Value(owner);
    if (value.dict() == nullptr)
      RefuseXacroType(fmt::format("a {} has no member '{}'", XacroKind(value), Shortened(node.text)));
    return Entry(value, {node.text});
  }

  XacroValue Entry(const XacroValue& dict, const XacroValue& key) {
    if (const XacroValue* value = dict.dict()->Find(key, context_.budget)) return *value;
    std::vector<std::string> keys;
    for (const auto& [name, value] : dict.dict()->entries) {
      if (name.text() != nullptr && keys.size() < 1000) keys.push_back(*name.text());
    }
    const std::string name = XacroPrinted(key, context_.budget);
    throw XacroProblem{FailureCode::kUnknownKey,
                       fmt::format("the dictionary has no key '{}'{}", Shortened(name), NearestOrAll(name, keys))};
  }

  XacroValue IndexValue(const XacroNode& node) {
    const XacroValue container = Value(node.children[0]);
    const XacroValue index = Value(node.children[1]);
    if (container.dict() != nullptr) return Entry(container, index);
    if (const XacroList* list = container.list())
      return list->items[PlaceInSequence(list->items.size(), index, "list")];
    if (const std::string* text = container.text())
      return {std::string(1, (*text)[PlaceInSequence(text->size(), index, "text")])};
    RefuseXacroType(fmt::format("a {} has no items", XacroKind(container)));
  }

  XacroValue SliceValue(const XacroNode& node) {
    const XacroValue container = Value(node.children[0]);
    const XacroValue first = Value(node.children[1]), last = Value(node.children[2]);
    if (container.text() == nullptr && container.list() == nullptr)
      RefuseXacroType(fmt::format("a {} has no slices", XacroKind(container)));
    const std::size_t size = container.text() != nullptr ? container.text()->size() : container.list()->items.size();
    const std::size_t from = SliceBound(size, first, 0), to = std::max(from, SliceBound(size, last, size));
    if (container.text() != nullptr) return XacroText(container.text()->substr(from, to - from));
    const auto begin = container.list()->items.begin();
    return XacroListOf({begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to)},
                       context_.budget);
  }

  XacroValue CallValue(const XacroNode& node) {
    const XacroNode& callee = node.children[0];
    const bool method = callee.kind == XacroNodeKind::kMember && !IsModule(callee.children[0]);
    if (callee.kind != XacroNodeKind::kName && callee.kind != XacroNodeKind::kMember)
      RefuseXacroType("only functions and methods can be called by their names");
    const bool is_dict = !method && callee.text == "dict", is_format = method && callee.text == "format";
    const auto named =
        std::find_if(node.operators.begin(), node.operators.end(), [](const auto& k) { return !k.empty(); });
    if (named != node.operators.end() && !is_dict && !is_format)
      throw XacroProblem{FailureCode::kXacroSyntax,
                         fmt::format("{}() has no argument with the name '{}'", callee.text, *named)};
    if (method) {
      const XacroValue object = Value(callee.children[0]);
      if (is_format && object.text() != nullptr)
        return FormatXacroText(*object.text(), ArgumentsOf(node), context_.budget);
      return CallXacroMethod(object, callee.text, Values(node, 1), context_.budget);
    }
    const std::vector<XacroValue> arguments = Values(node, 1);
    if (is_dict) return MadeDict(node, arguments);
    if (auto value = context_.Call(callee.text, arguments)) return *value;
    if (auto value = CallXacroFunction(callee.text, arguments, context_.budget)) return *value;
    std::vector<std::string> names = XacroFunctionNames();
    names.insert(names.end(), kXacroFileFunctions.begin(), kXacroFileFunctions.end());
    throw XacroProblem{
        FailureCode::kUnknownFunction,
        fmt::format("the function '{}' is not known{}", Shortened(callee.text), NearestHint(callee.text, names))};
  }

  XacroArguments ArgumentsOf(const XacroNode& call) {
    XacroArguments arguments;
    for (std::size_t i = 1; i < call.children.size(); ++i) {
      if (call.operators[i - 1].empty())
        arguments.unnamed.push_back(Value(call.children[i]));
      else
        arguments.named.emplace_back(call.operators[i - 1], Value(call.children[i]));
    }
    return arguments;
  }

  /// dict(a=1, b=2), dict(other, a=1) or dict([['a', 1]]).
  XacroValue MadeDict(const XacroNode& node, const std::vector<XacroValue>& arguments) {
    std::vector<std::pair<XacroValue, XacroValue>> entries;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!node.operators[i].empty()) {
        entries.emplace_back(XacroValue{node.operators[i]}, arguments[i]);
      } else if (const XacroDict* other = arguments[i].dict()) {
        entries.insert(entries.end(), other->entries.begin(), other->entries.end());
      } else {
        for (const XacroValue& pair : XacroItems(arguments[i], context_.budget)) {
          if (pair.list() == nullptr || pair.list()->items.size() != 2)
            RefuseXacroType("dict() needs names with values, a dictionary or a list of pairs");
          entries.emplace_back(pair.list()->items[0], pair.list()->items[1]);
        }
      }
    }
    return XacroDictOf(std::move(entries), context_.budget);
  }

  XacroValue ComprehensionValue(const XacroNode& node) {
    const std::vector<XacroValue> items = XacroItems(Value(node.children[1]), context_.budget);
    std::vector<XacroValue> values;
    locals_.emplace_back(node.text, XacroValue{});
    for (const XacroValue& item : items) {
      locals_.back().second = item;
      if (XacroTruth(Value(node.children[2]))) values.push_back(Value(node.children[0]));
    }
    locals_.pop_back();
    return XacroListOf(std::move(values), context_.budget);
  }

  static std::string Quoted(const XacroValue& value) {
    return value.text() == nullptr ? "" : fmt::format(" '{}'", Shortened(*value.text()));
  }

  XacroContext& context_;
  std::vector<std::pair<std::string, XacroValue>> locals_;
};

}  // namespace

XacroValue EvaluateXacro(const std::string& expression, XacroContext& context) {
  context.budget.Spend(1 + expression.size() / 8);
  try {
    return XacroEvaluator(context).Value(ParseXacroExpression(expression));
  } catch (XacroProblem& problem) {
    if (!problem.shows_expression)
      problem.message = fmt::format("'{}': {}", Shortened(Trimmed(expression)), problem.message);
    problem.shows_expression = true;
    throw;
  }
}

}  // namespace gaitwright
