// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "playback/policy/contract_internal.h"

namespace gaitwright {

inline constexpr char kGaitPhase[] = "gait_phase";

/// Names of all observations, and the meaning of one.
const std::vector<std::string>& ObservationNames();
const std::string& ObservationMeaning(const std::string& name);

/// What observations are made of, at one time.
struct PolicyState {
  Matrix3 R_WB = Matrix3::Identity();
  double height_m = 0.0;                                     ///< of the base's origin in W
  Vector3 v_WB = Vector3::Zero(), w_WB = Vector3::Zero();    ///< in W [m/s], [rad/s]
  Vector3 command = Vector3::Zero();                         ///< forward, lateral [m/s], yaw rate [rad/s]
  VectorX joint_position, joint_velocity, default_position;  ///< in the network's order
  Eigen::VectorXf last_action;                               ///< the network's last output
  double time_s = 0.0;                                       ///< since the start of the policy
};

/// Number of elements of a term at one time. @param joints, actions  of the policy.
int SizeOf(const ObservationTerm& term, int joints, int actions);

/// Number of elements of all terms with their histories.
int SizeOf(const PolicyContract& contract, int actions);

/// Keeps the histories and puts the network's input together.
class Observer {
 public:
  /// @pre the contract's lists fit the numbers of joints and actions, see FitPolicy.
  Observer(const PolicyContract& contract, int actions);

  /// Forgets the history; the next observation fills it.
  void Reset() { begun_ = false; }
  /// Adds the observations of a state, and returns the input of the network.
  const Eigen::VectorXf& Observe(const PolicyState& state);

 private:
  const PolicyContract& contract_;
  std::vector<Eigen::VectorXf> histories_;  ///< by term: its last values, the oldest first
  std::vector<int> sizes_;                  ///< by term
  Eigen::VectorXf now_, input_;
  bool begun_ = false;
};

}  // namespace gaitwright
