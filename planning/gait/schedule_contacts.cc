// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/schedule_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gaitwright {
namespace {

struct Swing {
  double liftoff_s, touchdown_s;
  int foot;
};

double Fraction(double x) { return x - std::floor(x); }

/// Lift-off of each foot, as a share of the cycle.
std::vector<double> Liftoffs(const Gait& gait) {
  std::vector<double> liftoff(gait.phase.size());
  for (std::size_t i = 0; i < liftoff.size(); ++i) liftoff[i] = Fraction(gait.phase[i] + gait.duty_factor[i] + 1e-12);
  return liftoff;
}

/// Lift-offs as shares of the cycle that begins when `first_foot` lifts.
std::vector<double> LiftoffsFrom(const Gait& gait, int first_foot) {
  std::vector<double> liftoff = Liftoffs(gait);
  const double first = first_foot < 0 ? *std::min_element(liftoff.begin(), liftoff.end())
                                      : liftoff[static_cast<std::size_t>(first_foot)];
  for (double& at : liftoff) at = (at < first - 1e-9 ? 1.0 : 0.0) + at - first;
  return liftoff;
}

/// Swings in order of lift-off, the first at time zero.
std::vector<Swing> Swings(const GaitStint& stint) {
  const Gait& gait = stint.gait;
  const std::vector<double> liftoff = LiftoffsFrom(gait, stint.first_foot);
  std::vector<Swing> swings;
  const int cycles =
      stint.footfalls > 0 ? 1 + stint.footfalls / gait.num_feet() : 1 + static_cast<int>(stint.time_s / gait.cycle_s);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (int foot = 0; foot < gait.num_feet(); ++foot) {
      const auto i = static_cast<std::size_t>(foot);
      const double start = (cycle + liftoff[i]) * gait.cycle_s;
      swings.push_back({start, start + (1.0 - gait.duty_factor[i]) * gait.cycle_s, foot});
    }
  }
  std::stable_sort(swings.begin(), swings.end(),
                   [](const Swing& a, const Swing& b) { return a.liftoff_s < b.liftoff_s - 1e-9; });
  if (stint.footfalls > 0) {
    swings.resize(static_cast<std::size_t>(stint.footfalls));
  } else {
    std::erase_if(swings, [&](const Swing& swing) { return swing.liftoff_s > stint.time_s - 1e-6; });
  }
  return swings;
}

/// Touchdown times in ascending order.
std::vector<double> Touchdowns(const std::vector<Swing>& swings) {
  std::vector<double> touchdowns;
  for (const Swing& swing : swings) touchdowns.push_back(swing.touchdown_s);
  std::sort(touchdowns.begin(), touchdowns.end());
  return touchdowns;
}

/// The element of the ascending `times` that is nearest to `t`; the later one if two are equally near.
double Nearest(const std::vector<double>& times, double t) {
  const auto after = std::lower_bound(times.begin(), times.end(), t);
  if (after == times.begin()) return *after;
  if (after == times.end()) return times.back();
  const double before = *(after - 1);
  return t - before < *after - t - 1e-9 ? before : *after;
}

/// Failure if the grid is too coarse for a gait.
std::optional<Failure> CheckGrid(const Gait& gait, double grid_s) {
  constexpr double kLeast = 2.0;  // least number of grid steps in each swing and stance
  for (std::size_t i = 0; i < gait.phase.size(); ++i) {
    const double share = std::min(gait.duty_factor[i], 1.0 - gait.duty_factor[i]);
    if (share * gait.cycle_s >= kLeast * grid_s * (1.0 - 1e-9)) continue;
    const bool swing = gait.duty_factor[i] > 0.5;
    return Failure{
        FailureKind::kBadInput,
        FailureCode::kGait,
        "ScheduleContacts",
        fmt::format("in gait '{}', the {} of foot {} lasts {:.3g} s, less than two steps of the plan's grid ({:.3g} s)",
                    gait.name, swing ? "swing" : "stance", i, share * gait.cycle_s, grid_s),
        {fmt::format("a cycle of {:.3g} s or more (gait.cycle_s)", kLeast * grid_s / share),
         fmt::format("a {} duty factor (gait.duty_factor)", swing ? "smaller" : "larger")}};
  }
  return std::nullopt;
}

/// Appends stints to one schedule.
class Joiner {
 public:
  Joiner(int num_feet, const ScheduleEnds& ends)
      : ends_(ends),
        feet_(static_cast<std::size_t>(num_feet)),
        by_foot_(feet_),
        down_s_(feet_, 0.0),
        free_s_(ends.initial_stand_s) {}

