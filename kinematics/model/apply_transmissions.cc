// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/apply_transmissions.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/result.h"
#include "kinematics/model/yaml_line.h"

namespace gaitwright {
namespace {

/// The coordinate of a joint that a transmission names.
int DrivenDof(const RobotModel& model, const std::string& name, const RobotYaml::SharedDrive& drive) {
  for (const Joint& joint : model.joints) {
    if (joint.name != name) continue;
    const std::string& leader = model.dof_names[static_cast<std::size_t>(joint.dof)];
    if (joint.is_mimic)
      RefuseYamlLine(drive.line,
                     fmt::format("transmission '{}' drives joint '{}', which mimics another joint; name '{}' instead",
                                 drive.name, name, leader));
    if (const Transmission* other = model.TransmissionOf(joint.dof))
      RefuseYamlLine(drive.line, fmt::format("transmission '{}' drives joint '{}', which transmission '{}' also drives",
                                             drive.name, name, other->name));
    return joint.dof;
  }
  RefuseYamlLine(drive.line, fmt::format("transmission '{}' drives joint '{}', which robot '{}' does not have{}",
                                         drive.name, name, model.name, NearestOrAll(name, model.dof_names)));
}

/// Refuses limits and motor data that the file gives elsewhere for a joint of a transmission.
void CheckSaidOnce(const RobotYaml& yaml, const std::string& joint, const RobotYaml::SharedDrive& drive) {
  const auto has_rotor = [](const RobotYaml::SharedMotor& motor) { return motor.rotor_inertia.has_value(); };
  const bool rotors = std::any_of(drive.motors.begin(), drive.motors.end(), has_rotor);
  for (const RobotYaml::JointLimits& limits : yaml.limits) {
    if (limits.joint == joint && (limits.effort || limits.velocity))
      RefuseYamlLine(limits.line, fmt::format("joint '{}' has a limit of effort or speed, but transmission '{}' drives "
                                              "it; set the effort and speed limits of its motors there",
                                              joint, drive.name));
  }
  for (const RobotYaml::JointMotor& motor : yaml.motors) {
    if (motor.joint != joint) continue;
    if (motor.corner_speed || motor.no_load_speed || motor.continuous_effort)
      RefuseYamlLine(motor.line, fmt::format("joint '{}' has a curve or a continuous effort under 'motors', but "
                                             "transmission '{}' drives it; give them to the motors of the transmission",
                                             joint, drive.name));
    if (motor.rotor_inertia && rotors)
      RefuseYamlLine(motor.line, fmt::format("joint '{}' has a rotor under 'motors', but the motors of transmission "
                                             "'{}' have rotors too; set only one of them: in 'motors' or in "
                                             "'transmissions'",
                                             joint, drive.name));
  }
}

TransmissionMotor MotorFrom(const RobotYaml::SharedMotor& given) {
  TransmissionMotor made{.name = given.name, .slides = given.sliding};
  made.effort_limit = given.effort.value_or(Motor::kNone);
  made.velocity_limit = given.velocity.value_or(Motor::kNone);
  made.motor.corner_speed = given.corner_speed.value_or(Motor::kNone);
  made.motor.no_load_speed = given.no_load_speed.value_or(Motor::kNone);
  made.motor.continuous_effort = given.continuous_effort.value_or(Motor::kNone);
  made.motor.thermal_s = given.thermal_s.value_or(made.motor.thermal_s);
  made.motor.rotor_inertia = given.rotor_inertia.value_or(0.0);
  return made;
}

/// Reports identify a motor by its name. So the names of motors must be unique, and a motor must not have the name of a
/// joint that it does not drive.
void CheckMotorName(const RobotYaml::SharedMotor& motor, const RobotYaml::SharedDrive& drive, const RobotModel& model,
                    std::set<std::string>& taken) {
  if (!taken.insert(motor.name).second)
    RefuseYamlLine(motor.line, fmt::format("two motors are named '{}'; give each its own name", motor.name));
  const auto is_joint = [&](const std::string& name) { return name == motor.name; };
  if (std::any_of(drive.joints.begin(), drive.joints.end(), is_joint)) return;
  if (std::any_of(model.dof_names.begin(), model.dof_names.end(), is_joint))
    RefuseYamlLine(motor.line, fmt::format("motor '{}' of transmission '{}' has the name of a joint that it does not "
                                           "drive; give it another name",
                                           motor.name, drive.name));
}

/// Name of a joint that was fixed during loading because nothing beyond it has inertia; "" if there is no such joint.
std::string FixedJointOf(const RobotYaml::SharedDrive& drive, const RobotModel& model) {
  for (const std::string& joint : drive.joints) {
    const RobotPart part{PartKind::kJoint, joint};
    if (std::any_of(model.findings.begin(), model.findings.end(),
                    [&](const Finding& f) { return f.code == FailureCode::kNoInertia && f.part == part; }))
      return joint;
  }
  return "";
}

void ApplyTransmission(const RobotYaml& yaml, const RobotYaml::SharedDrive& drive, RobotModel& model,
                       std::set<std::string>& taken) {
  Transmission made;
  made.name = drive.name;
  made.ratios.resize(static_cast<Eigen::Index>(drive.motors.size()), static_cast<Eigen::Index>(drive.joints.size()));
  for (const std::string& joint : drive.joints) {
    made.dofs.push_back(DrivenDof(model, joint, drive));
    CheckSaidOnce(yaml, joint, drive);
  }
  for (std::size_t m = 0; m < drive.motors.size(); ++m) {
    CheckMotorName(drive.motors[m], drive, model, taken);
    made.motors.push_back(MotorFrom(drive.motors[m]));
    for (std::size_t j = 0; j < drive.joints.size(); ++j)
      made.ratios(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(j)) = drive.motors[m].ratios[j];
  }
  try {
    AddTransmission(std::move(made), model);
  } catch (const InvalidArgument& error) {
    RefuseYamlLine(drive.line, error.what());
  }
}

}  // namespace

void ApplyTransmissions(const RobotYaml& yaml, RobotModel& model) {
  std::set<std::string> taken, names;
  for (const RobotYaml::SharedDrive& drive : yaml.transmissions) {
    if (!names.insert(drive.name).second)
      RefuseYamlLine(drive.line, fmt::format("two transmissions are named '{}'; give each its own name", drive.name));
    const std::string fixed = FixedJointOf(drive, model);
    if (fixed.empty()) {
      ApplyTransmission(yaml, drive, model, taken);
      continue;
    }
    model.findings.push_back(
        {FindingLevel::kWarning, FailureCode::kTransmission, RobotPart{PartKind::kTransmission, drive.name}, 0,
         fmt::format("it is left out, because its joint '{}' moves nothing and was fixed", fixed)});
  }
}

}  // namespace gaitwright
