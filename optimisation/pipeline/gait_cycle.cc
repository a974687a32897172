// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/gait_cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "optimisation/centroidal/gait_phases.h"

namespace gaitwright {
namespace {

constexpr double kOneEvent = 1e-6;  // share of the cycle; closer events are merged

double ShareOf(double cycles) { return cycles - std::floor(cycles); }

/// A contact switch of a walk, and the number of times that each part of the gait's cycle lies before it.
struct CountedSwitch {
  double time_s;
  VectorX before;
};

/// A foot's lift-off and the following touch-down.
struct FootSwing {
  int foot;
  double liftoff_s, touchdown_s;
};

/// The swings that begin in a part of a walk, by foot and in order of time.
std::vector<FootSwing> SwingsIn(const FootstepSkeleton& skeleton, std::size_t part) {
  constexpr double kSame = 1e-9;
  const MotionPart& within = skeleton.parts[part];
  std::vector<FootSwing> swings;
  for (int foot = 0; foot < within.gait.num_feet(); ++foot) {
    const std::vector<ContactInterval> stances = IntervalsOf(skeleton.schedule, foot);
    for (std::size_t k = 1; k < stances.size(); ++k) {
      const double liftoff_s = stances[k - 1].end_s;
      if (liftoff_s >= within.start_s - kSame && liftoff_s < within.end_s - kSame)
        swings.push_back({foot, liftoff_s, stances[k].start_s});
    }
  }
  return swings;
}

std::vector<CountedSwitch> CountedSwitches(const GaitCycle& cycle, const std::vector<FootSwing>& swings) {
  std::vector<CountedSwitch> switches;
  int number = 0;
  for (std::size_t k = 0; k < swings.size(); ++k) {
    number = k > 0 && swings[k].foot == swings[k - 1].foot ? number + 1 : 0;
    switches.push_back({swings[k].liftoff_s, cycle.LiftOff(swings[k].foot, number)});
    switches.push_back({swings[k].touchdown_s, cycle.TouchDown(swings[k].foot, number)});
  }
  return switches;
}

const VectorX* BeforeSwitch(const std::vector<CountedSwitch>& counted, double time_s) {
  for (const CountedSwitch& one : counted) {
    if (std::abs(one.time_s - time_s) <= kSameSwitch_s) return &one.before;
  }
  return nullptr;
}

}  // namespace

GaitCycle::GaitCycle(const Gait& gait, int first_foot) : gait_(gait) {
  const auto feet = gait.phase.size();
  const auto first = static_cast<std::size_t>(first_foot);
  const auto liftoff_of = [&](std::size_t i) { return ShareOf(gait.phase[i] + gait.duty_factor[i] + kOneEvent); };
  std::vector<double> liftoff(feet), begins = {0.0};
  for (std::size_t i = 0; i < feet; ++i) {
    const double after = liftoff_of(i) - liftoff_of(first);
    liftoff[i] = after < -kOneEvent ? after + 1.0 : std::max(after, 0.0);
    for (const double share : {liftoff[i], ShareOf(liftoff[i] + 1.0 - gait.duty_factor[i])}) {
      const bool known =
          std::any_of(begins.begin(), begins.end(), [&](double other) { return std::abs(share - other) <= kOneEvent; });
      if (!known && share < 1.0 - kOneEvent) begins.push_back(share);
    }
  }
  std::sort(begins.begin(), begins.end());
  VectorX all_s(static_cast<Eigen::Index>(begins.size()));
  for (std::size_t k = 0; k < begins.size(); ++k)
    all_s[static_cast<Eigen::Index>(k)] = ((k + 1 < begins.size() ? begins[k + 1] : 1.0) - begins[k]) * gait.cycle_s;
  for (std::size_t i = 0; i < feet; ++i) {
    lift_off_.push_back(EventAt(liftoff[i], begins));
    touch_down_.push_back(EventAt(liftoff[i] + 1.0 - gait.duty_factor[i], begins));
  }
  Fold(all_s);
}

/// Finds the number of repeats in the cycle: parts of equal duration that begin with equal numbers of lift-offs and
/// touch-downs.
void GaitCycle::Fold(const VectorX& all_s) {
  const Eigen::Index parts = all_s.size();
  std::vector<int> lifts(static_cast<std::size_t>(parts), 0), touches = lifts;
  for (const Event& event : lift_off_) ++lifts[static_cast<std::size_t>(event.part)];
  for (const Event& event : touch_down_) ++touches[static_cast<std::size_t>(event.part)];
  const auto alike = [&](Eigen::Index k, Eigen::Index other) {
    const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>(other);
    return std::abs(all_s[k] - all_s[other]) <= kOneEvent * gait_.cycle_s * 4.0 && lifts[i] == lifts[j] &&
           touches[i] == touches[j];
  };
  Eigen::Index length = 1;
  for (; length < parts; ++length) {
    if (parts % length != 0) continue;
    bool repeats = true;
    for (Eigen::Index k = length; k < parts && repeats; ++k) repeats = alike(k, k - length);
    if (repeats) break;
  }
  repeats_ = static_cast<int>(parts / length);
  durations_s_ = all_s.head(length);
}

GaitCycle::Event GaitCycle::EventAt(double share, const std::vector<double>& begins) const {
  Event event;
  event.cycle = static_cast<int>(std::floor(share + 2.0 * kOneEvent));
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < begins.size(); ++k) {
    const double off = std::abs(share - event.cycle - begins[k]);
    if (off >= nearest) continue;
    nearest = off;
    event.part = static_cast<Eigen::Index>(k);
  }
  return event;
}

