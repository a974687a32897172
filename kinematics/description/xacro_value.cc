// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "kinematics/base/non_finite.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_value_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostXacroUnits = 5000000, kMostXacroElements = 1000000;
constexpr std::size_t kLargestExpansion = std::size_t{64} << 20;  // [byte]
constexpr int kDeepestXacroLevel = 400;

int DepthOfXacro(const XacroValue& value) {
  if (value.list() != nullptr) return value.list()->depth;
  return value.dict() != nullptr ? value.dict()->depth : 0;
}

void CheckXacroSize(std::size_t items, int depth) {
  if (items > kMostXacroItems)
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("a list has {} items; at most {} are accepted", items, kMostXacroItems)};
  if (depth > kDeepestXacroValue) {
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("more than {} nested lists and dictionaries", kDeepestXacroValue)};
  }
}

/// A number as in Python: the fewest digits that read back exactly, with an exponent below 1e-4 and from 1e16.
std::string PrintedXacroReal(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0.0 ? "inf" : "-inf";
  const double size = std::abs(number);
  const bool plain = size == 0.0 || (size >= 1e-4 && size < 1e16);
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof(digits), number,
                                 plain ? std::chars_format::fixed : std::chars_format::scientific);
  std::string text(digits, end.ptr);
  if (plain && text.find('.') == std::string::npos) text += ".0";
  return text;
}

/// A text as printed by Python's repr().
std::string QuotedXacroText(const std::string& text) {
  const char quote = text.find('\'') != std::string::npos && text.find('"') == std::string::npos ? '"' : '\'';
  std::string quoted(1, quote);
  for (const char c : text) {
    constexpr std::string_view kControls = "\n\t\r", kLetters = "ntr";
    if (const std::size_t control = kControls.find(c); control != std::string_view::npos) {
      quoted += '\\';
      quoted += kLetters[control];
      continue;
    }
    if (c == quote || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + quote;
}

void AppendXacro(const XacroValue& value, bool quotes, std::string& out, XacroBudget& budget) {
  budget.Spend(1);
  if (out.size() > kLongestXacroText)
    throw XacroProblem{FailureCode::kXacroLimit, "the printed text of a list has more than 1 MiB"};
  if (const auto* truth = std::get_if<bool>(&value.held)) {
    out += *truth ? "True" : "False";
  } else if (const auto* whole = value.whole()) {
    out += std::to_string(*whole);
  } else if (const auto* real = std::get_if<double>(&value.held)) {
    out += PrintedXacroReal(*real);
  } else if (const auto* text = value.text()) {
    budget.Spend(text->size() / 16);
    out += quotes ? QuotedXacroText(*text) : *text;
  } else if (const XacroList* list = value.list()) {
    for (std::size_t i = 0; i < list->items.size(); ++i) {
      out += i == 0 ? "[" : ", ";
      AppendXacro(list->items[i], true, out, budget);
    }
    out += list->items.empty() ? "[]" : "]";
  } else if (const XacroDict* dict = value.dict()) {
    for (std::size_t i = 0; i < dict->entries.size(); ++i) {
      out += i == 0 ? "{" : ", ";
      AppendXacro(dict->entries[i].first, true, out, budget);
      out += ": ";
      AppendXacro(dict->entries[i].second, true, out, budget);
    }
    out += dict->entries.empty() ? "{}" : "}";
  } else {
    out += "None";
  }
}

/// Whether two scalars (numbers, booleans, texts) are equal. Neither may be a list or a dictionary.
bool EqualXacroScalars(const XacroValue& a, const XacroValue& b) {
  if (a.whole() != nullptr && b.whole() != nullptr) return *a.whole() == *b.whole();
  const auto number = XacroNumber(a), other = XacroNumber(b);
  if (number || other) return number && other && *number == *other;
  return a.held == b.held;
}

/// The text without blanks around it and without a plus sign before a digit or point; empty if it is not a number.
std::string XacroNumberText(const std::string& text) {
  std::string trimmed = Trimmed(text.substr(0, 400));
  if (text.size() > 400 || trimmed.find("+-") == 0 || trimmed.find("++") == 0) return "";
  if (!trimmed.empty() && trimmed[0] == '+') trimmed.erase(0, 1);
  return trimmed;
}

/// Whether a number outside the range of double is too small (not too large): its first digit other than 0 is after the
/// decimal point.
bool IsXacroUnderflow(const std::string& number) {
  const std::size_t exponent_at = std::min(number.find_first_of("eE"), number.size());
  const std::size_t first = number.find_first_of("123456789");
  if (first >= exponent_at) return true;
  const std::size_t point = std::min(number.find('.'), exponent_at);
  const long behind = static_cast<long>(first) - static_cast<long>(point);
  const long exponent = exponent_at < number.size() ? std::strtol(number.c_str() + exponent_at + 1, nullptr, 10) : 0;
  return exponent < behind;
}

}  // namespace

void XacroBudget::Spend(std::size_t units) {
  units_ += units;
  if (units_ > kMostXacroUnits) {
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("its expansion needs more than {} steps", kMostXacroUnits)};
  }
}

