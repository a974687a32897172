// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/steady_stretch.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace gaitwright {
namespace {

constexpr double kTime = 1e-6;  // [s]

/// Sum of the components of a seam, each relative to its limit in kSteady.
double Worth(const Seam& seam) {
  return seam.height_m / kSteady.height_m + seam.tilt_rad / kSteady.tilt_rad + seam.joints / kSteady.joints +
         seam.base_rates / kSteady.base_rates + seam.joint_rates / kSteady.joint_rates;
}

/// The same stretch, moved to start in the middle of the longest phase of its first cycle in which the most feet stand.
/// There the seam between two cycles cuts the fewest swings, and the standing feet are the same on both sides.
SteadyStretch AtItsStance(const MotionPlan& plan, const SteadyStretch& stretch, double last_s) {
  const WholeBodyTrajectory& w = plan.whole_body;
  SteadyStretch best = stretch;
  std::pair<int, double> most = {-1, 0.0};
  for (const ContactPhase& phase : plan.schedule.phases) {
    const double middle_s = 0.5 * (phase.start_s + phase.end_s);
    const double start_s = w.start_s + std::round((middle_s - w.start_s) / w.step_s) * w.step_s;
    const int cycles = static_cast<int>(std::floor((last_s - start_s + kTime) / stretch.cycle_s));
    if (start_s < stretch.start_s - kTime || start_s > stretch.start_s + stretch.cycle_s || cycles < 1) continue;
    const std::pair<int, double> here = {std::popcount(phase.stance), phase.end_s - phase.start_s - kTime};
    if (here <= most) continue;
    most = {here.first, phase.end_s - phase.start_s};
    best = {start_s, stretch.cycle_s, cycles};
  }
  return best;
}

const MotionPart& PartOf(const MotionPlan& plan, std::size_t part) {
  if (part >= plan.parts.size())
    throw InvalidArgument(fmt::format("part {} does not exist in a plan of {} parts", part, plan.parts.size()));
  return plan.parts[part];
}

/// The longest stretch in which states one cycle apart, to the nearest row, are equal within `within`.
/// @param same_stance  whether the same feet must stand, too.
std::optional<SteadyStretch> LongestRepeating(const MotionPlan& plan, const MotionPart& asked, const Seam& within,
                                              bool same_stance) {
  const WholeBodyTrajectory& w = plan.whole_body;
  const auto count = static_cast<int>(std::round(asked.gait.cycle_s / w.step_s));
  if (StandsStill(asked.gait) || count < 1) return std::nullopt;
  const double cycle_s = count * w.step_s;
  const int first = std::max(0, static_cast<int>(std::ceil((asked.start_s - w.start_s - kTime) / w.step_s)));
  const int last = std::min(w.size() - 1, static_cast<int>(std::floor((asked.end_s - w.start_s + kTime) / w.step_s)));
  const auto time = [&](int row) { return w.start_s + row * w.step_s; };
  SteadyStretch longest;
  int begun = first, last_row = first;
  for (int row = first; row + count <= last; ++row) {
    const bool repeats = (!same_stance || SameStance(plan, time(row), plan, time(row + count))) &&
                         Within(SeamBetween(plan, time(row), plan, time(row + count)), within);
    if (!repeats) {
      begun = row + 1;
      continue;
    }
    const int cycles = (row - begun) / count + 1;
    if (cycles > longest.cycles) longest = {time(begun), cycle_s, cycles};
    if (longest.start_s == time(begun)) last_row = row + count;
  }
  if (longest.cycles == 0) return std::nullopt;
  return AtItsStance(plan, longest, time(last_row));
}

}  // namespace

bool Within(const Seam& seam, const Seam& limit) {
  return seam.height_m <= limit.height_m && seam.tilt_rad <= limit.tilt_rad && seam.joints <= limit.joints &&
         seam.base_rates <= limit.base_rates && seam.joint_rates <= limit.joint_rates;
}

std::optional<SteadyStretch> SteadyStretchOf(const MotionPlan& plan, std::size_t part, const Seam& within) {
  const MotionPart& asked = PartOf(plan, part);
  if (std::abs(std::remainder(asked.gait.cycle_s, plan.whole_body.step_s)) > kTime) return std::nullopt;
  return LongestRepeating(plan, asked, within, true);
}

std::optional<SteadyStretch> NearlySteadyStretchOf(const MotionPlan& plan, std::size_t part) {
  Seam within = kNearlySteady;
  within.joint_rates = std::numeric_limits<double>::infinity();  // at a landing, a row makes a large difference
  return LongestRepeating(plan, PartOf(plan, part), within, false);
}

double LastLikeStart(const MotionPlan& plan, const SteadyStretch& stretch, const Seam& within) {
  double last_s = stretch.end_s();
  for (double at_s = last_s; at_s < plan.whole_body.end_s(); at_s += stretch.cycle_s) {
    if (SameStance(plan, stretch.start_s, plan, at_s) && Within(SeamBetween(plan, stretch.start_s, plan, at_s), within))
      last_s = at_s;
  }
  return last_s;
}

std::optional<double> SameMoment(const MotionPlan& plan, double time_s, const MotionPlan& in, const SteadyStretch& of) {
  const double step_s = in.whole_body.step_s;
  std::optional<double> same;
  double least = 0.0;
  for (int row = 0; row < static_cast<int>(std::lround(of.cycle_s / step_s)); ++row) {
    const double at_s = of.end_s() - of.cycle_s + row * step_s;
    if (!SameStance(plan, time_s, in, at_s)) continue;
    const double worth = Worth(SeamBetween(plan, time_s, in, at_s));
    if (same && worth >= least) continue;
    same = at_s;
    least = worth;
  }
  return same;
}

}  // namespace gaitwright
