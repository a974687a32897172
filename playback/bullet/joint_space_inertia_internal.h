// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <vector>

#include "kinematics/spatial/pose.h"
#include "playback/bullet/tree_factor_internal.h"

namespace gaitwright::bullet {

/// The mass matrix of a free-floating multibody with revolute, prismatic and fixed joints, over Bullet's velocities: of
/// the base its angular velocity and that of its centre of mass O, both in world axes, then the joints' rates. It is
/// what Bullet's articulated-body algorithm inverts; Bullet passes over all links for each column of its inverse, and
/// the factor of this only along the paths to the root.
///
/// Composite rigid bodies, all about O in world axes (Featherstone 2008, section 6.2): with S_i the motion that joint i
/// gives and I_i the inertia of all that it carries, M_ij = S_j . I_i S_i for j on the path of i.
class JointSpaceInertia {
 public:
  /// The body must be finished, and outlive it.
  explicit JointSpaceInertia(const btMultiBody& body);

  /// For the body's present position, as its last step or forwardKinematics left it.
  void Update();

  int size() const { return tree_.size(); }
  const CoordinateTree& tree() const { return tree_; }
  const std::vector<double>& matrix() const { return M_; }
  const TreeFactor& factor() const { return factor_; }
  /// Of those that move a link, the one at the end of the path. @param link  Bullet's number, -1 for the base.
  int last_coordinate(int link) const { return last_coordinate_[static_cast<std::size_t>(link + 1)]; }
  /// J M^-1 J^T. @param J  of size().
  double InverseAlong(const double* J);
  /// (M^-1)_ii of a coordinate i.
  double InverseAt(int coordinate);

  /// J of the velocity along a direction of the point of a link that is at p_W.
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
  std::vector<int> last_coordinate_;  ///< by link + 1: of those that move it
  std::vector<Motion> motions_;       ///< by coordinate; of joints
  std::vector<Inertia> inertias_;     ///< by link + 1
  std::vector<double> M_;
  TreeFactor factor_;
  VectorX half_;
};

}  // namespace gaitwright::bullet
