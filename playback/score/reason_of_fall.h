// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/measurements.h"

namespace gaitwright {

/// An event that preceded a failure.
struct FailureEvent {
  enum class Kind {
    kPlanUnstable,        ///< the plan's own ZMP is outside its support
    kPlanBeyondLimits,    ///< the plan itself exceeds a position or torque limit
    kPlanBeyondFriction,  ///< the plan itself needs more friction than the ground has
    kPlanForcesOff,       ///< the plan's torques or contact forces do not match its motion
    kContactLost,         ///< a foot was off the ground during a scheduled stance
    kEarlyContact,        ///< a foot touched the ground in mid swing
    kMissedFoothold,      ///< a foot came down off its foothold
    kSlip,                ///< a foot slid further than the gate allows
    kTorqueLimit,         ///< a joint stayed at its limit
    kDcmOut,              ///< no step of the plan could catch the DCM
    kBodyContact,         ///< a body that is not a foot touched the ground
  };
  Kind kind = Kind::kContactLost;
  double time_s = 0.0;
  std::string text;  ///< "at 2.41 s 'l_ankle' was off the ground, although the schedule has it in stance"
};

/// The first event of each kind before the fall (or the end), in order of time.
std::vector<FailureEvent> FailureEvents(const ScoreInputs& in);

}  // namespace gaitwright
