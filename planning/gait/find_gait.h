// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/gait/load_gaits.h"

namespace gaitwright {

/// Changes of a gait for one walk.
struct GaitOptions {
  double cycle_s = 0.0;
  double duty_factor = 0.0;
  double stance_travel = 0.42;
  double cycle_step_s = 0.0;

  OptionFields Fields() {
    return WithBasics(
        {"cycle_s", "duty_factor"},
        {{"cycle_s", &cycle_s, "s", 0.0, 20.0, "Duration of a gait cycle; 0 uses the gait's default."},
         {"duty_factor", &duty_factor, "1", 0.0, 0.99,
          "Share of the cycle during which a foot is on the ground; 0 uses the gait's default."},
         {"stance_travel", &stance_travel, "1", 0.05, 1.0,
          "Largest travel of the body over a stance foot, as a share of the leg length; higher speeds shorten the "
          "cycle."},
         {"cycle_step_s", &cycle_step_s, "s", 0.0, 0.05,
          "The cycle is rounded to a multiple of this time, so that it fits the plan's grid; 0 does not round."}});
  }
};

/// The gait of that name fitted to a robot and speed. "walk" is the one for its number of legs, "" its best; a name
/// that ends in .yaml is a file whose first gait is taken, FILE.yaml:NAME another one. Gaits that no file lists are
/// made for any number of feet, see GeneratedGaits. Failure kBadInput lists what exists for this number of feet.
Result<Gait> FindGait(const RobotModel& model, const std::string& name, double speed_m_s, const GaitOptions& options);

/// The file of such a name; empty for a gait name.
std::string GaitFileOf(const std::string& name);

/// Shortest cycle that the gait may be given for a robot [s]: half of its default if that scales with the leg, else the
/// given one.
Result<double> ShortestCycle(const RobotModel& model, const std::string& name, const GaitOptions& options);

/// Longest cycle that the gait may be given for a robot [s]: twice its default if that scales with the leg, else the
/// given one.
Result<double> LongestCycle(const RobotModel& model, const std::string& name, const GaitOptions& options);

/// Largest stride of a gait if no speed is given [m]; 0 if the gait has no default stride.
Result<double> OwnStride(const RobotModel& model, const std::string& name);

}  // namespace gaitwright
