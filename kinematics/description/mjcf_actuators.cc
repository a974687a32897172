// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/base/nearest_name.h"
#include "kinematics/description/mjcf_actuators_internal.h"

namespace gaitwright {
namespace {

/// The force of an actuator before its gear.
struct MjcfForce {
  std::optional<double> most;
  double stiffness = 0.0, damping = 0.0;
};

double MjcfFirst(const MjcfAttributes& attributes, const std::string& key, std::size_t index, double fallback) {
  constexpr std::size_t kMostParameters = 100;
  const std::vector<double> numbers = attributes.Numbers(key, 1, kMostParameters);
  return index < numbers.size() ? numbers[index] : fallback;
}

/// Whether the force is a gain times the control, without other terms, and the control is limited to a range.
bool IsMjcfMotor(const MjcfAttributes& attributes, const std::string& tag) {
  if (tag == "motor") return true;
  if (tag != "general") return false;
  const std::string dynamics = attributes.Text("dyntype");
  const auto is_unset = [&](const std::string& key, const std::string& usual) {
    return !attributes.Has(key) || attributes.Text(key) == usual;
  };
  return is_unset("gaintype", "fixed") && is_unset("biastype", "none") &&
         (is_unset("dyntype", "none") || dynamics == "filter" || dynamics == "filterexact");
}

/// Gains of a position or velocity servo.
void ReadMjcfServo(MjcfContext& context, const MjcfAttributes& attributes, const std::string& tag, MjcfForce& force) {
  const bool is_position = tag == "position" || tag == "intvelocity" || tag == "pid";
  if (is_position) {
    force.stiffness = attributes.Number("kp", MjcfFirst(attributes, "gainprm", 0, 1.0));
    force.damping = attributes.Number("kv", 0.0);
  } else if (tag == "velocity") {
    force.damping = attributes.Number("kv", MjcfFirst(attributes, "gainprm", 0, 1.0));
  } else if (tag == "general" && attributes.Text("biastype") == "affine") {
    force.stiffness = -MjcfFirst(attributes, "biasprm", 1, 0.0);
    force.damping = -MjcfFirst(attributes, "biasprm", 2, 0.0);
  }
  if (is_position && attributes.Has("dampratio"))
    context.Note(attributes.owner(), "'dampratio' is left out; the gain on speed is derived instead");
}

MjcfForce ReadMjcfForce(MjcfContext& context, const MjcfAttributes& attributes, const std::string& tag) {
  const bool autolimits = context.compiler.autolimits;
  MjcfForce force;
  if (attributes.IsLimited("forcelimited", "forcerange", autolimits))
    force.most = MjcfEitherSide(context, attributes, "forcerange");
  if (IsMjcfMotor(attributes, tag) && attributes.IsLimited("ctrllimited", "ctrlrange", autolimits)) {
    const double gain = tag == "motor" ? 1.0 : std::abs(MjcfFirst(attributes, "gainprm", 0, 1.0));
    const double by_control = gain * MjcfEitherSide(context, attributes, "ctrlrange");
    force.most = std::min(force.most.value_or(by_control), by_control);
  }
  ReadMjcfServo(context, attributes, tag, force);
  return force;
}

/// Index of the joint that an actuator drives. If it does not drive a moving joint, adds a note and returns -1.
int MjcfDrivenJoint(MjcfContext& context, const MjcfAttributes& attributes, const MjcfTree& tree) {
  for (const char* key : {"tendon", "cranksite"}) {
    if (!attributes.Has(key)) continue;
    context.Note(attributes.owner(), fmt::format("it drives '{}' by '{}', which is not supported; it is left out, and "
                                                 "the joints that it moves have no motor",
                                                 ShownMjcf(attributes.Text(key)), key));
    return -1;
  }
  const std::string key = attributes.Has("joint") ? "joint" : "jointinparent";
  if (!attributes.Has(key)) {
    context.Note(attributes.owner(), "it drives no joint; it is left out");
    return -1;
  }
  const std::string name = attributes.Name(key);
  const auto at = tree.joint_named.find(name);
  if (at == tree.joint_named.end()) {
    std::vector<std::string> names;
    for (const auto& [known, index] : tree.joint_named) names.push_back(known);
    RefuseMjcf(FailureCode::kMjcfActuator, fmt::format("{}: there is no joint '{}'{}", attributes.owner(),
                                                       ShownMjcf(name), NearestOrAll(name, names)));
  }
  if (tree.Moves(at->second)) return at->second;
  if (!tree.IsRobotJoint(at->second)) return -1;  // there is a note on its body
  context.Note(attributes.owner(),
               fmt::format("it drives '{}', which is left out; the actuator is left out too", name));
  return -1;
}

void AddMjcfActuator(MjcfContext& context, const MjcfAttributes& attributes, const std::string& tag,
                     const MjcfJoint& joint, MjcfDrive& drive) {
  if (tag == "damper" || tag == "adhesion") {
    context.Note(attributes.owner(), "it does not drive a joint by its control alone; it is left out");
    return;
  }
  ++drive.actuators;
  std::vector<double> gear = attributes.Numbers("gear", 1, 6);
  if (gear.empty()) gear = {1.0};
  gear.resize(3, 0.0);
  if (joint.is_scalar()) gear[1] = gear[2] = 0.0;
  const Vector3 ratio = Vector3(gear[0], gear[1], gear[2]).cwiseAbs();
  const MjcfForce force = ReadMjcfForce(context, attributes, tag);
  drive.is_bounded = drive.is_bounded && force.most.has_value();
  drive.effort += force.most.value_or(0.0) * ratio;
  if (!joint.is_scalar()) return;
  drive.stiffness += std::max(force.stiffness, 0.0) * ratio.x() * ratio.x();
  drive.damping += std::max(force.damping, 0.0) * ratio.x() * ratio.x();
}

/// Effort limit of a joint. A ball joint has one limit for all axes, the smallest limit of the driven axes.
double MjcfEffortOf(MjcfContext& context, const MjcfJoint& joint, const MjcfDrive& drive) {
  if (joint.is_scalar()) return drive.effort.x();
  double least = drive.effort.maxCoeff();
  for (const double effort : drive.effort) least = effort > 0.0 ? std::min(least, effort) : least;
  if (least != drive.effort.minCoeff() || least != drive.effort.maxCoeff())
    context.Note(joint.owner,
                 fmt::format("its actuators differ by axis; an effort limit of {} is used for all axes", least));
  return least;
}

}  // namespace

std::vector<MjcfDrive> ReadMjcfDrives(MjcfContext& context, const MjcfTree& tree) {
  std::vector<MjcfDrive> drives(tree.joints.size());
  for (const tinyxml2::XMLElement* element : context.document.InSections("actuator")) {
    const std::string tag = element->Name();
    const MjcfAttributes attributes = context.defaults.Of(*element, "actuator");
    if (!IsMjcfActuator(tag)) {
      context.Note(attributes.owner(), "this kind of actuator is unknown; it is left out");
      continue;
    }
    const int joint = MjcfDrivenJoint(context, attributes, tree);
    if (joint < 0) continue;
    const auto j = static_cast<std::size_t>(joint);
    AddMjcfActuator(context, attributes, tag, tree.joints[j], drives[j]);
  }
  return drives;
}

std::vector<double> MjcfEfforts(MjcfContext& context, const MjcfTree& tree, const std::vector<MjcfDrive>& drives,
                                const std::vector<bool>& follows) {
  std::vector<double> efforts(drives.size(), kMjcfUnknownEffort);
  const bool any =
      std::any_of(drives.begin(), drives.end(), [](const MjcfDrive& drive) { return drive.actuators > 0; });
  if (!any)
    context.Note(context.document.Owner(context.document.root()),
                 "the model has no joint actuators, so effort limits are unknown");
  for (std::size_t j = 0; j < drives.size(); ++j) {
    const MjcfJoint& joint = tree.joints[j];
    if (!tree.Moves(static_cast<int>(j)) || follows[j]) continue;
    if (any && drives[j].actuators == 0) {
      efforts[j] = 0.0;
      context.Note(joint.owner, fmt::format("it has no actuator, so it has no motor here; if a motor drives it, add to "
                                            "robot.yaml: limits: {{'{}': {{{}: ...}}}}",
                                            joint.is_scalar() ? joint.name : joint.name + "_x",
                                            joint.type == MjcfJointType::kSlide ? "effort_n" : "effort_nm"));
      continue;
    }
    const double own = any && drives[j].is_bounded ? MjcfEffortOf(context, joint, drives[j]) : kMjcfUnknownEffort;
    efforts[j] = std::min(own, joint.force_limit.value_or(kMjcfUnknownEffort));
    if (efforts[j] <= 0.0) efforts[j] = kMjcfUnknownEffort;
    if (any && efforts[j] == kMjcfUnknownEffort)
      context.Note(joint.owner, "its actuators have no force limit, so its effort limit is unknown");
  }
  return efforts;
}

}  // namespace gaitwright
