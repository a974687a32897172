// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"
#include "optimisation/numerics/affine_vector.h"

namespace gaitwright {

/// Where a foot is on the ground, or on its way between two footholds:
///   constant + sum_i axes_i * (x[start_i], x[start_i + 1]).
struct FootPlace {
  /// Two unknowns by the first of them, and where they move it.
  struct Part {
    int start;
    Eigen::Matrix<double, 3, 2> axes;
  };

  Vector3 constant = Vector3::Zero();
  std::vector<Part> parts = {};

  /// Where it is.
  Vector3 At(const VectorX& x) const;
  /// Adds factor * other.
  FootPlace& Add(double factor, const FootPlace& other);
  /// Adds `by` * (derivative of this by the unknowns) to rows of a Jacobian, from `row` on.
  template <typename Derived>
  void AddTo(const Eigen::MatrixBase<Derived>& by, MatrixX& J, Eigen::Index row) const {
    for (const Part& part : parts) J.block(row, part.start, by.rows(), 2) += by * part.axes;
  }
  /// The same in a term's own numbers.
  FootPlace SeenBy(SeenUnknowns& seen) const;
};

/// The force on one point of contact of a stance over the interval between two breaks: linear from one to the other.
struct ContactForce {
  std::size_t stance = 0, point = 0;
  AffineVector from, to;  ///< [m g]
};

/// A force at a break that friction and its greatest value bound.
struct BoundForce {
  std::size_t stance = 0, point = 0, at_break = 0;
  AffineVector force;  ///< [m g]
};

/// What a motion of a rigid body is described by, as numbers of one vector. The centre of mass is a cubic B-spline over
/// breaks, all switches of contact among them, with its ends and their rates given, so that the force on the whole is
/// continuous and linear between breaks. So are the forces on points of contact, zero where a stance begins or ends in
/// between; one at each break is not unknown, but what the others leave of the force on the whole. Where all feet on
/// the ground are exchanged at once, either lot carries the whole. Then there are the angles of the base and the
/// angular momentum at breaks, their ends given, the footholds on their planes, and at last the control points of free
/// swings. Where the body rests it is given.
/// Units: m, rad, forces in m g, angular momentum over the mean inertia [rad/s]. Keeps a reference to the problem.
class RigidBodyUnknowns {
 public:
  /// @param spacing_s  most between two breaks; each stance has `least_intervals` or more.
  /// @param grid_s     breaks between switches are at multiples of it where they come to differ; 0 for anywhere.
  RigidBodyUnknowns(const RigidBodyProblem& problem, double spacing_s, int least_intervals, double grid_s = 0.0);

  /// Over given breaks. @throws InvalidArgument unless they rise from 0 to the end with all switches of contact among
  /// them.
  RigidBodyUnknowns(const RigidBodyProblem& problem, std::vector<double> breaks_s);

  int size() const { return size_; }
  const std::vector<double>& breaks_s() const { return breaks_s_; }
  std::size_t intervals() const { return breaks_s_.size() - 1; }
  double mean_inertia() const { return mean_inertia_; }

  /// Its place at a time.
  AffineVector CentreOfMass(double time_s) const;
  /// Its velocity at a time.
  AffineVector Velocity(double time_s) const;
  /// The force on the whole that this centre of mass needs, p'' - g [m g].
  AffineVector WholeForce(std::size_t at_break) const;
  const AffineVector& Angles(std::size_t at_break) const { return angles_[at_break]; }
  const AffineVector& Momentum(std::size_t at_break) const { return momentum_[at_break]; }
  const FootPlace& Foothold(std::size_t stance) const { return footholds_[stance]; }
  /// A point of contact of a stance.
  FootPlace ContactPoint(std::size_t stance, std::size_t point) const;
  /// A foot at a share of a swing of the problem.
  FootPlace InSwing(std::size_t swing, double share) const;
  /// Its second derivative by the share, of a free swing.
  FootPlace InSwingAcceleration(std::size_t swing, double share) const;
  /// The first of the unknowns of a free swing's control points, three for each.
  int Detour(std::size_t swing) const { return detours_[swing]; }
  /// The forces over the interval after a break.
  const std::vector<ContactForce>& Forces(std::size_t interval) const { return forces_[interval]; }
  /// All forces at breaks that are not zero.
  const std::vector<BoundForce>& BoundForces() const { return bound_forces_; }
  /// The breaks where nothing carries.
  const std::vector<std::size_t>& FreeBreaks() const { return free_breaks_; }
  /// Unknowns of control point, -1 where it is given.
  int ControlPoint(std::size_t i) const { return control_[i].parts.empty() ? -1 : control_[i].parts.front().start; }

 private:
  void PlaceBreaks(double spacing_s, int least_intervals, double grid_s);
  void AddAll();
  void AddCentreOfMass();
  void AddTurning();
  void AddFootholds();
  void AddDetours();
  void AddForces();
  /// The forces of some points at a break, together the force on the whole.
  std::vector<BoundForce> Carry(const std::vector<std::size_t>& stances, std::size_t at_break);
  AffineVector Next();
  /// The rest that one of some breaks is in; null for none.
  const RigidRest* RestTouching(std::size_t first, std::size_t last) const;

  const RigidBodyProblem& problem_;
  int size_ = 0;
  double mean_inertia_ = 1.0;
  std::vector<double> breaks_s_;
  std::vector<AffineVector> control_, angles_, momentum_;
  std::vector<FootPlace> footholds_;
  std::vector<int> detours_;  // by swing, the first unknown
  std::vector<std::vector<ContactForce>> forces_;
  std::vector<BoundForce> bound_forces_;
  std::vector<std::size_t> free_breaks_;
};

}  // namespace gaitwright
