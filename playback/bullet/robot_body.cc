// SPDX-License-Identifier: BSD-3-Clause
#include <BulletDynamics/Featherstone/btMultiBodyLink.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "kinematics/collision/shape_extent.h"
#include "planning/plan/sole_support.h"
#include "playback/bullet/contact_thinning_internal.h"
#include "playback/bullet/robot_body_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kPointFootRadius = 0.005;   // of a point foot's sphere [m]
constexpr double kSoleSphereRadius = 0.002;  // [m]
constexpr double kPlateLift = 0.0002;  // plate above corner level; it touches only where corner spheres do not [m]

btQuaternion ToQuaternion(const Matrix3& R) {
  const Quaternion q(R);
  return {q.x(), q.y(), q.z(), q.w()};
}

/// The principal frame, or the body's own frame if its axes are principal.
Pose PrincipalFrame(const Body& body, Vector3& moments) {
  Pose X_BM = Pose::Identity();
  X_BM.translation() = body.p_BC;
  const Matrix3 off_diagonal = body.I_C - Matrix3(body.I_C.diagonal().asDiagonal());
  moments = body.I_C.diagonal();
  if (off_diagonal.isZero(0.0)) return X_BM;
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(body.I_C);
  Matrix3 R = solver.eigenvectors();
  if (R.determinant() < 0.0) R.col(0) = -R.col(0);
  X_BM.linear() = R;
  moments = solver.eigenvalues();
  return X_BM;
}

/// X_JB of the child body at a joint position.
Pose JointMotion(const Joint& joint, double position) {
  Pose X = Pose::Identity();
  if (joint.type == JointType::kPrismatic) {
    X.translation() = position * joint.axis_J;
  } else {
    X.linear() = Eigen::AngleAxisd(position, joint.axis_J).toRotationMatrix();
  }
  return X;
}

/// Joints of each independent coordinate. A motor acts on the mean of their estimates of the coordinate, so that a gear
/// between twins carries no load.
std::vector<std::vector<RobotBody::Member>> MembersOf(const RobotModel& model) {
  std::vector<std::vector<RobotBody::Member>> members(model.dof_names.size());
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    members[static_cast<std::size_t>(joint.dof)].push_back({static_cast<int>(i), joint.multiplier, joint.offset, 0.0});
  }
  for (auto& group : members) {
    double count = 0.0;
    for (const auto& member : group) count += member.multiplier != 0.0 ? 1.0 : 0.0;
    for (auto& member : group) member.share = member.multiplier != 0.0 ? 1.0 / (count * member.multiplier) : 0.0;
  }
  return members;
}

}  // namespace

btTransform ToBullet(const Pose& X) {
  return btTransform(ToQuaternion(X.linear()), ToBullet(Vector3(X.translation())));
}

RobotBody::RobotBody(const RobotModel& model, const BodyOptions& options)
    : model_(model), members_(MembersOf(model)), locked_(model.dof_names.size(), 0), q0_(options.q0) {
  for (int dof : options.locked_dofs) locked_.at(static_cast<std::size_t>(dof)) = 1;
  for (const Body& body : model.bodies) {
    Vector3 moments;
    X_BM_.push_back(PrincipalFrame(body, moments));
    inertia_M_.push_back(ToBullet(Vector3(options.mass_scale * options.inertia_scale * moments)));
  }
  X_BM_[0].translation() += options.base_com_shift_B;
  const double base_mass = options.mass_scale * model.bodies[0].mass;
  const int links = static_cast<int>(model.joints.size());
  body_ = std::make_unique<btMultiBody>(links, base_mass, inertia_M_[0], false, false);
  body_->setHasSelfCollision(false);
  body_->setCanSleep(false);
  body_->setLinearDamping(0.0);
  body_->setAngularDamping(0.0);
  body_->setUseGyroTerm(true);
  body_->setMaxCoordinateVelocity(1e4);
  body_->setMaxAppliedImpulse(1e6);
  for (int i = 0; i < links; ++i) SetupJoint(model, i, options.mass_scale);
  body_->finalizeMultiDof();
  inertia_ = std::make_unique<JointSpaceInertia>(*body_);
  AddColliders(model, options);
  SetState(options.q0, VectorX::Zero(model.nv()));
}

void RobotBody::SetupJoint(const RobotModel& model, int i, double mass_scale) {
  const Joint& joint = model.joints[static_cast<std::size_t>(i)];
  const double mass = mass_scale * model.bodies[static_cast<std::size_t>(i + 1)].mass;
  const btVector3 inertia = inertia_M_[static_cast<std::size_t>(i + 1)];
  const bool fixed = locked(joint.dof);
  const double position = fixed ? joint.multiplier * q0_[7 + joint.dof] + joint.offset : 0.0;
  const Pose A = X_BM(joint.parent_body).inverse() * joint.X_PJ * JointMotion(joint, position);
  const Pose B = X_BM(i + 1).inverse();
  const btQuaternion to_this = ToQuaternion(B.linear() * A.linear().transpose());
  const btVector3 pivot = ToBullet(Vector3(A.translation())), to_com = ToBullet(Vector3(-B.translation()));
  const btVector3 axis = ToBullet(Vector3(B.linear() * joint.axis_J));
  const int parent = joint.parent_body - 1;
  if (fixed) {
    body_->setupFixed(i, mass, inertia, parent, to_this, pivot, to_com);
  } else if (joint.type == JointType::kPrismatic) {
    body_->setupPrismatic(i, mass, inertia, parent, to_this, axis, pivot, to_com, true);
  } else {
    body_->setupRevolute(i, mass, inertia, parent, to_this, axis, pivot, to_com, true);
  }
}

