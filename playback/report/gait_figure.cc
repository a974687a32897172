// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/gait_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kinematics/base/result.h"
#include "playback/report/plot_grid.h"
#include "playback/report/plots.h"

namespace gaitwright {
namespace {

constexpr double kRateHz = 200.0, kTimePlotHeight = 230.0;
constexpr int kMostCycles = 1000;

struct Window {
  double from_s = 0.0, to_s = 0.0, cycle_s = 1.0;
};

/// The time window of a number of cycles, from the first step or the requested time, of the gait at its start.
Window WindowOf(const MotionPlan& plan, const GaitFigureOptions& options) {
  if (options.cycles < 1 || options.cycles > kMostCycles) {
    throw InvalidArgument(
        fmt::format("the number of gait cycles is {}; accepted: 1 to {}", options.cycles, kMostCycles));
  }
  double first_step_s = plan.whole_body.start_s;
  for (const SwingTrajectory& swing : plan.swings) {
    if (swing.start_s >= options.from_s) {
      first_step_s = swing.start_s;
      break;
    }
  }
  const double from_s = std::max(options.from_s, first_step_s);
  const MotionPart* part = PartAt(plan.parts, from_s);
  const double cycle_s = part == nullptr ? 1.0 : part->gait.cycle_s;
  return {from_s, from_s + options.cycles * cycle_s, cycle_s};
}

MotionSeries Within(MotionSeries series, const Window& window) {
  const auto outside = [&](const MotionSample& s) { return s.time_s < window.from_s || s.time_s > window.to_s; };
  std::erase_if(series.planned, outside);
  std::erase_if(series.measured, outside);
  series.plan.clear();
  return series;
}

SvgPlot OverTime(const MotionSeries& series, int axis) {
  SvgPlot::Options options;
  const std::string name = axis == 0 ? "x" : "y";
  options.title = "Along " + name;
  options.x_label = axis == 0 ? "" : "time [s]";
  options.y_label = name + " [m]";
  options.height_px = kTimePlotHeight;
  options.x_lowest = series.planned.front().time_s;
  options.x_highest = series.planned.back().time_s;
  SvgPlot plot(options);
  DrawBalance(series, axis, plot);
  return plot;
}

}  // namespace

std::string GaitFigure(const RobotModel& model, const MotionPlan& plan, const PlaybackLog* log,
                       const GaitFigureOptions& options) {
  const Window window = WindowOf(plan, options);
  const MotionSeries series = Within(log == nullptr ? MakePlannedSeries(model, plan, kRateHz, {})
                                                    : MakeMotionSeries(model, plan, *log, ScoreOptionsOf(*log)),
                                     window);
  if (series.planned.size() < 2) {
    throw InvalidArgument(
        fmt::format("the figure would show {:.3f} to {:.3f} s, but the motion lasts from {:.3f} to {:.3f} s",
                    window.from_s, window.to_s, plan.whole_body.start_s, plan.whole_body.end_s()));
  }
  SvgPlot above(SvgPlot::ToScale("From above", "x [m]", "y [m]"));
  DrawSupports(plan.schedule, series.measured.empty() ? series.planned : series.measured, above);
  DrawPaths(series, above);
  const std::string gait = GaitNames(plan.parts);
  return StandaloneSvg(
      StackOfPlots({above, OverTime(series, 0), OverTime(series, 1)}, model.name + (gait.empty() ? "" : ": " + gait)));
}

double CyclesShown(const MotionPlan& plan, const PlaybackLog* log, const GaitFigureOptions& options) {
  const Window window = WindowOf(plan, options);
  const bool played = log != nullptr && !log->samples.empty();
  const double end_s = played ? log->samples.back().time_s : plan.whole_body.end_s();
  return std::max(0.0, (std::min(window.to_s, end_s) - window.from_s) / window.cycle_s);
}

}  // namespace gaitwright
