// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/text.h"
#include "kinematics/description/xacro_evaluate_internal.h"

namespace gaitwright {
namespace {

[[noreturn]] void RefuseXacroNumber(const std::string& message) {
  throw XacroProblem{FailureCode::kXacroNumber, message};
}

std::optional<std::int64_t> WholeOfXacro(const XacroValue& value) {
  if (const auto* truth = std::get_if<bool>(&value.held)) return *truth ? 1 : 0;
  if (value.whole() != nullptr) return *value.whole();
  return std::nullopt;
}

/// Quotient rounded down, and its remainder, which has the sign of b.
std::int64_t FloorQuotient(std::int64_t a, std::int64_t b) {
  return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}
std::int64_t FloorRemainder(std::int64_t a, std::int64_t b) {
  const std::int64_t rest = a % b;
  return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}

double FloorRemainder(double a, double b) {
  const double rest = std::fmod(a, b);
  if (rest == 0.0) return std::copysign(0.0, b);
  return (rest < 0.0) != (b < 0.0) ? rest + b : rest;
}

/// Quotient rounded down, computed from the remainder as in Python: 1.0 // 0.1 is 9, because the double 0.1 is slightly
/// larger than 0.1.
double FloorQuotient(double a, double b) {
  const double quotient = (a - FloorRemainder(a, b)) / b;
  return std::nearbyint(quotient);
}

XacroValue WholePower(std::int64_t base, std::int64_t exponent) {
  if (exponent < 0) return {std::pow(static_cast<double>(base), static_cast<double>(exponent))};
  std::int64_t result = 1;
  bool fits = true;
  if (base == 0 || base == 1) return {exponent == 0 ? std::int64_t{1} : base};
  if (base == -1) return {exponent % 2 == 0 ? std::int64_t{1} : std::int64_t{-1}};
  for (std::int64_t i = 0; i < exponent && fits; ++i) fits = !__builtin_mul_overflow(result, base, &result);
  if (!fits)
    RefuseXacroNumber(fmt::format("{} ** {} is outside the range of whole numbers of 64 bits", base, exponent));
  return {result};
}

XacroValue WholeArithmetic(const std::string& operation, std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  bool overflow = false;
  if (operation == "+") overflow = __builtin_add_overflow(a, b, &result);
  if (operation == "-") overflow = __builtin_sub_overflow(a, b, &result);
  if (operation == "*") overflow = __builtin_mul_overflow(a, b, &result);
  if (operation == "//" || operation == "%") {
    if (b == 0) RefuseXacroNumber(fmt::format("{} {} 0 divides by zero", a, operation));
    if (b == -1) {
      overflow = operation == "//" && __builtin_sub_overflow(std::int64_t{0}, a, &result);
    } else {
      result = operation == "//" ? FloorQuotient(a, b) : FloorRemainder(a, b);
    }
  }
  if (overflow)
    RefuseXacroNumber(fmt::format("{} {} {} is outside the range of whole numbers of 64 bits", a, operation, b));
  return {result};
}

XacroValue RealArithmetic(const std::string& operation, double a, double b) {
  if (b == 0.0 && (operation == "/" || operation == "//" || operation == "%"))
    RefuseXacroNumber(fmt::format("{} {} 0 divides by zero", a, operation));
  double result = operation == "+"    ? a + b
                  : operation == "-"  ? a - b
                  : operation == "*"  ? a * b
                  : operation == "/"  ? a / b
                  : operation == "//" ? FloorQuotient(a, b)
                  : operation == "%"  ? FloorRemainder(a, b)
                                      : std::pow(a, b);
  const bool finite = std::isfinite(a) && std::isfinite(b);
  if (operation == "**" && finite && !std::isfinite(result))
    RefuseXacroNumber(fmt::format("{} ** {} is not a finite real number", a, b));
  return {result};
}

/// A repeated text or list.
XacroValue RepeatedXacroValue(const XacroValue& value, std::int64_t times, XacroBudget& budget) {
  const std::size_t count = static_cast<std::size_t>(std::max<std::int64_t>(times, 0));
  const std::size_t size = value.text() != nullptr ? value.text()->size() : value.list()->items.size();
  if (size > 0 && count > kLongestXacroText / size)
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("a {} repeated {} times is too long", XacroKind(value), times)};
  budget.Spend(1 + count * size / 8);
  if (value.text() != nullptr) {
    std::string text;
    for (std::size_t i = 0; i < count && size > 0; ++i) text += *value.text();
    return XacroText(std::move(text));
  }
  std::vector<XacroValue> items;
  for (std::size_t i = 0; i < count && size > 0; ++i)
    items.insert(items.end(), value.list()->items.begin(), value.list()->items.end());
  return XacroListOf(std::move(items), budget);
}

/// Arithmetic of texts and lists: joining, repeating and formatting.
std::optional<XacroValue> TextArithmetic(const std::string& operation, const XacroValue& left, const XacroValue& right,
                                         XacroBudget& budget) {
  const bool sequence = left.text() != nullptr || left.list() != nullptr;
  if (operation == "+" && left.text() != nullptr && right.text() != nullptr) {
    budget.Spend(1 + (left.text()->size() + right.text()->size()) / 16);
    return XacroText(*left.text() + *right.text());
  }
  if (operation == "+" && left.list() != nullptr && right.list() != nullptr) {
    std::vector<XacroValue> items = left.list()->items;
    items.insert(items.end(), right.list()->items.begin(), right.list()->items.end());
    return XacroListOf(std::move(items), budget);
  }
  if (operation == "*" && sequence && WholeOfXacro(right))
    return RepeatedXacroValue(left, *WholeOfXacro(right), budget);
  if (operation == "*" && WholeOfXacro(left) && (right.text() != nullptr || right.list() != nullptr))
    return RepeatedXacroValue(right, *WholeOfXacro(left), budget);
  if (operation == "%" && left.text() != nullptr) return XacroText(XacroFormatted(*left.text(), right, budget));
  return std::nullopt;
}

/// -1, 0 or 1 for less, equal or more; 2 if one of them is NaN.
int OrderOfXacro(const std::string& operation, const XacroValue& left, const XacroValue& right, XacroBudget& budget) {
  budget.Spend(1);
  if (left.text() != nullptr && right.text() != nullptr) {
    budget.Spend(left.text()->size() / 16);
    const int order = left.text()->compare(*right.text());
    return order < 0 ? -1 : order > 0 ? 1 : 0;
  }
  if (left.list() != nullptr && right.list() != nullptr) {
    const auto &a = left.list()->items, &b = right.list()->items;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
      if (!XacroEqual(a[i], b[i], budget)) return OrderOfXacro(operation, a[i], b[i], budget);
    }
    return a.size() < b.size() ? -1 : a.size() > b.size() ? 1 : 0;
  }
  const auto a = XacroNumber(left), b = XacroNumber(right);
  if (!a || !b) {
    RefuseXacroType(fmt::format("'{}' cannot compare a {} with a {}{}", operation, XacroKind(left), XacroKind(right),
                                a || b ? "; float() converts a text to a number" : ""));
  }
  if (WholeOfXacro(left) && WholeOfXacro(right))
    return *WholeOfXacro(left) < *WholeOfXacro(right) ? -1 : *WholeOfXacro(left) > *WholeOfXacro(right) ? 1 : 0;
  return *a < *b ? -1 : *a > *b ? 1 : *a == *b ? 0 : 2;
}

