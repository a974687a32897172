// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/ik/leg_polytope.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A foot of a single rigid body: the workspace of a massless leg.
struct RigidFoot {
  Vector3 p_CF_nominal_B = Vector3::Zero();             ///< nominal position relative to the centre of mass, in B [m]
  std::vector<WorkspaceSide> workspace_B;               ///< for its position relative to the centre of mass, in B [m]
  std::vector<Vector3> contacts_F = {Vector3::Zero()};  ///< contact points of the sole, in the foothold's frame [m]
  double force_max_n = 1e4;                             ///< largest normal force of each of these points
  std::vector<WorkspaceSide> workspace_in_air_B = {};   ///< workspace during swings; empty if equal to workspace_B
  double radius_m = 0.0;  ///< radius of a spherical foot above the contact point; 0 if none
};

/// Limits of a leg's motors: lower <= by_force (f_1; f_2; ..) <= upper for the forces on the foot's points [N], in W.
struct MotorLimits {
  MatrixX by_force;  ///< a row for each motor, three columns for each point
  VectorX lower, upper;
};

/// A stance of a foot: its time interval and the region of its foothold.
struct RigidStance {
  int foot = 0;
  double start_s = 0.0, end_s = 0.0;
  Pose X_WF = Pose::Identity();   ///< initial guess; z along the ground's normal, along which it is fixed
  bool held = false;              ///< true: the foothold is fixed there
  std::vector<Vector2> region_F;  ///< its region if not held: convex, counter-clockwise; empty if unbounded [m]
  double friction = 0.8;
  /// Displacement of its contact points along the ground at uniform times from start to end, for rolling spheres; empty
  /// for none [m].
  std::vector<Vector3> moved_W = {};

  /// Motor limits at uniform times from start to end; empty for no limits.
  std::vector<MotorLimits> motors = {};

  /// Displacement of the contacts at a time, linear in between.
  Vector3 MovedAt(double time_s) const;
  /// The motor limits at the nearest of their times; null for none.
  const MotorLimits* MotorsAt(double time_s) const;
};

/// A plane that a swing foot must be beyond at a fraction of its swing: normal_W . p >= offset_m.
struct SwingPlane {
  double share = 0.5;
  Vector3 normal_W = Vector3::UnitZ();  ///< unit
  double offset_m = 0.0;
};

/// The path of a foot from one of its stances to the next, a SwingCurve that must stay within reach.
struct RigidSwing {
  std::size_t from = 0, to = 0;  ///< stances
  double lift_m = 0.0;           ///< lift at half time
  double cruise = 0.0;           ///< share of the time at constant speed, below 1
  /// Control points of the spline that replaces the lift curve; empty for none [m].
  std::vector<Vector3> detour_W = {};
  bool free = false;                    ///< these are unknowns, with an initial guess; an even number of them
  std::vector<double> shares = {};      ///< fractions at which it is checked; empty for nine
  std::vector<SwingPlane> planes = {};  ///< planes that keep it clear of solids

  int unknowns() const { return free ? 3 * static_cast<int>(detour_W.size()) : 0; }
  /// Completed fraction of the straight path.
  double GoneAt(double share) const;
  /// Offset of the given curve from the straight path.
  Vector3 OffAt(double share) const;
};

/// A state of a single rigid body. Angles are roll, pitch and yaw: R_WB = Rz(yaw) Ry(pitch) Rx(roll).
struct RigidBodyState {
  Vector3 p_WC = Vector3::Zero(), angles_rad = Vector3::Zero();
  Vector3 v_WC = Vector3::Zero(), w_WB_B = Vector3::Zero();  ///< [m/s], [rad/s]
};

/// Poses of a body at uniform times from start to goal, without regard to forces.
struct BodyTrajectory {
  std::vector<double> time_s;
  std::vector<Vector3> p_WC, angles_rad;

  /// Linear between its times, constant beyond the ends. @pre not empty.
  Vector3 PlaceAt(double at_s) const;
  Vector3 AnglesAt(double at_s) const;
};

/// A time interval in which a body rests.
struct RigidRest {
  double start_s = 0.0, end_s = 0.0;
  Vector3 p_WC = Vector3::Zero(), angles_rad = Vector3::Zero();
};

/// A body-fixed point that must be beyond a plane at a time:
///   normal_W . (p_WC + R_WB p_CQ_B) >= offset_m.
struct RigidClearance {
  double time_s = 0.0;
  Vector3 p_CQ_B = Vector3::Zero();     ///< from the centre of mass [m]
  Vector3 normal_W = Vector3::UnitZ();  ///< unit
  double offset_m = 0.0;
  std::string of = "body";  ///< name of the part, for messages
};

/// A single rigid body that moves from one state to another by contact forces at its feet:
///   m p'' = sum f_i + m g,   (I w)' + l' = sum (p_i - p) x f_i,
/// forces in the friction cones of their footholds, feet in their workspaces. l is the angular momentum of the legs and
/// other moving parts relative to the body.
struct RigidBodyProblem {
  double mass_kg = 1.0;
  Matrix3 inertia_B = Matrix3::Identity();  ///< about the centre of mass [kg m^2]
  std::vector<RigidFoot> feet;
  std::vector<RigidStance> stances;  ///< stances of one foot are disjoint and in order
  std::vector<RigidSwing> swings;    ///< swings whose reach is constrained
  RigidBodyState start, goal;
  double duration_s = 1.0;            ///< from time 0
  std::vector<RigidRest> rests = {};  ///< between start and goal, in order
  std::vector<RigidClearance> clearances = {};
  double rise_max_m_s = 0.0;  ///< largest upward or downward speed while any foot is on the ground; 0 for no limit
  /// Leg angular momentum: of all parts that move relative to the body, about the centre of mass, with its rate, at two
  /// or more uniform times from 0 to the end; empty for none [N m s], [N m].
  std::vector<Vector3> leg_momentum_W = {}, leg_torque_W = {};
  BodyTrajectory path;       ///< initial guess; empty for one above the footholds
  bool follows_yaw = false;  ///< the wanted yaw is that of the path; else it changes evenly from start to goal
};

/// The leg angular momentum of a problem as a function of time: cubic Hermite interpolation of the given values.
class LegMomentum {
 public:
  LegMomentum() = default;  ///< none
  explicit LegMomentum(const RigidBodyProblem& problem);

  bool empty() const { return momentum_W_.empty(); }
  /// [N m s]
  Vector3 At(double time_s) const;
  /// [N m]
  Vector3 RateAt(double time_s) const;

 private:
  double step_s_ = 1.0;
  std::vector<Vector3> momentum_W_, torque_W_;
};

/// R_WB of roll, pitch and yaw.
Matrix3 RotationOf(const Vector3& angles_rad);

/// The matrix E of w_WB_B = E d(angles)/dt. Singular at a pitch of pi / 2.
Matrix3 BodyRatesByAngleRates(const Vector3& angles_rad);

/// The half-spaces of a box about a point, with its edges along B.
std::vector<WorkspaceSide> BoxAbout(const Vector3& centre_B, const Vector3& half_size);

/// @throws InvalidArgument for a mass, inertia, duration or friction that is not positive, a foot that does not exist,
/// a stance or clearance outside the duration, a stance that overlaps another of its foot, a region that is not convex,
/// or a value that is not finite; and if no foot is on the ground at the start or at the end.
void CheckRigidBodyProblem(const RigidBodyProblem& problem);

}  // namespace gaitwright