void XacroBudget::Visit() {
  if (++elements_ > kMostXacroElements)
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("it expands to more than {} elements", kMostXacroElements)};
}

void XacroBudget::Write(std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ > kLargestExpansion)
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("it expands to more than {} MiB", kLargestExpansion >> 20)};
}

XacroBudget::Level::Level(XacroBudget& budget) : budget_(budget) {
  if (budget.level_ >= kDeepestXacroLevel) {
    throw XacroProblem{
        FailureCode::kXacroLimit,
        fmt::format("more than {} nested elements, macros and expressions; check whether one uses itself",
                    kDeepestXacroLevel)};
  }
  ++budget.level_;
}

const XacroList* XacroValue::list() const {
  const auto* pointer = std::get_if<std::shared_ptr<XacroList>>(&held);
  return pointer == nullptr ? nullptr : pointer->get();
}

const XacroDict* XacroValue::dict() const {
  const auto* pointer = std::get_if<std::shared_ptr<const XacroDict>>(&held);
  return pointer == nullptr ? nullptr : pointer->get();
}

const XacroValue* XacroDict::Find(const XacroValue& key, XacroBudget& budget) const {
  budget.Spend(1 + entries.size() / 8);
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return EqualXacroScalars(entry.first, key); });
  return found == entries.end() ? nullptr : &found->second;
}

XacroValue XacroText(std::string text) {
  if (text.size() > kLongestXacroText) {
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("a text has {} bytes; at most {} are accepted", text.size(), kLongestXacroText)};
  }
  return {std::move(text)};
}

XacroValue XacroListOf(std::vector<XacroValue> items, XacroBudget& budget) {
  budget.Spend(1 + items.size() / 8);
  int depth = 0;
  for (const XacroValue& item : items) depth = std::max(depth, DepthOfXacro(item));
  CheckXacroSize(items.size(), depth + 1);
  return {std::make_shared<XacroList>(XacroList{std::move(items), depth + 1})};
}

XacroValue XacroDictOf(std::vector<std::pair<XacroValue, XacroValue>>&& entries, XacroBudget& budget) {
  int depth = 0;
  XacroDict dict;
  for (auto& [key, value] : entries) {
    if (DepthOfXacro(key) > 0)
      throw XacroProblem{FailureCode::kXacroType,
                         fmt::format("a {} cannot be the key of a dictionary", XacroKind(key))};
    budget.Spend(1 + dict.entries.size() / 8);
    depth = std::max(depth, DepthOfXacro(value));
    const auto known = std::find_if(dict.entries.begin(), dict.entries.end(), [&, &name = key](const auto& entry) {
      return EqualXacroScalars(entry.first, name);
    });
    if (known != dict.entries.end()) {
      known->second = std::move(value);
    } else {
      dict.entries.emplace_back(std::move(key), std::move(value));
    }
  }
  dict.depth = depth + 1;
  CheckXacroSize(dict.entries.size(), dict.depth);
  return {std::make_shared<const XacroDict>(std::move(dict))};
}

