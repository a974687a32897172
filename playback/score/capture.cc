// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/capture.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

constexpr double kSame = 1e-6;  // [s]

double HipHeight(const RobotModel& model, const DynamicsScratch& scratch, const Leg& leg) {
  const std::size_t foot_body = static_cast<std::size_t>(model.feet[static_cast<std::size_t>(leg.foot)].body);
  const double foot = scratch.p_WB[foot_body].z();
  double highest = foot;
  for (const int joint : leg.joints) highest = std::max(highest, scratch.p_WB[static_cast<std::size_t>(joint) + 1].z());
  return highest;
}

/// The last part of a plan with a gait; null if there is none.
const MotionPart* LastGait(const std::vector<MotionPart>& parts) {
  const auto walks = [](const MotionPart& part) { return !StandsStill(part.gait); };
  const auto last = std::find_if(parts.rbegin(), parts.rend(), walks);
  return last == parts.rend() ? nullptr : &*last;
}

/// Whether any foot touches down at the start of phase i >= 1.
bool BringsDown(const ContactSchedule& schedule, std::size_t i) {
  return (schedule.phases[i].stance & ~schedule.phases[i - 1].stance) != 0;
}

/// Minkowski sum of `a` and `weight` times `b`.
Polygon Plus(const Polygon& a, double weight, const Polygon& b) {
  std::vector<Vector2> sums;
  for (const Vector2& p : a) {
    for (const Vector2& q : b) sums.push_back(p + weight * q);
  }
  return ConvexHull(std::move(sums));
}

}  // namespace

double StepReach(const RobotModel& model, double stretch) {
  if (model.legs.empty()) return 0.0;
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  double sum = 0.0;
  for (const Leg& leg : model.legs) {
    const double longest = stretch * leg.length_m, height = HipHeight(model, scratch, leg);
    const double half = std::sqrt(std::max(longest * longest - height * height, 0.0));
    sum += std::max(2.0 * half, 0.2 * leg.length_m);
  }
  return sum / static_cast<double>(model.legs.size());
}

std::vector<double> TouchdownTimes(const ContactSchedule& schedule) {
  std::vector<double> times;
  for (std::size_t i = 1; i < schedule.phases.size(); ++i) {
    if (BringsDown(schedule, i)) times.push_back(schedule.phases[i].start_s);
  }
  return times;
}

std::vector<CaptureStage> StagesToNextTouchdown(const MotionPlan& plan, double time_s) {
  const std::vector<ContactPhase>& phases = plan.schedule.phases;
  if (phases.empty()) return {};
  const auto now = static_cast<std::size_t>(PhaseAt(plan.schedule, time_s));
  std::size_t next = now + 1;
  while (next < phases.size() && !(BringsDown(plan.schedule, next) && phases[next].start_s > time_s + kSame)) ++next;
  if (next == phases.size()) {
    const MotionPart* last = LastGait(plan.parts);
    std::vector<double> times = TouchdownTimes(plan.schedule);
    if (last != nullptr) std::erase_if(times, [&](double touchdown_s) { return touchdown_s < last->start_s; });
    const double mean = times.size() < 2 ? 0.5 * (last == nullptr ? Gait{} : last->gait).cycle_s
                                         : (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    return {{mean, phases.back().stance}};
  }
  std::vector<CaptureStage> stages;
  for (std::size_t i = now; i < next; ++i) {
    const double start = std::max(phases[i].start_s, time_s);
    if (phases[i].end_s > start + kSame) stages.push_back({phases[i].end_s - start, phases[i].stance});
  }
  return stages;
}

std::optional<double> CaptureMargin(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain,
                                    const std::vector<CaptureStage>& stages, const MotionSample& sample,
                                    double reach_m) {
  Polygon set = {Vector2::Zero()}, last;
  double still = 1.0;  // exp(-omega T_i)
  for (const CaptureStage& stage : stages) {
    const double after = still * std::exp(-sample.omega_rad_s * stage.duration_s);
    const Polygon support = SupportOf(model, scratch, terrain, stage.stance).polygon;
    if (support.empty()) continue;  // in flight the DCM cannot be controlled
    set = Plus(set, still - after, support);
    last = support;
    still = after;
  }
  if (last.empty()) return std::nullopt;
  return SignedDistance(Plus(set, still, last), sample.dcm_W) + reach_m * still;
}

}  // namespace gaitwright
