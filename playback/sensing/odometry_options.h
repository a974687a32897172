// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"

namespace gaitwright {

/// Assumptions of LegOdometry, in addition to the sensors' data (SensorOptions).
///
/// Tuning
///   drifts slowly in place or heading             lower stance_slip_m_s_sqrt_hz if feet do not slip
///   jumps when feet land                          raise landing_slip_m_s_sqrt_hz or trust_s
///   follows a foot that slides                    lower gate
///   leans on sloping ground                       raise start_tilt_rad
struct OdometryOptions {
  double stance_slip_m_s_sqrt_hz = 0.002;
  double landing_slip_m_s_sqrt_hz = 0.1;
  double stance_turn_rad_s_sqrt_hz = 0.1;
  double landing_turn_rad_s_sqrt_hz = 0.5;
  double trust_s = 0.02;
  double trust_load = 0.1;
  double model_error_m = 0.0002;
  double gate = 5.0;
  double start_tilt_rad = 0.02;
  double terrain_height_m = 0.0;

  OptionFields Fields() {
    return WithBasics(
        {},
        {
            {"stance_slip_m_s_sqrt_hz", &stance_slip_m_s_sqrt_hz, "m/s/sqrt(Hz)", 1e-5, 1.0,
             "Slip velocity of a foot in firm stance, as a white-noise density."},
            {"landing_slip_m_s_sqrt_hz", &landing_slip_m_s_sqrt_hz, "m/s/sqrt(Hz)", 1e-5, 10.0,
             "Slip velocity of a foot that has just landed or is about to lift off, as a white-noise density."},
            {"stance_turn_rad_s_sqrt_hz", &stance_turn_rad_s_sqrt_hz, "rad/s/sqrt(Hz)", 1e-5, 10.0,
             "Rotation rate of a sole in firm stance, as a white-noise density."},
            {"landing_turn_rad_s_sqrt_hz", &landing_turn_rad_s_sqrt_hz, "rad/s/sqrt(Hz)", 1e-5, 100.0,
             "Rotation rate of a sole that has just landed or is about to lift off, as a white-noise density."},
            {"trust_s", &trust_s, "s", 0.0, 1.0, "Time in contact after which a foot counts as in firm stance."},
            {"trust_load", &trust_load, "1", 0.0, 1.0,
             "Smallest load of a foot in firm stance, as a share of the robot's weight."},
            {"model_error_m", &model_error_m, "m", 1e-6, 0.1,
             "Standard deviation of a foot's position relative to the base, in addition to encoder errors."},
            {"gate", &gate, "1", 1.0, 100.0,
             "Number of standard deviations beyond which a moved foot counts as slipped and its position is "
             "initialised again."},
            {"start_tilt_rad", &start_tilt_rad, "rad", 1e-4, 1.0,
             "Standard deviation of the base's tilt at the start."},
            {"terrain_height_m", &terrain_height_m, "m", 0.0, 1.0,
             "Standard deviation of the planned ground height where a foot lands; 0 does not use the planned height."},
        });
  }
};

}  // namespace gaitwright
