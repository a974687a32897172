// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Work space of the functions below for one model. The caller owns it, so each thread only needs its own.
/// After ForwardKinematics, poses and axes are valid; after ForwardVelocities, velocities too.
///
/// = Notation =
///   W world, B a body's frame, O the origin of the base (body 0). Composite inertias are in world axes about O,
///   because with one reference point for all bodies they are simple sums.
struct DynamicsScratch {
  explicit DynamicsScratch(const RobotModel& model);

  std::vector<Matrix3> R_WB;    ///< by body
  std::vector<Vector3> p_WB;    ///< by body [m]
  std::vector<Vector3> axis_W;  ///< by joint, unit
  std::vector<Vector3> w_WB;    ///< by body: angular velocity [rad/s]
  std::vector<Vector3> v_WB;    ///< by body: velocity of the body's origin [m/s]

  std::vector<Vector3> alpha_bias_W;  ///< by body: angular acceleration when `a` is zero [rad/s^2]
  std::vector<Vector3> a_bias_W;      ///< by body: acceleration of the body's origin when `a` is zero [m/s^2]

  /// Internal data of the functions; not part of the interface.
  struct Composite {
    double mass;
    Vector3 moment_O;  // mass times the position of the centre of mass from O
    Matrix3 inertia_O;
  };
  std::vector<Vector3> alpha_W, a_W, force_W, moment_W;
  std::vector<Composite> composite;
};

/// Poses of all bodies at q (size nq). The quaternion may deviate from unit length.
void ForwardKinematics(const RobotModel& model, const VectorX& q, DynamicsScratch& scratch);

/// Poses and velocities at q, v. ForwardKinematics is included.
void ForwardVelocities(const RobotModel& model, const VectorX& q, const VectorX& v, DynamicsScratch& scratch);

/// X_WF of a frame fixed in a body. Needs ForwardKinematics.
Pose FramePose(const DynamicsScratch& scratch, int body, const Pose& X_BF);

/// Jacobian of the point Q fixed in a body: [v_WQ; w_WB] = J v, size 6 x nv, rows linear then angular, in W.
void PointJacobian(const RobotModel& model, const DynamicsScratch& scratch, int body, const Vector3& p_BQ,
                   Eigen::Ref<MatrixX> J);

/// Screw axes of all joints, size 6 x joints, as [velocity at the world's origin; angular velocity] in W. A column is
/// the motion that a joint gives to the bodies beyond it if its independent joint moves at unit rate. The Jacobian of a
/// point Q consists of the columns of the joints that carry it: [s_v + s_w x p_WQ; s_w], summed over coupled joints.
/// Needs ForwardKinematics. Lynch and Park, Modern Robotics, 2017, section 5.1.1.
void JointScrews(const RobotModel& model, const DynamicsScratch& scratch, Eigen::Ref<MatrixX> S_W);

/// Time derivative of PointJacobian, size 6 x nv. PointBiasAcceleration computes Jdot v faster. Needs
/// ForwardVelocities.
void PointJacobianRate(const RobotModel& model, const DynamicsScratch& scratch, int body, const Vector3& p_BQ,
                       Eigen::Ref<MatrixX> Jdot);

/// Velocity [v_WQ; w_WB] of a point fixed in a body. Needs ForwardVelocities.
Vector6 PointVelocity(const DynamicsScratch& scratch, int body, const Vector3& p_BQ);

/// Jdot v: the acceleration [a_WQ; alpha_WB] of a point if all accelerations `a` are zero. Needs ForwardVelocities.
Vector6 PointBiasAcceleration(const DynamicsScratch& scratch, int body, const Vector3& p_BQ);

/// p_WC [m]. Needs ForwardKinematics.
Vector3 CentreOfMass(const RobotModel& model, const DynamicsScratch& scratch);

/// v_WC = J v, size 3 x nv. Needs ForwardKinematics.
void CentreOfMassJacobian(const RobotModel& model, DynamicsScratch& scratch, Eigen::Ref<MatrixX> J);

/// Jdot v of the centre of mass [m/s^2]. Needs ForwardVelocities.
Vector3 CentreOfMassBiasAcceleration(const RobotModel& model, const DynamicsScratch& scratch);

/// [linear momentum; angular momentum about C] in W [N s; N m s]. Needs ForwardVelocities.
Vector6 CentroidalMomentum(const RobotModel& model, const DynamicsScratch& scratch);

/// Generalised forces tau (size nv) with M(q) a + h(q, v) = tau, gravity included; no contact forces. tau[0..5] is the
/// wrench on the base: force, then moment about O, in W. Includes the kinematics. Recursive Newton-Euler: Featherstone,
/// Rigid Body Dynamics Algorithms, 2008, section 5.3.
void InverseDynamics(const RobotModel& model, const VectorX& q, const VectorX& v, const VectorX& a,
                     DynamicsScratch& scratch, VectorX& tau);

/// M(q), size nv x nv, both triangles. Composite rigid bodies: Featherstone 2008, section 6.2. Includes the kinematics.
void MassMatrix(const RobotModel& model, const VectorX& q, DynamicsScratch& scratch, MatrixX& M);

/// Inertia of the robot as one rigid body in its current posture, about the centre of mass, in W [kg m^2]. Needs
/// ForwardKinematics.
Matrix3 LockedInertia(const RobotModel& model, const DynamicsScratch& scratch);

/// Kinetic plus potential energy [J], zero height at z = 0. Needs ForwardVelocities.
double MechanicalEnergy(const RobotModel& model, const DynamicsScratch& scratch);

}  // namespace gaitwright
