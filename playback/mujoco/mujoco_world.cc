// SPDX-License-Identifier: BSD-3-Clause
#include "playback/mujoco/mujoco_world.h"

#include <algorithm>

#include "kinematics/model/check_state.h"
#include "playback/mujoco/contacts_internal.h"
#include "playback/mujoco/motors_internal.h"

namespace gaitwright {
namespace {

using mujoco::AsVector;

WorldOptions Checked(const RobotModel& model, const VectorX& q, const WorldOptions& options) {
  CheckWorld(model, q, options);
  return options;
}

}  // namespace

struct MujocoWorld::Impl {
  Impl(const RobotModel& robot, const Terrain& ground, const VectorX& q0, const WorldOptions& wanted)
      : model(robot),
        terrain(ground),
        options(Checked(robot, q0, wanted)),
        text(mujoco::WriteModel(robot, ground, q0, options)),
        m(mujoco::Compile(text)),
        d(mj_makeData(m.get())),
        motors(robot, options, *m, *d),
        contacts(robot, terrain, text, *m, *d),
        before(robot),
        after(robot),
        q(q0),
        v(VectorX::Zero(robot.nv())) {
    for (const Body& body : model.bodies) body_id.push_back(mujoco::IdOf(*m, mjOBJ_BODY, body.name));
    Put(q0, v);
    Refresh();
  }

  void Put(const VectorX& to_q, const VectorX& to_v) {
    const Quaternion rotation = Quaternion(to_q[6], to_q[3], to_q[4], to_q[5]).normalized();
    mju_copy(d->qpos, to_q.data(), 3);
    d->qpos[3] = rotation.w();
    d->qpos[4] = rotation.x();
    d->qpos[5] = rotation.y();
    d->qpos[6] = rotation.z();
    const Vector3 w_B = rotation.toRotationMatrix().transpose() * to_v.segment<3>(3);
    mju_copy(d->qvel, to_v.data(), 3);
    mju_copy(d->qvel + 3, w_B.data(), 3);
    for (int dof = 0; dof < model.num_dofs(); ++dof) {
      for (const mujoco::Member& member : motors.members(dof)) {
        d->qpos[member.qpos] = member.multiplier * to_q[7 + dof] + member.offset;
        d->qvel[member.dof] = member.multiplier * to_v[6 + dof];
      }
    }
  }

  void Refresh() {
    const Quaternion rotation = Quaternion(d->qpos[3], d->qpos[4], d->qpos[5], d->qpos[6]).normalized();
    q.head<3>() = AsVector(d->qpos);
    q.segment<4>(3) = rotation.coeffs();
    v.head<3>() = AsVector(d->qvel);
    v.segment<3>(3) = rotation * AsVector(d->qvel + 3);
    for (int dof = 0; dof < model.num_dofs(); ++dof) {
      if (motors.locked(dof)) continue;
      double position = 0.0;
      for (const mujoco::Member& member : motors.members(dof))
        position += member.share * (d->qpos[member.qpos] - member.offset);
      q[7 + dof] = position;
      v[6 + dof] = motors.RateOf(dof, d->qvel);
    }
    ForwardKinematics(model, q, after);
  }

  void Solve(bool first) {
    mjModel* model_of = m.get();
    mjData* data = d.get();
    if (first) {
      mj_kinematics(model_of, data);
      mj_comPos(model_of, data);
    }
    mj_crb(model_of, data);
    motors.AddSharedRotors();
    mj_factorM(model_of, data);
    if (first) {
      mj_collision(model_of, data);
      mj_makeConstraint(model_of, data);
    }
    mj_projectConstraint(model_of, data);
    if (first) mj_fwdVelocity(model_of, data);
    mj_fwdActuation(model_of, data);
    mj_fwdAcceleration(model_of, data);
    mj_fwdConstraint(model_of, data);
  }

  /// Deepest contact along the normal of the ground.
  Penetration Deepest() {
    mj_kinematics(m.get(), d.get());
    mj_comPos(m.get(), d.get());
    mj_collision(m.get(), d.get());
    int deepest = -1;
    for (int c = 0; c < d->ncon; ++c) {
      if (d->contact[c].dist < (deepest < 0 ? 0.0 : d->contact[deepest].dist)) deepest = c;
    }
    return deepest < 0 ? Penetration{} : contacts.PenetrationOf(d->contact[deepest]);
  }