VectorX GaitCycle::Before(const Event& event, int cycle) const {
  const Eigen::Index length = durations_s_.size();
  VectorX before = VectorX::Constant(length, (cycle + event.cycle) * repeats_ + static_cast<int>(event.part / length));
  before.head(event.part % length).array() += 1.0;
  return before;
}

VectorX GaitCycle::LiftOff(int foot, int cycle) const {
  return Before(lift_off_[static_cast<std::size_t>(foot)], cycle);
}

VectorX GaitCycle::TouchDown(int foot, int cycle) const {
  return Before(touch_down_[static_cast<std::size_t>(foot)], cycle);
}

double GaitCycle::ShareKeepingSwings(const VectorX& to_s, double shortest_swing_s, double least_swing) const {
  double share = 1.0;
  for (int foot = 0; foot < gait_.num_feet(); ++foot) {
    const VectorX in_swing = TouchDown(foot, 0) - LiftOff(foot, 0);
    const double swing_s = in_swing.dot(durations_s_), shorter_s = swing_s - in_swing.dot(to_s);
    const double most_s = swing_s - std::min(swing_s, std::max(shortest_swing_s, least_swing * swing_s));
    if (shorter_s > most_s) share = std::min(share, most_s / shorter_s);
  }
  return share;
}

Gait GaitCycle::With(const VectorX& durations_s) const {
  Gait gait = gait_;
  gait.cycle_s = repeats_ * durations_s.sum();
  double last = 0.0;  // lift-off, as a share of the cycle after the first one
  for (int foot = 0; foot < gait_.num_feet(); ++foot)
    last = std::max(last, LiftOff(foot, 0).dot(durations_s) / gait.cycle_s);
  double first = 1.0;
  for (std::size_t i = 0; i < gait.phase.size(); ++i)
    first = std::min(first, ShareOf(gait_.phase[i] + gait_.duty_factor[i] + kOneEvent) - kOneEvent);
  // The foot that lifts off first in a cycle must remain the first.
  if (first < 0.0 || first + last >= 1.0 - kOneEvent) first = 0.0;
  for (int foot = 0; foot < gait_.num_feet(); ++foot) {
    const auto i = static_cast<std::size_t>(foot);
    const double touchdown = TouchDown(foot, 0).dot(durations_s) / gait.cycle_s;
    gait.duty_factor[i] = 1.0 - (touchdown - LiftOff(foot, 0).dot(durations_s) / gait.cycle_s);
    gait.phase[i] = ShareOf(first + touchdown);
    if (gait.phase[i] > 1.0 - kOneEvent) gait.phase[i] = 0.0;
  }
  return gait;
}

std::optional<CycleTies> TiesOf(const FootstepSkeleton& skeleton, std::size_t part,
                                const std::vector<double>& switches_s, double grid_s) {
  constexpr double kOff = 3.0;  // steps of the grid to which times are rounded
  const Gait& gait = skeleton.parts[part].gait;
  const std::vector<FootSwing> swings = SwingsIn(skeleton, part);
  const bool steps = std::all_of(gait.duty_factor.begin(), gait.duty_factor.end(),
                                 [](double duty) { return duty > 0.0 && duty < 1.0; });
  if (swings.empty() || !steps) return std::nullopt;
  const auto first = std::min_element(swings.begin(), swings.end(),
                                      [](const FootSwing& a, const FootSwing& b) { return a.liftoff_s < b.liftoff_s; });
  const GaitCycle cycle(gait, first->foot);
  const std::vector<CountedSwitch> counted = CountedSwitches(cycle, swings);
  const auto phases = static_cast<Eigen::Index>(switches_s.size()) - 1;
  const Eigen::Index parts = cycle.durations_s().size();
  PhaseTies ties{MatrixX::Zero(phases, parts), VectorX::Zero(phases), cycle.durations_s(), {}};
  const double start_s = skeleton.schedule.start_s();
  for (Eigen::Index k = 0; k < phases; ++k) {
    const double from_s = switches_s[static_cast<std::size_t>(k)], to_s = switches_s[static_cast<std::size_t>(k) + 1];
    const VectorX *before = BeforeSwitch(counted, start_s + from_s), *after = BeforeSwitch(counted, start_s + to_s);
    if (before != nullptr && after != nullptr) ties.phases_by_parts.row(k) = *after - *before;
    if (k + 1 == phases) ties.phases_by_parts.row(k) = -ties.phases_by_parts.topRows(k).colwise().sum();
    const double tied_s = ties.phases_by_parts.row(k).dot(ties.parts_s);
    ties.rest_s[k] = to_s - from_s - tied_s;
    if (before != nullptr && after != nullptr && std::abs(ties.rest_s[k]) > kOff * grid_s) return std::nullopt;
  }
  return CycleTies{cycle, ties};
}

}  // namespace gaitwright
