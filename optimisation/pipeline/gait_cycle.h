// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "optimisation/centroidal/phase_ties.h"
#include "planning/footsteps/plan_footsteps.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// The cycle of a gait as durations: of the parts between the times at which any of its feet lifts off or touches down,
/// from the lift-off of one foot on. Where the cycle repeats itself with other feet, as a trot does after half of it,
/// the parts are those until then, so that at other durations it still does.
class GaitCycle {
 public:
  /// @param first_foot  the foot from whose lift-off on the cycle is counted. Each foot swings (a duty factor below 1).
  GaitCycle(const Gait& gait, int first_foot);

  /// Of the parts, in order; together the time of the cycle over its repeats [s].
  const VectorX& durations_s() const { return durations_s_; }
  /// How many times a cycle has the parts, each time with other feet.
  int repeats() const { return repeats_; }
  /// How many of each part lie between the first lift-off and that of a foot in a cycle (0 for the first), or the
  /// touch-down after it.
  VectorX LiftOff(int foot, int cycle) const;
  VectorX TouchDown(int foot, int cycle) const;
  /// Of the way from the durations of the gait to others, how far one may go so that no swing becomes shorter than
  /// `least_swing` of its time or shortest_swing_s, or than it is where that is less: in [0, 1].
  double ShareKeepingSwings(const VectorX& to_s, double shortest_swing_s, double least_swing) const;
  /// The gait with parts of other durations.
  Gait With(const VectorX& durations_s) const;

 private:
  /// An event of a cycle: which of its parts it begins, and in which cycle after that of the lift-off.
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

/// How the phases of a walk follow from the cycle of the gait of one of its parts: times before its first lift-off and
/// after its last touch-down stay, but that the time of standing at the end makes up for what others become longer or
/// shorter, so that the walk lasts as long. Nothing where its contacts are not those of the gait.
/// @param switches_s  SwitchTimes of the walk's problem, from its start on.
struct CycleTies {
  GaitCycle cycle;
  PhaseTies ties;
};
std::optional<CycleTies> TiesOf(const FootstepSkeleton& skeleton, std::size_t part,
                                const std::vector<double>& switches_s, double grid_s);

}  // namespace gaitwright
