// SPDX-License-Identifier: BSD-3-Clause
#include "playback/bullet/bullet_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/actuator.h"
#include "kinematics/model/check_state.h"
#include "planning/plan/sole_support.h"
#include "playback/bullet/condensed_solver_internal.h"
#include "playback/bullet/contact_reader_internal.h"
#include "playback/bullet/ground_internal.h"
#include "playback/bullet/joint_rows_internal.h"
#include "playback/bullet/robot_body_internal.h"
#include "playback/bullet/shared_motors_internal.h"
#include "playback/engine/drive_internal.h"
#include "playback/engine/motor_setup_internal.h"

namespace gaitwright {
namespace {

WorldOptions Checked(const RobotModel& model, const VectorX& q, const WorldOptions& options) {
  CheckWorld(model, q, options);
  return options;
}

bullet::BodyOptions BodyOptionsOf(const WorldOptions& options, const VectorX& q, const bullet::Ground& ground) {
  const bool by_ground = options.sole_contact == "auto";
  bullet::BodyOptions body{.mass_scale = options.mass_scale,
                           .inertia_scale = options.inertia_scale,
                           .base_com_shift_B = {options.com_shift_x_m, options.com_shift_y_m, options.com_shift_z_m},
                           .locked_dofs = options.locked_dofs,
                           .q0 = q};
  body.sole_plates = options.sole_contact == "plate" || (by_ground && ground.has_edges());
  if (by_ground) body.sole_spacing_m = kSoleSampling * ground.finest_m();
  return body;
}

}  // namespace

struct BulletWorld::Impl {
  Impl(const RobotModel& robot, const Terrain& terrain, const VectorX& q0, const WorldOptions& wanted, bool condenses)
      : model(robot),
        options(Checked(robot, q0, wanted)),
        ground(terrain, options, BumpsOf(robot, q0, options)),
        body(robot, BodyOptionsOf(options, q0, ground)),
        dispatcher(&configuration),
        solver(condenses ? std::make_unique<bullet::CondensedSolver>(body.inertia())
                         : std::make_unique<btMultiBodyConstraintSolver>()),
        world(&dispatcher, &broadphase, solver.get(), &configuration),
        reader(robot, body, terrain),
        before(robot),
        after(robot) {
    SetUpSolver();
    ground.AddTo(world);
    body.AddTo(world);
    AddMotors();
    tau = VectorX::Zero(model.num_dofs());
    feed_forward = tau;
    effort_use = motor_torque = tau;
    Refresh();
  }

  ~Impl() {
    for (auto& motor : motors) {
      if (motor) world.removeMultiBodyConstraint(motor.get());
    }
    for (auto& motors_of_one : shared) {
      for (auto& row : motors_of_one->rows()) world.removeMultiBodyConstraint(row.get());
    }
    for (auto& gear : gears) world.removeMultiBodyConstraint(gear.get());
    world.removeMultiBody(&body.multibody());
    for (int i = world.getNumCollisionObjects() - 1; i >= 0; --i) {
      world.removeCollisionObject(world.getCollisionObjectArray()[i]);
    }
  }

  void SetUpSolver() {
    world.setGravity(btVector3(0.0, 0.0, -kGravity));
    btContactSolverInfo& info = world.getSolverInfo();
    info.m_numIterations = options.solver_iterations;
    info.m_globalCfm = options.contact_cfm * options.contact_softness;
    info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;  // friction is then a cone
  }

  void AddMotors() {
    for (int dof = 0; dof < model.num_dofs(); ++dof) {
      motors.push_back(nullptr);
      const Actuator actuator = ActuatorOf(model, dof);
      drives.push_back(engine::DriveOf(actuator, options));
      bounds.push_back(engine::BoundOf(model, actuator));
      if (body.locked(dof)) continue;
      motors.back() = std::make_unique<bullet::MotorRow>(body, dof, engine::TraitsOf(model, options, dof));
      world.addMultiBodyConstraint(motors.back().get());
    }
    for (const Transmission& transmission : model.transmissions) AddShared(transmission);
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      const Joint& joint = model.joints[i];
      if (!joint.is_mimic || body.locked(joint.dof)) continue;
      const int leader = model.dof_joint[static_cast<std::size_t>(joint.dof)];
      gears.push_back(std::make_unique<bullet::GearRow>(body, joint, static_cast<int>(i), leader));
      world.addMultiBodyConstraint(gears.back().get());
    }
  }

  void AddShared(const Transmission& transmission) {
    std::vector<bullet::MotorRow*> joints;
    for (const int dof : transmission.dofs) joints.push_back(motors[static_cast<std::size_t>(dof)].get());
    if (std::none_of(joints.begin(), joints.end(), [](const auto* joint) { return joint != nullptr; })) return;
    shared.push_back(
        std::make_unique<bullet::SharedMotors>(body, transmission, joints, bullet::TraitsOf(transmission, options)));
    for (auto& row : shared.back()->rows()) world.addMultiBodyConstraint(row.get());
  }

  /// Copies Bullet's state into ours and updates the kinematics.
  void Refresh() {
    body.GetState(q, v);
    ForwardKinematics(model, q, after);
  }

