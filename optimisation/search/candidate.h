// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace gaitwright {

/// A variation of a walk; the search for a sound plan evaluates variations one after the other.
struct Candidate {
  double pace = 0.0;    ///< in the unit of the command's speed, see PaceOf
  int cycle = 0;        ///< index of the gait's cycle, see GaitCycles
  double flight = 1.0;  ///< factor of the gait's flight times; 0: its duty factors at speed zero
  /// Footholds are free instead of held, or held instead of free (MotionOptions::footholds).
  bool other_footholds = false;
  bool finishes = false;      ///< the whole body is optimised (`trajectory.method=whole-body`)
  double heel_off_rad = 0.0;  ///< larger value of `trajectory.heel_off_rad`, with `finishes`

  bool operator==(const Candidate&) const = default;
};

/// How a candidate is evaluated, in the order of the cost. A candidate that a cheaper evaluation refuses is refused by
/// all others.
enum class Effort {
  kStartLook,  ///< a few passes of a rigid body for the start of the walk; every violated limit refuses
  kFirstLook,  ///< a few passes of a rigid body; clearly violated limits refuse
  kStart,      ///< the start of the walk, planned coarsely and audited
  kWhole,      ///< the whole walk, planned and audited
};

/// A row of a table of candidates: changes to the requested walk.
struct Variation {
  double pace_share = 1.0;  ///< factor of the requested speed
  int cycle = 0;
  double flight = 1.0;
  bool other_footholds = false;
  bool finishes = false;
  double heel_off_rad = 0.0;
};

/// Properties of a walk that decide which candidates may be better.
struct SearchSituation {
  enum class Kind {
    kLevel,   ///< a pendulum's motion on level ground
    kUneven,  ///< a pendulum's motion over other ground
    kFlying,  ///< the motion of a rigid body, with or without flight
  };
  Kind kind = Kind::kLevel;
  bool refused_by_ground = false;  ///< friction or support forbids the requested walk, not the robot's limits
  bool may_slow_down = false;      ///< the request does not set the speed
  bool may_vary_flight = false;    ///< counted leaps on uneven ground, with no flight time in the request
  bool may_move_feet = false;      ///< footholds on uneven ground that may be held or free
  bool may_raise_heels = false;    ///< soles that step forward
};

/// Candidates that replace the requested walk, in the order of their evaluation. For violated joint limits, shorter
/// cycles come before longer ones; for too little friction or support, longer cycles. On uneven ground the terrain
/// determines the step length, so only longer cycles are tried, and fewer of them, because each takes longer to plan.
/// For leaps onto other ground, longer or shorter flights are tried; for motions of a rigid body over uneven ground,
/// footholds that move on their patches.
std::span<const Variation> VariationsFor(const SearchSituation& situation);

/// Candidates for which the whole body is optimised. They cost seconds, and can walk where the passes of the pendulum
/// exceed limits of joints and motors. None for motions of a rigid body, which are always finished so.
std::span<const Variation> FinishedVariationsFor(const SearchSituation& situation);

/// Evaluation of a variation before the whole walk is planned; kWhole for none.
Effort EarlyCheckOf(SearchSituation::Kind kind);

}  // namespace gaitwright
