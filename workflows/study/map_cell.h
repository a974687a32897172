// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "workflows/study/point_outcome.h"

namespace gaitwright {

/// What a map colours.
enum class MapQuantity { kScore, kSurvival };

/// Share of the scale, 0 to 1, that an outcome has of the quantity; nothing where it has none.
std::optional<double> ShareOf(const PointOutcome& outcome, MapQuantity quantity);

/// Colour of a share, dark blue over grey to yellow, as "#rrggbb": cividis, whose order people with the common kinds of
/// colour blindness see as others do. Nunez, Anderton and Renslow, PLoS ONE 13(7), 2018.
std::string MapColour(double share);

/// The letter of a status: G gate missed, F fell, A audit failed, R refused; empty for a pass.
std::string LetterOf(PointStatus status);

/// What a status is called in a legend.
std::string WordsOf(PointStatus status);

/// Definitions of the patterns that mark a status, to stand once in a page or picture.
std::string MapPatterns();

/// Where a cell is drawn [px], and whether it is a disc instead of a rectangle.
struct MapCell {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  bool round = false, framed = false;
  std::string words;  ///< shown where the pointer rests
};

/// One cell: its colour, over it the pattern and the letter of its status.
std::string DrawCell(const MapCell& cell, PointStatus status, std::optional<double> share);

}  // namespace gaitwright