bool XacroContains(const XacroValue& container, const XacroValue& item, XacroBudget& budget) {
  if (container.text() != nullptr && item.text() != nullptr) {
    budget.Spend(1 + container.text()->size() / 4);
    return container.text()->find(*item.text()) != std::string::npos;
  }
  if (container.list() != nullptr) {
    const auto& items = container.list()->items;
    return std::any_of(items.begin(), items.end(), [&](const auto& one) { return XacroEqual(one, item, budget); });
  }
  if (container.dict() != nullptr) return container.dict()->Find(item, budget) != nullptr;
  RefuseXacroType(fmt::format("'in' cannot look for a {} in a {}", XacroKind(item), XacroKind(container)));
}

}  // namespace

void RefuseXacroType(const std::string& message) { throw XacroProblem{FailureCode::kXacroType, message}; }

XacroValue XacroArithmetic(const std::string& operation, const XacroValue& left, const XacroValue& right,
                           XacroBudget& budget) {
  budget.Spend(1);
  if (const auto joined = TextArithmetic(operation, left, right, budget)) return *joined;
  const auto a = XacroNumber(left), b = XacroNumber(right);
  if (!a || !b) {
    const XacroValue& text = a ? right : left;
    const bool mixed = (a || b) && text.text() != nullptr;
    RefuseXacroType(fmt::format("operator '{}' cannot combine a {} and a {}{}", operation, XacroKind(left),
                                XacroKind(right),
                                mixed ? fmt::format("; the text is '{}'", Shortened(*text.text())) : ""));
  }
  const auto whole = WholeOfXacro(left), other = WholeOfXacro(right);
  if (whole && other && operation == "**" && !(*whole == 0 && *other < 0)) return WholePower(*whole, *other);
  if (whole && other && operation != "/" && operation != "**") return WholeArithmetic(operation, *whole, *other);
  return RealArithmetic(operation, *a, *b);
}

bool XacroCompared(const std::string& operation, const XacroValue& left, const XacroValue& right, XacroBudget& budget) {
  if (operation == "==") return XacroEqual(left, right, budget);
  if (operation == "!=") return !XacroEqual(left, right, budget);
  if (operation == "is" || operation == "is not") {
    const bool same = left.held.index() == right.held.index() && XacroEqual(left, right, budget);
    return same == (operation == "is");
  }
  if (operation == "in") return XacroContains(right, left, budget);
  if (operation == "not in") return !XacroContains(right, left, budget);
  const int order = OrderOfXacro(operation, left, right, budget);
  if (order == 2) return false;
  if (operation == "<") return order < 0;
  if (operation == "<=") return order <= 0;
  return operation == ">" ? order > 0 : order >= 0;
}

}  // namespace gaitwright
