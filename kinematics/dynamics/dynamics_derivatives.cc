// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/dynamics_derivatives.h"

#include "kinematics/dynamics/spatial_internal.h"

namespace gaitwright {
namespace {

using spatial::Cross, spatial::Dot, spatial::Force, spatial::Motion, spatial::Stacked;

/// Matrix B of a body. The force f = I a + v x* I v changes by 2 B m if the velocity changes by m and the acceleration
/// by v x m less than for a motion m that is fixed in the body. B (u; w) = (w x momentum; turning w) for any u, so the
/// sum of B over bodies needs only the sums of `momentum` and `turning`.
struct VelocityEffect {
  Vector3 momentum = Vector3::Zero();  // linear momentum
  Matrix3 turning = Matrix3::Zero();

  Force operator*(const Motion& m) const { return {m.angular.cross(momentum), turning * m.angular}; }
  void Add(const VelocityEffect& other) {
    momentum += other.momentum;
    turning += other.turning;
  }
};

VelocityEffect EffectOf(const spatial::Inertia& I, const Motion& v) {
  const Matrix3 spread = 0.5 * I.inertia_O.trace() * Matrix3::Identity() - I.inertia_O;  // integral of r r^T dm
  VelocityEffect effect;
  effect.momentum = I.mass * v.linear + v.angular.cross(I.moment_O);
  effect.turning.noalias() = -v.linear * I.moment_O.transpose();
  effect.turning.diagonal().array() += v.linear.dot(I.moment_O);
  for (int k = 0; k < 3; ++k) effect.turning.col(k) -= v.angular.cross(spread.col(k));
  return effect;
}

/// Motion of a joint as spatial vectors about O.
struct JointTerms {
  Motion S;          ///< motion at unit rate of its coordinate
  Motion S_rate;     ///< time derivative of S
  Motion S_bending;  ///< a_parent x S + v_parent x S_rate: change of accelerations beyond the joint by its position
};

/// Sums over a body and all bodies beyond it.
struct Subtree {
  spatial::Inertia inertia;
  VelocityEffect effect;
  Force force, momentum;

  void Add(const Subtree& other) {
    spatial::Add(other.inertia, inertia);
    effect.Add(other.effect);
    momentum = momentum + other.momentum;
    force = force + other.force;
  }
};

/// A point fixed in a body, at r from O. The velocity is relative to O, and the acceleration includes gravity.
struct PointState {
  Vector3 r, velocity, turning, acceleration, turning_rate;
};

/// Linear part of a motion at a point.
Vector3 At(const Motion& m, const Vector3& r) { return m.linear + m.angular.cross(r); }

}  // namespace

struct DynamicsDerivatives::Impl {
  explicit Impl(const RobotModel& of)
      : model(of),
        scratch(of),
        joints(of.joints.size()),
        velocity(of.bodies.size()),
        acceleration(of.bodies.size()),
        beyond(of.bodies.size()) {}

  /// Velocities, accelerations (gravity as an upward acceleration of the world) and the force for each body alone.
  void Forward(const VectorX& q, const VectorX& v, const VectorX& a) {
    ForwardKinematics(model, q, scratch);
    origin_velocity = v.head<3>();
    velocity[0] = {Vector3::Zero(), v.segment<3>(3)};
    acceleration[0] = {a.head<3>() + Vector3(0.0, 0.0, kGravity), a.segment<3>(3)};
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const Joint& joint = model.joints[j];
      const auto parent = static_cast<std::size_t>(joint.parent_body);
      JointTerms& terms = joints[j];
      terms.S = joint.multiplier * spatial::JointMotion(joint, scratch, j);
      terms.S_rate = Cross(velocity[parent], terms.S);
      terms.S_bending = Cross(acceleration[parent], terms.S) + Cross(velocity[parent], terms.S_rate);
      const double rate = v[6 + joint.dof], change = a[6 + joint.dof];
      velocity[j + 1] = velocity[parent] + rate * terms.S;
      acceleration[j + 1] = acceleration[parent] + (change * terms.S + rate * terms.S_rate);
    }
    for (std::size_t i = 0; i < beyond.size(); ++i) {
      Subtree& body = beyond[i];
      body.inertia = spatial::InertiaOf(model.bodies[i], scratch.R_WB[i], scratch.p_WB[i] - scratch.p_WB[0]);
      body.effect = EffectOf(body.inertia, velocity[i]);
      body.momentum = body.inertia * velocity[i];
      body.force = body.inertia * acceleration[i] + Cross(velocity[i], body.momentum);
    }
  }

