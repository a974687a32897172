// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "playback/score/contact_timing.h"
#include "playback/score/measurements.h"

namespace gaitwright {
namespace {

const char* const kNoStance = "no foot touched the ground";
const char* const kNoSwing = "no foot swings between two stances";

int NumFeet(const ScoreInputs& in) { return static_cast<int>(in.model.feet.size()); }

/// The largest of a quantity over the stances before the fall.
template <class Figure>
Measurement LargestStance(const ScoreInputs& in, const std::string& key, Figure figure) {
  Extreme largest(Extreme::Kind::kLargest);
  for (const StanceRecord& stance : in.log.stances) {
    if (stance.touchdown_s <= in.fall.time_s) largest.See(figure(stance), stance.touchdown_s);
  }
  return FromExtremes(key, largest, Extreme(Extreme::Kind::kLargest), kNoStance);
}

Measurement TotalSlip(const ScoreInputs& in) {
  double total = 0.0;
  for (const StanceRecord& stance : in.log.stances) total += stance.touchdown_s <= in.fall.time_s ? stance.slip_m : 0.0;
  if (in.log.stances.empty()) return {"slip_total_m", {}, {}, {}, kNoStance};
  return {"slip_total_m", total, {}, {}, ""};
}

/// Lowest height of a sole above the ground in the middle half of the swings.
Extreme Clearance(const ScoreInputs& in, const std::vector<MotionSample>& samples) {
  Extreme lowest(Extreme::Kind::kSmallest);
  for (const ScheduledSwing& swing : SwingsOf(in.plan.schedule, NumFeet(in))) {
    const double quarter = 0.25 * (swing.touchdown_s - swing.liftoff_s);
    const double from_s = swing.liftoff_s + quarter, to_s = swing.touchdown_s - quarter;
    auto at = std::partition_point(samples.begin(), samples.end(),
                                   [&](const MotionSample& sample) { return sample.time_s < from_s; });
    for (; at != samples.end() && at->time_s <= to_s; ++at) {
      const double height = at->feet[static_cast<std::size_t>(swing.foot)].height_m;
      if (std::isfinite(height)) lowest.See(height, at->time_s);
    }
  }
  return lowest;
}

Measurement Scuffs(const ScoreInputs& in) {
  if (SwingsOf(in.plan.schedule, NumFeet(in)).empty()) return {"scuffs", {}, {}, {}, kNoSwing};
  const auto scuffed = ScuffedSwings(in.plan.schedule, in.log, NumFeet(in), TimingGate(), in.fall.time_s);
  Measurement row{"scuffs", static_cast<double>(scuffed.size()), {}, {}, ""};
  if (!scuffed.empty()) row.at_s = scuffed.front().liftoff_s;
  return row;
}

Measurement TimingRow(const ScoreInputs& in) {
  Extreme largest(Extreme::Kind::kLargest);
  for (const TimingError& error : TimingErrors(in.plan.schedule, in.log, NumFeet(in), in.fall.time_s)) {
    largest.See(std::abs(error.error_s), error.scheduled_s);
  }
  return FromExtremes("contact_timing_error_max_s", largest, Extreme(Extreme::Kind::kLargest),
                      "no foot touches down or lifts off");
}

/// Tangential force over mu times normal force, for the plan's own contact forces.
Extreme PlannedFrictionUse(const ScoreInputs& in) {
  Extreme largest(Extreme::Kind::kLargest);
  const double least = in.options.min_normal_fraction * in.model.weight_n();
  for (const MotionSample& sample : in.series.planned) {
    for (const FootSample& foot : sample.feet) {
      const GroundPoint ground = GroundAt(in.plan.terrain, foot.p_WF.head<2>());
      const double normal = foot.force_W.dot(ground.normal_W);
      if (normal < least || ground.friction <= 0.0) continue;
      const double tangential = (foot.force_W - normal * ground.normal_W).norm();
      largest.See(tangential / (ground.friction * normal), sample.time_s);
    }
  }
  return largest;
}

}  // namespace

std::vector<Measurement> ContactMeasurements(const ScoreInputs& in) {
  std::vector<Measurement> rows;
  const double weight = in.model.weight_n();
  rows.push_back(TotalSlip(in));
  rows.push_back(LargestStance(in, "slip_max_step_m", [](const StanceRecord& s) { return s.slip_m; }));
  rows.push_back(LargestStance(in, "penetration_max_m", [](const StanceRecord& s) { return s.penetration_m; }));
  rows.push_back(
      FromExtremes("clearance_min_m", Clearance(in, in.series.measured), Clearance(in, in.series.planned), kNoSwing));
  rows.push_back(Scuffs(in));
  rows.push_back(
      LargestStance(in, "impact_max_n_per_mg", [weight](const StanceRecord& s) { return s.peak_normal_n / weight; }));
  rows.push_back(
      LargestStance(in, "touchdown_speed_max_m_s", [](const StanceRecord& s) { return s.touchdown_speed_m_s; }));
  rows.push_back(LargestStance(in, "friction_use_max", [](const StanceRecord& s) { return s.friction_use_max; }));
  rows.back().planned = PlannedFrictionUse(in).value;
  rows.push_back(TimingRow(in));
  return rows;
}

}  // namespace gaitwright
