// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/model/actuator.h"
#include "playback/mujoco/motors_internal.h"

namespace gaitwright::mujoco {
namespace {

constexpr double kSlight = 1e-9;  // share of a torque below which it is rounding
constexpr double kNone = 1e-12;   // [rad], [m]: rounding

/// Number of joints that share a coordinate's torque.
double CountOf(const std::vector<Member>& members) {
  return static_cast<double>(
      std::count_if(members.begin(), members.end(), [](const Member& m) { return m.multiplier != 0.0; }));
}

}  // namespace

Motors::Motors(const RobotModel& model, const WorldOptions& options, mjModel& m, mjData& d)
    : model_(model), options_(options), m_(m), d_(d), members_(model.dof_names.size()) {
  const int n = model.num_dofs();
  tau_ = motor_torque_ = effort_use_ = VectorX::Zero(n);
  v_ = VectorX::Zero(model.nv());
  bare_inertia_ = Eigen::Map<const VectorX>(m.dof_invweight0, m.nv).cwiseMax(mjMINVAL).cwiseInverse();
  const std::vector<int>& locked = options.locked_dofs;
  for (const Joint& joint : model.joints) {
    if (std::find(locked.begin(), locked.end(), joint.dof) != locked.end()) continue;
    const int id = IdOf(m, mjOBJ_JOINT, joint.name);
    members_[static_cast<std::size_t>(joint.dof)].push_back(
        {m.jnt_qposadr[id], m.jnt_dofadr[id], joint.multiplier, joint.offset, 0.0});
  }
  for (std::vector<Member>& group : members_) {
    const double count = CountOf(group);
    for (Member& member : group) member.share = member.multiplier != 0.0 ? 1.0 / (count * member.multiplier) : 0.0;
  }
  for (int dof = 0; dof < n; ++dof) {
    const Actuator actuator = ActuatorOf(model, dof);
    drives_.push_back(engine::DriveOf(actuator, options));
    bounds_.push_back(engine::BoundOf(model, actuator));
    traits_.push_back(engine::TraitsOf(model, options, dof));
    motors_.emplace_back();
    stops_.emplace_back();
    SetUpJoint(dof);
  }
}

/// Sets the dry friction of the leading joint of a coordinate.
void Motors::SetUpJoint(int dof) {
  const auto i = static_cast<std::size_t>(dof);
  if (members_[i].empty()) return;
  const int id = IdOfLeader(dof);
  m_.dof_frictionloss[m_.jnt_dofadr[id]] = traits_[i].friction;
  m_.dof_solref[mjNREF * m_.jnt_dofadr[id]] = 2.0 * options_.step_s;
  m_.dof_solimp[mjNIMP * m_.jnt_dofadr[id]] = m_.dof_solimp[mjNIMP * m_.jnt_dofadr[id] + 1] = 0.9999;
}

double Motors::RateOf(int dof, const mjtNum* rates) const {
  double rate = 0.0;
  for (const Member& member : members_[static_cast<std::size_t>(dof)]) rate += member.share * rates[member.dof];
  return rate;
}

/// The inertia of a stop. It is so large that the motor's greatest torque moves the joint by kMostYield in a step, and
/// that the other bodies that move with the joint hardly move it.
double Motors::StopInertia(int dof) const {
  constexpr double kMostYield = 1e-6, kRatio = 1e3;  // [rad] or [m]; of the joint's own inertia
  constexpr double kMostEffort = 1e4;                // [N m], [N]: of motors without a limit
  const auto i = static_cast<std::size_t>(dof);
  const double effort = std::min(bounds_[i], kMostEffort), h = options_.step_s;
  return std::max(effort * h * h / kMostYield, kRatio * bare_inertia_[members_[i].front().dof]);
}

bool Motors::HoldStops() {
  constexpr double kReturn = 0.2;
  const double h = options_.step_s;
  bool good = true;
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    const auto i = static_cast<std::size_t>(dof);
    if (members_[i].empty() || stops_[i]) continue;
    const double position = q_[7 + dof], lower = traits_[i].lower, upper = traits_[i].upper;
    const double next = position + h * (v_[6 + dof] + h * RateOf(dof, d_.qacc));
    const double highest = position > upper ? position + kReturn * (upper - position) : upper;
    const double lowest = position < lower ? position + kReturn * (lower - position) : lower;
    if (next <= highest + kNone && next >= lowest - kNone) continue;
    stops_[i] = (std::clamp(next, lowest, highest) - position) / h;
    good = false;
  }
  return good;
}

