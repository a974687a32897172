// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/gait.h"
#include "planning/plan/motion_plan.h"
#include "playback/sensing/delay_line.h"
#include "playback/sensing/noise_stream.h"
#include "playback/sensing/sample_clock.h"
#include "playback/sensing/sensor_options.h"

namespace gaitwright {

/// Readings of the feet's contact sensors.
struct ContactReading {
  FootSet contact = 0;
  std::vector<double> load_n;  ///< by foot: vertical force [N]; not negative
};

/// A vertical force sensor in each foot, such as pads under a sole or the torques of a leg's motors, and contact from
/// its force by a threshold. With noise, rate, delay and wrong contact readings.
class ContactSensors {
 public:
  /// @param weight_n  of the robot; threshold and noise are shares of it.
  ContactSensors(std::size_t feet, double weight_n, const SensorOptions& options, double step_s);

  /// Call once per step. @param contact, wrenches  true values, as in ControlInput.
  const ContactReading& Read(FootSet contact, const std::vector<ContactWrench>& wrenches);

 private:
  void Sample(FootSet contact, const std::vector<ContactWrench>& wrenches);

  const SensorOptions options_;
  const double weight_n_;
  SampleClock clock_;
  NoiseStream noise_;
  ContactReading now_;
  DelayLine<ContactReading> delay_;
};

}  // namespace gaitwright