  /// Rows and columns of a joint with itself, its ancestors and the base.
  void AddJoint(std::size_t j, InverseDynamicsDerivatives& d) const {
    const JointTerms& own = joints[j];
    const Subtree& tree = beyond[j + 1];
    const Eigen::Index column = 6 + model.joints[j].dof;
    const Force inertial = tree.inertia * own.S;
    const Force turned = tree.effect * own.S, rated = tree.effect * own.S_rate;
    const Force swung = tree.inertia * own.S_rate, bent = tree.inertia * own.S_bending;
    // Change of the force on all bodies beyond the joint, by the joint's position and by its rate.
    const Force carried = Cross(own.S, tree.force);
    const Force by_q{2.0 * rated.linear + bent.linear, 2.0 * rated.angular + bent.angular};
    const Force by_v{2.0 * (turned.linear + swung.linear), 2.0 * (turned.angular + swung.angular)};
    const Force by_q_carried = by_q + carried;
    // S^T 2 B (u; w) = effect . w
    const Vector3 effect =
        2.0 * (tree.effect.momentum.cross(own.S.linear) + tree.effect.turning.transpose() * own.S.angular);
    d.tau[column] += Dot(own.S, tree.force);
    d.M(column, column) += Dot(own.S, inertial);
    d.by_q(column, column) += Dot(own.S, by_q);
    d.by_v(column, column) += Dot(own.S, by_v);
    for (int i = model.joints[j].parent_body; i > 0; i = model.joints[static_cast<std::size_t>(i - 1)].parent_body) {
      const auto k = static_cast<std::size_t>(i - 1);
      const JointTerms& other = joints[k];
      const Eigen::Index row = 6 + model.joints[k].dof;
      const double coupling = Dot(other.S, inertial);
      d.M(row, column) += coupling;
      d.M(column, row) += coupling;
      d.by_q(row, column) += Dot(other.S, by_q_carried);
      d.by_v(row, column) += Dot(other.S, by_v);
      d.by_q(column, row) += effect.dot(other.S_rate.angular) + Dot(other.S_bending, inertial);
      d.by_v(column, row) += effect.dot(other.S.angular) + 2.0 * Dot(other.S_rate, inertial);
    }
    d.M.col(column).head<6>() += Stacked(inertial);
    d.by_q.col(column).head<6>() += Stacked(by_q_carried);
    d.by_v.col(column).head<6>() += Stacked(by_v);
    // A rotation e of the base is the motion (0; e), and its rate of change is (0; w x e).
    const Vector3& w = velocity[0].angular;
    d.by_v.row(column).segment<3>(3) += effect + inertial.angular.cross(w);
  }

  void AddBase(InverseDynamicsDerivatives& d) const {
    const Subtree& whole = beyond[0];
    const Vector3& w = velocity[0].angular;
    d.tau.head<6>() = Stacked(whole.force);
    d.M.topLeftCorner<3, 3>() = whole.inertia.mass * Matrix3::Identity();
    d.M.block<3, 3>(0, 3) = -Skew(whole.inertia.moment_O);
    d.M.block<3, 3>(3, 0) = Skew(whole.inertia.moment_O);
    d.M.block<3, 3>(3, 3) = whole.inertia.inertia_O;
    for (int k = 0; k < 3; ++k) {
      const Motion turn{Vector3::Zero(), Vector3::Unit(k)}, rate{Vector3::Zero(), w.cross(Vector3::Unit(k))};
      const Force effect = whole.effect * turn, inertial = whole.inertia * rate;
      d.by_v.col(3 + k).head<3>() = 2.0 * effect.linear + inertial.linear;
      d.by_v.col(3 + k).segment<3>(3) = 2.0 * effect.angular + inertial.angular;
    }
    d.M.bottomLeftCorner(model.num_dofs(), 6) = d.M.topRightCorner(6, model.num_dofs()).transpose();
  }