int Motors::IdOfLeader(int dof) const { return IdOf(m_, mjOBJ_JOINT, model_.dof_names[static_cast<std::size_t>(dof)]); }

engine::EffortRange Motors::RangeOf(int dof, double speed) const {
  const auto i = static_cast<std::size_t>(dof);
  const engine::EffortRange range = drives_[i].At(speed);
  return {std::max(range.lowest, -bounds_[i]), std::min(range.highest, bounds_[i])};
}

void Motors::Command(const JointCommand& command, const VectorX& q, const VectorX& v) {
  q_ = q;
  v_ = v;
  std::fill(stops_.begin(), stops_.end(), std::nullopt);
  const double h = options_.step_s;
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    Motor& motor = motors_[static_cast<std::size_t>(dof)];
    const double kp = command.stiffness[dof], kd = command.damping[dof], rate = v_[6 + dof];
    const double at_rest = command.tau_ff[dof] + kp * (command.q[dof] - q[7 + dof]) + kd * command.v[dof];
    motor.limits = RangeOf(dof, rate);
    motor.wanted = at_rest - kd * rate;
    motor.at_rest = at_rest;
    motor.by_speed = kd + h * kp;
    motor.held = !IsImplicit(motor);
    motor.constant = std::clamp(motor.wanted, motor.limits.lowest, motor.limits.highest);
  }
}

/// Writes armatures and constant torques for the current state of the motors. A stop is a damper, implicit in the step,
/// so that the joint ends the step at the rate that the stop allows. The softness of a joint's dry friction is a share
/// of its inverse inertia in `dof_invweight0`, which must therefore include the armature.
void Motors::Apply() {
  const double h = options_.step_s, scale = options_.torque_scale;
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    const auto i = static_cast<std::size_t>(dof);
    const Motor& motor = motors_[i];
    const double stop = stops_[i] ? StopInertia(dof) / h : 0.0;
    const double by_speed = (motor.held ? 0.0 : scale * motor.by_speed) + traits_[i].damping + stop;
    const double at_rest = scale * (motor.held ? motor.constant : motor.at_rest) + stop * stops_[i].value_or(0.0);
    const double rate = v_[6 + dof];
    for (const Member& member : members_[i]) {
      if (member.multiplier == 0.0) continue;
      double& armature = m_.dof_armature[member.dof];
      armature = (traits_[i].rotor_inertia + h * by_speed) * member.share / member.multiplier;
      m_.dof_invweight0[member.dof] = 1.0 / (bare_inertia_[member.dof] + armature);
      d_.qfrc_applied[member.dof] = member.share * (at_rest - by_speed * rate);
    }
  }
}

/// Torque of a joint's motor at the end of the step, without limits, for the computed acceleration.
double Motors::WantedAtEnd(int dof) const {
  const Motor& motor = motors_[static_cast<std::size_t>(dof)];
  if (!IsImplicit(motor)) return motor.wanted;
  return motor.at_rest - motor.by_speed * (v_[6 + dof] + options_.step_s * RateOf(dof, d_.qacc));
}

/// Checks the motors of a transmission against their limits. If one exceeds its limit, all its joints get constant
/// torques.
bool Motors::HoldShared(const Transmission& transmission) {
  const Eigen::Index n = transmission.size();
  VectorX wanted(n);
  for (Eigen::Index i = 0; i < n; ++i) wanted[i] = WantedAtEnd(transmission.dofs[static_cast<std::size_t>(i)]);
  const VectorX efforts = transmission.inverse.transpose() * wanted;
  const VectorX speeds = transmission.MotorSpeeds(v_.tail(model_.num_dofs()));
  VectorX within = efforts;
  for (Eigen::Index k = 0; k < n; ++k) {
    Motor& motor = motors_[static_cast<std::size_t>(transmission.dofs[static_cast<std::size_t>(k)])];
    motor.limits = RangeOf(transmission.dofs[static_cast<std::size_t>(k)], speeds[k]);
    within[k] = std::clamp(efforts[k], motor.limits.lowest, motor.limits.highest);
  }
  const bool explicit_torques = options_.actuation == "torque";
  const bool out = explicit_torques || (within - efforts).cwiseAbs().maxCoeff() > kSlight * (1.0 + efforts.norm());
  const VectorX torques = transmission.ratios.transpose() * within;
  bool good = true;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto dof = static_cast<std::size_t>(transmission.dofs[static_cast<std::size_t>(i)]);
    Motor& motor = motors_[dof];
    good = good && motor.held == out &&
           (!out || std::abs(motor.constant - torques[i]) <= kSlight * (1.0 + std::abs(torques[i])));
    motor.held = out;
    motor.constant = torques[i];
    motor_torque_[static_cast<Eigen::Index>(dof)] = within[i];
  }
  return good;
}

