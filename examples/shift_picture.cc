// SPDX-License-Identifier: BSD-3-Clause
#include "examples/shift_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "playback/report/plot_grid.h"
#include "playback/report/plots.h"
#include "playback/report/svg_plot.h"

namespace gaitwright::examples {
namespace {

SvgPlot PlotOf(const ShownShift& shown, int axis) {
  const std::vector<MotionSample>& measured = shown.series.measured;
  const auto by_axis = [axis](const Vector2& a, const Vector2& b) { return a[axis] < b[axis]; };
  const Polygon& support = measured.front().support.polygon;
  const auto [least, most] = std::minmax_element(support.begin(), support.end(), by_axis);
  const double beyond_m = 0.4 * ((*most)[axis] - (*least)[axis]);  // lines are cut beyond this distance
  SvgPlot::Options options;
  options.title = fmt::format("in {:g} s{}", shown.duration_s, shown.fell ? ": it falls" : "");
  options.x_label = "time [s]";
  options.y_label = axis == 0 ? "x [m]" : "y [m]";
  options.width_px = 720.0;
  options.legend = false;  // one legend for all plots
  options.y_lowest = (*least)[axis] - beyond_m;
  options.y_highest = (*most)[axis] + beyond_m;
  SvgPlot plot(options);
  DrawBalance(shown.series, axis, plot);
  std::vector<Vector2> formula;
  for (std::size_t k = 0; k < shown.formula_W.size(); ++k)
    formula.emplace_back(measured[k + 1].time_s, shown.formula_W[k][axis]);
  plot.Line(formula, Ink::kMuted, Stroke::kDashed, "c - (z / g) c''");
  return plot;
}

}  // namespace

std::string ShiftPicture(const std::vector<ShownShift>& shifts, int axis) {
  std::vector<SvgPlot> plots;
  for (const ShownShift& shown : shifts) plots.push_back(PlotOf(shown, axis));
  return StandaloneSvg(GridOfPlots(plots, 2, "A shift of the body, slow and quick"));
}

}  // namespace gaitwright::examples