  /// Derivatives by the rotation of the base. If robot and world rotate together, forces rotate with them. So a
  /// rotation of the robot alone equals a rotation of both, followed by the inverse rotation of velocities,
  /// accelerations and gravity.
  void AddRotation(InverseDynamicsDerivatives& d) const {
    const Vector3 &w = velocity[0].angular, &linear = acceleration[0].linear, &angular = acceleration[0].angular;
    for (int k = 0; k < 3; ++k) {
      const Vector3 e = Vector3::Unit(k);
      auto column = d.by_q.col(3 + k);
      column.noalias() = -d.by_v.middleCols<3>(3) * e.cross(w);
      column.noalias() -= d.M.leftCols<3>() * e.cross(linear);
      column.noalias() -= d.M.middleCols<3>(3) * e.cross(angular);
      column.head<3>() += e.cross(beyond[0].force.linear);
      column.segment<3>(3) += e.cross(beyond[0].force.angular);
    }
  }

  /// Columns of a point at r from O by a joint that carries it.
  void AddPoint(std::size_t j, const PointState& at, PointDerivatives& d) const {
    const JointTerms& joint = joints[j];
    const Eigen::Index column = 6 + model.joints[j].dof;
    const Vector3& turn = joint.S.angular;
    const Vector3 rated = At(joint.S_rate, at.r), bent = At(joint.S_bending, at.r);
    const Vector3 &rated_turn = joint.S_rate.angular, &bent_turn = joint.S_bending.angular;
    d.velocity_by_q.col(column).head<3>() += turn.cross(at.velocity) + rated;
    d.velocity_by_q.col(column).tail<3>() += turn.cross(at.turning) + rated_turn;
    d.acceleration_by_q.col(column).head<3>() +=
        turn.cross(at.acceleration) + bent + 2.0 * rated_turn.cross(at.velocity);
    d.acceleration_by_q.col(column).tail<3>() += turn.cross(at.turning_rate) + bent_turn + rated_turn.cross(at.turning);
    d.acceleration_by_v.col(column).head<3>() += 2.0 * (rated + turn.cross(at.velocity));
    d.acceleration_by_v.col(column).tail<3>() += 2.0 * rated_turn + turn.cross(at.turning);
  }

  /// Columns of a point by the rotation of the base and its rate; see AddRotation.
  void AddPointRotation(const PointState& at, PointDerivatives& d) const {
    const Vector3 &w = velocity[0].angular, &linear = acceleration[0].linear, &angular = acceleration[0].angular;
    for (int k = 0; k < 3; ++k) {
      const Vector3 e = Vector3::Unit(k);
      d.acceleration_by_v.col(3 + k).head<3>() = w.cross(e).cross(at.r) + 2.0 * e.cross(at.velocity);
      d.acceleration_by_v.col(3 + k).tail<3>() = w.cross(e) + e.cross(at.turning);
    }
    for (int k = 0; k < 3; ++k) {
      const Vector3 e = Vector3::Unit(k), w_back = e.cross(w), angular_back = e.cross(angular);
      d.velocity_by_q.col(3 + k).head<3>() = e.cross(at.velocity) - w_back.cross(at.r);
      d.velocity_by_q.col(3 + k).tail<3>() = e.cross(at.turning) - w_back;
      auto column = d.acceleration_by_q.col(3 + k);
      column.noalias() = -d.acceleration_by_v.middleCols<3>(3) * w_back;
      column.head<3>() += e.cross(at.acceleration - linear) - angular_back.cross(at.r);
      column.tail<3>() += e.cross(at.turning_rate) - angular_back;
    }
  }

  const RobotModel& model;
  DynamicsScratch scratch;
  Vector3 origin_velocity = Vector3::Zero();  ///< velocity of the base origin
  std::vector<JointTerms> joints;
  std::vector<Motion> velocity, acceleration;  ///< by body
  std::vector<Subtree> beyond;                 ///< by body
};

DynamicsDerivatives::DynamicsDerivatives(const RobotModel& model) : impl_(std::make_unique<Impl>(model)) {}
DynamicsDerivatives::~DynamicsDerivatives() = default;

