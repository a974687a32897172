// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/body_tree.h"
#include "workflows/repair/joint_groups_internal.h"

namespace gaitwright {

std::vector<std::string> GroupsOfJoints(const RobotModel& model, const UpperBody& upper) {
  std::vector<std::string> groups(static_cast<std::size_t>(model.num_dofs()), kTorsoJoints);
  const auto set = [&](int dof, const char* group) { groups[static_cast<std::size_t>(dof)] = group; };
  if (upper.head) {
    for (const int dof : upper.head->dofs) set(dof, kHeadJoints);
  }
  for (const bool left : {true, false}) {
    if (!upper.arm(left)) continue;
    const int root = model.dof_joint[static_cast<std::size_t>(upper.arm(left)->dofs.front())] + 1;
    for (int dof = 0; dof < model.num_dofs(); ++dof) {
      if (Carries(model, root, model.dof_joint[static_cast<std::size_t>(dof)] + 1)) set(dof, kArmJoints);
    }
  }
  for (const Leg& leg : model.legs) {
    for (const int joint : leg.joints) set(model.joints[static_cast<std::size_t>(joint)].dof, kLegJoints);
  }
  return groups;
}

}  // namespace gaitwright
