// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/study/stability_map.h"

namespace gaitwright {

/// A page about a study: title, one style sheet and the HTML `body`. Self-contained: no network, no scripts.
std::string StudyPage(const std::string& title, const std::string& body);

/// A figure with its caption.
std::string FigureOf(const StudyPicture& picture);

/// A table; the first row has the headings. Cells are plain text.
std::string TableOf(const std::vector<std::vector<std::string>>& rows);

/// The page of a sweep: counts and the best point, the maps, the score over each axis for sampled points, the failures
/// with their reasons, and every point. Well-formed XML; deterministic to the byte.
std::string SweepPage(const Study& study, const std::vector<PointOutcome>& outcomes);

}  // namespace gaitwright
