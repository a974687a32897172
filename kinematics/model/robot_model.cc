// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/robot_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

/// The tightest limit of all joints that one coordinate moves.
template <class Limit>
double Tightest(const RobotModel& model, int dof, Limit limit) {
  double tightest = std::numeric_limits<double>::infinity();
  for (const Joint& joint : model.joints) {
    if (joint.dof == dof && joint.multiplier != 0.0) tightest = std::min(tightest, limit(joint));
  }
  return tightest;
}

/// The coordinate's value at which a joint is at one of its limits.
double AtLimit(const Joint& joint, bool upper) {
  const bool high = upper == (joint.multiplier > 0.0);
  return ((high ? joint.upper : joint.lower) - joint.offset) / joint.multiplier;
}

}  // namespace

const std::vector<std::string>& FootTypeNames() {
  static const std::vector<std::string> names = {"point", "sphere", "line", "sole"};
  return names;
}

double RobotModel::dof_lower(int dof) const {
  return -Tightest(*this, dof, [](const Joint& joint) { return -AtLimit(joint, false); });
}

double RobotModel::dof_upper(int dof) const {
  return Tightest(*this, dof, [](const Joint& joint) { return AtLimit(joint, true); });
}

double RobotModel::dof_velocity_limit(int dof) const {
  return Tightest(*this, dof, [](const Joint& joint) {
    return joint.velocity_limit_is_placeholder ? std::numeric_limits<double>::infinity()
                                               : joint.velocity_limit / std::abs(joint.multiplier);
  });
}

double RobotModel::dof_effort_limit(int dof) const {
  const Joint& leader = LeaderOf(dof);
  return leader.effort_limit_is_placeholder ? std::numeric_limits<double>::infinity() : leader.effort_limit;
}

const Joint& RobotModel::LeaderOf(int dof) const {
  return joints[static_cast<std::size_t>(dof_joint[static_cast<std::size_t>(dof)])];
}

const Motor& RobotModel::MotorOf(int dof) const {
  static const Motor plain;
  const auto at = static_cast<std::size_t>(dof);
  return at < motors.size() ? motors[at] : plain;
}

const Transmission* RobotModel::TransmissionOf(int dof) const {
  const auto drives = [dof](const Transmission& t) {
    return std::find(t.dofs.begin(), t.dofs.end(), dof) != t.dofs.end();
  };
  const auto at = std::find_if(transmissions.begin(), transmissions.end(), drives);
  return at == transmissions.end() ? nullptr : &*at;
}

double RobotModel::leg_length_m() const {
  double longest = 0.0;
  for (const Leg& leg : legs) longest = std::max(longest, leg.length_m);
  return longest;
}

int RobotModel::FrameIndex(const std::string& frame_name) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].name == frame_name) return static_cast<int>(i);
    names.push_back(frames[i].name);
  }
  throw InvalidArgument(
      fmt::format("robot '{}' has no link '{}'{}", name, frame_name, NearestOrAll(frame_name, names)));
}

int RobotModel::DofIndex(const std::string& joint_name) const {
  const auto at = std::find(dof_names.begin(), dof_names.end(), joint_name);
  if (at == dof_names.end()) {
    throw InvalidArgument(
        fmt::format("robot '{}' has no moving joint '{}'{}", name, joint_name, NearestOrAll(joint_name, dof_names)));
  }
  return static_cast<int>(at - dof_names.begin());
}

VectorX StandingConfiguration(const RobotModel& model) {
  VectorX q = VectorX::Zero(model.nq());
  q[2] = model.standing_base_height_m;
  q[6] = 1.0;
  q.tail(model.num_dofs()) = model.standing_joints;
  return q;
}

}  // namespace gaitwright
