// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "playback/report/plot_grid.h"
#include "playback/report/plots.h"

namespace gaitwright {
namespace {

int NumFeet(const PlotData& data) { return static_cast<int>(data.model.feet.size()); }

Plot GaitDiagram(const PlotData& data) {
  SvgPlot::Options options;
  options.title = "Contact of the feet";
  options.x_label = "time [s]";
  for (const Foot& foot : data.model.feet) options.rows.push_back(foot.name);
  options.height_px = 76.0 + 30.0 * static_cast<double>(options.rows.size());
  options.x_lowest = data.start_s();
  options.x_highest = data.end_s();
  SvgPlot plot(options);
  for (int foot = 0; foot < NumFeet(data); ++foot) {
    for (const ContactInterval& stance : IntervalsOf(data.plan.schedule, foot)) {
      plot.Bar(foot, stance.start_s, stance.end_s, Ink::kFoot, Stroke::kPlanned, "scheduled");
    }
  }
  for (const StanceRecord& stance : data.log.stances) {
    plot.Bar(stance.foot, stance.touchdown_s, stance.liftoff_s, Ink::kFoot, Stroke::kMeasured, "measured");
  }
  MarkTimes(data, plot);
  return {"gait", "Scheduled (broad) and measured (narrow) contact of each foot.", plot.Svg()};
}

/// One small plot per foot of a quantity of its samples.
template <class Figure>
std::string FootGrid(const PlotData& data, const std::string& title, const std::string& unit, Ink ink, Figure figure) {
  std::vector<SvgPlot> plots;
  const int columns = 2;
  for (int foot = 0; foot < NumFeet(data); ++foot) {
    SvgPlot::Options options;
    options.title = data.model.feet[static_cast<std::size_t>(foot)].name;
    options.width_px = 480.0;
    options.height_px = 170.0;
    options.x_lowest = data.start_s();
    options.x_highest = data.end_s();
    options.x_label_room = true;
    options.x_label = foot >= NumFeet(data) - columns ? "time [s]" : "";
    options.y_label = unit;
    options.most_points = 700;
    options.y_least_span = 5.0;
    options.legend = false;
    SvgPlot plot(options);
    const auto line = [&](const std::vector<MotionSample>& samples) {
      std::vector<Vector2> points;
      for (const MotionSample& s : samples) {
        points.emplace_back(s.time_s, figure(s.feet[static_cast<std::size_t>(foot)]));
      }
      return points;
    };
    plot.Line(line(data.series.planned), ink, Stroke::kPlanned, "planned");
    plot.Line(line(data.series.measured), ink, Stroke::kMeasured, "measured");
    MarkTimes(data, plot, false);
    plots.push_back(std::move(plot));
  }
  return GridOfPlots(plots, columns, title);
}

}  // namespace

std::vector<Plot> ContactPlots(const PlotData& data) {
  const auto height = [](const FootSample& foot) {
    return std::isfinite(foot.height_m) ? 1e3 * foot.height_m : std::nan("");
  };
  const auto force = [](const FootSample& foot) { return foot.force_W.z(); };
  return {GaitDiagram(data),
          {"foot_heights", "Height of the lowest point of each foot above the ground, in millimetres.",
           FootGrid(data, "Heights of the feet", "height [mm]", Ink::kFoot, height)},
          {"foot_forces", "Vertical ground force on each foot, in newtons, as mean over the log's interval.",
           FootGrid(data, "Forces on the feet", "force [N]", Ink::kZmp, force)}};
}

}  // namespace gaitwright
