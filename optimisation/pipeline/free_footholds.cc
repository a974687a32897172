// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/free_footholds.h"

#include <optional>
#include <utility>

#include "optimisation/pipeline/compare_motions.h"

namespace gaitwright {
namespace {

MotionFigures FiguresOf(const RobotModel& model, const MotionPass& pass) {
  return {pass.violation, pass.error_m, TorqueUseOf(model, pass.solution.trajectory)};
}

}  // namespace

Result<MotionPass> RunRigidBodyPasses(const MotionTask& task, const Crouch* crouch, int& passes) {
  MotionOptions held = task.options;
  held.footholds = "held";
  const MotionTask over_held{task.model, task.terrain, task.skeleton, held, task.body, task.cycle_s};
  Result<MotionPass> best = RigidBodyPasses(over_held, crouch).Run(passes);
  if (task.options.footholds == "held" || KindOfGround(task.terrain) == GroundKind::kFlat) return best;
  std::optional<MotionFigures> former;
  if (best) former = FiguresOf(task.model, *best);
  int others = 0;
  Result<MotionPass> other = RigidBodyPasses(task, crouch).Run(others);
  if (!other || (best && best->settled && !other->settled)) return best;
  if (best && best->settled == other->settled &&
      !IsBetterMotion(FiguresOf(task.model, *other), former, task.options.pipeline.residual))
    return best;
  passes = others;
  return other;
}

}  // namespace gaitwright
