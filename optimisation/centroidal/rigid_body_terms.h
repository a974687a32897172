// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/rigid_body_unknowns.h"
#include "optimisation/centroidal/turning_rate.h"
#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// The rows of a rigid body's problem over its unknowns. Keeps references to both; what it gives keeps none.
class RigidBodyTerms {
 public:
  RigidBodyTerms(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns)
      : problem_(problem), unknowns_(unknowns), inner_(problem) {}

  /// Over the interval after a break, six rows that are zero: the change of the box's angular momentum, and of what
  /// moves against it, less the impulse of the torques, which is exact (a polynomial of degree four, in five places);
  /// the change of angles by the Lobatto IIIA rule of order four (Hairer and Wanner, Solving Ordinary Differential
  /// Equations II, 1996, section IV.5).
  Constraint Turning(std::size_t interval) const;

  /// Where nothing carries, the force on the whole is zero.
  Constraint Free(std::size_t at_break) const;

  /// A force within the regular pyramid of `sides` sides that its cone of friction holds, of which one edge points
  /// along x of the foothold; and no greater than it may be along its normal. `margin` [m g] keeps it inside.
  Constraint Friction(const BoundForce& force, int sides, double margin) const;

  /// The forces on all points of a stance at a break within what its motors hold there. Only where they have limits.
  Constraint Motors(const std::vector<BoundForce>& forces) const;

  /// The foothold of a stance in its foot's workspace at a time, by `margin_m`; between breaks the angles are those of
  /// Hermite's cubic.
  Constraint Reach(std::size_t stance, double time_s, double margin_m) const;

  /// The same of a foot at a share of a swing of the problem.
  Constraint SwingReach(std::size_t swing, double share, double margin_m) const;

  /// A swing of the problem beyond its planes. Only for one that has any.
  Constraint SwingClearance(std::size_t swing) const;

  /// A point of the body beyond a plane at a time; how it is turned as for Reach.
  Constraint Clearance(const RigidClearance& clearance) const;

  /// The centre of mass no faster upward or downward than it may be.
  Constraint Rise(double time_s) const;

  /// A foothold in its region. Only for one that is neither held nor without end.
  Constraint Region(std::size_t stance) const;

 private:
  // In rigid_body_reach.cc, with what is public of reach and clearance.
  Constraint ReachOf(int foot, const std::vector<WorkspaceSide>& workspace_B, const FootPlace& place, double time_s,
                     double margin_m) const;

  const RigidBodyProblem& problem_;
  const RigidBodyUnknowns& unknowns_;
  const InnerMomentum inner_;
};

}  // namespace gaitwright
