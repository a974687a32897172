// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/model/joint_losses.h"
#include "workflows/exchange/median_internal.h"
#include "workflows/repair/stuck_joints_internal.h"

namespace gaitwright {

std::vector<HeldJoint> HoldStuckJoints(const RobotModel& model, EvenMotion& motion) {
  constexpr double kNearlyAll = 0.9, kMost = 0.5;  // of a motor's limit
  constexpr double kHardly = 0.05;                 // [rad], [m]
  std::vector<HeldJoint> held;
  for (int dof = 0; dof < model.num_dofs() && !motion.q.empty(); ++dof) {
    HeldJoint joint{dof, 0.0, LossesOf(model, dof).friction, model.dof_effort_limit(dof)};
    if (!std::isfinite(joint.limit) || joint.friction < kMost * joint.limit || joint.friction <= 0.0) continue;
    std::vector<double> positions;
    for (const VectorX& q : motion.q) positions.push_back(q[7 + dof]);
    const double place = std::clamp(MedianOf(positions), model.dof_lower(dof), model.dof_upper(dof));
    for (const double position : positions) joint.moved = std::max(joint.moved, std::abs(position - place));
    if (joint.moved == 0.0 || (joint.friction < kNearlyAll * joint.limit && joint.moved > kHardly)) continue;
    for (VectorX& q : motion.q) q[7 + dof] = place;
    held.push_back(joint);
  }
  return held;
}

}  // namespace gaitwright
