// SPDX-License-Identifier: BSD-3-Clause
// `'{}_{}'.format(a, b)`, of which robot descriptions make names and rounded numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_evaluate_internal.h"

namespace gaitwright {
namespace {

/// What follows the colon of a field: [[fill]align][sign][0][width][.precision][type].
struct XacroFieldSpec {
  char fill = ' ', align = '\0', sign = '-', type = '\0';
  int width = 0, precision = -1;
};

bool IsOneOf(std::string_view characters, char c) { return characters.find(c) != std::string_view::npos; }

/// Reads the parts of a field's specification in their order.
class XacroSpecReader {
 public:
  explicit XacroSpecReader(const std::string& text) : text_(text) {}

  XacroFieldSpec Read() {
    XacroFieldSpec spec;
    constexpr std::string_view kAligns = "<>^=";
    if (text_.size() > 1 && IsOneOf(kAligns, text_[1])) spec.fill = text_[at_++];
    if (IsOneOf(kAligns, Peek())) spec.align = text_[at_++];
    if (IsOneOf("+- ", Peek())) spec.sign = text_[at_++];
    if (Peek() == '0') {
      ++at_;
      if (spec.align == '\0') {
        spec.fill = '0';
        spec.align = '=';
      }
    }
    spec.width = std::max(Digits(), 0);
    if (Peek() == '.') {
      ++at_;
      spec.precision = Digits();
      if (spec.precision < 0) Refuse();
    }
    if (IsOneOf("sdfFeEgGxX", Peek())) spec.type = text_[at_++];
    if (at_ != text_.size()) Refuse();
    return spec;
  }

 private:
  char Peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  /// A number of at most two digits; -1 where there is none.
  int Digits() {
    int number = -1;
    for (int count = 1; Peek() >= '0' && Peek() <= '9'; ++at_, ++count) {
      if (count > 2) throw XacroProblem{FailureCode::kXacroLimit, "a format has a width of more than two digits"};
      number = 10 * std::max(number, 0) + (Peek() - '0');
    }
    return number;
  }

