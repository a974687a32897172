// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"

namespace gaitwright {

/// Switches of contact nearer to each other than this are one [s].
constexpr double kSameSwitch_s = 1e-4;

/// The times at which any contact or rest of a problem begins or ends, in order, those that are nearly the same taken
/// together; the first is 0 and the last the end. Between two of them is a phase.
std::vector<double> SwitchTimes(const RigidBodyProblem& problem);

/// Times of one schedule by those of another: straight between switches, each of which has its own in the other.
/// @param from, to  SwitchTimes, as many of both.
class TimeMap {
 public:
  TimeMap(std::vector<double> from, std::vector<double> to);

  /// The time of the other schedule.
  double At(double time_s) const;
  /// The same of a switch, whose time is exactly that of all that are one with it.
  double SwitchAt(double time_s) const;

 private:
  std::size_t Before(double time_s) const;

  std::vector<double> from_, to_;
};

/// The problem with switches at other times: stances, its duration and the way of its first guess go with them. How far
/// contacts roll stays spread evenly over their stances. Only for problems without inner momentum and limits of motors,
/// which follow from how legs move at given times (IsRetimable).
RigidBodyProblem Retimed(RigidBodyProblem problem, const TimeMap& map);

/// Whether nothing in it belongs to given times but its stances and its way.
bool IsRetimable(const RigidBodyProblem& problem);

}  // namespace gaitwright
