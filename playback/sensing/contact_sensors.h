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

/// What the feet tell of the ground.
struct ContactReading {
  FootSet contact = 0;
  std::vector<double> load_n;  ///< by foot: vertical force [N]; not negative
};

/// A sensor of vertical force in each foot, as pads under a sole or the torques of a leg's motors give it, and contact
/// from it by a threshold; with noise, rate, delay, and readings of contact that are wrong.
class ContactSensors {
 public:
  /// @param weight_n  of the robot, to which threshold and noise are shares.
  ContactSensors(std::size_t feet, double weight_n, const SensorOptions& options, double step_s);

  /// Once a step. @param contact, wrenches  the truth, as ControlInput has it.
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
