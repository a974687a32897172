// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/motion_series.h"
#include "playback/score/stability_report.h"

namespace gaitwright {

/// One picture of a playback.
struct Plot {
  std::string name;     ///< short, suitable as a file name: "top_view"
  std::string caption;  ///< what the plot shows and how to read it
  std::string svg;      ///< without style; StandaloneSvg makes a file from it
};

/// All plots of a playback: top_view, side_view (on uneven ground), zmp_com_x, zmp_com_y, margins, errors,
/// base_attitude, base_height, estimate_error (if the controller estimated the base), gait, foot_heights, foot_forces,
/// torque_use (if any joint has a limit), joint_torques, joint_positions. Planned curves are broad and pale, measured
/// curves thin and dark on top. The plots end shortly after a fall.
/// @throws InvalidArgument as Score does.
std::vector<Plot> MakePlots(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                            const StabilityReport& report);

/// Data of the plots: the motion as Score computed it, cut shortly after the fall.
struct PlotData {
  const RobotModel& model;
  const MotionPlan& plan;
  const PlaybackLog& log;
  const StabilityReport& report;
  MotionSeries series;

  double start_s() const { return log.start_s; }
  double end_s() const { return series.measured.back().time_s; }
};

/// The plots by kind; MakePlots collects them.
Plot TopView(const PlotData& data);
Plot SideView(const PlotData& data);
std::vector<Plot> BalancePlots(const PlotData& data);
std::vector<Plot> ContactPlots(const PlotData& data);
std::vector<Plot> JointPlots(const PlotData& data);
std::vector<Plot> EstimatePlots(const PlotData& data);

class SvgPlot;
/// Edges of the ground and obstacles, in plan view around the path.
void DrawGround(const PlotData& data, SvgPlot& plot);
/// The support polygon of each phase, at the places of the scheduled feet in these samples.
void DrawSupports(const ContactSchedule& schedule, const std::vector<MotionSample>& samples, SvgPlot& plot);
/// The paths of centre of mass and ZMP in plan view, planned and measured.
void DrawPaths(const MotionSeries& series, SvgPlot& plot);
/// Centre of mass and ZMP along one axis over time, planned and measured, with the extent of the support.
void DrawBalance(const MotionSeries& series, int axis, SvgPlot& plot);
/// Lines at the starts of the plan's parts after the first, and at the time of a fall.
void MarkTimes(const PlotData& data, SvgPlot& plot, bool in_words = true);

}  // namespace gaitwright