  /// Target of a motor's row. With explicit torques the row does nothing and the feed-forward holds the whole torque.
  bullet::MotorRow::Target TargetOf(const JointCommand& command, int dof, const engine::EffortRange& limits) {
    const double kp = command.stiffness[dof], kd = command.damping[dof], torque = command.tau_ff[dof];
    const double wanted = torque + (kp * (command.q[dof] - q[7 + dof]) + kd * (command.v[dof] - v[6 + dof]));
    const bool has_row = options.actuation != "torque" && (kp > 0.0 || kd > 0.0);  // the row limits the sum
    const double inside = std::clamp(torque, limits.lowest, limits.highest);
    if (has_row) return {command.q[dof], command.v[dof], inside, kp, kd, torque - inside, wanted, limits};
    return {0.0, 0.0, std::clamp(wanted, limits.lowest, limits.highest), 0.0, 0.0, 0.0, wanted, limits};
  }

  /// Range of effort of a motor at a speed.
  engine::EffortRange RangeOf(int index, double speed) const {
    const auto d = static_cast<std::size_t>(index);
    const engine::EffortRange range = drives[d].At(speed);
    return {std::max(range.lowest, -bounds[d]), std::min(range.highest, bounds[d])};
  }

  void CommandShared(const JointCommand& command, bullet::SharedMotors& motors_of_one) {
    const Transmission& t = motors_of_one.transmission();
    const VectorX speeds = motors_of_one.Speeds();
    std::vector<engine::EffortRange> limits;
    for (Eigen::Index m = 0; m < t.size(); ++m)
      limits.push_back(RangeOf(t.dofs[static_cast<std::size_t>(m)], speeds[m]));
    const VectorX torques = motors_of_one.SetTarget(
        {t.Own(command.q), t.Own(command.v), t.Own(command.tau_ff), t.Own(command.stiffness), t.Own(command.damping)},
        limits);
    t.Put(options.torque_scale * torques, feed_forward);
  }

  void Command(const JointCommand& command) {
    for (const auto& motors_of_one : shared) CommandShared(command, *motors_of_one);
    for (int dof = 0; dof < model.num_dofs(); ++dof) {
      const auto d = static_cast<std::size_t>(dof);
      if (!motors[d] || model.TransmissionOf(dof) != nullptr) continue;
      const auto target = TargetOf(command, dof, RangeOf(dof, v[6 + dof]));
      motors[d]->SetTarget(target);
      feed_forward[dof] = options.torque_scale * target.tau_ff;
    }
    body.AddTorque(feed_forward);
  }

  /// Records the torque that a motor gave.
  void ReadMotor(int index, double torque, double wanted, const engine::EffortRange& limits) {
    const auto i = static_cast<std::size_t>(index);
    motor_torque[index] = torque;
    effort_use[index] = engine::ShareOfLimit(torque, wanted, limits, bounds[i]);
    drives[i].Warm(torque, options.step_s);
  }

  void ReadTorques() {
    for (int dof = 0; dof < model.num_dofs(); ++dof) {
      bullet::MotorRow* motor = motors[static_cast<std::size_t>(dof)].get();
      if (motor == nullptr || model.TransmissionOf(dof) != nullptr) continue;
      tau[dof] = motor->Torque(options.step_s);
      ReadMotor(dof, tau[dof], motor->target().wanted, motor->target().limits);
    }
    for (const auto& motors_of_one : shared) {
      const Transmission& t = motors_of_one->transmission();
      const VectorX torques = motors_of_one->Torques();
      t.Put(motors_of_one->JointTorques(torques), tau);
      for (Eigen::Index m = 0; m < t.size(); ++m) {
        const auto place = static_cast<std::size_t>(m);
        ReadMotor(t.dofs[place], torques[m], motors_of_one->wanted()[m], motors_of_one->limits()[place]);
      }
    }
  }

  /// Deepest contact along the normal of the ground. Clears the contacts, so that the next step finds its own.
  Penetration Deepest() {
    world.performDiscreteCollisionDetection();
    Penetration deepest;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
      for (int k = 0; k < manifold.getNumContacts(); ++k) {
        if (-manifold.getContactPoint(k).getDistance() > deepest.depth_m) deepest = PenetrationAt(manifold, k);
      }
      manifold.clearManifold();
    }
    return deepest;
  }

  Penetration PenetrationAt(const btPersistentManifold& manifold, int index) const {
    const btManifoldPoint& contact = manifold.getContactPoint(index);
    const auto* first = btMultiBodyLinkCollider::upcast(manifold.getBody0());
    const auto* robot = first != nullptr ? first : btMultiBodyLinkCollider::upcast(manifold.getBody1());
    const bullet::ColliderPart& part =
        body.part(robot->m_link + 1, first != nullptr ? contact.m_index0 : contact.m_index1);
    return {-contact.getDistance(), part.link,
            ground.NameOf(first != nullptr ? manifold.getBody1() : manifold.getBody0())};
  }

  const RobotModel& model;
  WorldOptions options;
  bullet::Ground ground;
  bullet::RobotBody body;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  std::unique_ptr<btMultiBodyConstraintSolver> solver;
  btMultiBodyDynamicsWorld world;
  std::vector<std::unique_ptr<bullet::MotorRow>> motors;      ///< by dof; null where locked
  std::vector<std::unique_ptr<bullet::SharedMotors>> shared;  ///< of transmissions that have an unlocked joint
  std::vector<engine::Drive> drives;                          ///< by motor (ActuatorOf)
  std::vector<double> bounds;                                 ///< by motor; see BoundOf
  std::vector<std::unique_ptr<bullet::GearRow>> gears;
  bullet::ContactReader reader;
  DynamicsScratch before, after;
  VectorX q, v, tau, motor_torque, feed_forward, effort_use;
};

