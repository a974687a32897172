// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/number_text.h"

#include <fmt/format.h>

#include <iterator>

namespace gaitwright {

void AppendNumber(double value, std::string& text) {
  fmt::format_to(std::back_inserter(text), "{}", value == 0.0 ? 0.0 : value);
}

void AppendDecimal(double value, std::string& text) {
  const std::size_t start = text.size();
  AppendNumber(value, text);
  if (text.find('.', start) != std::string::npos) return;
  const std::size_t exponent = text.find('e', start);
  text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
}

}  // namespace gaitwright
