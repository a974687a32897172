// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/capture.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

double HipHeight(const RobotModel& model, const DynamicsScratch& scratch, const Leg& leg) {
  const std::size_t foot_body = static_cast<std::size_t>(model.feet[static_cast<std::size_t>(leg.foot)].body);
  const double foot = scratch.p_WB[foot_body].z();
  double highest = foot;
  for (const int joint : leg.joints) highest = std::max(highest, scratch.p_WB[static_cast<std::size_t>(joint) + 1].z());
  return highest;
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

std::vector<Touchdown> TouchdownsOf(const ContactSchedule& schedule) {
  std::vector<Touchdown> touchdowns;
  FootSet coming = 0;
  const auto close_last = [&] {
    if (!touchdowns.empty() && touchdowns.back().stance == 0) touchdowns.back().stance = coming;
  };
  for (std::size_t i = 1; i < schedule.phases.size(); ++i) {
    const FootSet stance = schedule.phases[i].stance, landed = stance & ~schedule.phases[i - 1].stance;
    if (landed != 0) {
      close_last();
      touchdowns.push_back({schedule.phases[i].start_s, stance});
      coming = landed;
    } else if (!touchdowns.empty()) {
      touchdowns.back().stance &= stance;
    }
  }
  close_last();
  return touchdowns;
}

double TimeToNextTouchdown(const MotionPlan& plan, double time_s) {
  constexpr double kSame = 1e-6;
  const std::vector<Touchdown> all = TouchdownsOf(plan.schedule);
  const auto next = std::find_if(all.begin(), all.end(), [&](const Touchdown& t) { return t.time_s > time_s + kSame; });
  if (next != all.end()) return next->time_s - time_s;
  if (all.size() < 2) return 0.5 * plan.gait.cycle_s;
  return (all.back().time_s - all.front().time_s) / static_cast<double>(all.size() - 1);
}

double CaptureMargin(const Support& support, const MotionSample& sample, double reach_m, double time_s) {
  return SignedDistance(support.polygon, sample.dcm_W) + reach_m * std::exp(-sample.omega_rad_s * time_s);
}

}  // namespace gaitwright
