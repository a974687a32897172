// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "kinematics/model/robot_model.h"
#include "optimisation/pipeline/leg_motors.h"
#include "optimisation/swing/plan_swings.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// How a swing that is in part flight is shaped: see SwingCurve.
struct FlightSwing {
  double lift_m = 0.0;
  double cruise = 0.0;
};

/// The shapes of swings in gaits with flight. A foot is lifted by what its body rises in its flight too, and goes along
/// with it at constant speed for as long as that lasts. Where that would take more than 0.4 of what the motors give to
/// move all feet that are in the air then (FootAccelerationInFlight), it is lifted by less and, where even the body's
/// rise is too much, starts and ends more gently: the leg is then longer while it flies.
class FlightSwings {
 public:
  /// @param model, schedule  outlive this.
  FlightSwings(const RobotModel& model, const ContactSchedule& schedule, const SwingOptions& options);

  /// The shape of a swing, by its times in the schedule.
  FlightSwing At(double start_s, double end_s) const;

 private:
  double AccelerationOf(FootSet feet) const;

  const RobotModel& model_;
  const ContactSchedule& schedule_;
  const double lift_m_;
  const bool own_lift_;  // asked for
  mutable std::map<FootSet, double> acceleration_m_s2_;
};

}  // namespace gaitwright
