// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// Contents of the figure.
struct GaitFigureOptions {
  int cycles = 10;       ///< number of cycles of the gait at its start, 1 to 1000
  double from_s = -1e9;  ///< on the plan's clock; a time before the first step means the first step
};

/// The gait of a motion as a figure for print, one `<svg>` with StandaloneSvg's head. Top: plan view of support
/// polygons, ZMP and centre of mass, to scale. Below: ZMP and centre of mass over time, along x and y, with the extent
/// of the support.
/// @param log  of the plan; null draws only the plan.
/// @throws InvalidArgument as MakeMotionSeries does, for options out of range, and if no sample is in the window.
std::string GaitFigure(const RobotModel& model, const MotionPlan& plan, const PlaybackLog* log,
                       const GaitFigureOptions& options = {});

/// Number of gait cycles of the figure: fewer than requested if the motion ends before.
/// @throws InvalidArgument for options out of range.
double CyclesShown(const MotionPlan& plan, const PlaybackLog* log, const GaitFigureOptions& options);

}  // namespace gaitwright
