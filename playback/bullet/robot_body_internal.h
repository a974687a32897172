// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "playback/bullet/joint_space_inertia_internal.h"

namespace gaitwright::bullet {

inline btVector3 ToBullet(const Vector3& p) { return {p.x(), p.y(), p.z()}; }
inline Vector3 FromBullet(const btVector3& p) { return {p.x(), p.y(), p.z()}; }
btTransform ToBullet(const Pose& X);

/// Identity of a child of a link's compound shape.
struct ColliderPart {
  int foot = -1;     ///< index into RobotModel::feet, or -1
  std::string link;  ///< URDF link
};

/// Options for building the robot.
struct BodyOptions {
  double mass_scale = 1.0, inertia_scale = 1.0;
  Vector3 base_com_shift_B = Vector3::Zero();  ///< [m]
  bool sole_plates = false;                    ///< soles also have convex plates, besides the spheres at their corners
  double sole_spacing_m = 0.0;   ///< distance of spheres all over a sole; 0 puts spheres at its corners only
  std::vector<int> locked_dofs;  ///< held at their position in q0, without a motor
  VectorX q0;                    ///< size nq
};

/// A RobotModel as a btMultiBody with one collider per body, and its state in our order.
///
/// = Notation =
///   B  a body's frame     M  its frame for Bullet: centre of mass, principal axes
/// Bullet's poses, inertias and colliders are in M; its base velocity is that of the centre of mass. X_BM converts.
class RobotBody {
 public:
  RobotBody(const RobotModel& model, const BodyOptions& options);

  /// Adds the links and their colliders to a world. The world must not outlive the robot or its shapes.
  void AddTo(btMultiBodyDynamicsWorld& world);

  void SetState(const VectorX& q, const VectorX& v);
  void GetState(VectorX& q, VectorX& v) const;

  /// Accelerations of forward dynamics for a state without contact, in our order. Mimic joints are held exactly:
  /// a = a0 - M^-1 J^T (J M^-1 J^T)^-1 J a0 with J the rows of the gears.
  VectorX Accelerations(const VectorX& q, const VectorX& v, const VectorX& tau);

  /// Adds generalised forces of the independent joints for the coming step; the joints of a gear share its torque.
  void AddTorque(const VectorX& tau);

  /// Share of coordinate `dof` that joint i represents: generalised force = sum of share * joint torque.
  struct Member {
    int joint;
    double multiplier, offset, share;
  };
  const std::vector<Member>& members(int dof) const { return members_[static_cast<std::size_t>(dof)]; }
  bool locked(int dof) const { return locked_[static_cast<std::size_t>(dof)]; }

  btMultiBody& multibody() { return *body_; }
  const btMultiBody& multibody() const { return *body_; }
  JointSpaceInertia& inertia() { return *inertia_; }
  const Pose& X_BM(int body) const { return X_BM_[static_cast<std::size_t>(body)]; }
  const ColliderPart& part(int body, int child) const;
  /// Index of the row of a joint in Bullet's vectors of joint velocities, -1 when locked.
  int Row(int joint) const;

 private:
  void SetupJoint(const RobotModel& model, int joint, double mass_scale);
  void AddColliders(const RobotModel& model, const BodyOptions& options);
  void AddFoot(const RobotModel& model, int foot, const BodyOptions& options);
  void AddChild(int body, const Pose& X_BS, std::unique_ptr<btCollisionShape> shape, const ColliderPart& part);
  /// Projects accelerations in Bullet's order onto those that satisfy the gears.
  void HoldGears(VectorX& a);

  const RobotModel& model_;
  std::vector<Pose> X_BM_;
  std::vector<btVector3> inertia_M_;
  std::vector<std::vector<Member>> members_;
  std::vector<char> locked_;
  VectorX q0_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCompoundShape>> compounds_;  ///< by body
  std::vector<std::vector<ColliderPart>> parts_;             ///< by body, child
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  std::unique_ptr<btMultiBody> body_;
  std::unique_ptr<JointSpaceInertia> inertia_;
  btAlignedObjectArray<btScalar> scratch_r_;
  btAlignedObjectArray<btVector3> scratch_v_;
  btAlignedObjectArray<btMatrix3x3> scratch_m_;
};

/// Bullet's shape for one of ours, and the pose of its axes in S; null for a mesh without vertices.
std::unique_ptr<btCollisionShape> MakeShape(const Shape& shape);

/// A sole as a convex plate above its polygon.
std::unique_ptr<btCollisionShape> MakeSolePlate(const std::vector<Vector2>& sole_F);

}  // namespace gaitwright::bullet
