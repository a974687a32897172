// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/data_shape.h"
#include "kinematics/base/result.h"

namespace gaitwright {

/// Range of accepted values.
struct PolicyRange {
  double lowest = 0.0, highest = 0.0;

  bool operator==(const PolicyRange&) const = default;
};

/// One kind of observation. A scale has one number for each element, or one for all.
struct ObservationTerm {
  std::string name;
  std::vector<double> scale = {1.0};
  std::optional<PolicyRange> clip = {};
  int history = 1;                      ///< number of the last values, the oldest first
  bool scale_first = false;             ///< scales before it clips
  std::optional<double> period_s = {};  ///< of gait_phase
  std::vector<int> joints = {};         ///< of joint positions and velocities, in the network's order; empty for all

  bool operator==(const ObservationTerm&) const = default;
};

/// Position targets of the joints: offset + scale x output, within `clip`. Lists have one number for each output, or
/// one for all.
struct PolicyAction {
  std::vector<double> scale = {1.0};
  std::vector<double> offset;     ///< empty for the default positions
  std::vector<PolicyRange> clip;  ///< empty for no limits
  std::vector<int> joints = {};   ///< in the network's order; empty for all joints

  bool operator==(const PolicyAction&) const = default;
};

/// What a learned policy expects of a robot and of the program that runs it: Unitree's `deploy.yaml`, with two optional
/// keys for the names of joints; docs/policies.md.
///
/// = Orders =  The network's order is that of `default_position`, actions and observations. The hardware's order is
/// that of `stiffness` and `damping`. Joint i of the network is number joint_ids_map[i] of the hardware; without that
/// list both orders are the same.
struct PolicyContract {
  std::vector<std::string> joint_names;     ///< in the network's order; may be empty
  std::vector<std::string> hardware_names;  ///< in the hardware's order; may be empty
  std::vector<int> joint_ids_map;           ///< may be empty
  double step_s = 0.02;
  std::vector<double> stiffness, damping;                                   ///< [N m/rad], [N m s/rad]
  std::vector<double> default_position;                                     ///< [rad]
  std::optional<PolicyRange> speed_m_s, lateral_speed_m_s, yaw_rate_rad_s;  ///< commands that the policy was trained on
  PolicyAction action;
  std::vector<ObservationTerm> observations;
  bool history_by_frame =
      false;  ///< all observations of the oldest time first; else all times of the first observation

  int num_joints() const { return static_cast<int>(default_position.size()); }
  /// Index of joint i of the network in `stiffness` and `damping`. These lists hold either all motors up to the largest
  /// number in `joint_ids_map`, or only the motors in it, in ascending order.
  int HardwareIndex(int joint) const;

  bool operator==(const PolicyContract&) const = default;
};

/// Structure of a contract.
DataShape ContractShape();

/// Reads a contract. Failure kBadInput, with the line, for unknown keys, unknown observations, numbers out of range and
/// lists whose sizes contradict each other. @param source  name of the file in messages.
Result<PolicyContract> ReadContract(const std::string& text, const std::string& source);

}  // namespace gaitwright
