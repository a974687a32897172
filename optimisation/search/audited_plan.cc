// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/audited_plan.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/collision/feet_overlap_internal.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/search/refuse_walk.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

/// Whether the feet overlap at a time of the motion.
bool DoFeetOverlap(const RobotModel& model, const WholeBodyTrajectory& motion, double at_s) {
  WholeBodySample sample;
  SampleWholeBody(motion, at_s, sample);
  return FeetOverlap(model, sample.q);
}

/// Whether a plan fails because its motion and its forces do not agree, or because links touch, and keeps the robot's
/// limits: passes that did not settle, or that do not see links.
bool IsUnsettled(const RobotModel& model, const PlannedWalk& planned) {
  const auto disagrees = [&](const Violation& v) {
    return v.law == Law::kConsistency || v.law == Law::kDynamics || v.law == Law::kFlight ||
           (v.law == Law::kSelfCollision && !DoFeetOverlap(model, planned.motion.plan.whole_body, v.at_s));
  };
  const std::vector<Violation>& all = planned.audit.violations;
  return planned.motion.limit_violation < kSlightViolation && std::any_of(all.begin(), all.end(), disagrees) &&
         std::all_of(all.begin(), all.end(),
                     [&](const Violation& v) { return disagrees(v) || v.law == Law::kZmpSupport; });
}

}  // namespace

MotionOptions WithFootholds(MotionOptions options, bool other) {
  if (other) options.footholds = options.footholds == "free" ? "held" : "free";
  return options;
}

bool MayMoveFeet(const MotionOptions& options, const Terrain& terrain) {
  return options.footholds != "held" && KindOfGround(terrain) != GroundKind::kFlat;
}

Result<PlannedWalk> Audited(const RobotModel& model, Result<PlannedMotion> motion, const MotionOptions& options,
                            const AuditOptions& audit_options, bool only_sound) {
  if (!motion) return motion.failure();
  PlannedWalk planned;
  planned.motion = std::move(*motion);
  if (planned.motion.limit_violation >= kSlightViolation && only_sound) return planned;
  const Result<AuditReport> audit = Audit(model, planned.motion.plan, audit_options);
  if (!audit) return audit.failure();
  planned.audit = *audit;
  if (planned.motion.unfinished || !IsUnsettled(model, planned)) return planned;
  PlannedWalk finished = planned;
  FinishPlanned(model, options, finished.motion);
  const Result<AuditReport> again = Audit(model, finished.motion.plan, audit_options);
  if (!again || !again->violations.empty()) return planned;
  finished.audit = *again;
  return finished;
}

Room RoomOf(const Result<PlannedWalk>& planned) {
  constexpr double kAmpleEffort = 0.85;  // of the limits; optimisations leave 8 %
  if (!planned || !planned->audit.violations.empty() || planned->motion.unfinished) return Room::kNoPlan;
  const std::optional<FinishReport>& finished = planned->motion.finished;
  if (!finished || (finished->keeps_room && finished->effort_use <= kAmpleEffort)) return Room::kAmple;
  return finished->keeps_room ? Room::kAsSolved : Room::kNone;
}

}  // namespace gaitwright
