// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "playback/report/plots.h"
#include "workflows/exchange/motion_rows.h"

namespace gaitwright {

/// A motion to draw, with its name in the legend.
struct DrawnMotion {
  std::string name;
  const RobotModel* model = nullptr;
  const MotionRows* rows = nullptr;
  double offset_s = 0.0;  ///< subtracted from its times, so that motions align
};

/// Plots of one motion, or of two on top of each other (the first broad and pale, the second thin and dark): top_view,
/// base_position, base_attitude, contacts, joint_positions, joint_speeds and joint_torques, as far as the motions have
/// data. Joints and feet are those of the first motion, found in the second by name; a joint that rests in both is left
/// out. `mark_s`, on the clock of the first motion, is drawn as a line. @throws InvalidArgument for none or more than
/// two motions, or for one without rows.
std::vector<Plot> MotionPlots(const std::vector<DrawnMotion>& motions, const std::optional<double>& mark_s = {},
                              const std::string& mark_words = "");

}  // namespace gaitwright
