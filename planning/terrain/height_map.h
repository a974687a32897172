// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// How the numbers or greys of a file become heights, and where they lie.
struct HeightMapOptions {
  double resolution_m = 0.0;
  double scale_m = 0.0;
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  double friction = 0.8;

  OptionFields Fields();
};

/// Reads a height map as seen from above, x to the right and y up: the first row has the highest y.
///
/// CSV: numbers with commas between, a row a line; empty lines and lines that begin with # are passed over; heights are
/// the numbers times scale_m (1 where it is not given). PNG (ReadGreyPng): black is 0, white is scale_m.
/// Failure kBadInput, naming the file and the line or cell: a file that is not there or of another kind, rows of
/// different lengths, fewer than 2 columns or rows, more than kMostNodes points, a cell that is no finite number, a
/// height beyond kHighest or farther than kSteepestStep from its neighbour, and options that are missing or out of
/// range.
Result<HeightField> ReadHeightMap(const std::string& path, const HeightMapOptions& options);

}  // namespace gaitwright
