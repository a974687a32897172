// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// A grey picture, rows from the top.
struct GreyImage {
  int columns = 0, rows = 0;
  int full = 255;  ///< the value of white: 255 of 8 bits, 65535 of 16
  std::vector<std::uint16_t> values;
};

/// Reads a grey PNG of 8 or 16 bits. Failure: no such file, no PNG or a broken one, one in colour, with transparency or
/// of fewer bits, or of more than kMostNodes points.
Result<GreyImage> ReadGreyPng(const std::string& path);

}  // namespace gaitwright
