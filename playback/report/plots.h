// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/motion_series.h"
#include "playback/score/stability_report.h"

namespace gaitwright {

/// One picture of a playback.
struct Plot {
  std::string name;     ///< short, fit for a file name: "top_view"
  std::string caption;  ///< what it shows and how to read it
  std::string svg;      ///< without style; StandaloneSvg makes a file of it
};

/// All plots of a playback: top_view, side_view (on uneven ground), zmp_com_x, zmp_com_y, margins, errors,
/// base_attitude, base_height, estimate_error (where the controller estimated the base), gait, foot_heights,
/// foot_forces, torque_use (where a joint has a limit), joint_torques, joint_positions. Planned is broad and pale,
/// measured thin and dark on top. They end shortly after a fall.
/// @throws InvalidArgument as Score does.
std::vector<Plot> MakePlots(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                            const StabilityReport& report);

/// What the plots are drawn from: the motion as Score saw it, cut shortly after the fall.
struct PlotData {
  const RobotModel& model;
  const MotionPlan& plan;
  const PlaybackLog& log;
  const StabilityReport& report;
  MotionSeries series;

  double start_s() const { return log.start_s; }
  double end_s() const { return series.measured.back().time_s; }
};

/// The plots by kind; MakePlots puts them together.
Plot TopView(const PlotData& data);
Plot SideView(const PlotData& data);
std::vector<Plot> BalancePlots(const PlotData& data);
std::vector<Plot> ContactPlots(const PlotData& data);
std::vector<Plot> JointPlots(const PlotData& data);
std::vector<Plot> EstimatePlots(const PlotData& data);

class SvgPlot;
/// Edges of the ground and what stands on it, in plan view about the walk.
void DrawGround(const PlotData& data, SvgPlot& plot);
/// The support polygons of each phase, once each, where the scheduled feet were in these samples.
void DrawSupports(const ContactSchedule& schedule, const std::vector<MotionSample>& samples, SvgPlot& plot);
/// The ways of centre of mass and ZMP in plan view, planned and measured.
void DrawPaths(const MotionSeries& series, SvgPlot& plot);
/// Centre of mass and ZMP along one axis over time, planned and measured, over the extent of the support.
void DrawBalance(const MotionSeries& series, int axis, SvgPlot& plot);
/// Lines where parts of the plan begin after its first, and at the time of the fall, if there was one.
void MarkTimes(const PlotData& data, SvgPlot& plot, bool in_words = true);

}  // namespace gaitwright
