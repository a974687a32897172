// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/gait.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

bool HasFlight(const Gait& gait) {
  // The stance changes only at touch-downs and lift-offs: looking just after each lift-off is enough.
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
  std::vector<double> times = {start_s, end_s};
  for (const auto& intervals : by_foot) {
    for (const ContactInterval& interval : intervals) {
      times.push_back(interval.start_s);
      times.push_back(interval.end_s);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  ContactSchedule schedule;
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const double middle = 0.5 * (times[k] + times[k + 1]);
    FootSet stance = 0;
    for (std::size_t foot = 0; foot < by_foot.size(); ++foot) {
      for (const ContactInterval& interval : by_foot[foot]) {
        if (interval.start_s < middle && middle < interval.end_s) stance |= FootBit(static_cast<int>(foot));
      }
    }
    if (!schedule.phases.empty() && schedule.phases.back().stance == stance) {
      schedule.phases.back().end_s = times[k + 1];
    } else {
      schedule.phases.push_back({times[k], times[k + 1], stance});
    }
  }
  return schedule;
}

void CheckSchedule(const ContactSchedule& schedule, int num_feet) {
  if (schedule.phases.empty()) throw InvalidArgument("the contact schedule has no phase");
  for (std::size_t i = 0; i < schedule.phases.size(); ++i) {
    const ContactPhase& phase = schedule.phases[i];
    if (!(phase.end_s > phase.start_s)) {
      throw InvalidArgument(fmt::format("contact phase {} lasts from {} s to {} s", i, phase.start_s, phase.end_s));
    }
    if ((phase.stance & ~AllFeet(num_feet)) != 0) {
      throw InvalidArgument(fmt::format("contact phase {} names a foot beyond the {} there are", i, num_feet));
    }
    if (i > 0 && schedule.phases[i - 1].end_s != phase.start_s) {
      throw InvalidArgument(fmt::format("contact phase {} starts at {} s, the one before ends at {} s", i,
                                        phase.start_s, schedule.phases[i - 1].end_s));
    }
  }
}

}  // namespace gaitwright
