// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gaitwright {

/// Set of feet: bit i is foot i of RobotModel::feet.
using FootSet = std::uint64_t;

/// The set of one foot, 0 <= foot < 64.
inline constexpr FootSet FootBit(int foot) { return FootSet{1} << foot; }
/// Whether a foot is in the set.
inline constexpr bool Contains(FootSet set, int foot) { return (set >> foot & 1U) != 0; }
/// The set of feet 0 to count - 1; all 64 feet if count >= 64.
inline constexpr FootSet AllFeet(int count) { return count >= 64 ? ~FootSet{0} : FootBit(count) - 1; }

/// A periodic pattern of contact. Foot i touches down at `phase[i]` of the cycle and stays on the ground for
/// `duty_factor[i]` of the cycle.
struct Gait {
  std::string name;
  std::string description;
  double cycle_s = 0.5;             ///< [s]
  std::vector<double> phase;        ///< by foot, in [0, 1)
  std::vector<double> duty_factor;  ///< by foot, in (0, 1); all 1 for standing still, all 0 for hanging
  /// Turns of the body about its x axis (left side up first) and y axis (nose down first) in each cycle: whole numbers.
  double roll_turns = 0.0, pitch_turns = 0.0;

  int num_feet() const { return static_cast<int>(phase.size()); }
  bool operator==(const Gait&) const = default;
};

/// The feet on the ground at a cycle phase in [0, 1).
FootSet StanceAt(const Gait& gait, double cycle_fraction);

/// The gait "stand": standing still on all feet.
Gait StandingGait(int num_feet);

/// True when no foot ever leaves the ground.
bool StandsStill(const Gait& gait);

/// The gait "hang": the base is held in place from outside, as on a stand, and no foot is on the ground.
Gait HangingGait(int num_feet);

/// True when no foot is ever on the ground.
bool Hangs(const Gait& gait);

/// True when the body turns over in each cycle, as in a backflip.
bool TurnsOver(const Gait& gait);

/// True when some part of the cycle has no foot on the ground.
bool HasFlight(const Gait& gait);

/// An interval in which the same feet are on the ground.
struct ContactPhase {
  double start_s = 0.0, end_s = 0.0;
  FootSet stance = 0;

  bool operator==(const ContactPhase&) const = default;
};

/// Intervals of contact; each ends exactly where the next starts, and neighbours differ.
struct ContactSchedule {
  std::vector<ContactPhase> phases;

  double start_s() const { return phases.empty() ? 0.0 : phases.front().start_s; }
  double end_s() const { return phases.empty() ? 0.0 : phases.back().end_s; }
  bool operator==(const ContactSchedule&) const = default;
};

/// Index of the phase at `time_s`; a boundary belongs to the later phase. Clamped to the ends.
int PhaseAt(const ContactSchedule& schedule, double time_s);

/// The longest time without any foot on the ground [s]; 0 without flight.
double LongestFlight(const ContactSchedule& schedule);

/// An interval of contact of one foot.
struct ContactInterval {
  double start_s = 0.0, end_s = 0.0;

  bool operator==(const ContactInterval&) const = default;
};

/// All intervals of contact of a foot, in order.
std::vector<ContactInterval> IntervalsOf(const ContactSchedule& schedule, int foot);

/// The schedule made of each foot's intervals of contact (each sorted, disjoint, within [start_s, end_s]).
ContactSchedule ScheduleFromIntervals(const std::vector<std::vector<ContactInterval>>& by_foot, double start_s,
                                      double end_s);

/// @throws InvalidArgument when intervals do not abut exactly, are empty, or name a foot beyond `num_feet`.
void CheckSchedule(const ContactSchedule& schedule, int num_feet);

}  // namespace gaitwright
