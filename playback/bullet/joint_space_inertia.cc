// SPDX-License-Identifier: BSD-3-Clause
#include <BulletDynamics/Featherstone/btMultiBodyLink.h>

#include "playback/bullet/joint_space_inertia_internal.h"
#include "playback/bullet/robot_body_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr int kBaseCoordinates = 6;

Matrix3 RotationFromBullet(const btMatrix3x3& R) {
  Matrix3 result;
  for (int row = 0; row < 3; ++row) result.row(row) = FromBullet(R[row]);
  return result;
}

/// By link + 1: the last coordinate on its path.
std::vector<int> LastCoordinates(const btMultiBody& body) {
  std::vector<int> last{kBaseCoordinates - 1};
  for (int i = 0; i < body.getNumLinks(); ++i) {
    const btMultibodyLink& link = body.getLink(i);
    const int before = last[static_cast<std::size_t>(link.m_parent + 1)];
    last.push_back(link.m_dofCount > 0 ? kBaseCoordinates + link.m_dofOffset : before);
  }
  return last;
}

}  // namespace

CoordinateTree JointSpaceInertia::TreeOf(const btMultiBody& body) {
  const std::vector<int> last = LastCoordinates(body);
  std::vector<int> parent{-1, 0, 1, 2, 3, 4};
  for (int i = 0; i < body.getNumLinks(); ++i) {
    const btMultibodyLink& link = body.getLink(i);
    if (link.m_dofCount > 0) parent.push_back(last[static_cast<std::size_t>(link.m_parent + 1)]);
  }
  return CoordinateTree(parent);
}

JointSpaceInertia::JointSpaceInertia(const btMultiBody& body)
    : body_(body),
      tree_(TreeOf(body)),
      last_coordinate_(LastCoordinates(body)),
      motions_(static_cast<std::size_t>(tree_.size())),
      inertias_(last_coordinate_.size()),
      M_(tree_.entries(), 0.0),
      factor_(tree_) {}

JointSpaceInertia::Inertia JointSpaceInertia::InertiaOf(double mass, const btVector3& principal, const Matrix3& R_W,
                                                        const Vector3& p_OC) {
  const Matrix3 about_centre = R_W * FromBullet(principal).asDiagonal() * R_W.transpose();
  const Vector3 moment = mass * p_OC;
  return {mass, moment, about_centre + moment.dot(p_OC) * Matrix3::Identity() - moment * p_OC.transpose()};
}

void JointSpaceInertia::Update() {
  const Vector3 p_WO = FromBullet(body_.getBasePos());
  const Matrix3 R_WB = RotationFromBullet(btMatrix3x3(body_.getWorldToBaseRot())).transpose();
  inertias_[0] = InertiaOf(body_.getBaseMass(), body_.getBaseInertia(), R_WB, Vector3::Zero());
  const int links = body_.getNumLinks();
  for (int i = 0; i < links; ++i) {
    const btMultibodyLink& link = body_.getLink(i);
    const auto k = static_cast<std::size_t>(i + 1);
    const Matrix3 R_W = RotationFromBullet(link.m_cachedWorldTransform.getBasis());
    const Vector3 p_OC = FromBullet(link.m_cachedWorldTransform.getOrigin()) - p_WO;
    inertias_[k] = InertiaOf(link.m_mass, link.m_inertiaLocal, R_W, p_OC);
    if (link.m_dofCount == 0) continue;
    Motion& motion = motions_[static_cast<std::size_t>(last_coordinate_[k])];
    motion.angular = R_W * FromBullet(link.getAxisTop(0));
    motion.linear_O = R_W * FromBullet(link.getAxisBottom(0)) - motion.angular.cross(p_OC);
  }
  for (int i = links - 1; i >= 0; --i) {
    const btMultibodyLink& link = body_.getLink(i);
    const auto k = static_cast<std::size_t>(i + 1);
    const Inertia& carried = inertias_[k];
    if (link.m_dofCount > 0) FillJointRow(last_coordinate_[k], carried);
    Inertia& parent = inertias_[static_cast<std::size_t>(link.m_parent + 1)];
    parent.mass += carried.mass;
    parent.moment += carried.moment;
    parent.I_O += carried.I_O;
  }
  FillBaseRows(inertias_[0]);
  factor_.Compute(M_);
}

void JointSpaceInertia::FillJointRow(int coordinate, const Inertia& carried) {
  const Motion& motion = motions_[static_cast<std::size_t>(coordinate)];
  const Vector3 angular = carried.I_O * motion.angular + carried.moment.cross(motion.linear_O);
  const Vector3 linear = carried.mass * motion.linear_O - carried.moment.cross(motion.angular);
  double* row = &M_[tree_.offset(coordinate)];
  Eigen::Map<Vector3>{row} = angular;
  Eigen::Map<Vector3>{row + 3} = linear;
  const int* path = tree_.path(coordinate);
  for (int a = kBaseCoordinates; a <= tree_.depth(coordinate); ++a) {
    const Motion& other = motions_[static_cast<std::size_t>(path[a])];
    row[a] = other.angular.dot(angular) + other.linear_O.dot(linear);
  }
}

void JointSpaceInertia::FillBaseRows(const Inertia& whole) {
  for (int i = 0; i < 3; ++i) {
    double* turning = &M_[tree_.offset(i)];
    for (int j = 0; j <= i; ++j) turning[j] = whole.I_O(i, j);
    double* moving = &M_[tree_.offset(3 + i)];
    Eigen::Map<Vector3>{moving} = whole.moment.cross(Vector3::Unit(i));
    for (int j = 0; j < i; ++j) moving[3 + j] = 0.0;
    moving[3 + i] = whole.mass;
  }
}

double JointSpaceInertia::InverseAlong(const double* J) {
  half_ = Eigen::Map<const VectorX>(J, size());
  factor_.SolveUpper(half_.data());
  return half_.squaredNorm();
}

double JointSpaceInertia::InverseAt(int coordinate) {
  half_.setZero(tree_.depth(coordinate) + 1);
  half_[tree_.depth(coordinate)] = 1.0;
  factor_.SolveUpperAlong(coordinate, half_.data());
  return half_.squaredNorm();
}

void JointSpaceInertia::FillPointJacobian(int link, const Vector3& p_W, const Vector3& direction_W, double* J) const {
  const Vector3 turning = (p_W - FromBullet(body_.getBasePos())).cross(direction_W);
  Eigen::Map<Vector3>{J} = turning;
  Eigen::Map<Vector3>{J + 3} = direction_W;
  const int last = last_coordinate(link);
  const int* path = tree_.path(last);
  for (int a = kBaseCoordinates; a <= tree_.depth(last); ++a) {
    const Motion& motion = motions_[static_cast<std::size_t>(path[a])];
    J[path[a]] = motion.angular.dot(turning) + motion.linear_O.dot(direction_W);
  }
}

}  // namespace gaitwright::bullet
