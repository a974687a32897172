// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/gait/load_gaits.h"

namespace gaitwright {

/// Changes to a gait for one walk.
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

/// The gait with this name, fitted to the robot and the speed. "walk" is the default gait for the robot's number of
/// legs; an empty name is the best gait of the robot. A name that ends in .yaml is a file: its first gait is used, or
/// the gait NAME of FILE.yaml:NAME. GeneratedGaits makes further gaits for any number of feet. Failure kBadInput lists
/// the gaits for this number of feet.
Result<Gait> FindGait(const RobotModel& model, const std::string& name, double speed_m_s, const GaitOptions& options);

/// The file that a gait name refers to; empty if it refers to no file.
std::string GaitFileOf(const std::string& name);

/// Shortest accepted cycle of the gait for a robot [s]: half of its default if the default scales with the leg,
/// otherwise the fixed cycle of the gait or of `options`.
Result<double> ShortestCycle(const RobotModel& model, const std::string& name, const GaitOptions& options);

/// Longest accepted cycle of the gait for a robot [s]: twice its default if the default scales with the leg, otherwise
/// the fixed cycle of the gait or of `options`.
Result<double> LongestCycle(const RobotModel& model, const std::string& name, const GaitOptions& options);

/// Forward and lateral travel of a gait in each cycle [m]; nothing for a gait that goes where its command says.
Result<std::optional<std::array<double, 2>>> OwnTravel(const RobotModel& model, const std::string& name);

/// Largest stride of a gait without a given speed [m]; 0 if the gait has no default stride.
Result<double> OwnStride(const RobotModel& model, const std::string& name);

}  // namespace gaitwright
