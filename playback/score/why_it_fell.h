// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/measurements.h"

namespace gaitwright {

/// An event that preceded a failure.
struct FailureEvent {
  enum class Kind {
    kPlanUnstable,        ///< the plan's own ZMP is outside of its support
    kPlanBeyondLimits,    ///< the plan itself is past a limit of position or torque
    kPlanBeyondFriction,  ///< the plan itself asks the ground for more than friction holds
    kPlanForcesOff,       ///< the plan's torques or contact forces are not those that its motion needs
    kContactLost,         ///< a foot was off the ground where the schedule has it standing
    kEarlyContact,        ///< a foot touched in mid swing
    kMissedFoothold,      ///< a foot came down elsewhere
    kSlip,                ///< a foot slid further than the gate allows
    kTorqueLimit,         ///< a joint stayed at its limit
    kDcmOut,              ///< no step of the plan could catch the DCM any more
    kBodyContact,         ///< a body that is not a foot touched the ground
  };
  Kind kind = Kind::kContactLost;
  double time_s = 0.0;
  std::string text;  ///< "at 2.41 s 'l_ankle' was off the ground where the schedule has it standing"
};

/// The first event of each kind before the fall (or the end), in the order of time.
std::vector<FailureEvent> FailureEvents(const ScoreInputs& in);

}  // namespace gaitwright
