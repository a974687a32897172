// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"
#include "optimisation/centroidal/rigid_body_unknowns.h"

namespace gaitwright {

/// A motion of a rigid body over one interval between nodes, in which everything except the angles is a polynomial.
struct RigidBodyInterval {
  /// Force on a contact point of a stance, linear over the interval.
  struct Force {
    std::size_t stance = 0;
    Vector3 p_W = Vector3::Zero();                             ///< point of contact at the start [m]
    Vector3 moves_W = Vector3::Zero();                         ///< from there to the end, evenly [m]
    Vector3 from_W = Vector3::Zero(), to_W = Vector3::Zero();  ///< [N]
  };

  double start_s = 0.0, end_s = 0.0;
  std::array<Vector3, 4> com;      ///< cubic in the time since start_s, by rising power
  Vector3 angles_rad, momentum_W;  ///< at its start; momentum of the body about the centre of mass [N m s]
  std::vector<Force> forces;
};

/// A planned motion of a rigid body, computed from its start and its forces: centre of mass and momentum exactly,
/// angles by the classical Runge-Kutta method.
struct RigidBodyMotion {
  double mass_kg = 1.0;
  Matrix3 inertia_B = Matrix3::Identity();
  LegMomentum inner;
  std::vector<RigidBodyInterval> intervals;
  std::vector<Pose> X_WF;  ///< foothold of each stance
  /// Control points of each free swing of the problem; none for other swings [m].
  std::vector<std::vector<Vector3>> detours_W = {};

  double duration_s() const { return intervals.empty() ? 0.0 : intervals.back().end_s; }
};

/// The motion at a time.
struct RigidBodySample {
  double time_s = 0.0;
  std::size_t interval = 0;
  Vector3 p_WC, v_WC, a_WC, angles_rad, w_WB_B;
  Vector3 momentum_W, torque_W;  ///< of the body, and its rate: moment of forces minus rate of leg momentum
  std::vector<Vector3> force_W;  ///< on each of the interval's points of contact [N]
};

/// The motion of a vector of unknowns. Its end differs from the goal by the violation of the rotation constraints.
RigidBodyMotion MotionOf(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns, const VectorX& x);

/// Samples at even times, `step_s` apart, the last at the end.
std::vector<RigidBodySample> Sample(const RigidBodyMotion& motion, double step_s);

/// Violations of a motion, over its samples.
struct RigidBodyFaults {
  double force_balance = 0.0;   ///< largest |m a - sum f - m g| / (m g)
  double torque_balance = 0.0;  ///< largest |d(I w)/dt - sum (p_i - p) x f_i| / (m g), for the sampled rotation [m]
  double friction = 0.0;        ///< largest tangential force beyond friction, over m g
  double unilateral = 0.0;      ///< largest pull, or push beyond the force limit, over m g
  double reach_m = 0.0;         ///< largest distance of a stance foot out of its workspace
  double foothold_m = 0.0;      ///< largest distance of a foothold out of its region
  double goal = 0.0;            ///< largest distance from the goal at the end [m], [rad]

  /// The largest of all.
  double Largest() const;
  /// Name of the largest violation.
  std::string Worst() const;
};

/// Violations at samples `step_s` apart; forces and feet are checked against the problem.
RigidBodyFaults FaultsOf(const RigidBodyProblem& problem, const RigidBodyMotion& motion, double step_s);

}  // namespace gaitwright
