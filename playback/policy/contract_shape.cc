// SPDX-License-Identifier: BSD-3-Clause
#include "playback/policy/contract_internal.h"
#include "playback/policy/observations_internal.h"

namespace gaitwright {
namespace {

using namespace shapes;

constexpr std::size_t kMostJoints = 300, kMostHistory = 1000;
constexpr double kMostGain = 1e6, kMostNumber = 1e6, kLongestStep = 1.0;

/// One number for all elements, or a number for each of them.
DataShape OneOrEach(const DataShape& number) { return Either(number, List(number, 1, 10 * kMostJoints)); }

DataShape Bounded() { return Number(-kMostNumber, kMostNumber); }
DataShape RangeShape() { return List(Bounded(), 2, 2); }
DataShape IndicesShape() { return List(Whole(0.0, 10000.0), 1, kMostJoints); }

DataShape RangesShape() {
  return Object({Optional("lin_vel_x", OrNull(RangeShape()), "Forward speed [m/s]."),
                 Optional("lin_vel_y", OrNull(RangeShape()), "Lateral speed, positive to the left [m/s]."),
                 Optional("ang_vel_z", OrNull(RangeShape()), "Yaw rate, positive to the left [rad/s]."),
                 Optional("heading", Anything(), "Not used: commands are velocities.")});
}

DataShape CommandsShape() {
  return Object({Optional("base_velocity", Object({{"ranges", RangesShape(), "Commands of the training."}}),
                          "Velocity commands.")});
}

DataShape ActionShape() {
  return Object(
      {Optional("scale", OrNull(OneOrEach(Bounded())), "Factor on the outputs; default 1."),
       Optional("offset", OrNull(OneOrEach(Bounded())), "Position at output 0 [rad]; default: default_joint_pos."),
       Optional("clip", OrNull(Either(RangeShape(), List(RangeShape(), 1, kMostJoints))),
                "Lowest and highest position target [rad]: for all joints, or for each."),
       Optional("joint_names", Anything(), "Patterns of the training; not used."),
       Optional("joint_ids", OrNull(IndicesShape()),
                "Joints that the outputs move, in the network's order; default: all.")});
}

DataShape AssetShape() {
  return Object(
      {Optional("joint_ids", OrNull(IndicesShape()), "Observed joints, in the network's order; default: all."),
       Optional("name", Text(), "Not used."), Optional("joint_names", Anything(), "Not used.")});
}

DataShape TermShape() {
  return Object(
      {Optional("params",
                OrNull(Object({Optional("period", Positive(100.0), "Period of gait_phase [s]."),
                               Optional("command_name", Text(), "Not used: there is one command."),
                               Optional("asset_cfg", OrNull(AssetShape()), "Observed joints.")})),
                "Parameters of the observation."),
       Optional("clip", OrNull(RangeShape()), "Lowest and highest value; default: none."),
       Optional("scale", OrNull(OneOrEach(Bounded())), "Factor; default 1."),
       Optional("history_length", Whole(0.0, kMostHistory), "Number of the last values, oldest first; 0 is 1."),
       Optional("scale_first", Truth(), "Scale before clipping; default false.")});
}

DataShape ObservationsShape() {
  DataShape shape = Object({});
  for (const std::string& name : ObservationNames())
    shape.members.push_back(Optional(name, TermShape(), ObservationMeaning(name)));
  shape.members.push_back(
      Optional("use_gym_history", Truth(),
               "True: all observations of the oldest time come first. False (default): all times of "
               "the first observation come first."));
  shape.members.push_back(Optional("scale_first", Truth(), "Scale all observations before clipping; default false."));
  shape.least = 1;
  return shape;
}

}  // namespace

DataShape ContractShape() {
  const DataShape names = List(Text(), 1, kMostJoints);
  return Object(
      {{"step_dt", Positive(kLongestStep), "Time between two evaluations of the policy [s]."},
       Optional("joint_names", names, "Names of the robot's joints, in the network's order."),
       Optional("joint_sdk_names", names, "Names of the robot's joints, in the hardware's order."),
       Optional("joint_ids_map", IndicesShape(),
                "Number in the hardware's order of each joint of the network; default: both orders are the same."),
       {"stiffness", List(Number(0.0, kMostGain), 1, kMostJoints),
        "Joint stiffness, in the hardware's order [N m/rad]."},
       {"damping", List(Number(0.0, kMostGain), 1, kMostJoints), "Joint damping, in the hardware's order [N m s/rad]."},
       {"default_joint_pos", List(Bounded(), 1, kMostJoints),
        "Joint positions of standing, in the network's order [rad]."},
       Optional("commands", OrNull(CommandsShape()), "Commands that the policy was trained on."),
       {"actions", Object({{"JointPositionAction", ActionShape(), "Position targets: offset + scale x output."}}),
        "Meaning of the network's outputs."},
       {"observations", ObservationsShape(), "The network's inputs, in their order."}});
}

}  // namespace gaitwright
