// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/options.h"
#include "kinematics/model/actuator.h"
#include "kinematics/model/apply_yaml.h"

namespace gaitwright {
namespace {

/// The joint names of a list of items from the file, as "a, b, c".
template <class Items>
std::string JointsOf(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.joint);
  return QuotedList(names);
}

const LegOverride* Given(const RobotYaml& yaml, const Leg& leg) {
  const auto at = std::find_if(yaml.legs.begin(), yaml.legs.end(), [&](const auto& l) { return l.foot == leg.name; });
  return at == yaml.legs.end() ? nullptr : &*at;
}

void NoteLeg(const RobotYaml& yaml, const RobotModel& model, const Leg& leg, std::vector<std::string>& notes) {
  const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
  notes.push_back(fmt::format(
      "foot '{}': {}; {}", foot.name,
      yaml.feet.empty() ? fmt::format("at the end of a chain of {} joints that reaches low enough", leg.joints.size())
                        : "named in robot.yaml",
      foot.derived_from));
  notes.push_back(fmt::format("leg '{}': {:.4f} m long, from its first pitch joint along its joints to the contact",
                              leg.name, leg.length_m));
  if (leg.knee_joint < 0) return;
  const Joint& knee = model.joints[static_cast<std::size_t>(leg.knee_joint)];
  const LegOverride* given = Given(yaml, leg);
  const bool side_given = given != nullptr && given->knee_sign != 0.0;
  notes.push_back(fmt::format(
      "leg '{}': its knee is '{}'{} and bends to {}{}", leg.name, knee.name,
      given != nullptr && !given->knee.empty() ? " (robot.yaml)" : ", the second pitch joint,",
      leg.knee_sign > 0.0 ? "plus" : "minus",
      side_given ? " (robot.yaml)" : fmt::format(", by its limits {:.3f} to {:.3f}", knee.lower, knee.upper)));
}

void NoteMirrors(const RobotYaml& yaml, const RobotModel& model, std::vector<std::string>& notes) {
  const char* from = yaml.mirror_pairs ? "robot.yaml" : "their feet are symmetric about the base";
  for (std::size_t i = 0; i < model.legs.size(); ++i) {
    const int mirror = model.legs[i].mirror;
    if (mirror > static_cast<int>(i)) {
      notes.push_back(fmt::format("legs '{}' and '{}' mirror each other: {}", model.legs[i].name,
                                  model.legs[static_cast<std::size_t>(mirror)].name, from));
    } else if (mirror < 0) {
      notes.push_back(fmt::format("leg '{}' has no mirrored leg", model.legs[i].name));
    }
  }
}

void NoteStanding(const RobotYaml& yaml, const RobotModel& model, std::vector<std::string>& notes) {
  notes.push_back(
      yaml.standing.empty()
          ? "standing posture: derived from the legs' lengths and limits"
          : fmt::format("standing posture: {} from robot.yaml, the other joints from the legs' lengths and limits",
                        JointsOf(yaml.standing)));
  notes.push_back(fmt::format("base height {:.4f} m: {}", model.standing_base_height_m,
                              yaml.standing_base_height_m ? "from robot.yaml, consistent with the feet"
                                                          : "above the lowest foot of the standing posture"));
  const double pendulum = std::sqrt(kGravity * model.leg_length_m());
  notes.push_back(fmt::format("default speed {:.3f} m/s: {}", model.nominal_speed_m_s,
                              yaml.nominal_speed_m_s ? "from robot.yaml"
                                                     : fmt::format("{:.2f} of sqrt(g * leg length) = {:.3f} m/s",
                                                                   model.nominal_speed_m_s / pendulum, pendulum)));
}

void NoteLimits(const RobotYaml& yaml, const RobotModel& model, std::vector<std::string>& notes) {
  if (!yaml.limits.empty()) notes.push_back("limits of " + JointsOf(yaml.limits) + ": from robot.yaml");
  for (const Transmission& transmission : model.transmissions) {
    std::string driven;
    for (const int dof : transmission.dofs)
      driven += fmt::format("{}'{}'", driven.empty() ? "" : ", ", model.dof_names[static_cast<std::size_t>(dof)]);
    notes.push_back(fmt::format(
        "speed and effort limits of {}: from the motors of transmission '{}' (robot.yaml), not from the URDF", driven,
        transmission.name));
  }
  for (const Actuator& motor : ActuatorsOf(model)) {
    if (!motor.shared()) continue;
    if (!std::isfinite(motor.effort_limit))
      notes.push_back(fmt::format("motor '{}': its effort limit is unknown", motor.name));
    if (!std::isfinite(motor.velocity_limit))
      notes.push_back(fmt::format("motor '{}': its speed limit is unknown", motor.name));
  }
  for (const Joint& joint : model.joints) {
    if (model.TransmissionOf(joint.dof) != nullptr) continue;
    if (joint.effort_limit_is_placeholder)
      notes.push_back(
          fmt::format("joint '{}': effort limit {} is a placeholder and is not used", joint.name, joint.effort_limit));
    if (joint.velocity_limit_is_placeholder)
      notes.push_back(fmt::format("joint '{}': velocity limit {} is a placeholder and is not used", joint.name,
                                  joint.velocity_limit));
  }
  for (const Actuator& motor : ActuatorsOf(model)) {
    if (!motor.motor.has_curve() || std::isfinite(motor.effort_limit)) continue;
    notes.push_back(
        fmt::format("{} '{}': its torque-speed curve has no peak torque, so it limits nothing below the no-load speed; "
                    "set its effort in '{}' of robot.yaml",
                    motor.shared() ? "motor" : "joint", motor.name, motor.shared() ? "transmissions" : "limits"));
  }
}

}  // namespace

std::vector<std::string> DerivationNotes(const RobotYaml& yaml, const RobotModel& model) {
  std::vector<std::string> notes;
  for (const Leg& leg : model.legs) NoteLeg(yaml, model, leg, notes);
  NoteMirrors(yaml, model, notes);
  NoteStanding(yaml, model, notes);
  NoteLimits(yaml, model, notes);
  if (yaml.sole_give_m &&
      std::none_of(model.feet.begin(), model.feet.end(), [](const Foot& f) { return f.has_sole(); }))
    notes.push_back("'sole_give_m' of robot.yaml has no effect: no foot has a sole");
  notes.push_back(
      yaml.gains.empty()
          ? "gains: derived from the inertia that each joint moves"
          : fmt::format("gains of {}: from robot.yaml; the others derived from the inertia that each joint moves",
                        JointsOf(yaml.gains)));
  return notes;
}

}  // namespace gaitwright
