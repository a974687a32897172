// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planning/plan/joined_plans.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A part of a plan in which a gait is periodic: each cycle repeats the motion, farther along.
struct SteadyStretch {
  double start_s = 0.0, cycle_s = 0.0;
  int cycles = 0;  ///< whole ones, one or more

  double end_s() const { return start_s + cycles * cycle_s; }
};

/// Tolerance of periodicity: small enough that a seam between states one cycle apart passes the audit.
inline constexpr Seam kSteady = {
    .height_m = 2e-4, .tilt_rad = 1e-3, .joints = 1e-3, .base_rates = 5e-3, .joint_rates = 0.05};

/// Whether no component of a seam is more than that of a limit.
bool Within(const Seam& seam, const Seam& limit);

/// The longest such stretch of a part, from a moment at which as many feet stand as ever do; nothing where it has none,
/// as where its cycle is no multiple of the plan's time step, or where it gains speed to its end.
/// @throws InvalidArgument for a part that does not exist.
std::optional<SteadyStretch> SteadyStretchOf(const MotionPlan& plan, std::size_t part, const Seam& within = kSteady);

/// The last moment of a plan, whole cycles after the start of a steady stretch of it, at which all is as it was there,
/// as nearly as `within`: from which it is the least way to what comes next.
double LastLikeStart(const MotionPlan& plan, const SteadyStretch& stretch, const Seam& within = kSteady);

/// When in the last cycle of a steady stretch `of` the robot does what it does at a time of another plan, as nearly as
/// there is: the same feet are on the ground just before and after. Nothing where none has them so.
std::optional<double> SameMoment(const MotionPlan& plan, double time_s, const MotionPlan& in, const SteadyStretch& of);

}  // namespace gaitwright
