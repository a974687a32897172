// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/first_look.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "optimisation/search/refuse_walk.h"
#include "optimisation/search/start_of_walk.h"

namespace gaitwright {
namespace {

constexpr double kFarPast = 0.05;  // limits, summed in shares of the limits: more than further passes can correct

constexpr double kFarEase = 0.5;  // factor of the speed if a violated constraint does not tell by how much

/// The request, changed to few and cheap passes.
WalkRequest Cheap(const WalkRequest& request) {
  constexpr int kPasses = 2;  // the second one shows whether the first one helped
  WalkRequest cheap = request;
  cheap.motion.rigid_body.method = "interior-point";  // fast if no motion exists
  cheap.motion.pipeline.max_body_passes = std::min(kPasses, request.motion.pipeline.max_body_passes);
  return cheap;
}

/// The start of a walk on level ground, if it is much shorter than the whole walk.
WalkCommand ShortStart(const RobotModel& model, const Terrain& terrain, const Gait& gait, const WalkCommand& command) {
  if (KindOfGround(terrain) != GroundKind::kFlat || IsShort(model, command, gait)) return command;
  return StartOfWalk(model, command, gait);
}

/// Whether a plan was refused only after a problem was solved: by constraints of the solver, or by later stages.
bool TookSolving(const Failure& failure) {
  static const std::set<FailureCode> kAfterSolving = {FailureCode::kUnmetLaw, FailureCode::kNotCarried,
                                                      FailureCode::kNoClearance, FailureCode::kOutOfReach,
                                                      FailureCode::kJointLimit};
  return kAfterSolving.contains(failure.code);
}

FirstLook Look(const RobotModel& model, const Terrain& terrain, const WalkRequest& cheap, const Gait& gait,
               const WalkCommand& command, double far) {
  FirstLook look;
  Result<PlannedMotion> motion = PlanMotion(model, terrain, gait, command, cheap.motion);
  if (!motion) {
    look.solved = TookSolving(motion.failure());
    if (look.solved) look.ease = kFarEase;
    if (IsTooMuch(motion.failure())) look.refusal = motion.failure();
    return look;
  }
  look.solved = look.planned = true;
  if (motion->limit_violation < far) return look;
  const Result<AuditReport> audit = Audit(model, motion->plan, {});
  if (!audit || BrokenLimits(*audit).empty()) return look;
  look.ease = EaseOf(*audit);
  look.refusal = ReasonForbidden({std::move(*motion), *audit});
  return look;
}

}  // namespace

FirstLook LookAt(const RobotModel& model, const Terrain& terrain, const WalkRequest& request, const Gait& gait,
                 const WalkCommand& command, bool whole) {
  const WalkRequest cheap = Cheap(request);
  const WalkCommand start = ShortStart(model, terrain, gait, command);
  const double far = whole ? kFarPast : kSlightViolation;
  FirstLook look = Look(model, terrain, cheap, gait, start, far);
  if (!whole || !look.refusal || look.planned || start == command) return look;
  return Look(model, terrain, cheap, gait, command, far);
}

double EaseOf(const AuditReport& audit) {
  constexpr double kShareOfLimits = 0.95;      // limits that are just kept at the knots are violated between them
  constexpr double kLeast = 0.4, kMost = 0.8;  // so that each look makes progress and none skips most speeds
  constexpr double kOtherwise = 0.7;           // for checks that are not a power of the speed
  double ease = 1.0;
  for (const Violation& v : BrokenLimits(audit)) {
    double share = kOtherwise;
    if (v.law == Law::kJointVelocity || v.law == Law::kJointAcceleration || v.law == Law::kJointJerk ||
        v.law == Law::kJointTorque)
      share = std::abs(v.limit / v.value);
    // Torques and accelerations grow with the square of the speed, jerk with its cube.
    if (v.law == Law::kJointTorque || v.law == Law::kJointAcceleration) share = std::sqrt(share);
    if (v.law == Law::kJointJerk) share = std::cbrt(share);
    ease = std::min(ease, share);
  }
  return std::clamp(kShareOfLimits * ease, kLeast, kMost);
}

}  // namespace gaitwright