void RobotBody::AddColliders(const RobotModel& model, const BodyOptions& options) {
  parts_.resize(model.bodies.size());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) compounds_.push_back(std::make_unique<btCompoundShape>(false));
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) AddFoot(model, foot, options);
  for (const Shape& shape : model.collision_shapes) {
    auto made = IsShapeOfAFoot(model, shape) ? nullptr : MakeShape(shape);
    if (made) AddChild(shape.body, shape.X_BS, std::move(made), {-1, shape.link});
  }
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const int link = static_cast<int>(i) - 1;
    auto collider = std::make_unique<btMultiBodyLinkCollider>(body_.get(), link);
    collider->setCollisionShape(compounds_[i].get());
    collider->setFriction(1.0);
    collider->setRestitution(0.0);
    collider->setActivationState(DISABLE_DEACTIVATION);
    (link < 0 ? body_->setBaseCollider(collider.get()) : void(body_->getLink(link).m_collider = collider.get()));
    colliders_.push_back(std::move(collider));
  }
}

void RobotBody::AddFoot(const RobotModel& model, int index, const BodyOptions& options) {
  const Foot& foot = model.feet[static_cast<std::size_t>(index)];
  const ColliderPart part{index, foot.link};
  const auto sphere = [&](const Vector3& p_F, double radius) {
    const Pose X_FS(Eigen::Translation3d(p_F.x(), p_F.y(), p_F.z()));
    AddChild(foot.body, foot.X_BF * X_FS, std::make_unique<btSphereShape>(radius), part);
  };
  if (foot.type == FootType::kSphere) return sphere(Vector3::Zero(), foot.radius);
  if (foot.type == FootType::kPoint) return sphere({0.0, 0.0, kPointFootRadius}, kPointFootRadius);
  const bool all_over = foot.type == FootType::kSole && options.sole_spacing_m > 0.0;
  const std::vector<Vector2> places = all_over ? SoleSamples(foot.sole_F, options.sole_spacing_m) : foot.sole_F;
  for (std::size_t k = 0; k < places.size(); ++k) {
    sphere({places[k].x(), places[k].y(), kSoleSphereRadius}, kSoleSphereRadius);
    const bool corner = k < foot.sole_F.size();
    if (all_over) shapes_.back()->setUserIndex(corner ? ContactThinning::kCorner : ContactThinning::kInner);
  }
  if (!options.sole_plates || foot.sole_F.size() < 3) return;
  const Pose X_FS(Eigen::Translation3d(0.0, 0.0, kPlateLift));
  AddChild(foot.body, foot.X_BF * X_FS, MakeSolePlate(foot.sole_F), part);
}

void RobotBody::AddChild(int body, const Pose& X_BS, std::unique_ptr<btCollisionShape> shape,
                         const ColliderPart& part) {
  const auto b = static_cast<std::size_t>(body);
  compounds_[b]->addChildShape(ToBullet(X_BM_[b].inverse() * X_BS), shape.get());
  parts_[b].push_back(part);
  shapes_.push_back(std::move(shape));
}

const ColliderPart& RobotBody::part(int body, int child) const {
  return parts_.at(static_cast<std::size_t>(body)).at(static_cast<std::size_t>(std::max(child, 0)));
}

int RobotBody::Row(int joint) const {
  return locked(model_.joints[static_cast<std::size_t>(joint)].dof) ? -1 : body_->getLink(joint).m_dofOffset;
}

void RobotBody::AddTo(btMultiBodyDynamicsWorld& world) {
  // Every link needs a collider, even without a shape: constraints on a link without a collider are never solved.
  constexpr int kRobotGroup = btBroadphaseProxy::CharacterFilter;
  for (std::size_t i = 0; i < colliders_.size(); ++i) {
    world.addCollisionObject(colliders_[i].get(), kRobotGroup, parts_[i].empty() ? 0 : btBroadphaseProxy::StaticFilter);
  }
  world.addMultiBody(body_.get());
}

