// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/placed_steps.h"

#include <fmt/format.h>

#include <utility>

#include "workflows/exchange/footstep_file.h"

namespace gaitwright {

std::string FootstepsYaml(const RobotModel& model, const std::vector<PlacedStep>& steps, const StepTimes& times) {
  std::string yaml = fmt::format("{{swing_s: {}, pause_s: {}, footsteps: [", times.swing_s, times.pause_s);
  for (const PlacedStep& step : steps) {
    if (step.foot < 0 || step.foot >= static_cast<int>(model.feet.size()))
      throw InvalidArgument(
          fmt::format("a step names foot {}; '{}' has feet 0 to {}", step.foot, model.name, model.feet.size() - 1));
    yaml += fmt::format("{{foot: '{}', x_m: {}, y_m: {}, yaw_rad: {}}},\n",
                        model.feet[static_cast<std::size_t>(step.foot)].name, step.place.x_m, step.place.y_m,
                        step.place.yaw_rad);
  }
  return yaml + "]}\n";
}

Result<MotionPlan> PlanOverSteps(const RobotModel& model, const Terrain& terrain, const std::vector<PlacedStep>& steps,
                                 const StepTimes& times, const MotionOptions& options) {
  ImportRequest request;
  request.file = "the footsteps, one per line";  // name in failures
  request.motion = options;
  ImportedMotion motion;
  if (const auto failure = PlanFootstepFile(model, terrain, FootstepsYaml(model, steps, times), request, motion))
    return *failure;
  motion.plan.warnings = std::move(motion.notes.warnings);
  return std::move(motion.plan);
}

}  // namespace gaitwright
