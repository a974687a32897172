// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/dynamic_motion.h"

#include <cmath>

namespace gaitwright {
namespace {

bool IsAskedFor(const CentreOfMassOptions& options) { return options.method == "rigid-body"; }

}  // namespace

bool IsDynamic(const ContactSchedule& schedule, const CentreOfMassOptions& options) {
  if (IsAskedFor(options)) return true;
  for (std::size_t i = 1; i < schedule.phases.size(); ++i) {
    if ((schedule.phases[i - 1].stance & schedule.phases[i].stance) == 0) return true;
  }
  return false;
}

bool IsDynamic(const Gait& gait, const CentreOfMassOptions& options) {
  constexpr double kBeside = 1e-9;
  if (IsAskedFor(options)) return true;
  if (StandsStill(gait)) return false;
  // The number of stance feet decreases only at lift-offs.
  for (std::size_t i = 0; i < gait.phase.size(); ++i) {
    const double lift_off = gait.phase[i] + gait.duty_factor[i];
    const auto carrying = [&](double cycles) { return StanceAt(gait, cycles - std::floor(cycles)); };
    if ((carrying(lift_off - kBeside) & carrying(lift_off + kBeside)) == 0) return true;
  }
  return false;
}

}  // namespace gaitwright
