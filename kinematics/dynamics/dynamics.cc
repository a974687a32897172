// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/dynamics.h"

#include <cmath>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

double JointRate(const Joint& joint, const VectorX& v) { return joint.multiplier * v[6 + joint.dof]; }

/// Inertia of a single body about O, in world axes.
DynamicsScratch::Composite BodyInertia(const Body& body, const Matrix3& R_WB, const Vector3& p_OB) {
  const Vector3 p_OC = p_OB + R_WB * body.p_BC;
  Matrix3 I = R_WB * body.I_C * R_WB.transpose() - body.mass * p_OC * p_OC.transpose();
  I.diagonal().array() += body.mass * p_OC.squaredNorm();
  return {body.mass, body.mass * p_OC, I};
}

/// Sets scratch.composite to the inertia of each body and all bodies beyond it.
void CompositeInertias(const RobotModel& model, DynamicsScratch& scratch) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    scratch.composite[i] = BodyInertia(model.bodies[i], scratch.R_WB[i], scratch.p_WB[i] - scratch.p_WB[0]);
  }
  for (std::size_t j = model.joints.size(); j-- > 0;) {
    auto& parent = scratch.composite[static_cast<std::size_t>(model.joints[j].parent_body)];
    const auto& child = scratch.composite[j + 1];
    parent.mass += child.mass;
    parent.moment_O += child.moment_O;
    parent.inertia_O += child.inertia_O;
  }
}

}  // namespace

DynamicsScratch::DynamicsScratch(const RobotModel& model) {
  const std::size_t n = model.bodies.size();
  R_WB.assign(n, Matrix3::Identity());
  for (auto* list : {&p_WB, &w_WB, &v_WB, &alpha_bias_W, &a_bias_W, &alpha_W, &a_W, &force_W, &moment_W}) {
    list->assign(n, Vector3::Zero());
  }
  axis_W.assign(model.joints.size(), Vector3::Zero());
  composite.assign(n, {0.0, Vector3::Zero(), Matrix3::Zero()});
}

void ForwardVelocities(const RobotModel& model, const VectorX& q, const VectorX& v, DynamicsScratch& scratch) {
  ForwardKinematics(model, q, scratch);
  scratch.v_WB[0] = v.head<3>();
  scratch.w_WB[0] = v.segment<3>(3);
  scratch.alpha_bias_W[0].setZero();
  scratch.a_bias_W[0].setZero();
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    const auto parent = static_cast<std::size_t>(joint.parent_body);
    const Vector3 r = scratch.p_WB[j + 1] - scratch.p_WB[parent];
    const Vector3& w = scratch.w_WB[parent];
    const Vector3 motion = JointRate(joint, v) * scratch.axis_W[j];
    const Vector3 w_cross_r = w.cross(r);
    scratch.w_WB[j + 1] = w;
    scratch.v_WB[j + 1] = scratch.v_WB[parent] + w_cross_r;
    scratch.alpha_bias_W[j + 1] = scratch.alpha_bias_W[parent];
    scratch.a_bias_W[j + 1] = scratch.a_bias_W[parent] + scratch.alpha_bias_W[parent].cross(r) + w.cross(w_cross_r);
    if (joint.is_prismatic()) {
      scratch.v_WB[j + 1] += motion;
      scratch.a_bias_W[j + 1] += 2.0 * w.cross(motion);
    } else {
      scratch.w_WB[j + 1] += motion;
      scratch.alpha_bias_W[j + 1] += w.cross(motion);
    }
  }
}

Pose FramePose(const DynamicsScratch& scratch, int body, const Pose& X_BF) {
  const auto b = static_cast<std::size_t>(body);
  Pose X_WF = Pose::Identity();
  X_WF.linear() = scratch.R_WB[b] * X_BF.linear();
  X_WF.translation() = scratch.p_WB[b] + scratch.R_WB[b] * X_BF.translation();
  return X_WF;
}

