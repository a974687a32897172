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

/// What one child of a link's compound shape is.
struct ColliderPart {
  int foot = -1;     ///< index into RobotModel::feet, or -1
  std::string link;  ///< URDF link
};

/// How the robot is built.
struct BodyOptions {
  double mass_scale = 1.0, inertia_scale = 1.0;
  Vector3 base_com_shift_B = Vector3::Zero();  ///< [m]
  bool sole_plates = false;                    ///< soles as convex plates too, beside the spheres at their corners
  double sole_spacing_m = 0.0;                 ///< of spheres all over a sole; 0 for none but at the corners
  std::vector<int> locked_dofs;                ///< held at their position in q0, without a motor
  VectorX q0;                                  ///< size nq
};

/// A RobotModel as a btMultiBody with one collider per body, and its state in our order.
///
/// = Notation =
///   B  a body's frame     M  its frame for Bullet: centre of mass, principal axes
/// Bullet's poses, inertias and colliders are in M, its base velocity is that of the centre of mass; X_BM goes between.
class RobotBody {
 public:
  RobotBody(const RobotModel& model, const BodyOptions& options);

  /// Puts the links and their colliders into a world. The world must outlive neither.
  void AddTo(btMultiBodyDynamicsWorld& world);

  void SetState(const VectorX& q, const VectorX& v);
  void GetState(VectorX& q, VectorX& v) const;

  /// Accelerations of forward dynamics at a state without contact, in our order. Mimic joints are held exactly:
  /// a = a0 - M^-1 J^T (J M^-1 J^T)^-1 J a0 with J the rows of the gears.
  VectorX Accelerations(const VectorX& q, const VectorX& v, const VectorX& tau);

  /// Adds generalised forces of the independent joints for the coming step; a gear's torque is shared by its joints.
  void AddTorque(const VectorX& tau);

  /// Share of coordinate `dof` that joint i stands for: generalised force = sum of share * joint torque.
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
  /// Projects accelerations in Bullet's order onto those that the gears allow.
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

/// Bullet's shape for one of ours with the pose of its axes in S; null for a mesh without vertices.
std::unique_ptr<btCollisionShape> MakeShape(const Shape& shape);

/// A sole as a convex plate above its polygon.
std::unique_ptr<btCollisionShape> MakeSolePlate(const std::vector<Vector2>& sole_F);

}  // namespace gaitwright::bullet
