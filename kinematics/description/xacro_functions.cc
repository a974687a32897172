// SPDX-License-Identifier: BSD-3-Clause
// The functions of Python and of its module math that expressions may call.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "kinematics/base/text.h"
#include "kinematics/description/xacro_evaluate_internal.h"

namespace gaitwright {
namespace {

using XacroArguments = std::vector<XacroValue>;

/// A function with its smallest and largest number of arguments.
struct XacroFunction {
  std::size_t least, most;
  XacroValue (*call)(const XacroArguments&, XacroBudget&);
};

constexpr double kXacroDegree = std::numbers::pi / 180.0;

double RealOfXacro(const XacroValue& value) {
  if (const auto number = XacroNumber(value)) return *number;
  RefuseXacroType(fmt::format("a number is needed, not a {}", XacroKind(value)));
}

/// A function of one number. Refuses an argument for which it is not defined.
template <double (*kFunction)(double)>
XacroValue CallOfOne(const XacroArguments& arguments, XacroBudget&) {
  const double x = RealOfXacro(arguments[0]), y = kFunction(x);
  if (std::isfinite(x) && !std::isfinite(y))
    throw XacroProblem{FailureCode::kXacroNumber, fmt::format("the function has no finite value at {}", x)};
  return {y};
}

/// A function of two numbers.
template <double (*kFunction)(double, double)>
XacroValue CallOfTwo(const XacroArguments& arguments, XacroBudget&) {
  const double x = RealOfXacro(arguments[0]), y = RealOfXacro(arguments[1]), z = kFunction(x, y);
  if (std::isfinite(x) && std::isfinite(y) && !std::isfinite(z))
    throw XacroProblem{FailureCode::kXacroNumber, fmt::format("the function has no finite value at {}, {}", x, y)};
  return {z};
}

double XacroRadians(double degrees) { return degrees * kXacroDegree; }
double XacroDegrees(double radians) { return radians / kXacroDegree; }

XacroValue XacroWholeFrom(double number) {
  if (!(number >= -9.2e18 && number <= 9.2e18))
    throw XacroProblem{FailureCode::kXacroNumber, fmt::format("{} is not a whole number of 64 bits", number)};
  return {static_cast<std::int64_t>(number)};
}

template <double (*kRounding)(double)>
XacroValue CallRounding(const XacroArguments& arguments, XacroBudget&) {
  if (arguments[0].whole() != nullptr) return arguments[0];
  return XacroWholeFrom(kRounding(RealOfXacro(arguments[0])));
}

/// Python's round(): a half rounds to the even neighbour. With a number of digits, the result is a real number.
XacroValue CallRound(const XacroArguments& arguments, XacroBudget&) {
  const double number = RealOfXacro(arguments[0]);
  if (arguments.size() == 1 || arguments[1].is_none())
    return arguments[0].whole() != nullptr ? arguments[0] : XacroWholeFrom(std::nearbyint(number));
  if (arguments[1].whole() == nullptr) RefuseXacroType("the digits of round() must be a whole number");
  if (arguments[0].whole() != nullptr && *arguments[1].whole() >= 0) return arguments[0];
  const std::int64_t digits = std::clamp<std::int64_t>(*arguments[1].whole(), -20, 20);
  if (!std::isfinite(number)) return {number};
  double rounded = 0.0;
  if (digits >= 0) {
    rounded = *XacroRealOf(fmt::format("{:.{}f}", number, digits));  // exact, as Python rounds
  } else {
    const double unit = std::pow(10.0, static_cast<double>(-digits));
    rounded = std::nearbyint(number / unit) * unit;
  }
  return arguments[0].whole() != nullptr ? XacroWholeFrom(rounded) : XacroValue{rounded};
}

XacroValue CallLog(const XacroArguments& arguments, XacroBudget&) {
  const double x = RealOfXacro(arguments[0]),
               base = arguments.size() == 2 ? RealOfXacro(arguments[1]) : std::numbers::e;
  if (!(x > 0.0) || !(base > 0.0) || base == 1.0)
    throw XacroProblem{FailureCode::kXacroNumber, fmt::format("log of {} to the base {} is not defined", x, base)};
  return {arguments.size() == 2 ? std::log(x) / std::log(base) : std::log(x)};
}

XacroValue CallAbs(const XacroArguments& arguments, XacroBudget& budget) {
  if (arguments[0].is_truth()) return {std::int64_t{XacroTruth(arguments[0])}};
  if (arguments[0].whole() == nullptr) return {std::abs(RealOfXacro(arguments[0]))};
  return *arguments[0].whole() < 0 ? XacroArithmetic("-", {std::int64_t{0}}, arguments[0], budget) : arguments[0];
}

/// The smallest or largest of the arguments, or of the items of a single argument.
XacroValue XacroExtreme(const XacroArguments& arguments, const char* better, XacroBudget& budget) {
  const XacroArguments items = arguments.size() == 1 ? XacroItems(arguments[0], budget) : arguments;
  if (items.empty()) RefuseXacroType("min() and max() need at least one item");
  XacroValue best = items[0];
  for (const XacroValue& item : items) {
    if (XacroCompared(better, item, best, budget)) best = item;
  }
  return best;
}
XacroValue CallMin(const XacroArguments& arguments, XacroBudget& budget) {
  return XacroExtreme(arguments, "<", budget);
}
XacroValue CallMax(const XacroArguments& arguments, XacroBudget& budget) {
  return XacroExtreme(arguments, ">", budget);
}

XacroValue CallInt(const XacroArguments& arguments, XacroBudget&) {
  if (arguments.empty()) return {std::int64_t{0}};
  if (arguments[0].whole() != nullptr) return arguments[0];
  if (const std::string* text = arguments[0].text()) {
    if (const auto whole = XacroWholeOf(*text)) return {*whole};
    RefuseXacroType(fmt::format("int('{}') is not a whole number", Shortened(*text)));
  }
  return XacroWholeFrom(std::trunc(RealOfXacro(arguments[0])));
}

XacroValue CallFloat(const XacroArguments& arguments, XacroBudget&) {
  if (arguments.empty()) return {0.0};
  if (const std::string* text = arguments[0].text()) {
    if (const auto real = XacroRealOf(*text)) return {*real};
    RefuseXacroType(fmt::format("float('{}') is not a number", Shortened(*text)));
  }
  return {RealOfXacro(arguments[0])};
}

XacroValue CallStr(const XacroArguments& arguments, XacroBudget& budget) {
  return arguments.empty() ? XacroValue{std::string()} : XacroText(XacroPrinted(arguments[0], budget));
}

XacroValue CallBool(const XacroArguments& arguments, XacroBudget&) {
  return {!arguments.empty() && XacroTruth(arguments[0])};
}

XacroValue CallList(const XacroArguments& arguments, XacroBudget& budget) {
  return XacroListOf(arguments.empty() ? XacroArguments{} : XacroItems(arguments[0], budget), budget);
}

XacroValue CallLen(const XacroArguments& arguments, XacroBudget& budget) {
  if (const std::string* text = arguments[0].text()) return {static_cast<std::int64_t>(text->size())};
  return {static_cast<std::int64_t>(XacroItems(arguments[0], budget).size())};
}

XacroValue CallSum(const XacroArguments& arguments, XacroBudget& budget) {
  XacroValue sum = arguments.size() == 2 ? arguments[1] : XacroValue{std::int64_t{0}};
  for (const XacroValue& item : XacroItems(arguments[0], budget)) sum = XacroArithmetic("+", sum, item, budget);
  return sum;
}

XacroValue CallAny(const XacroArguments& arguments, XacroBudget& budget) {
  const XacroArguments items = XacroItems(arguments[0], budget);
  return {std::any_of(items.begin(), items.end(), XacroTruth)};
}

XacroValue CallAll(const XacroArguments& arguments, XacroBudget& budget) {
  const XacroArguments items = XacroItems(arguments[0], budget);
  return {std::all_of(items.begin(), items.end(), XacroTruth)};
}

/// Sorts by insertion with a binary search. Unlike std::sort, it can safely refuse values that cannot be compared.
XacroValue CallSorted(const XacroArguments& arguments, XacroBudget& budget) {
  XacroArguments sorted;
  for (const XacroValue& item : XacroItems(arguments[0], budget)) {
    std::size_t from = 0, to = sorted.size();
    while (from < to) {
      const std::size_t middle = (from + to) / 2;
      if (XacroCompared("<", item, sorted[middle], budget)) {
        to = middle;
      } else {
        from = middle + 1;
      }
    }
    budget.Spend(1 + (sorted.size() - from) / 2);
    sorted.insert(sorted.begin() + static_cast<std::ptrdiff_t>(from), item);
  }
  return XacroListOf(std::move(sorted), budget);
}

XacroValue CallRange(const XacroArguments& arguments, XacroBudget& budget) {
  for (const XacroValue& argument : arguments) {
    if (argument.whole() == nullptr) RefuseXacroType("range() needs whole numbers");
  }
  const std::int64_t first = arguments.size() > 1 ? *arguments[0].whole() : 0;
  const std::int64_t end = *arguments[arguments.size() > 1 ? 1 : 0].whole();
  const std::int64_t step = arguments.size() > 2 ? *arguments[2].whole() : 1;
  if (step == 0) RefuseXacroType("the step of range() must not be 0");
  XacroArguments items;
  for (std::int64_t i = first; step > 0 ? i < end : i > end;) {
    if (items.size() > kMostXacroItems) throw XacroProblem{FailureCode::kXacroLimit, "range() has too many numbers"};
    items.push_back({i});
    if (__builtin_add_overflow(i, step, &i)) break;
  }
  return XacroListOf(std::move(items), budget);
}

/// [[0, a], [1, b] ...]
XacroValue CallEnumerate(const XacroArguments& arguments, XacroBudget& budget) {
  XacroArguments pairs;
  for (const XacroValue& item : XacroItems(arguments[0], budget))
    pairs.push_back(XacroListOf({XacroValue{static_cast<std::int64_t>(pairs.size())}, item}, budget));
  return XacroListOf(std::move(pairs), budget);
}

const std::map<std::string, XacroFunction>& XacroFunctions() {
  static const std::map<std::string, XacroFunction> functions = {{"sin", {1, 1, CallOfOne<std::sin>}},
                                                                 {"cos", {1, 1, CallOfOne<std::cos>}},
                                                                 {"tan", {1, 1, CallOfOne<std::tan>}},
                                                                 {"asin", {1, 1, CallOfOne<std::asin>}},
                                                                 {"acos", {1, 1, CallOfOne<std::acos>}},
                                                                 {"atan", {1, 1, CallOfOne<std::atan>}},
                                                                 {"sinh", {1, 1, CallOfOne<std::sinh>}},
                                                                 {"cosh", {1, 1, CallOfOne<std::cosh>}},
                                                                 {"tanh", {1, 1, CallOfOne<std::tanh>}},
                                                                 {"atan2", {2, 2, CallOfTwo<std::atan2>}},
                                                                 {"hypot", {2, 2, CallOfTwo<std::hypot>}},
                                                                 {"fmod", {2, 2, CallOfTwo<std::fmod>}},
                                                                 {"pow", {2, 2, CallOfTwo<std::pow>}},
                                                                 {"copysign", {2, 2, CallOfTwo<std::copysign>}},
                                                                 {"sqrt", {1, 1, CallOfOne<std::sqrt>}},
                                                                 {"exp", {1, 1, CallOfOne<std::exp>}},
                                                                 {"log10", {1, 1, CallOfOne<std::log10>}},
                                                                 {"log2", {1, 1, CallOfOne<std::log2>}},
                                                                 {"fabs", {1, 1, CallOfOne<std::fabs>}},
                                                                 {"radians", {1, 1, CallOfOne<XacroRadians>}},
                                                                 {"degrees", {1, 1, CallOfOne<XacroDegrees>}},
                                                                 {"log", {1, 2, CallLog}},
                                                                 {"floor", {1, 1, CallRounding<std::floor>}},
                                                                 {"ceil", {1, 1, CallRounding<std::ceil>}},
                                                                 {"trunc", {1, 1, CallRounding<std::trunc>}},
                                                                 {"round", {1, 2, CallRound}},
                                                                 {"abs", {1, 1, CallAbs}},
                                                                 {"min", {1, 100, CallMin}},
                                                                 {"max", {1, 100, CallMax}},
                                                                 {"int", {0, 1, CallInt}},
                                                                 {"float", {0, 1, CallFloat}},
                                                                 {"str", {0, 1, CallStr}},
                                                                 {"bool", {0, 1, CallBool}},
                                                                 {"list", {0, 1, CallList}},
                                                                 {"tuple", {0, 1, CallList}},
                                                                 {"len", {1, 1, CallLen}},
                                                                 {"sum", {1, 2, CallSum}},
                                                                 {"any", {1, 1, CallAny}},
                                                                 {"all", {1, 1, CallAll}},
                                                                 {"sorted", {1, 1, CallSorted}},
                                                                 {"range", {1, 3, CallRange}},
                                                                 {"enumerate", {1, 1, CallEnumerate}}};
  return functions;
}

}  // namespace

std::vector<XacroValue> XacroItems(const XacroValue& value, XacroBudget& budget) {
  std::vector<XacroValue> items;
  if (value.list() != nullptr) {
    items = value.list()->items;
  } else if (value.dict() != nullptr) {
    for (const auto& [key, entry] : value.dict()->entries) items.push_back(key);
  } else if (value.text() != nullptr && value.text()->size() <= kMostXacroItems) {
    for (const char c : *value.text()) items.push_back({std::string(1, c)});
  } else {
    RefuseXacroType(fmt::format("a list is needed, not a {}", XacroKind(value)));
  }
  budget.Spend(1 + items.size() / 2);
  return items;
}

std::vector<std::string> XacroFunctionNames() {
  std::vector<std::string> names;
  for (const auto& [name, function] : XacroFunctions()) names.push_back(name);
  return names;
}

std::optional<XacroValue> CallXacroFunction(const std::string& name, const std::vector<XacroValue>& arguments,
                                            XacroBudget& budget) {
  const auto known = XacroFunctions().find(name);
  if (known == XacroFunctions().end()) return std::nullopt;
  const auto& [least, most, call] = known->second;
  if (arguments.size() < least || arguments.size() > most) {
    throw XacroProblem{
        FailureCode::kXacroType,
        fmt::format("{}() takes {} arguments, not {}", name,
                    least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most), arguments.size())};
  }
  try {
    return call(arguments, budget);
  } catch (XacroProblem& problem) {
    if (problem.code != FailureCode::kXacroLimit) problem.message = fmt::format("{}(): {}", name, problem.message);
    throw;
  }
}

}  // namespace gaitwright
