// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace gaitwright::cli {

/// Why a text is not a finite number, or "" if it is one.
std::string NotANumber(const std::string& text);

/// Why a text is not a whole number from `lowest` to `highest`, or "" if it is one.
std::string NotAWholeNumber(const std::string& text, std::int64_t lowest,
                            std::int64_t highest = std::numeric_limits<std::int64_t>::max());

/// Reads `count` comma-separated numbers. @throws InvalidArgument that names the flag.
std::vector<double> ParseNumbers(const std::string& flag, const std::string& text, std::size_t count);

}  // namespace gaitwright::cli
