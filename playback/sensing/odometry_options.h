// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"

namespace gaitwright {

/// What LegOdometry takes for granted beside the sensors' own data sheet (SensorOptions).
///
/// Tuning
///   drifts or turns off slowly while it walks     lower stance_slip_m_s_sqrt_hz, where feet do not slip
///   jumps when feet land                          raise landing_slip_m_s_sqrt_hz or trust_s
///   follows a foot that slides                    lower gate
///   leans on sloping ground                       raise start_tilt_rad
struct OdometryOptions {
  double stance_slip_m_s_sqrt_hz = 0.002;
  double landing_slip_m_s_sqrt_hz = 0.1;
  double stance_turn_rad_s_sqrt_hz = 0.01;
  double landing_turn_rad_s_sqrt_hz = 0.5;
  double trust_s = 0.02;
  double trust_load = 0.1;
  double model_error_m = 0.0002;
  double gate = 5.0;
  double start_tilt_rad = 0.02;
  double terrain_height_m = 0.0;

  OptionFields Fields() {
    return {
        {"stance_slip_m_s_sqrt_hz",
         &stance_slip_m_s_sqrt_hz,
         "m/s/sqrt(Hz)",
         1e-5,
         1.0,
         "How a foot that stands firmly may creep, as white noise of its velocity.",
         {}},
        {"landing_slip_m_s_sqrt_hz",
         &landing_slip_m_s_sqrt_hz,
         "m/s/sqrt(Hz)",
         1e-5,
         10.0,
         "The same of one that has just landed or is about to leave.",
         {}},
        {"stance_turn_rad_s_sqrt_hz",
         &stance_turn_rad_s_sqrt_hz,
         "rad/s/sqrt(Hz)",
         1e-5,
         10.0,
         "How a sole that stands firmly may turn or rock.",
         {}},
        {"landing_turn_rad_s_sqrt_hz",
         &landing_turn_rad_s_sqrt_hz,
         "rad/s/sqrt(Hz)",
         1e-5,
         100.0,
         "The same of one that has just landed or is about to leave.",
         {}},
        {"trust_s", &trust_s, "s", 0.0, 1.0, "Time in contact until a foot stands firmly.", {}},
        {"trust_load", &trust_load, "1", 0.0, 1.0, "Share of the robot's weight on a foot that stands firmly.", {}},
        {"model_error_m",
         &model_error_m,
         "m",
         1e-6,
         0.1,
         "Error of a foot's place against the base beyond that of the encoders.",
         {}},
        {"gate",
         &gate,
         "1",
         1.0,
         100.0,
         "A foot that is more standard deviations than this from where it was has slipped, and is taken anew.",
         {}},
        {"start_tilt_rad",
         &start_tilt_rad,
         "rad",
         1e-4,
         1.0,
         "Error of the tilt with which the robot is put on its start, as a standard deviation.",
         {}},
        {"terrain_height_m",
         &terrain_height_m,
         "m",
         0.0,
         1.0,
         "Error of the planned ground's height where a foot lands, as a standard deviation; 0: it is not used.",
         {}},
    };
  }
};

}  // namespace gaitwright
