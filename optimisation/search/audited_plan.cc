// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/audited_plan.h"

#include <algorithm>
#include <utility>

#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/limit_violation.h"
#include "optimisation/search/refuse_walk.h"

namespace gaitwright {
namespace {

/// Whether a plan fails because its motion and its forces do not agree, and keeps the robot's limits: passes that did
/// not settle.
bool IsUnsettled(const PlannedWalk& planned) {
  const auto disagrees = [](const Violation& v) { return v.law == Law::kConsistency || v.law == Law::kDynamics; };
  const std::vector<Violation>& all = planned.audit.violations;
  return planned.motion.limit_excess < kSlightViolation && std::any_of(all.begin(), all.end(), disagrees) &&
         std::all_of(all.begin(), all.end(),
                     [&](const Violation& v) { return disagrees(v) || v.law == Law::kZmpSupport; });
}

/// Replaces a plan that passes have left unsettled by one that is optimised as a whole, if that is sound.
void FinishUnsettled(const RobotModel& model, const AuditOptions& options, PlannedWalk& planned) {
  if (!ReasonNotFinished(model, planned.motion.plan).empty()) return;
  FinishReport report;
  Result<MotionPlan> finished = FinishMotion(model, planned.motion.plan, {}, &report);
  if (!finished) return;
  const Result<AuditReport> audit = Audit(model, *finished, options);
  if (!audit || !audit->violations.empty()) return;
  planned.motion.plan = std::move(*finished);
  planned.motion.residual = std::max(report.residual_force, report.residual_moment * model.leg_length_m());
  planned.motion.limit_excess = TotalViolation(model, planned.motion.plan.whole_body, 0.0);
  planned.motion.summary += "; " + report.summary;
  planned.audit = *audit;
}

}  // namespace

MotionOptions WithFootholds(MotionOptions options, bool other) {
  if (other) options.footholds = options.footholds == "free" ? "held" : "free";
  return options;
}

bool MayMoveFeet(const MotionOptions& options, const Terrain& terrain) {
  return options.footholds != "held" && KindOfGround(terrain) != GroundKind::kFlat;
}

Result<PlannedWalk> Audited(const RobotModel& model, Result<PlannedMotion> motion, const AuditOptions& options,
                            bool only_sound) {
  if (!motion) return motion.failure();
  PlannedWalk planned;
  planned.motion = std::move(*motion);
  if (planned.motion.limit_excess >= kSlightViolation && only_sound) return planned;
  const Result<AuditReport> audit = Audit(model, planned.motion.plan, options);
  if (!audit) return audit.failure();
  planned.audit = *audit;
  if (IsUnsettled(planned)) FinishUnsettled(model, options, planned);
  return planned;
}

}  // namespace gaitwright
