// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"
#include "optimisation/numerics/affine_vector.h"

namespace gaitwright {

/// Position of a foot on the ground, or between two footholds:
///   constant + sum_i axes_i * (x[start_i], x[start_i + 1]).
struct FootPlace {
  /// Two unknowns, by the index of the first, with their directions.
  struct Part {
    int start;
    Eigen::Matrix<double, 3, 2> axes;
  };

  Vector3 constant = Vector3::Zero();
  std::vector<Part> parts = {};

  /// Its position.
  Vector3 At(const VectorX& x) const;
  /// Adds factor * other.
  FootPlace& Add(double factor, const FootPlace& other);
  /// Adds `by` * (derivative of the position with respect to the unknowns) to rows of a Jacobian, from `row` on.
  template <typename Derived>
  void AddTo(const Eigen::MatrixBase<Derived>& by, MatrixX& J, Eigen::Index row) const {
    for (const Part& part : parts) J.block(row, part.start, by.rows(), 2) += by * part.axes;
  }
  /// The place in a term's local variables.
  FootPlace SeenBy(SeenUnknowns& seen) const;
};

/// The force on one contact point of a stance over the interval between two nodes, linear in time.
struct ContactForce {
  std::size_t stance = 0, point = 0;
  AffineVector from, to;  ///< [m g]
};

/// A force at a node, bounded by friction and its limit.
struct BoundForce {
  std::size_t stance = 0, point = 0, at_node = 0;
  AffineVector force;  ///< [m g]
};

/// The vector of unknowns of a rigid body's motion. The centre of mass is a cubic B-spline over nodes, which include
/// all contact switches, with given ends and end rates, so the total force is continuous and linear between nodes.
/// Forces on contact points are linear too, and zero when a stance begins or ends in between; one force at each node is
/// not an unknown but the remainder of the total force. If all stance feet change at once, each set carries the total.
/// Further unknowns are the base angles and the angular momentum at nodes, with given ends, the footholds on their
/// planes, and the control points of free swings. During rests, the body's state is given. Units: m, rad, forces in m
/// g, angular momentum over the mean inertia [rad/s]. Keeps a reference to the problem.
class RigidBodyUnknowns {
 public:
  /// @param spacing_s  largest node spacing; each stance has `least_intervals` or more.
  /// @param grid_s     nodes between switches lie at multiples of it; 0 allows any time.
  RigidBodyUnknowns(const RigidBodyProblem& problem, double spacing_s, int least_intervals, double grid_s = 0.0);

  /// Over given nodes. @throws InvalidArgument unless they rise from 0 to the end and include all contact switches.
  RigidBodyUnknowns(const RigidBodyProblem& problem, std::vector<double> nodes_s);

  int size() const { return size_; }
  const std::vector<double>& nodes_s() const { return nodes_s_; }
  std::size_t intervals() const { return nodes_s_.size() - 1; }
  double mean_inertia() const { return mean_inertia_; }

  /// Its position at a time.
  AffineVector CentreOfMass(double time_s) const;
  /// Its velocity at a time.
  AffineVector Velocity(double time_s) const;
  /// The total force that this centre of mass needs, p'' - g [m g].
  AffineVector WholeForce(std::size_t at_node) const;
  const AffineVector& Angles(std::size_t at_node) const { return angles_[at_node]; }
  const AffineVector& Momentum(std::size_t at_node) const { return momentum_[at_node]; }
  const FootPlace& Foothold(std::size_t stance) const { return footholds_[stance]; }
  /// A point of contact of a stance.
  FootPlace ContactPoint(std::size_t stance, std::size_t point) const;
  /// A foot at a fraction of a swing of the problem.
  FootPlace InSwing(std::size_t swing, double share) const;
  /// Its second derivative by the fraction, for a free swing.
  FootPlace InSwingAcceleration(std::size_t swing, double share) const;
  /// The first of the unknowns of a free swing's control points, three for each.
  int Detour(std::size_t swing) const { return detours_[swing]; }
  /// The forces over the interval after a node.
  const std::vector<ContactForce>& Forces(std::size_t interval) const { return forces_[interval]; }
  /// All forces at nodes that are not zero.
  const std::vector<BoundForce>& BoundForces() const { return bound_forces_; }
  /// The nodes without contact.
  const std::vector<std::size_t>& FreeNodes() const { return free_nodes_; }
  /// Unknowns of a control point, -1 if it is given.
  int ControlPoint(std::size_t i) const { return control_[i].parts.empty() ? -1 : control_[i].parts.front().start; }

 private:
  void PlaceNodes(double spacing_s, int least_intervals, double grid_s);
  void AddAll();
  void AddCentreOfMass();
  void AddTurning();
  void AddFootholds();
  void AddDetours();
  void AddForces();
  /// The forces of some points at a node, which add up to the total force.
  std::vector<BoundForce> Carry(const std::vector<std::size_t>& stances, std::size_t at_node);
  AffineVector Next();
  /// The rest that contains a node; null for none.
  const RigidRest* RestTouching(std::size_t first, std::size_t last) const;

  const RigidBodyProblem& problem_;
  int size_ = 0;
  double mean_inertia_ = 1.0;
  std::vector<double> nodes_s_;
  std::vector<AffineVector> control_, angles_, momentum_;
  std::vector<FootPlace> footholds_;
  std::vector<int> detours_;  // by swing, the first unknown
  std::vector<std::vector<ContactForce>> forces_;
  std::vector<BoundForce> bound_forces_;
  std::vector<std::size_t> free_nodes_;
};

}  // namespace gaitwright
