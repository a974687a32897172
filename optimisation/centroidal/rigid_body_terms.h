// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/rigid_body_unknowns.h"
#include "optimisation/centroidal/turning_rate.h"
#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// Constraint::family of the rigid body's constraints.
enum class RigidBodyRowKind { kOther, kReach, kFriction, kMotors, kRise, kFreeFlight, kClearance, kRegion, kTurning };

/// The constraint with that family.
inline Constraint OfKind(RigidBodyRowKind kind, Constraint constraint) {
  constraint.family = static_cast<int>(kind);
  return constraint;
}

/// The rows of a rigid body's problem over its unknowns. Keeps references to both; its results do not.
class RigidBodyTerms {
 public:
  RigidBodyTerms(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns)
      : problem_(problem), unknowns_(unknowns), inner_(problem) {}

  /// Six zero rows over the interval after a node: the change of angular momentum of the body and the legs minus the
  /// impulse of the torques, which is exact (a polynomial of degree four, at five points); the change of angles by the
  /// Lobatto IIIA rule of order four (Hairer and Wanner, Solving Ordinary Differential Equations II, 1996, section
  /// IV.5).
  Constraint Turning(std::size_t interval) const;

  /// Without contact, the total force is zero.
  Constraint Free(std::size_t at_node) const;

  /// A force within the regular pyramid of `sides` sides inside its friction cone, with one edge along x of the
  /// foothold, and within its limit along the normal, with a `margin` [m g].
  Constraint Friction(const BoundForce& force, int sides, double margin) const;

  /// The forces on all points of a stance at a node within its motor limits. Only if there are limits.
  Constraint Motors(const std::vector<BoundForce>& forces) const;

  /// The foothold of a stance inside its foot's workspace at a time, by `margin_m`; between nodes, angles follow a
  /// cubic Hermite curve.
  Constraint Reach(std::size_t stance, double time_s, double margin_m) const;

  /// As above for a foot at a fraction of a swing of the problem.
  Constraint SwingReach(std::size_t swing, double share, double margin_m) const;

  /// A swing of the problem beyond its planes. Only for a swing with planes.
  Constraint SwingClearance(std::size_t swing) const;

  /// A point of the body beyond a plane at a time; rotation as for Reach.
  Constraint Clearance(const RigidClearance& clearance) const;

  /// The vertical speed of the centre of mass within its limit.
  Constraint Rise(double time_s) const;

  /// A foothold in its region. Only for a free foothold with a bounded region.
  Constraint Region(std::size_t stance) const;

 private:
  // Implemented in rigid_body_reach.cc, together with the public functions for reach and clearance.
  Constraint ReachOf(int foot, const std::vector<WorkspaceSide>& workspace_B, const FootPlace& place, double time_s,
                     double margin_m) const;

  const RigidBodyProblem& problem_;
  const RigidBodyUnknowns& unknowns_;
  const LegMomentum inner_;
};

}  // namespace gaitwright
