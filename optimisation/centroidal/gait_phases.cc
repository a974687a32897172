// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/gait_phases.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaitwright {

std::vector<double> SwitchTimes(const RigidBodyProblem& problem) {
  std::vector<double> times;
  for (const RigidStance& stance : problem.stances) times.insert(times.end(), {stance.start_s, stance.end_s});
  for (const RigidRest& rest : problem.rests) times.insert(times.end(), {rest.start_s, rest.end_s});
  std::sort(times.begin(), times.end());
  std::vector<double> switches = {0.0};
  for (const double t : times) {
    if (t > switches.back() + kSameSwitch_s && t < problem.duration_s - kSameSwitch_s) switches.push_back(t);
  }
  switches.push_back(problem.duration_s);
  return switches;
}

TimeMap::TimeMap(std::vector<double> from, std::vector<double> to) : from_(std::move(from)), to_(std::move(to)) {}

std::size_t TimeMap::Before(double time_s) const {
  return static_cast<std::size_t>(std::upper_bound(from_.begin() + 1, from_.end() - 1, time_s) - from_.begin()) - 1;
}

double TimeMap::At(double time_s) const {
  const std::size_t k = Before(time_s);
  const double u = (time_s - from_[k]) / (from_[k + 1] - from_[k]);
  return (1.0 - u) * to_[k] + u * to_[k + 1];
}

double TimeMap::SwitchAt(double time_s) const {
  const std::size_t k = Before(time_s);
  if (std::abs(time_s - from_[k]) <= kSameSwitch_s) return to_[k];
  if (std::abs(time_s - from_[k + 1]) <= kSameSwitch_s) return to_[k + 1];
  return At(time_s);
}

RigidBodyProblem Retimed(RigidBodyProblem problem, const TimeMap& map) {
  for (RigidStance& stance : problem.stances) {
    stance.start_s = map.SwitchAt(stance.start_s);
    stance.end_s = map.SwitchAt(stance.end_s);
  }
  for (RigidRest& rest : problem.rests) {
    rest.start_s = map.SwitchAt(rest.start_s);
    rest.end_s = map.SwitchAt(rest.end_s);
  }
  for (double& t : problem.path.time_s) t = map.At(t);
  problem.duration_s = map.SwitchAt(problem.duration_s);
  return problem;
}

bool IsRetimable(const RigidBodyProblem& problem) {
  return problem.leg_momentum_W.empty() && problem.clearances.empty() &&
         std::all_of(problem.stances.begin(), problem.stances.end(),
                     [](const RigidStance& stance) { return stance.motors.empty(); });
}

}  // namespace gaitwright
