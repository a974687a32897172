// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/leg_motors.h"

#include <algorithm>
#include <cmath>

#include "kinematics/base/non_finite.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/ik/whole_body_ik.h"
#include "kinematics/model/actuator.h"
#include "kinematics/spatial/dense_solvers.h"

namespace gaitwright {
namespace {

constexpr double kStill = 1e-9;  // speeds and torques below it count as zero

/// The standing posture as a target.
BodyTarget TargetOf(const RobotModel& model, const VectorX& q, DynamicsScratch& scratch) {
  ForwardKinematics(model, q, scratch);
  BodyTarget target;
  target.p_WC = CentreOfMass(model, scratch);
  target.R_WB = BaseRotation(q);
  for (const Foot& foot : model.feet) {
    const Pose X_WF = FramePose(scratch, foot.body, foot.X_BF);
    FootTarget wanted;
    wanted.p_WF = X_WF.translation();
    wanted.R_WF = wanted.R_anchor = X_WF.linear();
    target.feet.push_back(wanted);
  }
  return target;
}

/// Limits of the motors while some feet push the body up.
class PushingLegs {
 public:
  /// @param share  share of the total force that each foot pushes with;  @param use  share of the motors' effort limits
  PushingLegs(const RobotModel& model, double share, double use)
      : model_(model), ik_(model), scratch_(model), share_(share), use_(use) {}

  WholeBodyIk& ik() { return ik_; }
  DynamicsScratch& scratch() { return scratch_; }

  /// Sets the largest upward speed in the posture `at.q`, and the joint that limits it.
  void SetSpeed(BodyTarget target, PushOff& at) {
    VectorX v, a;
    target.v_WC = Vector3::UnitZ();
    ik_.SolveRates(target, at.q, v, a);
    at.speed_m_s = kInfinity;
    at.speed_by_rise.resize(model_.num_dofs());
    for (int d = 0; d < model_.num_dofs(); ++d) {
      const Actuator motor = ActuatorOf(model_, d);
      at.speed_by_rise[d] = motor.Speed(v.tail(model_.num_dofs()));
      const double rate = std::abs(at.speed_by_rise[d]);
      if (rate < kStill || rate * at.speed_m_s <= motor.velocity_limit) continue;
      at.speed_m_s = motor.velocity_limit / rate;
      at.fastest = d;
    }
  }

  /// Sets the largest upward acceleration in the posture `at.q`, and the joint that limits it.
  void SetGain(const BodyTarget& target, PushOff& at) {
    const VectorX held = HoldingTorques(target, at.q, 0.0);
    const VectorX by_gain = HoldingTorques(target, at.q, 1.0) - held;
    at.gain_m_s2 = kInfinity;
    at.effort_at_rest.resize(model_.num_dofs());
    at.effort_by_gain.resize(model_.num_dofs());
    for (int d = 0; d < model_.num_dofs(); ++d) {
      const Actuator motor = ActuatorOf(model_, d);
      at.effort_at_rest[d] = motor.Effort(held);
      at.effort_by_gain[d] = motor.Effort(by_gain);
      const double by = at.effort_by_gain[d], most = use_ * motor.effort_limit;
      if (std::abs(by) < kStill) continue;
      const double gain = ((by > 0.0 ? most : -most) - at.effort_at_rest[d]) / by;
      if (gain >= at.gain_m_s2) continue;
      at.gain_m_s2 = gain;
      at.strongest = d;
    }
  }

 private:
  /// Torques that hold the robot while its centre of mass accelerates upward.
  VectorX HoldingTorques(BodyTarget target, const VectorX& q, double up_m_s2) {
    VectorX v, a, tau;
    target.a_WC = up_m_s2 * Vector3::UnitZ();
    ik_.SolveRates(target, q, v, a);
    InverseDynamics(model_, q, VectorX::Zero(model_.nv()), a, scratch_, tau);
    const double force = share_ * model_.total_mass_kg * (kGravity + up_m_s2);
    VectorX given = VectorX::Zero(model_.nv());
    for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
      const Foot& foot = model_.feet[static_cast<std::size_t>(f)];
      Vector3 at = ContactFrame(model_, scratch_, f).translation();
      if (foot.has_sole()) at.x() = target.p_WC.x();
      AddPointForce(model_, scratch_, foot.body, at, force * Vector3::UnitZ(), given);
    }
    return (tau - given).tail(model_.num_dofs());
  }

  const RobotModel& model_;
  WholeBodyIk ik_;
  DynamicsScratch scratch_;
  const double share_, use_;
};

bool KeepsLimits(const RobotModel& model, const VectorX& q, double reserve) {
  for (int d = 0; d < model.num_dofs(); ++d) {
    const double lower = model.dof_lower(d), upper = model.dof_upper(d), standing = model.standing_joints[d];
    const double kept = std::isfinite(upper - lower) ? reserve * (upper - lower) : 0.0;
    if (q[7 + d] < std::min(lower + kept, standing) || q[7 + d] > std::max(upper - kept, standing)) return false;
  }
  return true;
}

}  // namespace

