// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "playback/report/plot_grid.h"
#include "playback/report/plots.h"
#include "playback/score/measurements.h"

namespace gaitwright {
namespace {

using Value = double (*)(const EstimateError&);

SvgPlot ErrorPlot(const PlotData& data, const std::string& title, const std::string& unit, Value value) {
  SvgPlot::Options options;
  options.title = title;
  options.width_px = 480.0;
  options.height_px = 190.0;
  options.x_lowest = data.start_s();
  options.x_highest = data.end_s();
  options.x_label_room = true;
  options.x_label = "time [s]";
  options.y_label = "[" + unit + "]";
  options.y_least_span = 1.0;
  options.legend = false;
  SvgPlot plot(options);
  std::vector<Vector2> line;
  for (std::size_t k = 0; k < data.series.measured.size(); ++k) {
    const LogSample& sample = data.log.samples[k];
    if (sample.estimate) line.emplace_back(sample.time_s, value(ErrorOf(sample)));
  }
  plot.Line(line, Ink::kCom, Stroke::kMeasured, "estimate minus truth");
  MarkTimes(data, plot, false);
  return plot;
}

}  // namespace

std::vector<Plot> EstimatePlots(const PlotData& data) {
  if (!data.log.samples.front().estimate) return {};
  const std::vector<SvgPlot> plots = {
      ErrorPlot(data, "Position, in plan view", "mm", [](const EstimateError& e) { return 1e3 * e.horizontal_m; }),
      ErrorPlot(data, "Height", "mm", [](const EstimateError& e) { return 1e3 * e.height_m; }),
      ErrorPlot(data, "Tilt", "mrad", [](const EstimateError& e) { return 1e3 * e.tilt_rad; }),
      ErrorPlot(data, "Heading", "mrad", [](const EstimateError& e) { return 1e3 * e.heading_rad; }),
      ErrorPlot(data, "Velocity", "mm/s", [](const EstimateError& e) { return 1e3 * e.velocity_m_s; })};
  return {{"estimate_error",
           "Error of the controller's base estimate: position and heading may drift; tilt and velocity errors must "
           "stay small.",
           GridOfPlots(plots, 2, "Errors of the estimate of the base")}};
}

}  // namespace gaitwright
