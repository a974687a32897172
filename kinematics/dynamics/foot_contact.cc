// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/foot_contact.h"

namespace gaitwright {

Pose ContactFrame(const RobotModel& model, const DynamicsScratch& scratch, int foot, const Vector3& normal_W) {
  const Foot& f = model.feet[static_cast<std::size_t>(foot)];
  Pose X_WF = FramePose(scratch, f.body, f.X_BF);
  X_WF.translation() -= f.radius * normal_W;
  return X_WF;
}

std::vector<Vector3> ContactPoints(const RobotModel& model, const DynamicsScratch& scratch, int foot,
                                   const Vector3& normal_W) {
  return ContactPoints(model.feet[static_cast<std::size_t>(foot)], ContactFrame(model, scratch, foot, normal_W));
}

std::vector<Vector3> ContactPoints(const Foot& foot, const Pose& X_WF) {
  if (foot.sole_F.empty()) return {X_WF.translation()};
  std::vector<Vector3> corners;
  for (const Vector2& corner : foot.sole_F) corners.push_back(X_WF * Vector3(corner.x(), corner.y(), 0.0));
  return corners;
}

void AddPointForce(const RobotModel& model, const DynamicsScratch& scratch, int body, const Vector3& p_WQ,
                   const Vector3& force_W, VectorX& tau) {
  Vector6 wrench;
  wrench << force_W, Vector3::Zero();
  AddPointWrench(model, scratch, body, p_WQ, wrench, tau);
}

void AddPointWrench(const RobotModel& model, const DynamicsScratch& scratch, int body, const Vector3& p_WQ,
                    const Vector6& force_and_moment_W, VectorX& tau) {
  const Vector3 force = force_and_moment_W.head<3>(), moment = force_and_moment_W.tail<3>();
  tau.head<3>() += force;
  tau.segment<3>(3) += moment + (p_WQ - scratch.p_WB[0]).cross(force);
  for (int i = body; i > 0; i = model.joints[static_cast<std::size_t>(i - 1)].parent_body) {
    const auto j = static_cast<std::size_t>(i - 1);
    const Joint& joint = model.joints[j];
    const Vector3& axis = scratch.axis_W[j];
    const double load =
        joint.is_prismatic() ? axis.dot(force) : axis.dot(moment + (p_WQ - scratch.p_WB[j + 1]).cross(force));
    tau[6 + joint.dof] += joint.multiplier * load;
  }
}

void AddHeldWeight(const RobotModel& model, const DynamicsScratch& scratch, double share, VectorX& tau) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body& body = model.bodies[b];
    AddPointForce(model, scratch, static_cast<int>(b), scratch.p_WB[b] + scratch.R_WB[b] * body.p_BC,
                  share * body.mass * kGravity * Vector3::UnitZ(), tau);
  }
}

}  // namespace gaitwright