  void Add(const GaitStint& stint) { StandsStill(stint.gait) ? Stand(stint.time_s) : Walk(stint); }

  JoinedSchedule Finish() {
    const double end = former_ == nullptr ? OnGrid(free_s_) : OnGrid(free_s_ + ends_.final_stand_s);
    for (std::size_t i = 0; i < feet_; ++i) by_foot_[i].push_back({down_s_[i], end});
    return {ScheduleFromIntervals(by_foot_, 0.0, end), start_s_};
  }

 private:
  /// Rounds halves up with a tolerance, so that equal times stay equal in spite of rounding errors.
  double OnGrid(double t) const { return std::floor(t / ends_.grid_s + 0.5 + 1e-6) * ends_.grid_s; }

  void Stand(double time_s) {
    const bool first = start_s_.empty();
    start_s_.push_back(first ? 0.0 : free_s_);
    free_s_ = (first ? 0.0 : free_s_) + time_s;
    former_ = nullptr;
  }

  void Walk(GaitStint stint) {
    double start = free_s_;
    if (former_ != nullptr) start = Follow(stint);
    start_s_.push_back(start_s_.empty() ? 0.0 : OnGrid(start));
    const std::vector<Swing> swings = Swings(stint);
    const std::vector<double> touchdowns = Touchdowns(swings);
    for (const Swing& swing : swings) {
      const auto i = static_cast<std::size_t>(swing.foot);
      // Keep the gait's time between the lift-off and the nearest touchdown, so that flights and double supports are
      // alike in every cycle.
      const double near = Nearest(touchdowns, swing.liftoff_s);
      by_foot_[i].push_back({down_s_[i], OnGrid(start + near) + OnGrid(swing.liftoff_s - near)});
      down_s_[i] = OnGrid(start + swing.touchdown_s);
      free_s_ = std::max(free_s_, down_s_[i]);
    }
    gait_ = stint.gait;
    former_ = &gait_;
  }

  /// Chooses the first foot with which a gait can begin earliest after the gait before. Returns the start time.
  double Follow(GaitStint& stint) const {
    double earliest = std::numeric_limits<double>::infinity();
    const int asked = stint.first_foot;
    for (int foot = 0; foot < stint.gait.num_feet(); ++foot) {
      if (asked >= 0 && foot != asked) continue;
      const double start = Earliest(stint.gait, LiftoffsFrom(stint.gait, foot));
      if (start > earliest - 1e-6) continue;
      earliest = start;
      stint.first_foot = foot;
    }
    return earliest;
  }

  /// Earliest start of a gait with these lift-offs.
  double Earliest(const Gait& gait, const std::vector<double>& liftoff) const {
    double start = free_s_;
    for (std::size_t i = 0; i < feet_; ++i) {
      const double least = std::min(gait.duty_factor[i] * gait.cycle_s, former_->duty_factor[i] * former_->cycle_s);
      start = std::max(start, down_s_[i] + least - liftoff[i] * gait.cycle_s);
    }
    return start;
  }

  const ScheduleEnds ends_;
  const std::size_t feet_;
  std::vector<std::vector<ContactInterval>> by_foot_;
  std::vector<double> down_s_;  // last touchdown of each foot
  double free_s_;               // when all feet are down and have stood for their full time
  std::vector<double> start_s_;
  Gait gait_;
  const Gait* former_ = nullptr;  // the gait before; null if the robot stands
};

}  // namespace

Result<ContactSchedule> ScheduleContacts(const Gait& gait, const ScheduleRequest& request) {
  Result<JoinedSchedule> joined = JoinSchedules({{gait, request.stepping_s, request.footfalls, request.first_foot}},
                                                {request.initial_stand_s, request.final_stand_s, request.grid_s});
  if (!joined) return joined.failure();
  return std::move(joined->schedule);
}

Result<JoinedSchedule> JoinSchedules(const std::vector<GaitStint>& stints, const ScheduleEnds& ends) {
  if (stints.empty())
    return Failure{FailureKind::kBadInput,
                   FailureCode::kGait,
                   "ScheduleContacts",
                   "the schedule contains no gait and no standing; give at least one part",
                   {}};
  Joiner joiner(stints.front().gait.num_feet(), ends);
  for (const GaitStint& stint : stints) {
    if (!StandsStill(stint.gait)) {
      if (auto failure = CheckGrid(stint.gait, ends.grid_s)) return *failure;
    }
    joiner.Add(stint);
  }
  return joiner.Finish();
}

}  // namespace gaitwright
