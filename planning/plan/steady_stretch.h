// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planning/plan/joined_plans.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A part of a plan in which the gait is periodic: each cycle repeats the motion at a new place.
struct SteadyStretch {
  double start_s = 0.0, cycle_s = 0.0;
  int cycles = 0;  ///< number of whole cycles, at least one

  double end_s() const { return start_s + cycles * cycle_s; }
};

/// Tolerance of periodicity: small enough that a seam between states one cycle apart passes the audit.
inline constexpr Seam kSteady = {
    .height_m = 2e-4, .tilt_rad = 1e-3, .joints = 1e-3, .base_rates = 5e-3, .joint_rates = 0.05};

/// Tolerance of a gait that repeats itself, but not exactly: motions of passes settle slowly.
inline constexpr Seam kNearlySteady = {
    .height_m = 0.02, .tilt_rad = 0.05, .joints = 0.1, .base_rates = 0.3, .joint_rates = 2.0};

/// Whether each component of a seam is within the limit.
bool Within(const Seam& seam, const Seam& limit);

/// The longest steady stretch of a part; it starts while the largest number of feet stand. Nothing if the part has no
/// such stretch, for example if its cycle is not a multiple of the plan's time step, or if it accelerates until its
/// end.
/// @throws InvalidArgument for an unknown part.
std::optional<SteadyStretch> SteadyStretchOf(const MotionPlan& plan, std::size_t part, const Seam& within = kSteady);

/// As SteadyStretchOf, within kNearlySteady and for any cycle, rounded to the plan's time step. Feet may land a row
/// earlier or later in one cycle than in the next, so that rates of joints may differ.
std::optional<SteadyStretch> NearlySteadyStretchOf(const MotionPlan& plan, std::size_t part);

/// The last time of a plan, a whole number of cycles after the start of a steady stretch, at which the state equals
/// that at the start within `within`. The next part is nearest from there.
double LastLikeStart(const MotionPlan& plan, const SteadyStretch& stretch, const Seam& within = kSteady);

/// The time in the last cycle of the steady stretch `of` at which the state is nearest to that of another plan at a
/// given time, with the same feet on the ground just before and after. Nothing if no time has the same feet on the
/// ground.
std::optional<double> SameMoment(const MotionPlan& plan, double time_s, const MotionPlan& in, const SteadyStretch& of);

}  // namespace gaitwright
