// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "kinematics/dynamics/chain_kinematics.h"
#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {
namespace {

/// Rotation by an angle about a unit axis (Rodrigues).
Matrix3 AxisRotation(const Vector3& axis, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  const Vector3 t = (1.0 - c) * axis;
  const Vector3 sa = s * axis;
  Matrix3 R;
  R << t.x() * axis.x() + c, t.x() * axis.y() - sa.z(), t.x() * axis.z() + sa.y(),  //
      t.x() * axis.y() + sa.z(), t.y() * axis.y() + c, t.y() * axis.z() - sa.x(),   //
      t.x() * axis.z() - sa.y(), t.y() * axis.z() + sa.x(), t.z() * axis.z() + c;
  return R;
}

/// Sets the pose of the child body of joint j from the pose of its parent.
void PlaceChild(const RobotModel& model, const VectorX& q, std::size_t j, DynamicsScratch& scratch) {
  const Joint& joint = model.joints[j];
  const auto parent = static_cast<std::size_t>(joint.parent_body);
  const double position = joint.multiplier * q[7 + joint.dof] + joint.offset;
  const Matrix3 R_WJ = scratch.R_WB[parent] * joint.X_PJ.linear();
  scratch.axis_W[j].noalias() = R_WJ * joint.axis_J;
  scratch.p_WB[j + 1] = scratch.p_WB[parent] + scratch.R_WB[parent] * joint.X_PJ.translation();
  if (joint.is_prismatic()) {
    scratch.R_WB[j + 1] = R_WJ;
    scratch.p_WB[j + 1] += position * scratch.axis_W[j];
  } else {
    scratch.R_WB[j + 1].noalias() = R_WJ * AxisRotation(joint.axis_J, position);
  }
}

void PlaceBase(const VectorX& q, DynamicsScratch& scratch) {
  scratch.p_WB[0] = q.head<3>();
  scratch.R_WB[0] = BaseRotation(q);
}

}  // namespace

void ForwardKinematics(const RobotModel& model, const VectorX& q, DynamicsScratch& scratch) {
  PlaceBase(q, scratch);
  for (std::size_t j = 0; j < model.joints.size(); ++j) PlaceChild(model, q, j, scratch);
}

std::vector<int> JointsTo(const RobotModel& model, int body) {
  std::vector<int> joints;
  for (int i = body; i > 0; i = model.joints[static_cast<std::size_t>(i - 1)].parent_body) joints.push_back(i - 1);
  return {joints.rbegin(), joints.rend()};
}

void ChainKinematics(const RobotModel& model, const VectorX& q, const std::vector<int>& joints,
                     DynamicsScratch& scratch) {
  PlaceBase(q, scratch);
  for (const int j : joints) PlaceChild(model, q, static_cast<std::size_t>(j), scratch);
}

}  // namespace gaitwright
