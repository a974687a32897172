// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/apply_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/nearest_name.h"
#include "kinematics/model/base_axes.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/model/find_feet.h"
#include "kinematics/model/yaml_line.h"

namespace gaitwright {
namespace {

constexpr double kLevelFeet = 5e-3;  // [m] how far feet may stand apart in height

/// The joint of that name; the model may be const.
template <class Model>
auto& JointNamed(Model& model, const std::string& name, int line) {
  std::vector<std::string> names;
  for (auto& joint : model.joints) {
    if (joint.name == name) return joint;
    names.push_back(joint.name);
  }
  RefuseYamlLine(line,
                 fmt::format("robot '{}' has no moving joint '{}'{}", model.name, name, NearestOrAll(name, names)));
}

/// The coordinate of a joint. Refuses a joint that mimics another one.
int DofNamed(const RobotModel& model, const std::string& name, int line) {
  const Joint& joint = JointNamed(model, name, line);
  if (!joint.is_mimic) return joint.dof;
  RefuseYamlLine(line, fmt::format("joint '{}' mimics another joint; name '{}' instead", name,
                                   model.dof_names[static_cast<std::size_t>(joint.dof)]));
}

void CheckUnits(const Joint& joint, bool sliding, bool any, int line) {
  if (!any || sliding == joint.is_prismatic()) return;
  RefuseYamlLine(
      line, fmt::format(
                "joint '{}' {}", joint.name,
                sliding ? "is revolute; its keys end in _rad, _rad_s, _rad_s2, _rad_s3, _nm, _nm_rad, _nm_s_rad, _kg_m2"
                        : "is prismatic; its keys end in _m, _m_s, _m_s2, _m_s3, _n, _n_m, _n_s_m, _kg"));
}

/// Height of a foot's lowest point in the base frame, in the standing posture [m].
double LowestOf(const Foot& foot, const std::vector<Pose>& X_OB) {
  const Pose X_OF = X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF;
  if (foot.sole_F.empty()) return X_OF.translation().z() - foot.radius;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector2& c : foot.sole_F) lowest = std::min(lowest, (X_OF * Vector3(c.x(), c.y(), 0.0)).z());
  return lowest;
}

void CheckLevel(const RobotYaml& yaml, const RobotModel& model) {
  const std::vector<Pose> X_OB = BodyPoses(model, model.standing_joints);
  const auto height = [&](const Foot& foot) { return LowestOf(foot, X_OB); };
  const auto lowest = std::min_element(model.feet.begin(), model.feet.end(),
                                       [&](const Foot& a, const Foot& b) { return height(a) < height(b); });
  for (const Foot& foot : model.feet) {
    const double above = height(foot) - height(*lowest);
    if (above <= kLevelFeet || yaml.standing.empty()) continue;
    RefuseYamlLine(yaml.standing.front().line,
                   fmt::format("in the posture of 'standing', foot '{}' is {:.1f} mm above foot '{}'; at most {} mm is "
                               "accepted, because all feet stand on level ground",
                               foot.name, 1e3 * above, lowest->name, 1e3 * kLevelFeet));
  }
  if (!yaml.standing_base_height_m) return;
  const double stands = -height(*lowest);
  if (std::abs(*yaml.standing_base_height_m - stands) <= kLevelFeet) return;
  RefuseYamlLine(
      yaml.height_line,
      fmt::format("'standing_base_height_m' is {}, but in the standing posture the base is {:.4f} m above the feet "
                  "({:.1f} mm off); set 'standing' for the legs to match, or leave the height out",
                  *yaml.standing_base_height_m, stands, 1e3 * std::abs(*yaml.standing_base_height_m - stands)));
}

/// Copies the given data of a motor to the model. @throws InvalidArgument if the values contradict each other.
void ApplyMotor(const RobotYaml::JointMotor& given, RobotModel& model) {
  const int dof = DofNamed(model, given.joint, given.line);
  Joint& joint = JointNamed(model, given.joint, given.line);
  CheckUnits(joint, given.sliding, given.has_units, given.line);
  Motor& motor = model.motors[static_cast<std::size_t>(dof)];
  if (given.corner_speed.has_value() != given.no_load_speed.has_value()) {
    RefuseYamlLine(given.line, fmt::format("the motor of '{}' has only one end of its torque-speed curve; give both "
                                           "the corner velocity and the no-load velocity, or neither",
                                           given.joint));
  }
  motor.corner_speed = given.corner_speed.value_or(motor.corner_speed);
  motor.no_load_speed = given.no_load_speed.value_or(motor.no_load_speed);
  if (motor.has_curve() && motor.corner_speed >= motor.no_load_speed) {
    RefuseYamlLine(given.line, fmt::format("the motor of '{}' has a corner velocity of {}, which is not below its "
                                           "no-load velocity of {}",
                                           given.joint, motor.corner_speed, motor.no_load_speed));
  }
  motor.continuous_effort = given.continuous_effort.value_or(motor.continuous_effort);
  if (given.continuous_effort && motor.continuous_effort > model.dof_effort_limit(dof)) {
    RefuseYamlLine(given.line,
                   fmt::format("the motor of '{}' has a continuous effort of {}, above the joint's limit of {}",
                               given.joint, motor.continuous_effort, model.dof_effort_limit(dof)));
  }
  motor.thermal_s = given.thermal_s.value_or(motor.thermal_s);
  motor.rotor_inertia = given.rotor_inertia.value_or(motor.rotor_inertia);
  motor.acceleration_limit = given.acceleration_limit.value_or(motor.acceleration_limit);
  motor.jerk_limit = given.jerk_limit.value_or(motor.jerk_limit);
  joint.damping = given.damping.value_or(joint.damping);
  joint.friction = given.friction.value_or(joint.friction);
}

}  // namespace

