// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/ik/leg_polytope.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A foot of a single rigid body: where a leg that has no mass can put it.
struct RigidFoot {
  Vector3 p_CF_nominal_B = Vector3::Zero();             ///< from the centre of mass, in B, where it likes to stand [m]
  std::vector<WorkspaceSide> workspace_B;               ///< of its place from the centre of mass, in B [m]
  std::vector<Vector3> contacts_F = {Vector3::Zero()};  ///< points of the sole that carry, in the foothold's frame [m]
  double force_max_n = 1e4;                             ///< along the ground's normal, of each of these points
  std::vector<WorkspaceSide> workspace_in_air_B = {};   ///< as the other, while it swings; empty for the same
};

/// What a leg's motors hold: lower <= by_force (f_1; f_2; ..) <= upper for the forces on the foot's points [N], in W.
struct MotorLimits {
  MatrixX by_force;  ///< a row for each motor, three columns for each point
  VectorX lower, upper;
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
  /// How far its points of contact have moved along the ground at even times from start to end, as spheres that roll
  /// do; empty for not at all [m].
  std::vector<Vector3> moved_W = {};

  /// What motors hold at even times from start to end; empty for anything.
  std::vector<MotorLimits> motors = {};

  /// How far contacts have moved at a time, linear in between.
  Vector3 MovedAt(double time_s) const;
  /// The limits of motors at the nearest of their times; null for none.
  const MotorLimits* MotorsAt(double time_s) const;
};

/// A plane that a foot on its way is to be beyond at a share of its swing: normal_W . p >= offset_m.
struct SwingPlane {
  double share = 0.5;
  Vector3 normal_W = Vector3::UnitZ();  ///< unit
  double offset_m = 0.0;
};

/// The way of a foot through the air from one of its stances to the next, a SwingCurve that is to stay within reach.
struct RigidSwing {
  std::size_t from = 0, to = 0;  ///< stances
  double lift_m = 0.0;           ///< of the bump at half time
  double cruise = 0.0;           ///< share of the time at constant speed, below 1
  /// Control points of the spline that takes the bump's place; empty for none [m].
  std::vector<Vector3> detour_W = {};
  bool free = false;                    ///< these are unknown, and given as a first guess; an even count of them
  std::vector<double> shares = {};      ///< at which it is looked at; empty for nine
  std::vector<SwingPlane> planes = {};  ///< that keep it clear of what it goes by

  int unknowns() const { return free ? 3 * static_cast<int>(detour_W.size()) : 0; }
  /// How much of the straight way is behind it.
  double GoneAt(double share) const;
  /// How far the curve, as it is given, is off the straight way.
  Vector3 OffAt(double share) const;
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

  /// Evenly between its times, and at the ends as there. Not of an empty one.
  Vector3 PlaceAt(double at_s) const;
  Vector3 AnglesAt(double at_s) const;
};

/// A while in which a body keeps still.
struct RigidRest {
  double start_s = 0.0, end_s = 0.0;
  Vector3 p_WC = Vector3::Zero(), angles_rad = Vector3::Zero();
};

/// A point that is fixed in the body is to be beyond a plane at a time:
///   normal_W . (p_WC + R_WB p_CQ_B) >= offset_m.
struct RigidClearance {
  double time_s = 0.0;
  Vector3 p_CQ_B = Vector3::Zero();     ///< from the centre of mass [m]
  Vector3 normal_W = Vector3::UnitZ();  ///< unit
  double offset_m = 0.0;
  std::string of = "body";  ///< what part it is, for people
};

/// A box of one inertia and mass is to go from one state to another, held by forces at its feet alone:
///   m p'' = sum f_i + m g,   (I w)' + l' = sum (p_i - p) x f_i,
/// forces in the friction cones of their footholds, feet in their workspaces. l is the momentum of what moves against
/// the box, such as legs.
struct RigidBodyProblem {
  double mass_kg = 1.0;
  Matrix3 inertia_B = Matrix3::Identity();  ///< about the centre of mass [kg m^2]
  std::vector<RigidFoot> feet;
  std::vector<RigidStance> stances;  ///< of one foot: disjoint, in order
  std::vector<RigidSwing> swings;    ///< those whose reach counts
  RigidBodyState start, goal;
  double duration_s = 1.0;            ///< from time 0
  std::vector<RigidRest> rests = {};  ///< on the way, in order
  std::vector<RigidClearance> clearances = {};
  double rise_max_m_s = 0.0;  ///< the greatest speed upward or downward while any foot is on the ground; 0 for no end
  /// Angular momentum about the centre of mass of all that moves against the box, and its rate, at even times from 0 to
  /// the end, two or more; empty for none [N m s], [N m].
  std::vector<Vector3> inner_momentum_W = {}, inner_torque_W = {};
  BodyWay way;               ///< first guess; empty for one over the footholds
  bool follows_yaw = false;  ///< the yaw wanted is that of the way; else it goes evenly from start to goal
};

/// The inner momentum of a problem as a function of time: Hermite's cubics between what is given.
class InnerMomentum {
 public:
  InnerMomentum() = default;  ///< none
  explicit InnerMomentum(const RigidBodyProblem& problem);

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

/// @throws InvalidArgument for a mass, inertia, duration or friction that is not positive, a foot that there is not, a
/// stance or clearance outside of the duration, a stance that overlaps another of its foot, a region that is not
/// convex, or a value that is not finite; and where no foot holds the body at the start or at the end.
void CheckRigidBodyProblem(const RigidBodyProblem& problem);

}  // namespace gaitwright
