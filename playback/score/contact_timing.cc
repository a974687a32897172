// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/contact_timing.h"

#include <algorithm>
#include <cmath>

#include "playback/score/gates.h"

namespace gaitwright {
namespace {

double Overlap(const ContactInterval& a, const ContactInterval& b) {
  return std::min(a.end_s, b.end_s) - std::max(a.start_s, b.start_s);
}

/// Appends the errors of one scheduled stance.
void Compare(int foot, const ContactInterval& wanted, const std::vector<ContactInterval>& measured,
             const ContactInterval& motion, std::vector<TimingError>& errors) {
  constexpr double kSame = 1e-9;
  const auto best = std::max_element(measured.begin(), measured.end(), [&](const auto& a, const auto& b) {
    return Overlap(a, wanted) < Overlap(b, wanted);
  });
  const bool missed = best == measured.end() || Overlap(*best, wanted) <= 0.0;
  const double length = wanted.end_s - wanted.start_s;
  if (wanted.start_s > motion.start_s + kSame) {
    const double error = missed ? length : best->start_s - wanted.start_s;
    errors.push_back({foot, wanted.start_s, error, true, missed});
  }
  if (wanted.end_s < motion.end_s - kSame && !missed) {
    errors.push_back({foot, wanted.end_s, best->end_s - wanted.end_s, false, false});
  }
}

}  // namespace

std::vector<ScheduledSwing> SwingsOf(const ContactSchedule& schedule, int num_feet) {
  std::vector<ScheduledSwing> swings;
  for (int foot = 0; foot < num_feet; ++foot) {
    const std::vector<ContactInterval> stances = IntervalsOf(schedule, foot);
    for (std::size_t i = 1; i < stances.size(); ++i) swings.push_back({foot, stances[i - 1].end_s, stances[i].start_s});
  }
  return swings;
}

std::vector<ContactInterval> MeasuredIntervals(const PlaybackLog& log, int foot, double bridge_s) {
  std::vector<ContactInterval> intervals;
  for (const StanceRecord& stance : log.stances) {
    if (stance.foot != foot) continue;
    if (!intervals.empty() && stance.touchdown_s - intervals.back().end_s < bridge_s) {
      intervals.back().end_s = std::max(intervals.back().end_s, stance.liftoff_s);
    } else {
      intervals.push_back({stance.touchdown_s, stance.liftoff_s});
    }
  }
  return intervals;
}

std::vector<TimingError> TimingErrors(const ContactSchedule& schedule, const PlaybackLog& log, int num_feet,
                                      double end_s) {
  std::vector<TimingError> errors;
  const ContactInterval motion{schedule.start_s(), std::min(schedule.end_s(), end_s)};
  for (int foot = 0; foot < num_feet; ++foot) {
    const std::vector<ContactInterval> measured = MeasuredIntervals(log, foot, TimingGate());
    for (const ContactInterval& stance : IntervalsOf(schedule, foot)) {
      if (stance.start_s < motion.end_s - TimingGate()) Compare(foot, stance, measured, motion, errors);
    }
  }
  return errors;
}

std::vector<ScheduledSwing> ScuffedSwings(const ContactSchedule& schedule, const PlaybackLog& log, int num_feet,
                                          double ends_s, double end_s) {
  std::vector<ScheduledSwing> scuffed;
  for (const ScheduledSwing& swing : SwingsOf(schedule, num_feet)) {
    const ContactInterval middle{swing.liftoff_s + ends_s, std::min(swing.touchdown_s - ends_s, end_s)};
    const bool touched = std::any_of(log.stances.begin(), log.stances.end(), [&](const StanceRecord& stance) {
      return stance.foot == swing.foot && Overlap({stance.touchdown_s, stance.liftoff_s}, middle) > 0.0;
    });
    if (touched && middle.end_s > middle.start_s) scuffed.push_back(swing);
  }
  return scuffed;
}

double TimingGate() {
  static const double gate = RuleOf("contact_timing_error_max_s").limit;
  return gate;
}

}  // namespace gaitwright
