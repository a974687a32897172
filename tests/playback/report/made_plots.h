// SPDX-License-Identifier: BSD-3-Clause
// Data of plots whose every figure is known.
#pragma once

#include <stdexcept>

#include "playback/report/plots.h"
#include "playback/report/svg_plot.h"
#include "tests/playback/played.h"

namespace gaitwright::synthetic {

/// What a playback is drawn from, with its verdict. Its parts may be spoiled before `Data`.
struct Drawn : Played {
  explicit Drawn(Played played) : Played(std::move(played)), report(Score(model, plan, log)) {}

  PlotData Data() const { return {model, plan, log, report, MakeMotionSeries(model, plan, log, {})}; }

  StabilityReport report;
};

/// The plot of a name. @throws std::out_of_range without one.
inline const Plot& PlotNamed(const std::vector<Plot>& plots, const std::string& name) {
  for (const Plot& plot : plots) {
    if (plot.name == name) return plot;
  }
  throw std::out_of_range("no plot is called " + name);
}

/// Axes without a legend, so that only what is drawn is counted.
inline SvgPlot BarePlot() {
  SvgPlot::Options options;
  options.legend = false;
  return SvgPlot(options);
}

}  // namespace gaitwright::synthetic