  [[noreturn]] void Refuse() const {
    RefuseXacroType(
        fmt::format("format(): ':{}' is not supported; supported: [[fill]align][sign][0][width]"
                    "[.precision][type] with one of the types s d f F e E g G x X",
                    Shortened(text_)));
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

/// The size of a number without its sign, as the type prints it.
std::string XacroDigitsOf(const XacroFieldSpec& spec, const XacroValue& value, double number, XacroBudget& budget) {
  const bool whole = IsOneOf("dxX", spec.type) || (spec.type == '\0' && !value.is_real());
  if (whole && value.is_real())
    RefuseXacroType(fmt::format("format(): ':{}' needs a whole number, not {}; use int() or the type f", spec.type,
                                XacroPrinted(value, budget)));
  if (whole && spec.precision >= 0) RefuseXacroType("format(): a whole number has no precision; use the type f");
  char text[512];  // a number of 309 digits with 99 behind its point
  std::string pattern = "%";
  if (whole) {
    const std::int64_t given = value.whole() != nullptr ? *value.whole() : static_cast<std::int64_t>(number);
    const auto size =
        given < 0 ? 0ULL - static_cast<unsigned long long>(given) : static_cast<unsigned long long>(given);
    pattern += std::string("ll") + (spec.type == 'x' || spec.type == 'X' ? spec.type : 'u');
    return {text, static_cast<std::size_t>(std::snprintf(text, sizeof(text), pattern.c_str(), size))};
  }
  if (spec.type == '\0') {
    if (spec.precision >= 0) RefuseXacroType("format(): a precision needs a type, such as in ':.3f' or ':.3g'");
    const std::string printed = XacroPrinted(value, budget);
    return printed.starts_with('-') ? printed.substr(1) : printed;
  }
  if (spec.precision >= 0) pattern += "." + std::to_string(spec.precision);
  pattern += spec.type;
  const int length = std::snprintf(text, sizeof(text), pattern.c_str(), std::abs(number));
  return {text, static_cast<std::size_t>(length)};
}

std::string XacroFieldText(const XacroFieldSpec& spec, const XacroValue& value, XacroBudget& budget) {
  std::string sign, text;
  char align = spec.align;
  if (value.text() != nullptr) {
    if (!IsOneOf(std::string_view("s\0", 2), spec.type) || align == '=' || spec.sign != '-')
      RefuseXacroType(fmt::format("format(): a field for a number is given the text '{}'", Shortened(*value.text())));
    text = *value.text();
    if (spec.precision >= 0) text = text.substr(0, static_cast<std::size_t>(spec.precision));
    if (align == '\0') align = '<';
  } else {
    const auto number = XacroNumber(value);
    if (!number || spec.type == 's')
      RefuseXacroType(fmt::format("format(): the field's format does not fit a {}", XacroKind(value)));
    text = XacroDigitsOf(spec, value, *number, budget);
    sign = std::signbit(*number) ? "-" : spec.sign == '-' ? "" : std::string(1, spec.sign);
    if (align == '\0') align = '>';
  }
  const std::size_t size = sign.size() + text.size(), width = static_cast<std::size_t>(spec.width);
  const std::size_t pad = width > size ? width - size : 0;
  const std::size_t before = align == '<' ? 0 : align == '^' ? pad / 2 : pad;
  const std::string front(before, spec.fill), back(pad - before, spec.fill);
  return align == '=' ? sign + front + text : front + sign + text + back;
}

/// Fills the fields of a format from left to right.
class XacroFieldFiller {
 public:
  XacroFieldFiller(const XacroArguments& arguments, XacroBudget& budget) : arguments_(arguments), budget_(budget) {}

  std::string Filled(const std::string& format) {
    std::string text;
    for (std::size_t at = 0; at < format.size();) {
      const char c = format[at];
      if (c != '{' && c != '}') {
        text += format[at++];
      } else if (at + 1 < format.size() && format[at + 1] == c) {
        text += c;
        at += 2;
      } else {
        const std::size_t end = format.find_first_of("{}", at + 1);
        if (c == '}' || end == std::string::npos || format[end] == '{')
          RefuseXacroType(fmt::format("format(): '{}' has a single or nested '{}'; a literal brace is written twice",
                                      Shortened(format), c == '}' ? c : '{'));
        budget_.Spend(8);
        text += Field(format.substr(at + 1, end - at - 1));
        at = end + 1;
      }
      if (text.size() > kLongestXacroText)
        throw XacroProblem{FailureCode::kXacroLimit, "a formatted text of more than 1 MiB"};
    }
    return text;
  }

 private:
  std::string Field(const std::string& field) {
    const std::size_t colon = field.find(':');
    const XacroValue& value = ValueOf(field.substr(0, colon));
    const std::string spec = colon == std::string::npos ? "" : field.substr(colon + 1);
    if (spec.empty()) return XacroPrinted(value, budget_);
    return XacroFieldText(XacroSpecReader(spec).Read(), value, budget_);
  }

  /// The argument that a field names: by its place, by its name, or the next one.
  const XacroValue& ValueOf(const std::string& name) {
    if (name.find_first_of("!.[") != std::string::npos)
      RefuseXacroType(
          fmt::format("format(): the field '{{{}}}' is not supported; use {{}}, {{0}} or {{name}}", Shortened(name)));
    const bool is_place = name.find_first_not_of("0123456789") == std::string::npos;
    if (is_place) {
      (name.empty() ? counts_ : numbers_) = true;
      if (counts_ && numbers_) RefuseXacroType("format(): fields with numbers and without are mixed");
      const std::size_t place = name.empty()      ? next_++
                                : name.size() > 6 ? arguments_.unnamed.size()
                                                  : static_cast<std::size_t>(std::stoul(name));
      if (place < arguments_.unnamed.size()) return arguments_.unnamed[place];
      RefuseXacroType(fmt::format("format(): the format has a field for argument {}; there are {} arguments",
                                  name.empty() ? std::to_string(place) : Shortened(name), arguments_.unnamed.size()));
    }
    const auto named = std::find_if(arguments_.named.begin(), arguments_.named.end(),
                                    [&](const auto& argument) { return argument.first == name; });
    if (named != arguments_.named.end()) return named->second;
    std::vector<std::string> names;
    for (const auto& [known, value] : arguments_.named) names.push_back(known);
    RefuseXacroType(
        fmt::format("format(): the format has a field '{}', which is no argument{}; write {}=VALUE in format()",
                    Shortened(name), names.empty() ? "" : NearestOrAll(name, names), Shortened(name)));
  }

  const XacroArguments& arguments_;
  XacroBudget& budget_;
  std::size_t next_ = 0;
  bool counts_ = false, numbers_ = false;
};

}  // namespace

XacroValue FormatXacroText(const std::string& format, const XacroArguments& arguments, XacroBudget& budget) {
  budget.Spend(1 + format.size() / 16);
  return XacroText(XacroFieldFiller(arguments, budget).Filled(format));
}

}  // namespace gaitwright
