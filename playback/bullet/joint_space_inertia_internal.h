// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <vector>

#include "kinematics/spatial/pose.h"
#include "playback/bullet/tree_factor_internal.h"

namespace gaitwright::bullet {

/// The mass matrix of a free-floating multibody with revolute, prismatic and fixed joints, in Bullet's velocities:
/// angular velocity of the base, velocity of its centre of mass O, both in world axes, then joint rates. Bullet's
/// articulated-body algorithm inverts the same matrix. Bullet passes over all links for each column of the inverse;
/// this factor passes only along the paths to the root.
///
/// Composite rigid bodies, all about O in world axes (Featherstone 2008, section 6.2): with S_i the motion of joint i
/// and I_i the inertia of all bodies that it carries, M_ij = S_j . I_i S_i for j on the path of i.
class JointSpaceInertia {
 public:
  /// The body must be finished, and outlive this object.
  explicit JointSpaceInertia(const btMultiBody& body);

  /// Updates for the body's current position, as its last step or forwardKinematics left it.
  void Update();

  int size() const { return tree_.size(); }
  const CoordinateTree& tree() const { return tree_; }
  const std::vector<double>& matrix() const { return M_; }
  const TreeFactor& factor() const { return factor_; }
  /// The last coordinate on the path that moves a link. @param link  Bullet's number, -1 for the base.
  int last_coordinate(int link) const { return last_coordinate_[static_cast<std::size_t>(link + 1)]; }
  /// J M^-1 J^T. @param J  of size().
  double InverseAlong(const double* J);
  /// (M^-1)_ii of a coordinate i.
  double InverseAt(int coordinate);

  /// Fills J of the velocity of a link's point p_W along a direction.
  /// @param link  Bullet's number, -1 for the base.  @param J  of size(), all zero before.
  void FillPointJacobian(int link, const Vector3& p_W, const Vector3& direction_W, double* J) const;

 private:
  struct Motion {
    Vector3 angular, linear_O;
  };
  struct Inertia {
    double mass;
    Vector3 moment;  ///< mass * centre
    Matrix3 I_O;
  };
  static CoordinateTree TreeOf(const btMultiBody& body);
  static Inertia InertiaOf(double mass, const btVector3& principal, const Matrix3& R_W, const Vector3& p_OC);
  void FillJointRow(int coordinate, const Inertia& carried);
  void FillBaseRows(const Inertia& whole);

  const btMultiBody& body_;
  CoordinateTree tree_;
  std::vector<int> last_coordinate_;  ///< by link + 1: last coordinate that moves it
  std::vector<Motion> motions_;       ///< by coordinate of a joint
  std::vector<Inertia> inertias_;     ///< by link + 1
  std::vector<double> M_;
  TreeFactor factor_;
  VectorX half_;
};

}  // namespace gaitwright::bullet