std::vector<PushOff> PushOffs(const RobotModel& model, int pushing, double reserve, double use) {
  constexpr double kStep = 0.01;  // share of the leg length
  PushingLegs legs(model, 1.0 / pushing, use);
  const VectorX standing = StandingConfiguration(model);
  const BodyTarget at_standing = TargetOf(model, standing, legs.scratch());
  std::vector<PushOff> above, below;
  for (const double side : {1.0, -1.0}) {
    std::vector<PushOff>& found = side > 0.0 ? above : below;
    VectorX q = standing;
    for (int i = side > 0.0 ? 1 : 0;; ++i) {
      BodyTarget target = at_standing;
      target.p_WC.z() += side * i * kStep * model.leg_length_m();
      if (target.p_WC.z() <= 0.0 || !legs.ik().SolvePosition(target, q) || !KeepsLimits(model, q, reserve)) break;
      PushOff at;
      at.q = q;
      at.com_m = target.p_WC.z();
      legs.SetSpeed(target, at);
      legs.SetGain(target, at);
      found.push_back(at);
    }
  }
  std::reverse(above.begin(), above.end());
  above.insert(above.end(), below.begin(), below.end());
  return above;
}

double GainAtSpeed(const RobotModel& model, const PushOff& at, double rising_m_s, double use) {
  double gain_m_s2 = kInfinity;
  for (int d = 0; d < model.num_dofs(); ++d) {
    const double by = at.effort_by_gain[d];
    if (std::abs(by) < kStill) continue;
    const Actuator motor = ActuatorOf(model, d);
    const double speed = at.speed_by_rise[d] * rising_m_s;
    const bool brakes = by * speed <= 0.0;
    const double most = use * (brakes ? motor.effort_limit : motor.motor.EffortAt(std::abs(speed), motor.effort_limit));
    gain_m_s2 = std::min(gain_m_s2, ((by > 0.0 ? most : -most) - at.effort_at_rest[d]) / by);
  }
  return gain_m_s2;
}

double FootAccelerationInFlight(const RobotModel& model, const std::vector<int>& feet) {
  DynamicsScratch scratch(model);
  WholeBodyIk ik(model);
  const VectorX q = StandingConfiguration(model);
  BodyTarget target = TargetOf(model, q, scratch);
  target.a_WC = -kGravity * Vector3::UnitZ();
  for (FootTarget& foot : target.feet) foot.a_WF = target.a_WC;
  for (const int f : feet) {
    FootTarget& foot = target.feet[static_cast<std::size_t>(f)];
    foot.a_WF += Vector3::UnitZ();
  }
  VectorX v, a, tau;
  const auto needed = [&](const Vector3& turning) {
    target.alpha_WB = turning;
    ik.SolveRates(target, q, v, a);
    InverseDynamics(model, q, VectorX::Zero(model.nv()), a, scratch, tau);
    return Vector3(tau.segment<3>(3));
  };
  // In the air, the body reacts to its legs by rotation.
  const Vector3 held = needed(Vector3::Zero());
  Matrix3 by_turning;
  for (int i = 0; i < 3; ++i) by_turning.col(i) = needed(Vector3::Unit(i)) - held;
  needed(-SolveLeastNorm(by_turning, held));
  double most_m_s2 = kInfinity;
  for (int d = 0; d < model.num_dofs(); ++d) {
    const Actuator motor = ActuatorOf(model, d);
    const double torque = std::abs(motor.Effort(tau.tail(model.num_dofs())));
    if (torque > kStill) most_m_s2 = std::min(most_m_s2, motor.effort_limit / torque);
  }
  return most_m_s2;
}

MotorLimits MotorLimitsOf(const RobotModel& model, const WholeBodyTrajectory& rows, std::size_t row, int foot,
                          DynamicsScratch& scratch) {
  constexpr double kUse = 0.95;  // of what the motors give at most
  const Foot& described = model.feet[static_cast<std::size_t>(foot)];
  ForwardKinematics(model, rows.q[row], scratch);
  const Pose X_WF = ContactFrame(model, scratch, foot);
  const std::vector<Vector3> points = ContactPoints(described, X_WF);
  const Pose X_WB = FramePose(scratch, described.body, Pose::Identity());
  MatrixX by_force(model.num_dofs(), static_cast<Eigen::Index>(3 * points.size()));
  MatrixX J(6, model.nv());
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointJacobian(model, scratch, described.body, X_WB.inverse() * points[i], J);
    by_force.middleCols<3>(static_cast<Eigen::Index>(3 * i)) = J.topRightCorner(3, model.num_dofs()).transpose();
  }
  VectorX given = VectorX::Zero(model.nv());
  const ContactWrench& wrench = rows.wrenches[row][static_cast<std::size_t>(foot)];
  Vector6 w;
  w << wrench.force_W, wrench.moment_W;
  AddPointWrench(model, scratch, described.body, X_WF.translation(), w, given);
  std::vector<Actuator> own;
  std::vector<VectorX> by_force_of;
  for (const Actuator& motor : ActuatorsOf(model)) {
    VectorX by = VectorX::Zero(by_force.cols());
    for (const Actuator::Term& term : motor.terms) by += term.by_effort * by_force.row(term.dof).transpose();
    if (by.norm() <= 1e-9 || !std::isfinite(motor.effort_limit)) continue;
    own.push_back(motor);
    by_force_of.push_back(by);
  }
  const VectorX free = rows.tau[row] + given.tail(model.num_dofs());  // torques without contacts
  const auto n = static_cast<Eigen::Index>(own.size());
  MotorLimits limits{MatrixX(n, by_force.cols()), VectorX(n), VectorX(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Actuator& motor = own[static_cast<std::size_t>(i)];
    // tau = tau without contacts - J^T f
    const double alone = motor.Effort(free), most = kUse * motor.effort_limit;
    limits.by_force.row(i) = by_force_of[static_cast<std::size_t>(i)].transpose();
    limits.lower[i] = alone - most;
    limits.upper[i] = limits.lower[i] + 2.0 * most;
  }
  return limits;
}

}  // namespace gaitwright
