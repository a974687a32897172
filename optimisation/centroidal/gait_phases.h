// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"

namespace gaitwright {

/// Contact switches closer than this are merged [s].
constexpr double kSameSwitch_s = 1e-4;

/// The times at which any contact or rest of a problem begins or ends, in order, with nearly equal times merged; the
/// first is 0 and the last the end. A phase lies between two of them.
std::vector<double> SwitchTimes(const RigidBodyProblem& problem);

/// Map of times from one schedule to another: linear between corresponding switches.
/// @param from, to  SwitchTimes, equal in number.
class TimeMap {
 public:
  TimeMap(std::vector<double> from, std::vector<double> to);

  /// The time of the other schedule.
  double At(double time_s) const;
  /// As above for a switch; merged switches get exactly the same time.
  double SwitchAt(double time_s) const;

 private:
  std::size_t Before(double time_s) const;

  std::vector<double> from_, to_;
};

/// The problem with switches at other times: stances, duration and initial path move with them. Rolling of contacts
/// stays evenly spread over their stances. Only for problems without leg angular momentum and motor limits, which
/// belong to given times (IsRetimable).
RigidBodyProblem Retimed(RigidBodyProblem problem, const TimeMap& map);

/// Whether only its stances and its path depend on time.
bool IsRetimable(const RigidBodyProblem& problem);

}  // namespace gaitwright
