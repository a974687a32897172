// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/gait_cycles.h"

#include <algorithm>
#include <cmath>

#include "optimisation/search/pace.h"
#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

Gait GaitCycles::At(int number) const {
  Gait gait = fitted;
  const double last = number > 0 ? std::min(shortest_s, gait.cycle_s) : std::max(longest_s, gait.cycle_s);
  gait.cycle_s *= std::pow(last / gait.cycle_s, static_cast<double>(number) / (number > 0 ? kShortest : kLongest));
  if (step_s > 0.0) gait.cycle_s = step_s * std::max(1.0, std::round(gait.cycle_s / step_s));
  return gait;
}

Result<GaitCycles> FindCycles(const RobotModel& model, const WalkRequest& request, const WalkCommand& command) {
  const double speed = SpeedOfSteps(model, command);
  const Result<Gait> gait = FindGait(model, request.gait, speed, request.gait_options);
  if (!gait) return gait.failure();
  const Result<double> shortest = ShortestCycle(model, request.gait, request.gait_options);
  const Result<double> longest = LongestCycle(model, request.gait, request.gait_options);
  if (!shortest || !longest) return shortest ? longest.failure() : shortest.failure();
  // For steps of a given length, a shorter cycle has no advantage.
  const double least_s =
      PaceOf(command) == Pace::kStepLength ? gait->cycle_s : std::max(*shortest, 0.5 * gait->cycle_s);
  return GaitCycles{*gait, least_s, *longest, request.gait_options.cycle_step_s};
}

}  // namespace gaitwright
