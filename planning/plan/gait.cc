// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/gait.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/base/result.h"

namespace gaitwright {

FootSet StanceAt(const Gait& gait, double cycle_fraction) {
  FootSet stance = 0;
  for (int foot = 0; foot < gait.num_feet(); ++foot) {
    const auto i = static_cast<std::size_t>(foot);
    const double since_touchdown = cycle_fraction - gait.phase[i] - std::floor(cycle_fraction - gait.phase[i]);
    if (since_touchdown < gait.duty_factor[i]) stance |= FootBit(foot);
  }
  return stance;
}

Gait StandingGait(int num_feet) {
  const auto feet = static_cast<std::size_t>(num_feet);
  return {"stand", "all feet on the ground", 1.0, std::vector<double>(feet, 0.0), std::vector<double>(feet, 1.0)};
}

bool StandsStill(const Gait& gait) {
  return !gait.duty_factor.empty() &&
         std::all_of(gait.duty_factor.begin(), gait.duty_factor.end(), [](double share) { return share >= 1.0; });
}

Gait HangingGait(int num_feet) {
  const auto feet = static_cast<std::size_t>(num_feet);
  return {"hang", "base held, no foot on the ground", 1.0, std::vector<double>(feet, 0.0),
          std::vector<double>(feet, 0.0)};
}

bool Hangs(const Gait& gait) {
  return !gait.duty_factor.empty() &&
         std::all_of(gait.duty_factor.begin(), gait.duty_factor.end(), [](double share) { return share <= 0.0; });
}

bool TurnsOver(const Gait& gait) { return gait.roll_turns != 0.0 || gait.pitch_turns != 0.0; }

bool HasFlight(const Gait& gait) {
  // The stance changes only at touch-downs and lift-offs, so it is enough to look just after each lift-off.
  for (std::size_t i = 0; i < gait.phase.size(); ++i) {
    const double after = gait.phase[i] + gait.duty_factor[i] + 1e-9;
    if (StanceAt(gait, after - std::floor(after)) == 0) return true;
  }
  return false;
}

int PhaseAt(const ContactSchedule& schedule, double time_s) {
  constexpr double kTiny = 1e-9;
  const auto after = std::upper_bound(schedule.phases.begin(), schedule.phases.end(), time_s + kTiny,
                                      [](double t, const ContactPhase& phase) { return t < phase.end_s; });
  const auto last = static_cast<std::ptrdiff_t>(schedule.phases.size()) - 1;
  return static_cast<int>(std::min(after - schedule.phases.begin(), last));
}

double LongestFlight(const ContactSchedule& schedule) {
  double longest_s = 0.0;
  for (const ContactPhase& phase : schedule.phases) {
    if (phase.stance == 0) longest_s = std::max(longest_s, phase.end_s - phase.start_s);
  }
  return longest_s;
}

std::vector<ContactInterval> IntervalsOf(const ContactSchedule& schedule, int foot) {
  std::vector<ContactInterval> intervals;
  for (const ContactPhase& phase : schedule.phases) {
    if (!Contains(phase.stance, foot)) continue;
    if (!intervals.empty() && intervals.back().end_s == phase.start_s) {
      intervals.back().end_s = phase.end_s;
    } else {
      intervals.push_back({phase.start_s, phase.end_s});
    }
  }
  return intervals;
}

ContactSchedule ScheduleFromIntervals(const std::vector<std::vector<ContactInterval>>& by_foot, double start_s,
                                      double end_s) {
  std::vector<std::pair<double, FootSet>> changes = {{end_s, 0}};  // feet that land or lift off at a time
  FootSet stance = 0;
  for (std::size_t foot = 0; foot < by_foot.size(); ++foot) {
    const FootSet bit = FootBit(static_cast<int>(foot));
    for (const ContactInterval& interval : by_foot[foot]) {
      if (!(interval.end_s > interval.start_s)) continue;
      for (const double time_s : {interval.start_s, interval.end_s}) {
        if (time_s <= start_s) {
          stance ^= bit;
        } else {
          changes.emplace_back(time_s, bit);
        }
      }
    }
  }
  std::sort(changes.begin(), changes.end());
  ContactSchedule schedule;
  double since_s = start_s;
  for (const auto& [time_s, bit] : changes) {
    if (time_s > since_s && !schedule.phases.empty() && schedule.phases.back().stance == stance) {
      schedule.phases.back().end_s = time_s;
    } else if (time_s > since_s) {
      schedule.phases.push_back({since_s, time_s, stance});
    }
    since_s = std::max(since_s, time_s);
    stance ^= bit;
  }
  return schedule;
}

void CheckSchedule(const ContactSchedule& schedule, int num_feet) {
  if (schedule.phases.empty()) throw InvalidArgument("the contact schedule has no phase");
  for (std::size_t i = 0; i < schedule.phases.size(); ++i) {
    const ContactPhase& phase = schedule.phases[i];
    if (!(phase.end_s > phase.start_s)) {
      throw InvalidArgument(fmt::format("contact phase {} lasts from {} s to {} s; it must end after its start", i,
                                        phase.start_s, phase.end_s));
    }
    if ((phase.stance & ~AllFeet(num_feet)) != 0) {
      throw InvalidArgument(fmt::format("contact phase {} names a foot beyond the robot's {} feet", i, num_feet));
    }
    if (i > 0 && schedule.phases[i - 1].end_s != phase.start_s) {
      throw InvalidArgument(
          fmt::format("contact phase {} starts at {} s, but phase {} ends at {} s; the two times must be equal", i,
                      phase.start_s, i - 1, schedule.phases[i - 1].end_s));
    }
  }
}

}  // namespace gaitwright