void PointJacobian(const RobotModel& model, const DynamicsScratch& scratch, int body, const Vector3& p_BQ,
                   Eigen::Ref<MatrixX> J) {
  const auto b = static_cast<std::size_t>(body);
  const Vector3 p_WQ = scratch.p_WB[b] + scratch.R_WB[b] * p_BQ;
  J.setZero();
  J.topLeftCorner<3, 3>().setIdentity();
  J.block<3, 3>(0, 3) = -Skew(p_WQ - scratch.p_WB[0]);
  J.block<3, 3>(3, 3).setIdentity();
  for (int i = body; i > 0; i = model.joints[static_cast<std::size_t>(i - 1)].parent_body) {
    const auto j = static_cast<std::size_t>(i - 1);
    const Joint& joint = model.joints[j];
    const Vector3 motion = joint.multiplier * scratch.axis_W[j];
    if (joint.is_prismatic()) {
      J.col(6 + joint.dof).head<3>() += motion;
    } else {
      J.col(6 + joint.dof).head<3>() += motion.cross(p_WQ - scratch.p_WB[j + 1]);
      J.col(6 + joint.dof).tail<3>() += motion;
    }
  }
}

void JointScrews(const RobotModel& model, const DynamicsScratch& scratch, Eigen::Ref<MatrixX> S_W) {
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    const Vector3 motion = joint.multiplier * scratch.axis_W[j];
    const auto column = static_cast<Eigen::Index>(j);
    S_W.col(column).head<3>() = joint.is_prismatic() ? motion : scratch.p_WB[j + 1].cross(motion);
    S_W.col(column).tail<3>() = joint.is_prismatic() ? Vector3::Zero() : motion;
  }
}

void PointJacobianRate(const RobotModel& model, const DynamicsScratch& scratch, int body, const Vector3& p_BQ,
                       Eigen::Ref<MatrixX> Jdot) {
  const auto b = static_cast<std::size_t>(body);
  const Vector3 p_WQ = scratch.p_WB[b] + scratch.R_WB[b] * p_BQ;
  const Vector3 v_WQ = PointVelocity(scratch, body, p_BQ).head<3>();
  Jdot.setZero();
  Jdot.block<3, 3>(0, 3) = -Skew(v_WQ - scratch.v_WB[0]);
  for (int i = body; i > 0; i = model.joints[static_cast<std::size_t>(i - 1)].parent_body) {
    const auto j = static_cast<std::size_t>(i - 1);
    const Joint& joint = model.joints[j];
    const Vector3 motion = joint.multiplier * scratch.axis_W[j];
    const Vector3 turning = scratch.w_WB[j + 1].cross(motion);
    if (joint.is_prismatic()) {
      Jdot.col(6 + joint.dof).head<3>() += turning;
    } else {
      Jdot.col(6 + joint.dof).head<3>() +=
          turning.cross(p_WQ - scratch.p_WB[j + 1]) + motion.cross(v_WQ - scratch.v_WB[j + 1]);
      Jdot.col(6 + joint.dof).tail<3>() += turning;
    }
  }
}

Vector6 PointVelocity(const DynamicsScratch& scratch, int body, const Vector3& p_BQ) {
  const auto b = static_cast<std::size_t>(body);
  Vector6 velocity;
  velocity << scratch.v_WB[b] + scratch.w_WB[b].cross(scratch.R_WB[b] * p_BQ), scratch.w_WB[b];
  return velocity;
}

Vector6 PointBiasAcceleration(const DynamicsScratch& scratch, int body, const Vector3& p_BQ) {
  const auto b = static_cast<std::size_t>(body);
  const Vector3 r = scratch.R_WB[b] * p_BQ;
  Vector6 bias;
  bias << scratch.a_bias_W[b] + scratch.alpha_bias_W[b].cross(r) + scratch.w_WB[b].cross(scratch.w_WB[b].cross(r)),
      scratch.alpha_bias_W[b];
  return bias;
}

Vector3 CentreOfMass(const RobotModel& model, const DynamicsScratch& scratch) {
  Vector3 moment = Vector3::Zero();
  double mass = 0.0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    moment += model.bodies[i].mass * (scratch.p_WB[i] + scratch.R_WB[i] * model.bodies[i].p_BC);
    mass += model.bodies[i].mass;
  }
  return moment / mass;
}

