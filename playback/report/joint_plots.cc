// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "kinematics/model/dof_units.h"
#include "playback/report/plot_grid.h"
#include "playback/report/plots.h"
#include "playback/score/measurements.h"

namespace gaitwright {
namespace {

constexpr int kColumns = 3;
constexpr double kMoves = 1e-3;  // smaller motion of a joint outside the legs is not shown [rad] or [m]

bool InALeg(const RobotModel& model, int dof) {
  const int joint = model.dof_joint[static_cast<std::size_t>(dof)];
  return std::any_of(model.legs.begin(), model.legs.end(), [&](const Leg& leg) {
    return std::find(leg.joints.begin(), leg.joints.end(), joint) != leg.joints.end();
  });
}

/// The joints to show: those of legs, and others that the plan moves.
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

/// Largest torque of a motor in the time shown, relative to its limit [%].
struct Use {
  double planned = 0.0, measured = 0.0;
};

Use UseOf(const PlotData& data, int index) {
  Use use;
  const Actuator motor = ActuatorOf(data.model, index);
  for (std::size_t k = 0; k < data.series.measured.size(); ++k) {
    if (data.series.plan[k].tau.size() == data.model.num_dofs())
      use.planned = std::max(use.planned, std::abs(motor.Effort(data.series.plan[k].tau)));
    use.measured = std::max(use.measured, data.log.samples[k].tau_peak[index]);
  }
  const double scale = 100.0 / motor.effort_limit;
  return {scale * use.planned, scale * use.measured};
}

/// The torque limit of a joint that is independent of other joints; nothing for a joint that a transmission drives.
std::optional<double> OwnTorqueLimit(const RobotModel& model, int dof) {
  const Actuator motor = ActuatorOf(model, dof);
  if (motor.shared() || !HasTorqueLimit(motor)) return std::nullopt;
  return motor.effort_limit;
}

/// Overview of all torque limits: one bar per motor, relative to the robot's limit.
std::vector<Plot> TorqueUsePlot(const PlotData& data, const std::vector<int>& shown) {
  constexpr double kRowHeight = 21.0, kAround = 76.0;  // [px]
  std::vector<int> limited;
  std::copy_if(shown.begin(), shown.end(), std::back_inserter(limited),
               [&](int dof) { return HasTorqueLimit(ActuatorOf(data.model, dof)); });
  if (limited.empty()) return {};
  SvgPlot::Options options;
  options.title = "Largest torques relative to their limits";
  options.x_label = "largest torque, share of the robot's limit [%]";
  options.x_lowest = 0.0;
  options.x_highest = 105.0;
  options.height_px = kAround + kRowHeight * static_cast<double>(limited.size());
  for (const int dof : limited) {
    const Actuator motor = ActuatorOf(data.model, dof);
    options.rows.push_back(fmt::format("{}, {:.4g} {}", motor.name, motor.effort_limit, motor.effort_unit()));
    options.x_highest = std::max(*options.x_highest, 1.05 * UseOf(data, dof).planned);
  }
  SvgPlot plot(options);
  for (std::size_t i = 0; i < limited.size(); ++i) {
    const Use use = UseOf(data, limited[i]);
    plot.Bar(static_cast<int>(i), 0.0, use.planned, Ink::kJoint, Stroke::kPlanned, "planned");
    plot.Bar(static_cast<int>(i), 0.0, use.measured, Ink::kJoint, Stroke::kMeasured, "measured");
  }
  plot.AcrossY(100.0, Ink::kLimit, "limit");
  return {{"torque_use",
           "Largest torque of each motor as a share of its limit (given after its name): planned (broad) and measured "
           "(narrow), including peaks within the log's intervals.",
           plot.Svg()}};
}

SvgPlot TorquePlot(const PlotData& data, SvgPlot::Options options, int dof) {
  options.y_label = Slides(data.model, dof) ? "force [N]" : "torque [N m]";
  const std::optional<double> limit = OwnTorqueLimit(data.model, dof);
  options.y_least_span = limit ? 0.02 * *limit : 0.1;
  if (limit) options.title += fmt::format(", limit \u00b1{:.4g} {}", *limit, EffortUnit(data.model, dof));
  SvgPlot plot(options);
  std::vector<Vector2> planned, measured;
  for (std::size_t k = 0; k < data.series.measured.size(); ++k) {
    const LogSample& sample = data.log.samples[k];
    if (data.series.plan[k].tau.size() > dof) planned.emplace_back(sample.time_s, data.series.plan[k].tau[dof]);
    measured.emplace_back(sample.time_s, sample.tau[dof]);
  }
  plot.Line(planned, Ink::kJoint, Stroke::kPlanned, "planned");
  plot.Line(measured, Ink::kJoint, Stroke::kMeasured, "measured");
  if (limit) {
    const bool near = UseOf(data, dof).measured > 50.0;
    plot.AcrossX(*limit, Ink::kLimit, "", near);
    plot.AcrossX(-*limit, Ink::kLimit, "", near);
  }
  MarkTimes(data, plot, false);
  return plot;
}

SvgPlot PositionPlot(const PlotData& data, SvgPlot::Options options, int dof) {
  options.y_label = Slides(data.model, dof) ? "position [m]" : "angle [rad]";
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
  MarkTimes(data, plot, false);
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
  std::vector<Plot> plots = TorqueUsePlot(data, shown);
  plots.push_back({"joint_torques",
                   "Torque of each joint over time; the dashed line is its limit, drawn if the torque exceeds half of "
                   "it. A joint whose motors drive several joints has no joint limit.",
                   GridOfPlots(torques, kColumns, "Torques of the joints")});
  plots.push_back({"joint_positions", "Position of each joint; the dashed line is a limit that it approaches.",
                   GridOfPlots(positions, kColumns, "Positions of the joints")});
  return plots;
}

}  // namespace gaitwright