void ApplyAxes(const RobotYaml& yaml, RobotModel& model) {
  const BaseAxes axes = yaml.up ? BaseAxes{*yaml.forward, *yaml.up} : DeriveBaseAxes(model);
  if (axes.are_usual()) return;
  TurnBase(axes, model);
  model.notes.push_back(
      fmt::format("base: axis {1} of link '{0}' points forward and {2} up ({3}); in states, x points forward and z up",
                  model.frames.front().name, NameOfAxis(axes.forward), NameOfAxis(axes.up),
                  yaml.up ? "robot.yaml" : "derived from its mirrored, hanging limbs"));
}

void ApplyLimits(const RobotYaml& yaml, RobotModel& model) {
  for (const RobotYaml::JointLimits& given : yaml.limits) {
    Joint& joint = JointNamed(model, given.joint, given.line);
    CheckUnits(joint, given.sliding, given.lower || given.upper || given.velocity || given.effort, given.line);
    if (joint.type == JointType::kContinuous && given.lower.has_value() != given.upper.has_value()) {
      RefuseYamlLine(
          given.line,
          fmt::format("joint '{}' is continuous; give both a lower and an upper limit, or neither", joint.name));
    }
    if (joint.type == JointType::kContinuous && given.lower) joint.type = JointType::kRevolute;
    joint.lower = given.lower.value_or(joint.lower);
    joint.upper = given.upper.value_or(joint.upper);
    joint.velocity_limit = given.velocity.value_or(joint.velocity_limit);
    joint.effort_limit = given.effort.value_or(joint.effort_limit);
    if (given.velocity) joint.velocity_limit_is_placeholder = false;
    if (given.effort) joint.effort_limit_is_placeholder = false;
    if (joint.lower > joint.upper) {
      RefuseYamlLine(given.line, fmt::format("joint '{}': its lower limit {} is above its upper limit {}", joint.name,
                                             joint.lower, joint.upper));
    }
  }
}

void ApplyMotors(const RobotYaml& yaml, RobotModel& model) {
  model.motors.assign(model.dof_names.size(), Motor());
  for (const RobotYaml::JointMotor& given : yaml.motors) ApplyMotor(given, model);
}

VectorX GivenPosture(const RobotYaml& yaml, const RobotModel& model) {
  VectorX given = VectorX::Constant(model.num_dofs(), std::numeric_limits<double>::quiet_NaN());
  for (const RobotYaml::JointPosition& at : yaml.standing) {
    const int dof = DofNamed(model, at.joint, at.line);
    if (at.position < model.dof_lower(dof) || at.position > model.dof_upper(dof)) {
      RefuseYamlLine(at.line, fmt::format("standing position {} of joint '{}' is outside its limits {} to {}",
                                          at.position, at.joint, model.dof_lower(dof), model.dof_upper(dof)));
    }
    given[dof] = at.position;
  }
  return given;
}

void ApplyStanding(const RobotYaml& yaml, RobotModel& model) {
  CheckLevel(yaml, model);
  model.standing_base_height_m = yaml.standing_base_height_m.value_or(model.standing_base_height_m);
  model.nominal_speed_m_s = yaml.nominal_speed_m_s.value_or(model.nominal_speed_m_s);
  for (const RobotYaml::JointGains& given : yaml.gains) {
    const int dof = DofNamed(model, given.joint, given.line);
    CheckUnits(JointNamed(model, given.joint, given.line), given.sliding, given.stiffness || given.damping, given.line);
    model.stiffness[dof] = given.stiffness.value_or(0.0);
    model.damping[dof] = given.damping.value_or(0.0);
  }
}

void ApplyRests(const RobotYaml& yaml, RobotModel& model) {
  for (const RobotYaml::Rest& rest : yaml.rests) {
    std::vector<std::string> links;
    for (const Frame& frame : model.frames) links.push_back(frame.name);
    if (std::find(links.begin(), links.end(), rest.link) == links.end()) {
      RefuseYamlLine(rest.line,
                     fmt::format("link '{}' of 'rests' does not exist{}", rest.link, NearestHint(rest.link, links)));
    }
    const auto of_link = [&](const Foot& foot) { return foot.link == rest.link; };
    if (std::any_of(model.feet.begin(), model.feet.end(), of_link))
      RefuseYamlLine(rest.line, fmt::format("link '{}' of 'rests' is a foot or is listed twice", rest.link));
    const std::optional<Foot> found = FindRest(model, rest.link, yaml.sole_give_m);
    if (!found) RefuseYamlLine(rest.line, fmt::format("link '{}' of 'rests' has no flat bottom", rest.link));
    model.feet.push_back(*found);
    model.notes.push_back(fmt::format("it may lie on link '{}': {}", rest.link, found->derived_from));
  }
}

}  // namespace gaitwright
