// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/passive_joints.h"

#include <cmath>

#include "kinematics/model/body_tree.h"

namespace gaitwright {

bool IsPassive(const RobotModel& model, int dof) {
  const Joint& joint = model.LeaderOf(dof);
  if (!joint.effort_limit_is_placeholder || joint.effort_limit != 0.0) return false;
  const std::vector<int> leg_of = LegsOfDofs(model);
  const int leg = leg_of[static_cast<std::size_t>(dof)];
  for (int other = 0; other < model.num_dofs(); ++other) {
    if (leg >= 0 && leg_of[static_cast<std::size_t>(other)] != leg) continue;
    if (std::isfinite(model.dof_effort_limit(other))) return true;
  }
  return false;
}

}  // namespace gaitwright
