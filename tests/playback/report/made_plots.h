// SPDX-License-Identifier: BSD-3-Clause
// Data of plots with known values.
#pragma once

#include <stdexcept>

#include "playback/report/plots.h"
#include "playback/report/svg_plot.h"
#include "tests/playback/played.h"

namespace gaitwright::synthetic {

/// Data of a plot, with its verdict. Tests may modify the parts before `Data`.
struct Drawn : Played {
  explicit Drawn(Played played) : Played(std::move(played)), report(Score(model, plan, log)) {}

  PlotData Data() const { return {model, plan, log, report, MakeMotionSeries(model, plan, log, {})}; }

  StabilityReport report;
};

/// The plot with a name. @throws std::out_of_range if it does not exist.
inline const Plot& PlotNamed(const std::vector<Plot>& plots, const std::string& name) {
  for (const Plot& plot : plots) {
    if (plot.name == name) return plot;
  }
  throw std::out_of_range("no plot is called " + name);
}

/// Axes without a legend, so that only drawn marks are counted.
inline SvgPlot BarePlot() {
  SvgPlot::Options options;
  options.legend = false;
  return SvgPlot(options);
}

}  // namespace gaitwright::synthetic
