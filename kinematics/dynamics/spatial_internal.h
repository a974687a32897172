// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"

/// Spatial vectors in world axes about one point O for all bodies. O is the origin of the base, in the inertial frame
/// that moves with it at this instant, so the velocity of the base is a pure rotation. Featherstone, Rigid Body
/// Dynamics Algorithms, 2008, chapter 2.
namespace gaitwright::spatial {

/// A velocity or acceleration: linear at O, and angular.
struct Motion {
  Vector3 linear = Vector3::Zero(), angular = Vector3::Zero();
};

/// A force, and its moment about O.
struct Force {
  Vector3 linear = Vector3::Zero(), angular = Vector3::Zero();
};

/// Inertia about O, as in DynamicsScratch.
using Inertia = DynamicsScratch::Composite;

inline Motion operator+(const Motion& a, const Motion& b) { return {a.linear + b.linear, a.angular + b.angular}; }
inline Motion operator*(double s, const Motion& m) { return {s * m.linear, s * m.angular}; }
inline Force operator+(const Force& a, const Force& b) { return {a.linear + b.linear, a.angular + b.angular}; }

inline Vector6 Stacked(const Motion& m) { return (Vector6() << m.linear, m.angular).finished(); }
inline Vector6 Stacked(const Force& f) { return (Vector6() << f.linear, f.angular).finished(); }

/// Power of a force on a velocity.
inline double Dot(const Motion& m, const Force& f) { return m.linear.dot(f.linear) + m.angular.dot(f.angular); }

/// a x b: rate of a motion b that is fixed in a body with velocity a.
inline Motion Cross(const Motion& a, const Motion& b) {
  return {a.angular.cross(b.linear) + a.linear.cross(b.angular), a.angular.cross(b.angular)};
}

/// a x* f: rate of a force f that is fixed in a body with velocity a.
inline Force Cross(const Motion& a, const Force& f) {
  return {a.angular.cross(f.linear), a.linear.cross(f.linear) + a.angular.cross(f.angular)};
}

inline Force operator*(const Inertia& I, const Motion& m) {
  return {I.mass * m.linear - I.moment_O.cross(m.angular), I.moment_O.cross(m.linear) + I.inertia_O * m.angular};
}

inline void Add(const Inertia& I, Inertia& sum) {
  sum.mass += I.mass;
  sum.moment_O += I.moment_O;
  sum.inertia_O += I.inertia_O;
}

/// Inertia about O of a body whose frame is at p_OB.
inline Inertia InertiaOf(const Body& body, const Matrix3& R_WB, const Vector3& p_OB) {
  const Vector3 p_OC = p_OB + R_WB * body.p_BC;
  Matrix3 I = R_WB * body.I_C * R_WB.transpose() - body.mass * p_OC * p_OC.transpose();
  I.diagonal().array() += body.mass * p_OC.squaredNorm();
  return {body.mass, body.mass * p_OC, I};
}

/// Motion of all bodies beyond a joint at unit rate of the joint's own position. Needs ForwardKinematics.
inline Motion JointMotion(const Joint& joint, const DynamicsScratch& scratch, std::size_t index) {
  const Vector3& axis = scratch.axis_W[index];
  if (joint.is_prismatic()) return {axis, Vector3::Zero()};
  return {(scratch.p_WB[index + 1] - scratch.p_WB[0]).cross(axis), axis};
}

}  // namespace gaitwright::spatial
