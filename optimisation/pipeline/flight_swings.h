// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "kinematics/model/robot_model.h"
#include "optimisation/pipeline/leg_motors.h"
#include "optimisation/swing/plan_swings.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// Shape of a swing that is partly in flight, see SwingCurve.
struct FlightSwing {
  double lift_m = 0.0;
  double cruise = 0.0;
};

/// Shapes of swings in gaits with flight. A foot is additionally lifted by the rise of the body in flight, and moves
/// with it at constant speed during the flight. If this needs more than 0.4 of the acceleration that the motors can
/// give all airborne feet (FootAccelerationInFlight), the lift is smaller and, if even the body's rise is too large,
/// the swing starts and ends more gently: the leg is then longer in flight. At least a tenth of the usual lift is kept,
/// so that feet leave the ground.
class FlightSwings {
 public:
  /// @param model, schedule  must outlive this object.
  FlightSwings(const RobotModel& model, const ContactSchedule& schedule, const SwingOptions& options);

  /// The shape of a swing, by its times in the schedule.
  FlightSwing At(double start_s, double end_s) const;

 private:
  double AccelerationOf(FootSet feet) const;

  const RobotModel& model_;
  const ContactSchedule& schedule_;
  const double lift_m_;
  const bool own_lift_;  // the lift is set by an option
  mutable std::map<FootSet, double> acceleration_m_s2_;
};

}  // namespace gaitwright