BulletWorld::BulletWorld(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options,
                         bool condenses)
    : impl_(std::make_unique<Impl>(model, terrain, q, options, condenses)) {}
BulletWorld::~BulletWorld() = default;
void BulletWorld::SetState(const VectorX& q, const VectorX& v) {
  CheckState(impl_->model, q, v);
  impl_->body.SetState(q, v);
  impl_->Refresh();
}

const VectorX& BulletWorld::q() const { return impl_->q; }
const VectorX& BulletWorld::v() const { return impl_->v; }
const VectorX& BulletWorld::tau() const { return impl_->tau; }
const VectorX& BulletWorld::motor_torque() const { return impl_->motor_torque; }
const VectorX& BulletWorld::effort_use() const { return impl_->effort_use; }
VectorX BulletWorld::mean_square_effort() const {
  VectorX squares(impl_->model.num_dofs());
  for (Eigen::Index dof = 0; dof < squares.size(); ++dof) {
    squares[dof] = impl_->drives[static_cast<std::size_t>(dof)].mean_square();
  }
  return squares;
}

const std::vector<FootContact>& BulletWorld::feet() const { return impl_->reader.feet(); }
const std::vector<std::string>& BulletWorld::body_contacts() const { return impl_->reader.body_contacts(); }

void BulletWorld::PushAt(int body, const Vector3& force_W, const Vector3& p_W) {
  const auto b = static_cast<std::size_t>(body);
  const Vector3 p_WM = impl_->after.p_WB[b] + impl_->after.R_WB[b] * impl_->body.X_BM(body).translation();
  const btVector3 moment = bullet::ToBullet(Vector3((p_W - p_WM).cross(force_W)));
  PushBody(body, force_W);
  btMultiBody& robot = impl_->body.multibody();
  body == 0 ? robot.addBaseTorque(moment) : robot.addLinkTorque(body - 1, moment);
}

void BulletWorld::PushRobot(const Vector3& force_W) {
  const Body& base = impl_->model.bodies[0];
  const Vector3 shift_W = impl_->after.R_WB[0] * (impl_->body.X_BM(0).translation() - base.p_BC);
  Push(force_W, CentreOfMass(impl_->model, impl_->after) + base.mass / impl_->model.total_mass_kg * shift_W);
}

void BulletWorld::PushBody(int body, const Vector3& force_W) {
  if (body == 0) return impl_->body.multibody().addBaseForce(bullet::ToBullet(force_W));
  impl_->body.multibody().addLinkForce(body - 1, bullet::ToBullet(force_W));
}

Penetration BulletWorld::DeepestPenetration() { return impl_->Deepest(); }

double BulletWorld::LiftOutOfGround(const VectorX& as_planned) {
  constexpr double kDeepest = 1e-5;  // [m]
  constexpr int kMostLifts = 20;
  const double before = impl_->q.z();
  VectorX q = impl_->q;
  q.z() += HighestDrop(impl_->model, as_planned, q);
  for (int i = 0; i < kMostLifts; ++i) {
    SetState(q, impl_->v);
    const double depth = impl_->Deepest().depth_m;
    if (depth <= kDeepest) break;
    q.z() += depth;
  }
  return impl_->q.z() - before;
}

void BulletWorld::Step(const JointCommand& command) {
  Impl& self = *impl_;
  CheckCommand(command, self.model.num_dofs());
  self.Command(command);
  self.world.stepSimulation(self.options.step_s, 0);
  std::swap(self.before, self.after);
  self.Refresh();
  self.ReadTorques();
  self.reader.Read(self.dispatcher, self.options.step_s, self.before, self.after);
}

VectorX BulletWorld::Accelerations(const VectorX& q, const VectorX& v, const VectorX& tau) {
  VectorX a = impl_->body.Accelerations(q, v, tau);
  impl_->Refresh();
  return a;
}

double BulletWorld::total_mass_kg() const {
  const btMultiBody& body = impl_->body.multibody();
  double mass = body.getBaseMass();
  for (int i = 0; i < body.getNumLinks(); ++i) mass += body.getLinkMass(i);
  return mass;
}

double BulletWorld::gear_error() const {
  double error = 0.0;
  for (const auto& gear : impl_->gears) error = std::max(error, std::abs(gear->Error()));
  return error;
}

}  // namespace gaitwright
