// SPDX-License-Identifier: BSD-3-Clause
// `'%.3f' % number`, which robot descriptions use for names and rounded numbers.
#include <fmt/format.h>

#include <cstdio>
#include <string_view>

#include "kinematics/description/xacro_evaluate_internal.h"

namespace gaitwright {
namespace {

/// One conversion, such as %-5.2f.
struct XacroConversion {
  std::string flags;
  int width = 0, precision = -1;
  char letter = 's';
};

/// Reads the digits of a width or precision, at most two.
int XacroFormatDigits(const std::string& format, std::size_t& at) {
  int number = 0;
  for (int count = 0; at < format.size() && format[at] >= '0' && format[at] <= '9'; ++at) {
    if (++count > 2) throw XacroProblem{FailureCode::kXacroLimit, "a format has a width of more than two digits"};
    number = number * 10 + (format[at] - '0');
  }
  return number;
}

XacroConversion XacroConversionAt(const std::string& format, std::size_t& at) {
  XacroConversion conversion;
  for (; at < format.size() && std::string_view("-+ 0#").find(format[at]) != std::string_view::npos; ++at) {
    if (conversion.flags.find(format[at]) == std::string::npos) conversion.flags += format[at];
  }
  conversion.width = XacroFormatDigits(format, at);
  if (at < format.size() && format[at] == '.') conversion.precision = XacroFormatDigits(format, ++at);
  if (at >= format.size() || std::string_view("sdifFeEgGxX").find(format[at]) == std::string_view::npos) {
    RefuseXacroType(
        fmt::format("the format '{}' has a conversion that is not one of %s %d %i %f %e %g %x and %%", format));
  }
  conversion.letter = format[at++];
  return conversion;
}

std::string XacroConverted(const XacroConversion& conversion, const XacroValue& value, XacroBudget& budget) {
  if (conversion.letter == 's') {
    std::string text = XacroPrinted(value, budget);
    if (conversion.precision >= 0) text = text.substr(0, static_cast<std::size_t>(conversion.precision));
    const std::size_t width = static_cast<std::size_t>(conversion.width);
    const std::string blanks(width > text.size() ? width - text.size() : 0, ' ');
    return conversion.flags.find('-') != std::string::npos ? text + blanks : blanks + text;
  }
  const auto number = XacroNumber(value);
  if (!number) RefuseXacroType(fmt::format("%{} needs a number, not a {}", conversion.letter, XacroKind(value)));
  const bool whole = std::string_view("dixX").find(conversion.letter) != std::string_view::npos;
  if (whole && !(*number > -9e18 && *number < 9e18))
    RefuseXacroType(fmt::format("%{} needs a whole number of 64 bits", conversion.letter));
  if ((conversion.letter == 'x' || conversion.letter == 'X') && *number < 0.0)
    RefuseXacroType(fmt::format("%{} needs a number that is not negative", conversion.letter));
  std::string pattern = "%" + conversion.flags + (conversion.width > 0 ? std::to_string(conversion.width) : "");
  if (conversion.precision >= 0) pattern += "." + std::to_string(conversion.precision);
  pattern += whole ? std::string("ll") + conversion.letter : std::string(1, conversion.letter);
  char text[512];  // room for 309 digits before and 99 after the decimal point
  if (!whole) return {text, static_cast<std::size_t>(std::snprintf(text, sizeof(text), pattern.c_str(), *number))};
  const long long rounded = value.whole() != nullptr ? *value.whole() : static_cast<long long>(*number);
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof(text), pattern.c_str(), rounded))};
}

}  // namespace

std::string XacroFormatted(const std::string& format, const XacroValue& value, XacroBudget& budget) {
  const std::vector<XacroValue> values = value.list() != nullptr ? value.list()->items : std::vector{value};
  std::string text;
  std::size_t used = 0;
  budget.Spend(1 + format.size() / 16);
  for (std::size_t at = 0; at < format.size();) {
    if (format[at] != '%') {
      text += format[at++];
    } else if (at + 1 < format.size() && format[at + 1] == '%') {
      text += '%';
      at += 2;
    } else {
      const XacroConversion conversion = XacroConversionAt(format, ++at);
      if (used >= values.size())
        RefuseXacroType(fmt::format("the format '{}' has more conversions than values", format));
      budget.Spend(8);
      text += XacroConverted(conversion, values[used++], budget);
    }
    if (text.size() > kLongestXacroText)
      throw XacroProblem{FailureCode::kXacroLimit, "a formatted text has more than 1 MiB"};
  }
  if (used < values.size()) RefuseXacroType(fmt::format("the format '{}' has fewer conversions than values", format));
  return text;
}

}  // namespace gaitwright
