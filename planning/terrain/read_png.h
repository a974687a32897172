// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// A grey picture, with rows from the top.
struct GreyImage {
  int columns = 0, rows = 0;
  int full = 255;  ///< value of white: 255 for 8 bits, 65535 for 16 bits
  std::vector<std::uint16_t> values;
};

/// Reads a grey PNG of 8 or 16 bits. Failure: missing file, not a PNG or a broken one, a picture in colour, with
/// transparency, with fewer bits, or with more than kMostNodes points.
Result<GreyImage> ReadGreyPng(const std::string& path);

}  // namespace gaitwright
