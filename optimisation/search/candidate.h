// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace gaitwright {

/// A variation of a walk, of which the search for a sound plan evaluates one after the other.
struct Candidate {
  double pace = 0.0;    ///< in the unit of the command's pace, see PaceOf
  int cycle = 0;        ///< number of the gait's cycle, see GaitCycles
  double flight = 1.0;  ///< factor of the gait's flight times; 0 for its duty factors at no speed

  bool operator==(const Candidate&) const = default;
};

/// How a candidate is evaluated, cheapest first. What a cheaper way refuses is refused by all later ones.
enum class Effort {
  kStartLook,  ///< a few passes of a rigid body, of the start of the walk; any limit that is passed refuses
  kFirstLook,  ///< a few passes of a rigid body; limits that are passed by far refuse
  kStart,      ///< the start of the walk, planned coarsely and audited
  kWhole,      ///< the whole walk, planned and audited
};

/// A row of a table of candidates: what is changed of the walk as asked for.
struct Variation {
  double pace_share = 1.0;  ///< of the pace asked for
  int cycle = 0;
  double flight = 1.0;
};

/// What decides which candidates may be better than the walk as asked for.
struct SearchSituation {
  enum class Kind {
    kLevel,   ///< a pendulum's motion on level ground
    kUneven,  ///< a pendulum's motion over other ground
    kFlying,  ///< the motion of a rigid body, with or without flight
  };
  Kind kind = Kind::kLevel;
  bool refused_by_ground = false;  ///< friction or support forbids the walk as asked for, not the robot's limits
  bool may_slow_down = false;      ///< nobody asked for the pace
  bool may_vary_flight = false;    ///< counted leaps off level ground, whose flight time nobody asked for
};

/// Candidates that replace the walk as asked for, in the order in which they are evaluated. What joints cannot do is
/// helped by quicker steps before slower ones, what the ground cannot hold by slower ones. Over uneven ground it is
/// the ground that says how long steps are, so that only slower ones are looked at, and fewer, since each takes longer.
/// Leaps onto other ground are helped by a longer or shorter flight.
std::span<const Variation> VariationsFor(const SearchSituation& situation);

/// How a variation is screened before the whole walk is planned; kWhole for no screening.
Effort ScreeningOf(SearchSituation::Kind kind);

}  // namespace gaitwright
