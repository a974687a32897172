// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/body_tree.h"
#include "kinematics/model/idle_joints_internal.h"

namespace gaitwright {

std::vector<std::string> IdleJoints(const RobotModel& model) {
  constexpr double kNothing = 1e-12;  // [kg m^2], [kg]
  std::vector<std::string> idle;
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Pose X_OJ = X_OB[static_cast<std::size_t>(model.joints[j].parent_body)] * model.joints[j].X_PJ;
    const Vector3 axis = X_OJ.linear() * model.joints[j].axis_J;
    double inertia = 0.0;
    for (std::size_t i = j + 1; i < model.bodies.size(); ++i) {
      if (!Carries(model, static_cast<int>(j) + 1, static_cast<int>(i))) continue;
      const Body& body = model.bodies[i];
      const Vector3 arm = X_OB[i] * body.p_BC - X_OJ.translation();
      const Vector3 axis_B = X_OB[i].linear().transpose() * axis;
      inertia += model.joints[j].is_prismatic()
                     ? body.mass
                     : axis_B.dot(body.I_C * axis_B) + body.mass * axis.cross(arm).squaredNorm();
    }
    if (inertia < kNothing) idle.push_back(model.joints[j].name);
  }
  return idle;
}

std::vector<std::string> FixJoints(urdf::ModelInterface& urdf, std::vector<std::string> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (const auto& [name, joint] : urdf.joints_) {
      if (name == names[i]) {
        joint->type = urdf::Joint::FIXED;
        joint->mimic.reset();
      } else if (joint->mimic && joint->mimic->joint_name == names[i]) {
        names.push_back(name);
      }
    }
  }
  return names;
}

}  // namespace gaitwright
