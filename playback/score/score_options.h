// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// Options of the measurements; the limits are in gates.h.
struct ScoreOptions {
  double zmp_filter_s = 0.010;
  double min_normal_fraction = 0.05;
  double fall_tilt_rad = 0.6;
  double fall_height_lowest = 0.6;
  double fall_height_highest = 1.5;
  double stretch = 0.95;

  OptionFields Fields() {
    return WithBasics({"fall_tilt_rad", "fall_height_lowest"},
                      {{"zmp_filter_s", &zmp_filter_s, "s", 0.0, 1.0,
                        "Time constant of the first-order low-pass filter on the measured and the planned ZMP."},
                       {"min_normal_fraction", &min_normal_fraction, "1", 0.0, 1.0,
                        "Smallest normal force, as a share of the weight, at which a ZMP is computed."},
                       {"fall_tilt_rad", &fall_tilt_rad, "rad", 0.0, 3.2,
                        "Tilt of the base relative to the plan above which the robot counts as fallen."},
                       {"fall_height_lowest", &fall_height_lowest, "1", 0.0, 1.0,
                        "Share of the planned base height below which the robot counts as fallen."},
                       {"fall_height_highest", &fall_height_highest, "1", 1.0, 10.0,
                        "Multiple of the planned base height above which the robot counts as fallen (thrown upward)."},
                       {"stretch", &stretch, "1", 0.5, 1.0,
                        "Share of the straight leg's length that a recovery step may use; it defines the one-step "
                        "capturable region."}});
  }
};

/// The options with which a log was scored after its playback, if it has them; else the defaults.
ScoreOptions ScoreOptionsOf(const PlaybackLog& log);

}  // namespace gaitwright
