// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "workflows/study/point_outcome.h"

namespace gaitwright {

/// Quantity that a map shows.
enum class MapQuantity { kScore, kSurvival };

/// Value of the quantity on the map's scale, 0 to 1; nothing if the outcome has none.
std::optional<double> ShareOf(const PointOutcome& outcome, MapQuantity quantity);

/// Colour of a scale value, from dark blue through grey to yellow, as "#rrggbb": cividis, which is readable with the
/// common kinds of colour blindness. Nunez, Anderton and Renslow, PLoS ONE 13(7), 2018.
std::string MapColour(double share);

/// The letter of a status: G gate missed, F fell, A audit failed, R refused; empty for a pass.
std::string LetterOf(PointStatus status);

/// Name of a status in a legend.
std::string WordsOf(PointStatus status);

/// Definitions of the patterns that mark a status; needed once in a page or picture.
std::string MapPatterns();

/// Position of a cell [px], and whether it is a disc instead of a rectangle.
struct MapCell {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  bool round = false, framed = false;
  std::string words;  ///< tooltip
};

/// One cell: its colour, with the pattern and the letter of its status on top.
std::string DrawCell(const MapCell& cell, PointStatus status, std::optional<double> share);

}  // namespace gaitwright
