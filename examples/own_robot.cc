// SPDX-License-Identifier: BSD-3-Clause
#include "examples/own_robot.h"

#include <fmt/format.h>

#include "kinematics/model/load_robot.h"

namespace gaitwright::examples {

Result<RobotModel> ReadOwnRobot(const std::string& urdf_path) { return LoadRobot(urdf_path, "none"); }

std::string WhatWasDerived(const RobotModel& model) {
  std::string text = fmt::format("{}: {:.2f} kg on {} legs, base {:.3f} m above the ground in standing\n", model.name,
                                 model.total_mass_kg, model.legs.size(), model.standing_base_height_m);
  for (const Leg& leg : model.legs) {
    const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
    text += fmt::format("leg   {}: {} joints, {:.3f} m long, on a {}\n", leg.name, leg.joints.size(), leg.length_m,
                        FootTypeNames()[static_cast<std::size_t>(foot.type)]);
  }
  for (const std::string& note : model.notes) text += "note  " + note + "\n";
  return text;
}

Result<PlannedWalk> PlanOwnWalk(const RobotModel& model) {
  WalkRequest request;
  request.command.distance_m = 2.0 * model.leg_length_m();
  return PlanWalk(model, request);
}

std::string ReasonRefused(const Failure& failure) {
  std::string text = failure.message + "\n";
  for (const Suggestion& suggestion : failure.suggestions) text += "hint  " + suggestion.text + "\n";
  return text;
}

}  // namespace gaitwright::examples
