// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "optimisation/centroidal/phase_ties.h"
#include "planning/footsteps/plan_footsteps.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// The cycle of a gait as durations of parts. A part lies between two times at which any foot lifts off or touches
/// down; the first part begins with the lift-off of a given foot. If the cycle repeats with other feet, as a trot does
/// after half of its cycle, the parts cover one repeat, so that the repetition is kept when durations change.
class GaitCycle {
 public:
  /// @param first_foot  foot whose lift-off is the start of the cycle. Each foot must swing (duty factor below 1).
  GaitCycle(const Gait& gait, int first_foot);

  /// Durations of the parts, in order; their sum is the cycle time divided by repeats() [s].
  const VectorX& durations_s() const { return durations_s_; }
  /// Number of repeats of the parts in a cycle, each with other feet.
  int repeats() const { return repeats_; }
  /// Number of occurrences of each part between the first lift-off and the lift-off of a foot in a cycle (0 for the
  /// first), or the touch-down after it.
  VectorX LiftOff(int foot, int cycle) const;
  VectorX TouchDown(int foot, int cycle) const;
  /// Largest share, in [0, 1], of the change from the gait's durations to others such that no swing becomes shorter
  /// than `least_swing` of its time or shortest_swing_s (or than it is, if that is less).
  double ShareKeepingSwings(const VectorX& to_s, double shortest_swing_s, double least_swing) const;
  /// The gait with other durations of the parts.
  Gait With(const VectorX& durations_s) const;

 private:
  /// An event of a cycle: the part that it begins, and the number of cycles after that of the lift-off.
  struct Event {
    Eigen::Index part = 0;
    int cycle = 0;
  };
  Event EventAt(double share, const std::vector<double>& begins) const;
  void Fold(const VectorX& all_s);
  VectorX Before(const Event& event, int cycle) const;

  const Gait gait_;
  int repeats_ = 1;
  VectorX durations_s_;
  std::vector<Event> lift_off_, touch_down_;  // by foot
};

/// Dependence of the phases of a walk on the gait cycle of one of its parts. Times before its first lift-off and after
/// its last touch-down are constant, except the final standing time, which changes so that the duration of the walk is
/// constant. Nothing if the contacts are not those of the gait.
/// @param switches_s  SwitchTimes of the walk's problem, from its start.
struct CycleTies {
  GaitCycle cycle;
  PhaseTies ties;
};
std::optional<CycleTies> TiesOf(const FootstepSkeleton& skeleton, std::size_t part,
                                const std::vector<double>& switches_s, double grid_s);

}  // namespace gaitwright
