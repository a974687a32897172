// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The points p with normal . p <= offset.
struct WorkspaceSide {
  Vector3 normal = Vector3::UnitX();
  double offset = 0.0;
};

/// A foot of a single rigid body: where a leg that has no mass can put it.
struct RigidFoot {
  Vector3 p_CF_nominal_B = Vector3::Zero();             ///< from the centre of mass, in B, where it likes to stand [m]
  std::vector<WorkspaceSide> workspace_B;               ///< of its place from the centre of mass, in B [m]
  std::vector<Vector3> contacts_F = {Vector3::Zero()};  ///< points of the sole that carry, in the foothold's frame [m]
  double force_max_n = 1e4;                             ///< along the ground's normal, of each of these points
};

/// An interval of contact of a foot and where it may be.
struct RigidStance {
  int foot = 0;
  double start_s = 0.0, end_s = 0.0;
  Pose X_WF = Pose::Identity();  ///< first guess; z along the ground's normal, along which it does not move
  bool held = false;             ///< it is put exactly there
  std::vector<Vector2>
      region_F;  ///< else where it may be in the plane: convex, counter-clockwise; empty for no end [m]
  double friction = 0.8;
};

/// A state of a single rigid body. Angles are roll, pitch and yaw: R_WB = Rz(yaw) Ry(pitch) Rx(roll).
struct RigidBodyState {
  Vector3 p_WC = Vector3::Zero(), angles_rad = Vector3::Zero();
  Vector3 v_WC = Vector3::Zero(), w_WB_B = Vector3::Zero();  ///< [m/s], [rad/s]
};

/// Where a body is at even times, from start to goal, whatever forces that takes.
struct BodyWay {
  std::vector<double> time_s;
  std::vector<Vector3> p_WC, angles_rad;
};

/// A box of one inertia and mass is to go from one state to another, held by forces at its feet alone:
///   m p'' = sum f_i + m g,   (I w)' = sum (p_i - p) x f_i,
/// forces in the friction cones of their footholds, feet in their workspaces.
struct RigidBodyProblem {
  double mass_kg = 1.0;
  Matrix3 inertia_B = Matrix3::Identity();  ///< about the centre of mass [kg m^2]
  std::vector<RigidFoot> feet;
  std::vector<RigidStance> stances;  ///< of one foot: disjoint, in order
  RigidBodyState start, goal;
  double duration_s = 1.0;  ///< from time 0
  BodyWay way;              ///< first guess; empty for one over the footholds
};

/// R_WB of roll, pitch and yaw.
Matrix3 RotationOf(const Vector3& angles_rad);

/// The matrix E of w_WB_B = E d(angles)/dt. Singular at a pitch of pi / 2.
Matrix3 BodyRatesByAngleRates(const Vector3& angles_rad);

/// The half-spaces of a box about a point, with its edges along B.
std::vector<WorkspaceSide> BoxAbout(const Vector3& centre_B, const Vector3& half_size);

/// @throws InvalidArgument for a mass, inertia, duration or friction that is not positive, a foot that there is not, a
/// stance outside of the duration or that overlaps another of its foot, a region that is not convex, or a value that is
/// not finite; and where no foot holds the body at the start or at the end.
void CheckRigidBodyProblem(const RigidBodyProblem& problem);

}  // namespace gaitwright