/// Whether all motors are within their limits for the computed acceleration; changes the motors that are not.
bool Motors::Hold() {
  bool all = true;
  for (const Transmission& transmission : model_.transmissions) all = HoldShared(transmission) && all;
  return HoldOwn() && all;
}

bool Motors::HoldOwn() {
  bool good = true;
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    Motor& motor = motors_[static_cast<std::size_t>(dof)];
    if (!IsImplicit(motor) || model_.TransmissionOf(dof) != nullptr) continue;
    const double torque = WantedAtEnd(dof);
    const double within = std::clamp(torque, motor.limits.lowest, motor.limits.highest);
    const double slight = kSlight * (1.0 + std::abs(torque));
    const bool out = std::abs(torque - within) > slight;
    if (out != motor.held || (out && motor.constant != within)) good = false;
    motor.held = out;
    motor.constant = within;
  }
  return good;
}

/// Rotors that several joints turn couple these joints: R^T diag(J) R in the mass matrix. MuJoCo stores only entries of
/// joints of one chain, such as those of an ankle.
void Motors::AddSharedRotors(const Transmission& transmission) {
  MatrixX rotors = MatrixX::Zero(transmission.size(), transmission.size());
  for (Eigen::Index k = 0; k < transmission.size(); ++k) {
    const double own = transmission.motors[static_cast<std::size_t>(k)].motor.rotor_inertia;
    const double inertia = options_.rotor_inertia_kg_m2 + (options_.joint_losses ? own : 0.0);
    rotors += inertia * transmission.ratios.row(k).transpose() * transmission.ratios.row(k);
  }
  for (Eigen::Index i = 0; i < transmission.size(); ++i) {
    for (Eigen::Index j = 0; j < transmission.size(); ++j) {
      const auto& first = members_[static_cast<std::size_t>(transmission.dofs[static_cast<std::size_t>(i)])];
      const auto& second = members_[static_cast<std::size_t>(transmission.dofs[static_cast<std::size_t>(j)])];
      if (first.empty() || second.empty()) continue;
      int address = m_.dof_Madr[first.front().dof], at = first.front().dof;
      while (at >= 0 && at != second.front().dof) {
        at = m_.dof_parentid[at];
        ++address;
      }
      if (at >= 0) d_.qM[address] += rotors(i, j);
    }
  }
}

void Motors::Read(const VectorX& v) {
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    const auto i = static_cast<std::size_t>(dof);
    if (members_[i].empty()) continue;
    const Motor& motor = motors_[i];
    tau_[dof] = motor.held ? motor.constant : motor.at_rest - motor.by_speed * v[6 + dof];
    if (model_.TransmissionOf(dof) == nullptr) motor_torque_[dof] = tau_[dof];
    const double torque = motor_torque_[dof];
    effort_use_[dof] = engine::ShareOfLimit(torque, motor.wanted, motor.limits, bounds_[i]);
    drives_[i].Warm(torque, options_.step_s);
  }
}

void Motors::AddSharedRotors() {
  for (const Transmission& transmission : model_.transmissions) AddSharedRotors(transmission);
}

VectorX Motors::mean_square_effort() const {
  VectorX squares(model_.num_dofs());
  for (Eigen::Index dof = 0; dof < squares.size(); ++dof)
    squares[dof] = drives_[static_cast<std::size_t>(dof)].mean_square();
  return squares;
}

}  // namespace gaitwright::mujoco
