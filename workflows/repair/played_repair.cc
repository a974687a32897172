// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>
#include <utility>

#include "kinematics/base/free_memory_internal.h"
#include "workflows/repair/played_repair_internal.h"

namespace gaitwright {
namespace {

/// What a playback proves about a plan.
PlayProof ProofOf(const MotionPlan& plan, const PlayedWalk& played) {
  constexpr double kEarly = 0.05;  // [s] before the end of the plan
  double until_s = played.log.samples.back().time_s;
  if (played.second != nullptr) until_s = std::min(until_s, played.second->log.samples.back().time_s);
  if (played.pass() || until_s > plan.whole_body.end_s() - kEarly) return {played.pass(), {}};
  return {false, until_s};
}

/// Leaves out the measurements, which take as much memory as a long plan.
void DropSamples(PlayedWalk& played) {
  played.log.samples = {};
  if (played.second == nullptr) return;
  auto second = std::make_shared<SecondPlayback>(*played.second);
  second->log.samples = {};
  played.second = std::move(second);
}

}  // namespace

Result<PlayedRepair> RepairAndPlay(const RobotModel& model, const RepairRequest& request, bool plays) {
  PlayRequest play;
  play.play.world.engine = ProvingEngine();
  std::optional<Result<PlayedWalk>> played;
  const auto proof = [&](const MotionPlan& plan) {
    played.reset();  // an earlier playback is not kept beside this one
    played = PlayWalk(model, plan, play);
    return *played ? ProofOf(plan, **played) : PlayProof{false, {}};
  };
  Result<RepairedMotion> repaired = RepairMotion(model, request, plays ? PlanProof(proof) : PlanProof());
  if (!repaired) return repaired.failure();
  PlayedRepair result{std::move(*repaired)};
  if (!plays) return result;
  if (!result.repaired.proved) played = PlayWalk(model, result.repaired.plan, play);
  if (!*played) return played->failure();
  result.played = std::move(**played);
  DropSamples(*result.played);
  ReleaseFreedMemory();
  return result;
}

}  // namespace gaitwright
