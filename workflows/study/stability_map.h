// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/study/map_cell.h"
#include "workflows/study/sweep.h"

namespace gaitwright {

/// A picture of a study.
struct StudyPicture {
  std::string name;     ///< fit for a file name: "score_map"
  std::string caption;  ///< what it shows and how to read it
  std::string svg;      ///< whole by itself, without an XML declaration
};

/// Most panels of one map.
inline constexpr std::size_t kMostMapPanels = 36;

/// The quantity over the first two axes as a heat map, a panel for each combination of values of further axes (of those
/// beyond the third the best point's alone, where there would be over kMostMapPanels). A sample is drawn as discs where
/// its points lie, in one panel. Cells that fail are marked by pattern and letter, the best has a frame.
StudyPicture DrawStabilityMap(const Study& study, const std::vector<PointOutcome>& outcomes, MapQuantity quantity);

}  // namespace gaitwright