void CentreOfMassJacobian(const RobotModel& model, DynamicsScratch& scratch, Eigen::Ref<MatrixX> J) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    scratch.composite[i].mass = body.mass;
    scratch.composite[i].moment_O = body.mass * (scratch.p_WB[i] - scratch.p_WB[0] + scratch.R_WB[i] * body.p_BC);
  }
  J.setZero();
  for (std::size_t j = model.joints.size(); j-- > 0;) {
    const Joint& joint = model.joints[j];
    const auto& child = scratch.composite[j + 1];
    auto& parent = scratch.composite[static_cast<std::size_t>(joint.parent_body)];
    parent.mass += child.mass;
    parent.moment_O += child.moment_O;
    const Vector3 motion = joint.multiplier * scratch.axis_W[j];
    const Vector3 p_OJ = scratch.p_WB[j + 1] - scratch.p_WB[0];
    J.col(6 + joint.dof) +=
        joint.is_prismatic() ? Vector3(child.mass * motion) : motion.cross(child.moment_O - child.mass * p_OJ);
  }
  const auto& whole = scratch.composite[0];
  J /= whole.mass;
  J.leftCols<3>().setIdentity();
  J.block<3, 3>(0, 3) = -Skew(whole.moment_O / whole.mass);
}

Vector3 CentreOfMassBiasAcceleration(const RobotModel& model, const DynamicsScratch& scratch) {
  Vector3 sum = Vector3::Zero();
  double mass = 0.0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Vector6 bias = PointBiasAcceleration(scratch, static_cast<int>(i), model.bodies[i].p_BC);
    sum += model.bodies[i].mass * bias.head<3>();
    mass += model.bodies[i].mass;
  }
  return sum / mass;
}

Vector6 CentroidalMomentum(const RobotModel& model, const DynamicsScratch& scratch) {
  const Vector3 p_WC = CentreOfMass(model, scratch);
  Vector6 momentum = Vector6::Zero();
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const Matrix3& R = scratch.R_WB[i];
    const Vector3 r = R * body.p_BC;
    const Vector3 linear = body.mass * (scratch.v_WB[i] + scratch.w_WB[i].cross(r));
    momentum.head<3>() += linear;
    momentum.tail<3>() +=
        R * (body.I_C * (R.transpose() * scratch.w_WB[i])) + (scratch.p_WB[i] + r - p_WC).cross(linear);
  }
  return momentum;
}

namespace {

/// Accelerations of all bodies, gravity included as an upward acceleration of the world.
void ForwardAccelerations(const RobotModel& model, const VectorX& v, const VectorX& a, DynamicsScratch& scratch) {
  scratch.a_W[0] = a.head<3>() + Vector3(0.0, 0.0, kGravity);
  scratch.alpha_W[0] = a.segment<3>(3);
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    const auto parent = static_cast<std::size_t>(joint.parent_body);
    const Vector3 r = scratch.p_WB[j + 1] - scratch.p_WB[parent];
    const Vector3& w = scratch.w_WB[parent];
    const Vector3 rate = JointRate(joint, v) * scratch.axis_W[j];
    const Vector3 acceleration = joint.multiplier * a[6 + joint.dof] * scratch.axis_W[j];
    scratch.alpha_W[j + 1] = scratch.alpha_W[parent];
    scratch.a_W[j + 1] = scratch.a_W[parent] + scratch.alpha_W[parent].cross(r) + w.cross(w.cross(r));
    if (joint.is_prismatic()) {
      scratch.a_W[j + 1] += acceleration + 2.0 * w.cross(rate);
    } else {
      scratch.alpha_W[j + 1] += acceleration + w.cross(rate);
    }
  }
}

/// Force and moment (about the body's origin) that accelerate each body alone.
void BodyWrenches(const RobotModel& model, DynamicsScratch& scratch) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const Matrix3& R = scratch.R_WB[i];
    const Vector3 w_B = R.transpose() * scratch.w_WB[i];
    const Vector3 alpha_B = R.transpose() * scratch.alpha_W[i];
    const Vector3 r = R * body.p_BC;
    const Vector3& w = scratch.w_WB[i];
    scratch.force_W[i] = body.mass * (scratch.a_W[i] + scratch.alpha_W[i].cross(r) + w.cross(w.cross(r)));
    scratch.moment_W[i] = R * (body.I_C * alpha_B + w_B.cross(body.I_C * w_B)) + r.cross(scratch.force_W[i]);
  }
}

}  // namespace

