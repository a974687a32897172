// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// Conversion of the numbers or grey values of a file to heights, and position of the map.
struct HeightMapOptions {
  double resolution_m = 0.0;
  double scale_m = 0.0;
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  double friction = 0.8;

  OptionFields Fields();
};

/// Reads a height map as seen from above, x to the right and y up: the first row has the largest y.
///
/// CSV: one row per line, numbers separated by commas; empty lines and lines that begin with # are skipped. The height
/// is the number times scale_m (default 1). PNG (ReadGreyPng): black is height 0, white is scale_m. Failure kBadInput
/// names the file and the line or cell: a missing file or one of another kind; rows of different lengths; fewer than 2
/// columns or rows; more than kMostNodes points; a cell that is not a finite number; a height beyond kHighest; a height
/// difference of more than kSteepestStep between neighbours; options that are missing or out of range.
Result<HeightField> ReadHeightMap(const std::string& path, const HeightMapOptions& options);

}  // namespace gaitwright