void RobotBody::SetState(const VectorX& q, const VectorX& v) {
  const Quaternion rotation = Quaternion(q[6], q[3], q[4], q[5]).normalized();
  const Matrix3 R_WB = rotation.toRotationMatrix();
  Pose X_WB = Pose::Identity();
  X_WB.translation() = q.head<3>();
  X_WB.linear() = R_WB;
  const Pose X_WM = X_WB * X_BM_[0];
  const Quaternion to_W = rotation * Quaternion(X_BM_[0].linear());
  body_->setBasePos(ToBullet(Vector3(X_WM.translation())));
  body_->setWorldToBaseRot(btQuaternion(-to_W.x(), -to_W.y(), -to_W.z(), to_W.w()));
  const Vector3 w_WB = v.segment<3>(3);
  const Vector3 v_WM = v.head<3>() + w_WB.cross(R_WB * X_BM_[0].translation());
  body_->setBaseVel(ToBullet(v_WM));
  body_->setBaseOmega(ToBullet(w_WB));
  for (std::size_t i = 0; i < model_.joints.size(); ++i) {
    const Joint& joint = model_.joints[i];
    if (locked(joint.dof)) continue;
    body_->setJointPos(static_cast<int>(i), joint.multiplier * q[7 + joint.dof] + joint.offset);
    body_->setJointVel(static_cast<int>(i), joint.multiplier * v[6 + joint.dof]);
  }
  btAlignedObjectArray<btQuaternion> rotations;
  btAlignedObjectArray<btVector3> origins;
  body_->forwardKinematics(rotations, origins);
  body_->updateCollisionObjectWorldTransforms(rotations, origins);
}

void RobotBody::GetState(VectorX& q, VectorX& v) const {
  q = q0_;
  v.setZero(model_.nv());
  const btQuaternion to_M = body_->getWorldToBaseRot();
  const Quaternion R_WM(to_M.w(), -to_M.x(), -to_M.y(), -to_M.z());
  const Quaternion R_WB = (R_WM * Quaternion(X_BM_[0].linear()).conjugate()).normalized();
  const Vector3 p_BM_W = R_WB * Vector3(X_BM_[0].translation());
  const Vector3 w_WB = FromBullet(body_->getBaseOmega());
  q.head<3>() = FromBullet(body_->getBasePos()) - p_BM_W;
  q.segment<4>(3) = R_WB.coeffs();
  v.head<3>() = FromBullet(body_->getBaseVel()) - w_WB.cross(p_BM_W);
  v.segment<3>(3) = w_WB;
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    if (locked(dof)) continue;
    const int joint = model_.dof_joint[static_cast<std::size_t>(dof)];
    q[7 + dof] = body_->getJointPos(joint);
    v[6 + dof] = body_->getJointVel(joint);
  }
}

void RobotBody::AddTorque(const VectorX& tau) {
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    if (locked(dof)) continue;
    for (const Member& member : members(dof)) {
      if (member.share != 0.0) body_->addJointTorque(member.joint, member.share * tau[dof]);
    }
  }
}

void RobotBody::HoldGears(VectorX& a) {
  std::vector<std::size_t> followers;
  for (std::size_t i = 0; i < model_.joints.size(); ++i) {
    if (model_.joints[i].is_mimic && !locked(model_.joints[i].dof)) followers.push_back(i);
  }
  if (followers.empty()) return;
  const auto m = static_cast<Eigen::Index>(followers.size());
  MatrixX J = MatrixX::Zero(m, a.size()), response(a.size(), m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const std::size_t follower = followers[static_cast<std::size_t>(k)];
    const Joint& joint = model_.joints[follower];
    J(k, 6 + Row(static_cast<int>(follower))) = 1.0;
    J(k, 6 + Row(model_.dof_joint[static_cast<std::size_t>(joint.dof)])) = -joint.multiplier;
    const VectorX row = J.row(k).transpose();
    body_->calcAccelerationDeltasMultiDof(row.data(), response.col(k).data(), scratch_r_, scratch_v_);
  }
  a -= response * (J * response).ldlt().solve(J * a);
}

VectorX RobotBody::Accelerations(const VectorX& q, const VectorX& v, const VectorX& tau) {
  SetState(q, v);
  body_->clearForcesAndTorques();
  body_->addBaseForce(btVector3(0.0, 0.0, -kGravity * body_->getBaseMass()));
  for (int i = 0; i < body_->getNumLinks(); ++i) {
    body_->addLinkForce(i, btVector3(0.0, 0.0, -kGravity * body_->getLinkMass(i)));
  }
  AddTorque(tau);
  body_->computeAccelerationsArticulatedBodyAlgorithmMultiDof(0.0, scratch_r_, scratch_v_, scratch_m_, false, false,
                                                              false);
  body_->clearForcesAndTorques();
  // In the scratch vector after the joints' own entries: angular and linear acceleration of M, then the joints.
  VectorX a = Eigen::Map<const VectorX>(&scratch_r_[body_->getNumDofs()], 6 + body_->getNumDofs());
  HoldGears(a);

  VectorX result = VectorX::Zero(model_.nv());
  const Matrix3 R_WB = Quaternion(q[6], q[3], q[4], q[5]).normalized().toRotationMatrix();
  const Vector3 p_BM_W = R_WB * X_BM_[0].translation();
  const Vector3 alpha = a.head<3>(), w = v.segment<3>(3);
  result.head<3>() = a.segment<3>(3) - alpha.cross(p_BM_W) - w.cross(w.cross(p_BM_W));
  result.segment<3>(3) = alpha;
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    if (!locked(dof)) result[6 + dof] = a[6 + Row(model_.dof_joint[static_cast<std::size_t>(dof)])];
  }
  return result;
}

}  // namespace gaitwright::bullet
