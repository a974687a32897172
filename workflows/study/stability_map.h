// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/study/map_cell.h"
#include "workflows/study/sweep.h"

namespace gaitwright {

/// A picture of a study.
struct StudyPicture {
  std::string name;     ///< usable as a file name: "score_map"
  std::string caption;  ///< describes the content and how to read it
  std::string svg;      ///< self-contained, without an XML declaration
};

/// Largest number of panels of one map.
inline constexpr std::size_t kMostMapPanels = 36;

/// Draws the quantity over the first two axes as a heat map, with a panel for each combination of values of further
/// axes. If there would be more than kMostMapPanels, axes beyond the third are shown only at the best point's values.
/// Samples are drawn as discs at their points, in one panel. Failed cells have a pattern and a letter, the best cell
/// has a frame.
StudyPicture DrawStabilityMap(const Study& study, const std::vector<PointOutcome>& outcomes, MapQuantity quantity);

}  // namespace gaitwright