std::string XacroKind(const XacroValue& value) {
  constexpr const char* kKindNames[] = {"None", "truth value", "number", "number", "text", "list", "dictionary"};
  return kKindNames[value.held.index()];
}

bool XacroTruth(const XacroValue& value) {
  if (const auto number = XacroNumber(value)) return *number != 0.0;
  if (value.text() != nullptr) return !value.text()->empty();
  if (value.list() != nullptr) return !value.list()->items.empty();
  return value.dict() != nullptr && !value.dict()->entries.empty();
}

std::optional<double> XacroNumber(const XacroValue& value) {
  if (const auto* truth = std::get_if<bool>(&value.held)) return *truth ? 1.0 : 0.0;
  if (value.whole() != nullptr) return static_cast<double>(*value.whole());
  if (const auto* real = std::get_if<double>(&value.held)) return *real;
  return std::nullopt;
}

bool XacroEqual(const XacroValue& a, const XacroValue& b, XacroBudget& budget) {
  budget.Spend(1);
  if (a.list() != nullptr && b.list() != nullptr) {
    const auto &left = a.list()->items, &right = b.list()->items;
    return left.size() == right.size() &&
           std::equal(left.begin(), left.end(), right.begin(),
                      [&](const XacroValue& l, const XacroValue& r) { return XacroEqual(l, r, budget); });
  }
  if (a.dict() != nullptr && b.dict() != nullptr) {
    if (a.dict()->entries.size() != b.dict()->entries.size()) return false;
    for (const auto& [key, value] : a.dict()->entries) {
      const XacroValue* other = b.dict()->Find(key, budget);
      if (other == nullptr || !XacroEqual(value, *other, budget)) return false;
    }
    return true;
  }
  if (a.held.index() != b.held.index() && (DepthOfXacro(a) > 0 || DepthOfXacro(b) > 0)) return false;
  if (a.text() != nullptr) budget.Spend(a.text()->size() / 16);
  return EqualXacroScalars(a, b);
}

std::string XacroPrinted(const XacroValue& value, XacroBudget& budget) {
  std::string text;
  AppendXacro(value, false, text, budget);
  return text;
}

std::optional<std::int64_t> XacroWholeOf(const std::string& text) {
  const std::string number = XacroNumberText(text);
  std::int64_t whole = 0;
  const auto end = std::from_chars(number.data(), number.data() + number.size(), whole);
  if (number.empty() || end.ec != std::errc{} || end.ptr != number.data() + number.size()) return std::nullopt;
  return whole;
}

std::optional<double> XacroRealOf(const std::string& text) {
  const std::string number = XacroNumberText(text);
  double real = 0.0;
  const auto end = std::from_chars(number.data(), number.data() + number.size(), real);
  if (number.empty() || end.ptr != number.data() + number.size()) return std::nullopt;
  if (end.ec == std::errc::result_out_of_range) {
    return std::copysign(IsXacroUnderflow(number) ? 0.0 : kInfinity, number[0] == '-' ? -1.0 : 1.0);
  }
  if (end.ec != std::errc{} || number.find('(') != std::string::npos) return std::nullopt;
  return real;
}

XacroValue XacroLiteral(const std::string& text) {
  if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') return {text.substr(1, text.size() - 2)};
  if (const auto whole = XacroWholeOf(text)) return {*whole};
  if (const auto real = XacroRealOf(text)) return {*real};
  if (text == "true" || text == "True") return {true};
  if (text == "false" || text == "False") return {false};
  return {text};
}

}  // namespace gaitwright
