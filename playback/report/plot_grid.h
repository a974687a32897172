// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/report/svg_plot.h"

namespace gaitwright {

/// Many small plots in a grid, as one `<svg>`; all have the size of the first, whose legend is beside the title.
std::string GridOfPlots(const std::vector<SvgPlot>& plots, int columns, const std::string& title);

/// Plots of one width below each other, each with its own height and legend, as one `<svg>`.
std::string StackOfPlots(const std::vector<SvgPlot>& plots, const std::string& title);

}  // namespace gaitwright
