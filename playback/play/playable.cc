// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planning/plan/check_motion.h"
#include "playback/engine/bumps.h"
#include "playback/play/off_plan_internal.h"
#include "playback/play/playable_internal.h"
#include "playback/play/whole_steps.h"

namespace gaitwright {
namespace {

constexpr double kLongestPlan = 3600.0;   // [s]
constexpr double kBumpsBeyondPlan = 2.0;  // ground with bumps beyond the region of the plan [m]

Failure Mismatch(FailureCode code, const std::string& message, const std::string& hint) {
  return {FailureKind::kBadInput, code, "Play", message, {hint}};
}

/// Reason for which this robot cannot play the plan; nothing if it can.
std::optional<Failure> Misfit(const RobotModel& model, const MotionPlan& plan) {
  const WholeBodyTrajectory& w = plan.whole_body;
  if (w.size() == 0 || w.step_s <= 0.0) {
    return Mismatch(FailureCode::kPlanWithoutMotion, "the plan has no whole-body motion to play", "plan it again");
  }
  if (!(plan.duration_s() <= kLongestPlan) || !std::isfinite(w.start_s)) {
    return Mismatch(FailureCode::kPlanTooLong,
                    fmt::format("the plan lasts {:.6g} s from {:.6g} s on; at most {} s can be played",
                                plan.duration_s(), w.start_s, kLongestPlan),
                    "check the plan's 'step_s'");
  }
  if (std::any_of(plan.parts.begin(), plan.parts.end(), [](const MotionPart& part) { return Hangs(part.gait); })) {
    return Mismatch(FailureCode::kHangs,
                    "the plan is for a robot whose base is held externally; in a playback it would fall at once",
                    "audit and export it; play the plan that follows it");
  }
  if (!model.hash.empty() && !plan.robot_hash.empty() && plan.robot_hash != model.hash) {
    return Mismatch(FailureCode::kPlanOfOtherRobot,
                    fmt::format("the plan was made for robot '{}' ({}), but the given robot is '{}' ({})", plan.robot,
                                plan.robot_hash, model.name, model.hash),
                    "play it with the robot that the plan contains, or plan again for the given robot");
  }
  try {
    CheckMotion(model, w);
  } catch (const InvalidArgument& error) {
    return Mismatch(FailureCode::kPlanOfOtherRobot, error.what(), "plan again for this robot");
  }
  return std::nullopt;
}

/// Failure for a push that begins after the end; nothing if there is none.
std::optional<Failure> LatePush(const MotionPlan& plan, const PlayOptions& options) {
  const double end_s = plan.whole_body.end_s() + options.hold_s;
  for (const TimedPush& push : playing::PushesOf(options)) {
    if (push.at_s < end_s) continue;
    return Mismatch(FailureCode::kLatePush,
                    fmt::format("the push begins at {} s, but the playback ends at {:.3f} s", push.at_s, end_s),
                    "begin the push earlier (push_at_s)");
  }
  return std::nullopt;
}

}  // namespace

namespace playing {

WorldOptions WorldOf(const MotionPlan& plan, const PlayOptions& options) {
  WorldOptions world = options.world;
  Vector2 low = plan.whole_body.q.front().head<2>(), high = low;
  for (const VectorX& q : plan.whole_body.q) {
    low = low.cwiseMin(q.head<2>());
    high = high.cwiseMax(q.head<2>());
  }
  world.bumps_from_W = low - Vector2::Constant(kBumpsBeyondPlan);
  world.bumps_to_W = high + Vector2::Constant(kBumpsBeyondPlan);
  if (!options.lock_unmoved) return world;
  const VectorX& first = plan.whole_body.q.front();
  for (Eigen::Index i = 7; i < first.size(); ++i) {
    const bool still = std::all_of(plan.whole_body.q.begin(), plan.whole_body.q.end(),
                                   [&](const VectorX& q) { return std::abs(q[i] - first[i]) < 1e-9; });
    if (still) world.locked_dofs.push_back(static_cast<int>(i) - 7);
  }
  return world;
}

}  // namespace playing

std::optional<Failure> ReasonNotPlayed(const RobotModel& model, const MotionPlan& plan, const PlayOptions& options) {
  PlayOptions checked = options;
  CheckOptions(checked.Fields());
  if (auto failure = Misfit(model, plan)) return failure;
  if (auto failure = LatePush(plan, options)) return failure;
  for (const TimedPush& push : playing::PushesOf(options)) (void)playing::PushedBody(model, push.on);
  (void)WholeSteps("log_rate_hz", options.log_rate_hz, options.world.step_s);
  CheckBumps(playing::WorldOf(plan, options));
  return std::nullopt;
}

}  // namespace gaitwright
