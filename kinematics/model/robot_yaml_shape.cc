// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/robot_yaml_shape.h"

#include <string>
#include <vector>

#include "kinematics/model/base_axes.h"
#include "kinematics/model/flat_bottom.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/robot_yaml_shape_internal.h"

namespace gaitwright {

using namespace shapes;

namespace {

/// What the motor of one joint and a motor of a transmission have both: curve, warmth and rotor.
std::vector<ShapeMember> TurningMotorKeys(const std::string& of_rotor) {
  const DataShape positive = Positive(kLargestValue);
  return {Optional("corner_velocity_rad_s", positive, "Up to there the motor gives its whole effort."),
          Optional("no_load_velocity_rad_s", positive, "There it gives none."),
          Optional("continuous_nm", positive, "Root mean square of effort that it bears without end."),
          Optional("thermal_s", positive, "Time over which that mean is taken; 10 unless given."),
          Optional("rotor_inertia_kg_m2", positive, of_rotor)};
}

/// TurningMotorKeys in the units of a motor that slides.
std::vector<ShapeMember> SlidingMotorKeys() {
  const DataShape positive = Positive(kLargestValue);
  return {Optional("corner_velocity_m_s", positive), Optional("no_load_velocity_m_s", positive),
          Optional("continuous_n", positive), Optional("rotor_mass_kg", positive)};
}

}  // namespace

DataShape FootYamlShape() {
  return Object({{"link", Text(), "The link at the end of a chain of moving joints."},
                 Optional("type", Text(FootTypeNames()), "Derived from the link's shapes unless given."),
                 Optional("radius_m", Positive(kLongestPart), "Of a sphere."),
                 Optional("sole_m", List(Numbers(2), 3, kMaxSoleCorners),
                          "Corners [x, y] in the link's plane, convex, in order around it."),
                 Optional("sole_give_m", Number(0.0, kLargestSoleGive), "In place of that of all feet.")});
}

DataShape LegYamlShape() {
  return Object({Optional("joints", List(Text()), "The chain from the base to the foot, as a check."),
                 Optional("knee", Text(), "The joint that bends the leg."),
                 Optional("knee_side", Text({"plus", "minus"}), "The sign of the knee's position.")});
}

DataShape LimitsYamlShape() {
  const DataShape any = Number(-kLargestValue, kLargestValue), positive = Positive(kLargestValue);
  return Object(
      {Optional("lower_rad", any, "Of a joint that turns."), Optional("upper_rad", any, "Of a joint that turns."),
       Optional("velocity_rad_s", positive, "Of a joint that turns."),
       Optional("effort_nm", positive, "Of a joint that turns."), Optional("lower_m", any, "Of one that slides."),
       Optional("upper_m", any, "Of one that slides."), Optional("velocity_m_s", positive, "Of one that slides."),
       Optional("effort_n", positive, "Of one that slides.")});
}

DataShape GainsYamlShape() {
  const DataShape positive = Positive(kLargestValue);
  return Object({Optional("stiffness_nm_rad", positive, "Of a joint that turns."),
                 Optional("damping_nm_s_rad", positive, "Of a joint that turns."),
                 Optional("stiffness_n_m", positive, "Of one that slides."),
                 Optional("damping_n_s_m", positive, "Of one that slides.")});
}

DataShape MotorYamlShape() {
  const DataShape positive = Positive(kLargestValue);
  std::vector<ShapeMember> keys = TurningMotorKeys("Of rotor and gear, as felt at the joint.");
  keys.insert(keys.end(), {Optional("acceleration_rad_s2", positive, "Largest acceleration."),
                           Optional("jerk_rad_s3", positive, "Largest jerk."),
                           Optional("damping_nm_s_rad", positive, "The joint's own damping."),
                           Optional("friction_nm", positive, "The joint's dry friction.")});
  std::vector<ShapeMember> sliding = SlidingMotorKeys();
  sliding.front().meaning = "The same of a joint that slides, as all that follow.";
  sliding.insert(sliding.end(), {Optional("acceleration_m_s2", positive), Optional("jerk_m_s3", positive),
                                 Optional("damping_n_s_m", positive), Optional("friction_n", positive)});
  keys.insert(keys.end(), sliding.begin(), sliding.end());
  return Object(keys);
}

DataShape TransmissionMotorYamlShape() {
  const DataShape positive = Positive(kLargestValue);
  std::vector<ShapeMember> keys = {{"name", Text(), "What reports call it."},
                                   {"ratios", List(Number(-kLargestRatio, kLargestRatio), 2, kMostShared),
                                    "Speed of the motor for a speed of 1 of each joint, in the order of 'joints'."},
                                   Optional("effort_nm", positive, "Largest torque; not checked unless given."),
                                   Optional("velocity_rad_s", positive, "Largest speed; not checked unless given.")};
  const auto add = [&](const std::vector<ShapeMember>& more) { keys.insert(keys.end(), more.begin(), more.end()); };
  add(TurningMotorKeys("Of rotor and gear, as felt at the motor's own shaft."));
  add({Optional("effort_n", positive, "Largest force of a motor that slides, as all that follow."),
       Optional("velocity_m_s", positive)});
  add(SlidingMotorKeys());
  return Object(keys);
}

DataShape TransmissionYamlShape() {
  return Object({{"name", Text(), "What messages call it."},
                 {"joints", List(Text(), 2, kMostShared), "The joints that its motors drive together."},
                 {"motors", List(TransmissionMotorYamlShape(), 2, kMostShared), "As many as joints."}});
}

DataShape RobotYamlShape() {
  const DataShape axis = Text(AxisNames()), by_joint = Number(-kLargestValue, kLargestValue);
  return Object({Optional("name", Text(), "What the robot is called."),
                 Optional("description", Text(), "A sentence about it."),
                 Optional("scale", Number(1e-3, 1e3), "By which the URDF's lengths are multiplied."),
                 Optional("up", axis, "Axis of the root link, with 'ahead'."),
                 Optional("ahead", axis, "Axis of the root link, with 'up'."),
                 Optional("limits", MapOf(LimitsYamlShape()), "By joint, in place of the URDF's."),
                 Optional("feet", List(FootYamlShape(), 1), "All feet."),
                 Optional("sole_give_m", Number(0.0, kLargestSoleGive),
                          "What of a foot's shapes is no higher than that over their lowest point is its sole."),
                 Optional("legs", MapOf(LegYamlShape()), "By the foot's link: what differs in its leg."),
                 Optional("mirror_pairs", List(List(Text(), 2, 2)), "All pairs of feet that mirror each other."),
                 Optional("standing", MapOf(by_joint), "By joint: its position in the standing posture [rad], [m]."),
                 Optional("standing_base_height_m", Positive(kLongestPart), "Of the root link over level ground."),
                 Optional("nominal_speed_m_s", Positive(kFastestWalk), "Of a walk that does not say its own."),
                 Optional("gains", MapOf(GainsYamlShape()), "By joint: gains of its motor."),
                 Optional("motors", MapOf(MotorYamlShape()), "By joint: what its motor can and takes."),
                 Optional("transmissions", List(TransmissionYamlShape()), "Motors that drive several joints together."),
                 Optional("rests", List(Text()), "Links that the robot may lie on.")});
}

}  // namespace gaitwright
