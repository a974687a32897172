// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "playback/report/plot_grid.h"
#include "playback/report/plots.h"

namespace gaitwright {
namespace {

constexpr int kColumns = 3;
constexpr double kMoves = 1e-3;  // a joint that moves and works less than this is left out [rad, share of its limit]

bool HasLimit(const RobotModel& model, int dof) {
  const Joint& joint = model.joints[static_cast<std::size_t>(model.dof_joint[static_cast<std::size_t>(dof)])];
  return !joint.effort_limit_is_placeholder && std::isfinite(model.dof_effort_limit(dof)) &&
         model.dof_effort_limit(dof) > 0.0;
}

bool InALeg(const RobotModel& model, int dof) {
  const int joint = model.dof_joint[static_cast<std::size_t>(dof)];
  return std::any_of(model.legs.begin(), model.legs.end(), [&](const Leg& leg) {
    return std::find(leg.joints.begin(), leg.joints.end(), joint) != leg.joints.end();
  });
}

/// The joints that take part: those of legs, and others that the plan moves.
std::vector<int> ShownDofs(const PlotData& data) {
  std::vector<int> shown;
  for (int i = 0; i < data.model.num_dofs(); ++i) {
    double least = INFINITY, most = -INFINITY;
    for (const WholeBodySample& row : data.series.plan) {
      least = std::min(least, row.q[7 + i]);
      most = std::max(most, row.q[7 + i]);
    }
    if (InALeg(data.model, i) || most - least > kMoves) shown.push_back(i);
  }
  return shown;
}

bool Slides(const RobotModel& model, int dof) {
  const int joint = model.dof_joint[static_cast<std::size_t>(dof)];
  return model.joints[static_cast<std::size_t>(joint)].type == JointType::kPrismatic;
}

SvgPlot::Options SmallPlot(const PlotData& data, int dof, bool last_row) {
  SvgPlot::Options options;
  options.title = data.model.dof_names[static_cast<std::size_t>(dof)];
  options.width_px = 320.0;
  options.height_px = 155.0;
  options.x_lowest = data.start_s();
  options.x_highest = data.end_s();
  options.x_label_room = true;
  options.x_label = last_row ? "time [s]" : "";
  options.most_points = 300;
  options.legend = false;
  return options;
}

SvgPlot TorquePlot(const PlotData& data, SvgPlot::Options options, int dof) {
  options.y_label = Slides(data.model, dof) ? "[N]" : "[N m]";
  options.y_least_span = HasLimit(data.model, dof) ? 0.02 * data.model.dof_effort_limit(dof) : 0.1;
  SvgPlot plot(options);
  std::vector<Vector2> planned, measured;
  for (std::size_t k = 0; k < data.series.measured.size(); ++k) {
    const LogSample& sample = data.log.samples[k];
    if (data.series.plan[k].tau.size() > dof) planned.emplace_back(sample.time_s, data.series.plan[k].tau[dof]);
    measured.emplace_back(sample.time_s, sample.tau[dof]);
  }
  plot.Line(planned, Ink::kJoint, Stroke::kPlanned, "planned");
  plot.Line(measured, Ink::kJoint, Stroke::kMeasured, "measured");
  if (HasLimit(data.model, dof)) {
    const double limit = data.model.dof_effort_limit(dof);
    double peak = 0.0;
    for (std::size_t k = 0; k < data.series.measured.size(); ++k)
      peak = std::max(peak, data.log.samples[k].tau_peak[dof]);
    const bool near = peak > 0.5 * limit;
    plot.AcrossX(limit, Ink::kLimit, fmt::format("limit {:.4g}", limit), near);
    plot.AcrossX(-limit, Ink::kLimit, "", near);
  }
  MarkFall(data, plot, false);
  return plot;
}

SvgPlot PositionPlot(const PlotData& data, SvgPlot::Options options, int dof) {
  options.y_label = Slides(data.model, dof) ? "[m]" : "[rad]";
  options.y_least_span = 0.02;
  SvgPlot plot(options);
  std::vector<Vector2> planned, measured;
  for (std::size_t k = 0; k < data.series.measured.size(); ++k) {
    planned.emplace_back(data.log.samples[k].time_s, data.series.plan[k].q[7 + dof]);
    measured.emplace_back(data.log.samples[k].time_s, data.log.samples[k].q[7 + dof]);
  }
  plot.Line(planned, Ink::kDcm, Stroke::kPlanned, "planned");
  plot.Line(measured, Ink::kDcm, Stroke::kMeasured, "measured");
  for (const double limit : {data.model.dof_lower(dof), data.model.dof_upper(dof)}) {
    if (std::isfinite(limit)) plot.AcrossX(limit, Ink::kLimit, "limit", false);
  }
  MarkFall(data, plot, false);
  return plot;
}

}  // namespace

std::vector<Plot> JointPlots(const PlotData& data) {
  const std::vector<int> shown = ShownDofs(data);
  std::vector<SvgPlot> torques, positions;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const SvgPlot::Options options = SmallPlot(data, shown[i], i + kColumns >= shown.size());
    torques.push_back(TorquePlot(data, options, shown[i]));
    positions.push_back(PositionPlot(data, options, shown[i]));
  }
  if (shown.empty()) return {};
  return {{"joint_torques",
           "Torque of each joint; the dashed lines are its limit, drawn where the torque comes within half of it.",
           GridOfPlots(torques, kColumns, "Torques of the joints")},
          {"joint_positions", "Position of each joint.", GridOfPlots(positions, kColumns, "Positions of the joints")}};
}

}  // namespace gaitwright