void InverseDynamics(const RobotModel& model, const VectorX& q, const VectorX& v, const VectorX& a,
                     DynamicsScratch& scratch, VectorX& tau) {
  ForwardVelocities(model, q, v, scratch);
  ForwardAccelerations(model, v, a, scratch);
  BodyWrenches(model, scratch);
  tau.setZero(model.nv());
  for (std::size_t j = model.joints.size(); j-- > 0;) {
    const Joint& joint = model.joints[j];
    const auto parent = static_cast<std::size_t>(joint.parent_body);
    const Vector3& load = joint.is_prismatic() ? scratch.force_W[j + 1] : scratch.moment_W[j + 1];
    tau[6 + joint.dof] += joint.multiplier * scratch.axis_W[j].dot(load);
    scratch.force_W[parent] += scratch.force_W[j + 1];
    scratch.moment_W[parent] +=
        scratch.moment_W[j + 1] + (scratch.p_WB[j + 1] - scratch.p_WB[parent]).cross(scratch.force_W[j + 1]);
  }
  tau.head<3>() = scratch.force_W[0];
  tau.segment<3>(3) = scratch.moment_W[0];
}

void MassMatrix(const RobotModel& model, const VectorX& q, DynamicsScratch& scratch, MatrixX& M) {
  ForwardKinematics(model, q, scratch);
  CompositeInertias(model, scratch);
  M.setZero(model.nv(), model.nv());
  const auto& whole = scratch.composite[0];
  M.topLeftCorner<3, 3>() = whole.mass * Matrix3::Identity();
  M.block<3, 3>(0, 3) = -Skew(whole.moment_O);
  M.block<3, 3>(3, 0) = Skew(whole.moment_O);
  M.block<3, 3>(3, 3) = whole.inertia_O;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    const auto& beyond = scratch.composite[j + 1];
    const Vector3 axis = joint.multiplier * scratch.axis_W[j];
    const bool slides = joint.is_prismatic();
    const Vector3 w = slides ? Vector3::Zero() : axis;
    const Vector3 v_O = slides ? axis : Vector3((scratch.p_WB[j + 1] - scratch.p_WB[0]).cross(axis));
    const Vector3 linear = beyond.mass * v_O + w.cross(beyond.moment_O);
    const Vector3 angular_O = beyond.inertia_O * w + beyond.moment_O.cross(v_O);
    const int column = 6 + joint.dof;
    M.col(column).head<3>() += linear;
    M.col(column).segment<3>(3) += angular_O;
    M(column, column) += w.dot(angular_O) + v_O.dot(linear);
    for (int i = joint.parent_body; i > 0; i = model.joints[static_cast<std::size_t>(i - 1)].parent_body) {
      const auto k = static_cast<std::size_t>(i - 1);
      const Joint& ancestor = model.joints[k];
      const Vector3& axis_k = scratch.axis_W[k];
      const double coupling =
          ancestor.multiplier * (ancestor.is_prismatic()
                                     ? axis_k.dot(linear)
                                     : axis_k.dot(angular_O - (scratch.p_WB[k + 1] - scratch.p_WB[0]).cross(linear)));
      M(6 + ancestor.dof, column) += coupling;
      M(column, 6 + ancestor.dof) += coupling;
    }
  }
  M.bottomLeftCorner(model.num_dofs(), 6) = M.topRightCorner(6, model.num_dofs()).transpose();
}

Matrix3 LockedInertia(const RobotModel& model, const DynamicsScratch& scratch) {
  const Vector3 p_WC = CentreOfMass(model, scratch);
  Matrix3 inertia = Matrix3::Zero();
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const Matrix3& R = scratch.R_WB[i];
    const Matrix3 arm = Skew(scratch.p_WB[i] + R * body.p_BC - p_WC);
    inertia += R * body.I_C * R.transpose() - body.mass * arm * arm;
  }
  return inertia;
}

double MechanicalEnergy(const RobotModel& model, const DynamicsScratch& scratch) {
  double energy = 0.0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const Matrix3& R = scratch.R_WB[i];
    const Vector3 r = R * body.p_BC;
    const Vector3 v_C = scratch.v_WB[i] + scratch.w_WB[i].cross(r);
    const Vector3 w_B = R.transpose() * scratch.w_WB[i];
    energy += 0.5 * body.mass * v_C.squaredNorm() + 0.5 * w_B.dot(body.I_C * w_B);
    energy += body.mass * kGravity * (scratch.p_WB[i] + r).z();
  }
  return energy;
}

}  // namespace gaitwright
