// SPDX-License-Identifier: BSD-3-Clause
#include "cli/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "cli/word_list.h"
#include "kinematics/base/result.h"

namespace gaitwright::cli {
namespace {

/// Reads the whole text as a number. @return no error, out of range of the type, or not a number.
template <class Number>
std::errc ReadNumber(const std::string& text, Number& value) {
  const char* begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  return end == text.data() + text.size() ? error : std::errc::invalid_argument;
}

/// Returns false also for a number out of range of double.
bool ReadFinite(const std::string& text, double& value) {
  return ReadNumber(text, value) == std::errc{} && std::isfinite(value);
}

}  // namespace

std::string NotANumber(const std::string& text) {
  double value = 0.0;
  return ReadFinite(text, value) ? "" : fmt::format("'{}' is not a finite number", text);
}

std::string NotAWholeNumber(const std::string& text, std::int64_t lowest, std::int64_t highest) {
  std::int64_t value = 0;
  const std::errc error = ReadNumber(text, value);
  if (error == std::errc::invalid_argument) return fmt::format("'{}' is not a whole number", text);
  const bool beyond = error == std::errc::result_out_of_range;
  if (beyond ? text.front() == '-' : value < lowest)
    return fmt::format("{} is too small; accepted: {} or more", text, lowest);
  return beyond || value > highest ? fmt::format("{} is too large; accepted: {} to {}", text, lowest, highest) : "";
}

std::vector<double> ParseNumbers(const std::string& flag, const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& word : SplitAtCommas(text)) {
    double value = 0.0;
    if (!ReadFinite(word, value)) throw InvalidArgument(fmt::format("{}: '{}' is not a finite number", flag, word));
    numbers.push_back(value);
  }
  if (numbers.size() != count || text.ends_with(',')) {
    throw InvalidArgument(
        fmt::format("{}: expects {} numbers separated by commas; '{}' has {}", flag, count, text, numbers.size()));
  }
  return numbers;
}

}  // namespace gaitwright::cli
