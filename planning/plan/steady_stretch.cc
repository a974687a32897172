// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/steady_stretch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

bool Within(const Seam& seam, const Seam& limit) {
  return seam.height_m <= limit.height_m && seam.tilt_rad <= limit.tilt_rad && seam.joints <= limit.joints &&
         seam.base_rates <= limit.base_rates && seam.joint_rates <= limit.joint_rates;
}

/// How many times what repeats itself it is, summed over what is told.
double Worth(const Seam& seam) {
  return seam.height_m / kSteady.height_m + seam.tilt_rad / kSteady.tilt_rad + seam.joints / kSteady.joints +
         seam.base_rates / kSteady.base_rates + seam.joint_rates / kSteady.joint_rates;
}

}  // namespace

std::optional<SteadyStretch> SteadyStretchOf(const MotionPlan& plan, std::size_t part, const Seam& within) {
  if (part >= plan.parts.size())
    throw InvalidArgument(fmt::format("there is no part {} in a plan of {}", part, plan.parts.size()));
  constexpr double kTime = 1e-6;
  const MotionPart& asked = plan.parts[part];
  const WholeBodyTrajectory& w = plan.whole_body;
  const double rows = asked.gait.cycle_s / w.step_s, cycle_rows = std::round(rows);
  if (StandsStill(asked.gait) || std::abs(rows - cycle_rows) * w.step_s > kTime || cycle_rows < 1.0)
    return std::nullopt;
  const auto count = static_cast<int>(cycle_rows);
  const double cycle_s = count * w.step_s;
  const int first = std::max(0, static_cast<int>(std::ceil((asked.start_s - w.start_s - kTime) / w.step_s)));
  const int last = std::min(w.size() - 1, static_cast<int>(std::floor((asked.end_s - w.start_s + kTime) / w.step_s)));
  const auto time = [&](int row) { return w.start_s + row * w.step_s; };
  SteadyStretch longest;
  int begun = first;
  for (int row = first; row + count <= last; ++row) {
    const bool repeats = SameStance(plan, time(row), plan, time(row + count)) &&
                         Within(SeamBetween(plan, time(row), plan, time(row + count)), within);
    if (!repeats) {
      begun = row + 1;
      continue;
    }
    const int cycles = (row - begun) / count + 1;
    if (cycles > longest.cycles) longest = {time(begun), cycle_s, cycles};
  }
  return longest.cycles == 0 ? std::nullopt : std::optional<SteadyStretch>(longest);
}

std::optional<double> SameMoment(const MotionPlan& plan, double time_s, const MotionPlan& in, const SteadyStretch& of) {
  const double step_s = in.whole_body.step_s;
  std::optional<double> same;
  double least = 0.0;
  for (int row = 0; row < static_cast<int>(std::lround(of.cycle_s / step_s)); ++row) {
    const double at_s = of.start_s + row * step_s;
    if (!SameStance(plan, time_s, in, at_s)) continue;
    const double worth = Worth(SeamBetween(plan, time_s, in, at_s));
    if (same && worth >= least) continue;
    same = at_s;
    least = worth;
  }
  return same;
}

}  // namespace gaitwright
