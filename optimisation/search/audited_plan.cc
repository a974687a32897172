// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/audited_plan.h"

#include <utility>

#include "optimisation/search/refuse_walk.h"

namespace gaitwright {

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
  return planned;
}

}  // namespace gaitwright