  const RobotModel& model;
  const Terrain terrain;
  const WorldOptions options;
  const mujoco::ModelText text;
  mujoco::ModelPtr m;
  mujoco::DataPtr d;
  mujoco::Motors motors;
  mujoco::Contacts contacts;
  DynamicsScratch before, after;
  VectorX q, v;
  std::vector<int> body_id;
};

MujocoWorld::MujocoWorld(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options)
    : impl_(std::make_unique<Impl>(model, terrain, q, options)) {}
MujocoWorld::~MujocoWorld() = default;

void MujocoWorld::SetState(const VectorX& q, const VectorX& v) {
  CheckState(impl_->model, q, v);
  impl_->Put(q, v);
  mju_zero(impl_->d->qacc_warmstart, impl_->m->nv);
  impl_->Refresh();
}

const VectorX& MujocoWorld::q() const { return impl_->q; }
const VectorX& MujocoWorld::v() const { return impl_->v; }
const VectorX& MujocoWorld::tau() const { return impl_->motors.tau(); }
const VectorX& MujocoWorld::motor_torque() const { return impl_->motors.motor_torque(); }
const VectorX& MujocoWorld::effort_use() const { return impl_->motors.effort_use(); }
const std::vector<FootContact>& MujocoWorld::feet() const { return impl_->contacts.feet(); }
const std::vector<std::string>& MujocoWorld::body_contacts() const { return impl_->contacts.body_contacts(); }
const std::string& MujocoWorld::mjcf() const { return impl_->text.mjcf; }

double MujocoWorld::total_mass_kg() const {
  double mass = 0.0;
  for (int b = 0; b < impl_->m->nbody; ++b) mass += impl_->m->body_mass[b];
  return mass;
}

VectorX MujocoWorld::mean_square_effort() const { return impl_->motors.mean_square_effort(); }

void MujocoWorld::PushBody(int body, const Vector3& force_W) {
  Impl& self = *impl_;
  const int id = self.body_id[static_cast<std::size_t>(body)];
  for (int k = 0; k < 3; ++k) self.d->xfrc_applied[6 * id + k] += force_W[k];
}

void MujocoWorld::PushRobot(const Vector3& force_W) {
  Impl& self = *impl_;
  Vector3 sum = Vector3::Zero();
  double mass = 0.0;
  for (std::size_t b = 0; b < self.body_id.size(); ++b) {
    const double of_body = self.m->body_mass[self.body_id[b]];
    sum += of_body * (self.after.p_WB[b] + self.after.R_WB[b] * AsVector(self.m->body_ipos + 3 * self.body_id[b]));
    mass += of_body;
  }
  PushAt(0, force_W, sum / mass);
}

Penetration MujocoWorld::DeepestPenetration() { return impl_->Deepest(); }

double MujocoWorld::LiftOutOfGround(const VectorX& as_planned) {
  constexpr double kDeepest = 1e-5;  // [m]
  constexpr int kMostLifts = 20;
  Impl& self = *impl_;
  const double before = self.q.z();
  VectorX q = self.q;
  q.z() += HighestDrop(self.model, as_planned, q);
  for (int i = 0; i < kMostLifts; ++i) {
    SetState(q, self.v);
    const double depth = self.Deepest().depth_m;
    if (depth <= kDeepest) break;
    q.z() += depth;
  }
  return self.q.z() - before;
}

void MujocoWorld::PushAt(int body, const Vector3& force_W, const Vector3& p_W) {
  Impl& self = *impl_;
  const int id = self.body_id[static_cast<std::size_t>(body)];
  const auto b = static_cast<std::size_t>(body);
  const Vector3 p_WM = self.after.p_WB[b] + self.after.R_WB[b] * AsVector(self.m->body_ipos + 3 * id);
  const Vector3 moment = (p_W - p_WM).cross(force_W);
  for (int k = 0; k < 3; ++k) {
    self.d->xfrc_applied[6 * id + k] += force_W[k];
    self.d->xfrc_applied[6 * id + 3 + k] += moment[k];
  }
}

void MujocoWorld::Step(const JointCommand& command) {
  constexpr int kMostSolves = 12;
  Impl& self = *impl_;
  CheckCommand(command, self.model.num_dofs());
  self.motors.Command(command, self.q, self.v);
  for (int i = 0; i < kMostSolves; ++i) {
    self.motors.Apply();
    self.Solve(i == 0);
    const bool held = self.motors.Hold();
    if (self.motors.HoldStops() && held) break;
  }
  mj_Euler(self.m.get(), self.d.get());
  mju_zero(self.d->xfrc_applied, 6 * self.m->nbody);
  std::swap(self.before, self.after);
  self.Refresh();
  self.motors.Read(self.v);
  self.contacts.Read(self.options.step_s, self.before, self.after);
}

MatrixX MujocoWorld::MassMatrix(const VectorX& q) {
  Impl& self = *impl_;
  self.Put(q, VectorX::Zero(self.model.nv()));
  mju_zero(self.m->dof_armature, self.m->nv);
  mj_kinematics(self.m.get(), self.d.get());
  mj_comPos(self.m.get(), self.d.get());
  mj_crb(self.m.get(), self.d.get());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> M(self.m->nv, self.m->nv);
  mj_fullM(self.m.get(), M.data(), self.d->qM);
  // Converts the base's angular velocity from base to world axes.
  MatrixX T = MatrixX::Identity(self.m->nv, self.m->nv);
  T.block<3, 3>(3, 3) = BaseRotation(q).transpose();
  return T.transpose() * M * T;
}

VectorX MujocoWorld::BiasForces(const VectorX& q, const VectorX& v) {
  Impl& self = *impl_;
  self.Put(q, v);
  mj_kinematics(self.m.get(), self.d.get());
  mj_comPos(self.m.get(), self.d.get());
  mj_comVel(self.m.get(), self.d.get());
  VectorX bias(self.m->nv);
  mj_rne(self.m.get(), self.d.get(), 0, bias.data());
  bias.segment<3>(3) = BaseRotation(q) * bias.segment<3>(3).eval();
  return bias;
}

}  // namespace gaitwright