const DynamicsScratch& DynamicsDerivatives::kinematics() const { return impl_->scratch; }

void DynamicsDerivatives::Compute(const VectorX& q, const VectorX& v, const VectorX& a,
                                  InverseDynamicsDerivatives& result) {
  Impl& self = *impl_;
  const Eigen::Index nv = self.model.nv();
  result.tau.setZero(nv);
  for (MatrixX* matrix : {&result.by_q, &result.by_v, &result.M}) matrix->setZero(nv, nv);
  self.Forward(q, v, a);
  for (std::size_t j = self.joints.size(); j-- > 0;) {
    self.AddJoint(j, result);
    self.beyond[static_cast<std::size_t>(self.model.joints[j].parent_body)].Add(self.beyond[j + 1]);
  }
  self.AddBase(result);
  self.AddRotation(result);
}

void DynamicsDerivatives::DifferentiatePoint(int body, const Vector3& p_BQ, PointDerivatives& result) const {
  const Impl& self = *impl_;
  const auto b = static_cast<std::size_t>(body);
  for (MatrixX* matrix : {&result.velocity_by_q, &result.acceleration_by_q, &result.acceleration_by_v})
    matrix->setZero(6, self.model.nv());
  const Motion &v = self.velocity[b], &a = self.acceleration[b];
  PointState at;
  at.r = self.scratch.p_WB[b] - self.scratch.p_WB[0] + self.scratch.R_WB[b] * p_BQ;
  at.velocity = At(v, at.r);
  at.turning = v.angular;
  at.acceleration = At(a, at.r) + v.angular.cross(at.velocity);
  at.turning_rate = a.angular;
  for (int i = body; i > 0; i = self.model.joints[static_cast<std::size_t>(i - 1)].parent_body)
    self.AddPoint(static_cast<std::size_t>(i - 1), at, result);
  self.AddPointRotation(at, result);
}

void DynamicsDerivatives::DifferentiateMomentum(MomentumDerivatives& result) const {
  const Impl& self = *impl_;
  const Subtree& whole = self.beyond[0];
  const double mass = whole.inertia.mass;
  const Vector3 p_OC = whole.inertia.moment_O / mass;
  const Vector3 &linear = whole.momentum.linear, &w = self.velocity[0].angular;
  result.by_q.setZero(6, self.model.nv());
  result.by_v.setZero(6, self.model.nv());
  result.momentum << linear + mass * self.origin_velocity, whole.momentum.angular - p_OC.cross(linear);
  result.by_v.topLeftCorner<3, 3>() = mass * Matrix3::Identity();
  result.by_v.block<3, 3>(0, 3) = -Skew(whole.inertia.moment_O);
  result.by_v.block<3, 3>(3, 3) = whole.inertia.inertia_O + Skew(p_OC) * Skew(whole.inertia.moment_O);
  for (std::size_t j = 0; j < self.joints.size(); ++j) {
    const JointTerms& joint = self.joints[j];
    const Subtree& tree = self.beyond[j + 1];
    const Eigen::Index column = 6 + self.model.joints[j].dof;
    const Force moved = tree.inertia * joint.S;  // its linear part is mass times the motion of the centre of mass
    const Force changed = Cross(joint.S, tree.momentum) + tree.inertia * joint.S_rate;
    result.by_v.col(column).head<3>() += moved.linear;
    result.by_v.col(column).tail<3>() += moved.angular - p_OC.cross(moved.linear);
    result.by_q.col(column).head<3>() += changed.linear;
    result.by_q.col(column).tail<3>() +=
        changed.angular - p_OC.cross(changed.linear) - moved.linear.cross(linear) / mass;
  }
  // A rotation of the robot alone equals a rotation of robot and velocities, and the inverse rotation of the base
  // velocity.
  for (int k = 0; k < 3; ++k) {
    const Vector3 e = Vector3::Unit(k);
    auto column = result.by_q.col(3 + k);
    column.noalias() = -result.by_v.middleCols<3>(3) * e.cross(w);
    column.head<3>() += e.cross(linear);
    column.tail<3>() += e.cross(result.momentum.tail<3>());
  }
}

}  // namespace gaitwright
