// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// How measurements are made; what they are held against stands in gates.h.
struct ScoreOptions {
  double zmp_filter_s = 0.010;
  double min_normal_fraction = 0.05;
  double fall_tilt_rad = 0.6;
  double fall_height_lowest = 0.6;
  double fall_height_highest = 1.5;
  double stretch = 0.95;

  OptionFields Fields() {
    return {{"zmp_filter_s", &zmp_filter_s, "s", 0.0, 1.0,
             "Time constant of the first-order low-pass of the ZMP, measured and planned alike."},
            {"min_normal_fraction", &min_normal_fraction, "1", 0.0, 1.0,
             "Samples with less normal force than this share of the weight have no ZMP."},
            {"fall_tilt_rad", &fall_tilt_rad, "rad", 0.0, 3.2, "A base tilted this much off the plan's has fallen."},
            {"fall_height_lowest", &fall_height_lowest, "1", 0.0, 1.0,
             "A base below this share of the plan's height has fallen."},
            {"fall_height_highest", &fall_height_highest, "1", 1.0, 10.0,
             "A base above this share of the plan's height has fallen (or been thrown)."},
            {"stretch", &stretch, "1", 0.5, 1.0,
             "Share of a leg's straight length that a recovery step may use; sets the one-step capturable set."}};
  }
};

/// Those that a log was scored with when it was played, so far as it has any; else the defaults.
ScoreOptions ScoreOptionsOf(const PlaybackLog& log);

}  // namespace gaitwright
