// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdlib>

#include "cli/numbers.h"
#include "kinematics/base/result.h"
#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {
namespace {

Verdict ReadNumbers(const std::string& input) {
  const bool number = cli::NotANumber(input).empty(), whole = cli::NotAWholeNumber(input, 0).empty();
  if (number) Require(std::isfinite(std::strtod(input.c_str(), nullptr)), "a number is finite");
  if (whole) Require(number && std::stoll(input) >= 0, "a whole number is not negative");
  try {
    const std::vector<double> numbers = cli::ParseNumbers("--push", input, 3);
    Require(numbers.size() == 3, "the number of values is as requested");
    for (const double value : numbers) Require(std::isfinite(value), "numbers are finite");
    return Verdict::kAccepted;
  } catch (const InvalidArgument&) {
    return number ? Verdict::kAccepted : Verdict::kRefused;
  }
}

}  // namespace

const std::vector<Reader>& Readers() {
  static const std::vector<Reader> readers = {
      {"numbers", ReadNumbers, {",", "nan", "inf", "-1", "1e400", "0x1p3", "+", " ", "e", "1e-400"}, {}}};
  return readers;
}

}  // namespace gaitwright::fuzz
