// SPDX-License-Identifier: BSD-3-Clause
#include "examples/step_picture.h"

#include <fmt/format.h>

#include "playback/report/plot_grid.h"
#include "playback/report/svg_plot.h"

namespace gaitwright::examples {
namespace {

SvgPlot PlotOf(const JointStep& step) {
  std::vector<Vector2> simulated, formula;
  for (std::size_t k = 0; k < step.simulated.size(); ++k) {
    const double time_s = static_cast<double>(k + 1) * step.step_s;
    simulated.emplace_back(time_s, step.simulated[k]);
    formula.emplace_back(time_s, step.formula[k]);
  }
  SvgPlot::Options options;
  options.title = fmt::format("kp {:g}, kd {:g}: {:.0f} rad/s, damping ratio {:.2f}", step.stiffness, step.damping,
                              step.frequency_rad_s, step.damping_ratio);
  options.x_label = "time [s]";
  options.y_label = "share of the step";
  options.width_px = 480.0;
  options.legend = false;  // one legend for all plots
  options.y_lowest = 0.0;
  options.y_highest = 2.0;  // maximum without damping
  SvgPlot plot(options);
  plot.Line(formula, Ink::kJoint, Stroke::kPlanned, "second-order system");
  plot.Line(simulated, Ink::kJoint, Stroke::kMeasured, "simulated");
  return plot;
}

}  // namespace

std::string StepPicture(const std::vector<JointStep>& steps, int columns) {
  std::vector<SvgPlot> plots;
  for (const JointStep& step : steps) plots.push_back(PlotOf(step));
  return StandaloneSvg(GridOfPlots(plots, columns, "A step of one joint's target"));
}

}  // namespace gaitwright::examples
