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

/// The keys of both a joint's motor and a transmission's motor: curve, thermal limit and rotor.
std::vector<ShapeMember> TurningMotorKeys(const std::string& of_rotor) {
  const DataShape positive = Positive(kLargestValue);
  return {Optional("corner_velocity_rad_s", positive, "Speed up to which the motor gives its full effort."),
          Optional("no_load_velocity_rad_s", positive, "Speed at which the motor gives no effort."),
          Optional("continuous_nm", positive, "Continuous effort, as root mean square."),
          Optional("thermal_s", positive, "Averaging time of the continuous effort; default 10."),
          Optional("rotor_inertia_kg_m2", positive, of_rotor)};
}

/// TurningMotorKeys in the units of a linear motor.
std::vector<ShapeMember> SlidingMotorKeys() {
  const DataShape positive = Positive(kLargestValue);
  return {Optional("corner_velocity_m_s", positive), Optional("no_load_velocity_m_s", positive),
          Optional("continuous_n", positive), Optional("rotor_mass_kg", positive)};
}

}  // namespace

DataShape FootYamlShape() {
  return Object(
      {{"link", Text(), "Link at the end of a chain of moving joints."},
       Optional("type", Text(FootTypeNames()), "Type of the foot; derived from the link's shapes by default."),
       Optional("radius_m", Positive(kLongestPart), "Radius of a spherical foot."),
       Optional("sole_m", List(Numbers(2), 3, kMaxSoleCorners),
                "Corners [x, y] in the link's plane, convex, in order around it."),
       Optional("sole_give_m", Number(0.0, kLargestSoleGive),
                "Compression of the sole's rubber for this foot, instead of the value for all feet.")});
}

DataShape LegYamlShape() {
  return Object({Optional("joints", List(Text()), "Joints from the base to the foot, as a check."),
                 Optional("knee", Text(), "Joint that bends the leg."),
                 Optional("knee_side", Text({"plus", "minus"}), "Sign of the knee's position.")});
}

DataShape LimitsYamlShape() {
  const DataShape any = Number(-kLargestValue, kLargestValue), positive = Positive(kLargestValue);
  return Object({Optional("lower_rad", any, "Lower limit of a revolute joint."),
                 Optional("upper_rad", any, "Upper limit of a revolute joint."),
                 Optional("velocity_rad_s", positive, "Speed limit of a revolute joint."),
                 Optional("effort_nm", positive, "Effort limit of a revolute joint."),
                 Optional("lower_m", any, "Lower limit of a prismatic joint."),
                 Optional("upper_m", any, "Upper limit of a prismatic joint."),
                 Optional("velocity_m_s", positive, "Speed limit of a prismatic joint."),
                 Optional("effort_n", positive, "Effort limit of a prismatic joint.")});
}

DataShape GainsYamlShape() {
  const DataShape positive = Positive(kLargestValue);
  return Object({Optional("stiffness_nm_rad", positive, "Stiffness of a revolute joint."),
                 Optional("damping_nm_s_rad", positive, "Damping gain of a revolute joint."),
                 Optional("stiffness_n_m", positive, "Stiffness of a prismatic joint."),
                 Optional("damping_n_s_m", positive, "Damping gain of a prismatic joint.")});
}

DataShape MotorYamlShape() {
  const DataShape positive = Positive(kLargestValue);
  std::vector<ShapeMember> keys = TurningMotorKeys("Inertia of rotor and gear, reflected to the joint.");
  keys.insert(keys.end(), {Optional("acceleration_rad_s2", positive, "Largest acceleration."),
                           Optional("jerk_rad_s3", positive, "Largest jerk."),
                           Optional("damping_nm_s_rad", positive, "Viscous damping of the joint."),
                           Optional("friction_nm", positive, "Dry friction of the joint.")});
  std::vector<ShapeMember> sliding = SlidingMotorKeys();
  sliding.front().meaning =
      "Speed up to which the motor of a prismatic joint gives its full effort. The keys below are for prismatic joints "
      "only.";
  sliding.insert(sliding.end(), {Optional("acceleration_m_s2", positive), Optional("jerk_m_s3", positive),
                                 Optional("damping_n_s_m", positive), Optional("friction_n", positive)});
  keys.insert(keys.end(), sliding.begin(), sliding.end());
  return Object(keys);
}

DataShape TransmissionMotorYamlShape() {
  const DataShape positive = Positive(kLargestValue);
  std::vector<ShapeMember> keys = {{"name", Text(), "Name of the motor in reports."},
                                   {"ratios", List(Number(-kLargestRatio, kLargestRatio), 2, kMostShared),
                                    "Motor speed for unit speed of each joint, in the order of 'joints'."},
                                   Optional("effort_nm", positive, "Largest torque; not checked unless given."),
                                   Optional("velocity_rad_s", positive, "Largest speed; not checked unless given.")};
  const auto add = [&](const std::vector<ShapeMember>& more) { keys.insert(keys.end(), more.begin(), more.end()); };
  add(TurningMotorKeys("Inertia of rotor and gear at the motor's shaft."));
  add({Optional("effort_n", positive, "Largest force of a linear motor. The keys below are for linear motors only."),
       Optional("velocity_m_s", positive)});
  add(SlidingMotorKeys());
  return Object(keys);
}

DataShape TransmissionYamlShape() {
  return Object({{"name", Text(), "Name of the transmission in messages."},
                 {"joints", List(Text(), 2, kMostShared), "Joints that the motors drive together."},
                 {"motors", List(TransmissionMotorYamlShape(), 2, kMostShared), "Motors, one for each joint."}});
}

DataShape RobotYamlShape() {
  const DataShape axis = Text(AxisNames()), by_joint = Number(-kLargestValue, kLargestValue);
  return Object(
      {Optional("name", Text(), "Name of the robot."), Optional("description", Text(), "One-sentence description."),
       Optional("scale", Number(1e-3, 1e3), "Factor on all lengths of the URDF."),
       Optional("up", axis, "Axis of the root link that points up; needs 'ahead'."),
       Optional("ahead", axis, "Axis of the root link that points forward; needs 'up'."),
       Optional("limits", MapOf(LimitsYamlShape()), "Limits by joint, which replace the URDF's."),
       Optional("feet", List(FootYamlShape(), 1), "All feet, instead of derived ones."),
       Optional("sole_give_m", Number(0.0, kLargestSoleGive),
                "Compression of the rubber of all soles: parts of a foot's shapes up to this height above their lowest "
                "point belong to the sole."),
       Optional("legs", MapOf(LegYamlShape()), "Overrides for a leg, by the foot's link."),
       Optional("mirror_pairs", List(List(Text(), 2, 2)), "All pairs of feet whose legs mirror each other."),
       Optional("standing", MapOf(by_joint), "Positions of joints in the standing posture, by joint [rad], [m]."),
       Optional("standing_base_height_m", Positive(kLongestPart),
                "Height of the root link above level ground in the standing posture."),
       Optional("nominal_speed_m_s", Positive(kFastestWalk), "Default walking speed."),
       Optional("gains", MapOf(GainsYamlShape()), "Gains of motors, by joint."),
       Optional("motors", MapOf(MotorYamlShape()), "Data of motors, by joint."),
       Optional("transmissions", List(TransmissionYamlShape()), "Motors that drive several joints together."),
       Optional("rests", List(Text()), "Links that the robot may lie on.")});
}

}  // namespace gaitwright
