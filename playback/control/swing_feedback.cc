// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/swing_feedback.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kinematics/model/joint_losses.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {

SwingFeedback::SwingFeedback(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options)
    : model_(model),
      plan_(plan),
      options_(options),
      legs_(model),
      next_scratch_(model),
      mass_scratch_(model),
      mass_(model.nv(), model.nv()) {
  Reset();
}

void SwingFeedback::Reset() {
  footing_ = {};
  ground_.Reset(model_.feet.size());
  footing_.offset_W.assign(model_.feet.size(), Vector3::Zero());
  offsets_.assign(model_.feet.size(), {});
}

const Footing& SwingFeedback::UpdateFooting(const Situation& now) {
  constexpr double kSettle = 0.02;  // [s]
  const double share = std::min(now.step_s / kSettle, 1.0);
  int standing = 0;
  Vector3 offset = Vector3::Zero();
  for (std::size_t f = 0; f < model_.feet.size(); ++f) {
    const int foot = static_cast<int>(f);
    if (!Contains(now.bearing, foot)) {
      ground_.Leave(f);
      continue;
    }
    const Vector3 p_FS = now.swings.Under(foot, now.time_s).middle_F;
    const Vector3 seen = now.measured.X_WF[f] * p_FS - now.planned.X_WF[f] * p_FS;
    footing_.offset_W[f] += share * (seen - footing_.offset_W[f]);
    if (!Contains(now.scheduled, foot)) continue;
    offset += footing_.offset_W[f];
    ++standing;
    if (!model_.feet[f].sole_F.empty()) RecordGround(now, foot);
  }
  if (standing > 0) footing_.mean_offset_W = offset / standing;  // in flight the ground estimate does not change
  ground_.Fit();
  footing_.ground_tilt_W += share * (ground_.Tilt_W() - footing_.ground_tilt_W);
  return footing_;
}

/// Corners of a sole under load lie on the ground. On a height field a sole rocks, so it is not used.
void SwingFeedback::RecordGround(const Situation& now, int foot) {
  constexpr double kBearing = 0.3;  // of the weight
  const auto f = static_cast<std::size_t>(foot);
  if (now.wrenches[f].force_W.z() < kBearing * model_.weight_n()) return;
  std::vector<GroundFit::Point> points;
  if (now.swings.Under(foot, now.time_s).is_plane) {
    now.PointsAt(foot, now.measured, measured_W_);
    now.PointsAt(foot, now.planned, planned_W_);
    for (std::size_t i = 0; i < measured_W_.size(); ++i)
      points.push_back({planned_W_[i].head<2>(), measured_W_[i].z() - planned_W_[i].z()});
  }
  ground_.Stand(f, std::move(points));
}

void SwingFeedback::Update(const Situation& now, const StanceFeedback& stance, JointCommand& command,
                           const MomentumFeedback* predictive) {
  SampleWholeBody(plan_.whole_body, now.time_s + now.lead_s, next_);
  next_.v -= 0.5 * now.step_s * next_.a;
  ForwardVelocities(model_, next_.q, next_.v, next_scratch_);
  MassMatrix(model_, now.measured.q, mass_scratch_, mass_);
  AddRotorInertia(model_, mass_);
  for (int f = 0; f < static_cast<int>(model_.legs.size()); ++f) {
    Offset& offset = offsets_[static_cast<std::size_t>(f)];
    if (legs_.dofs(f).empty()) continue;
    if (Contains(now.bearing, f)) {
      offset = {};
      offset.value = offset.wanted = footing_.offset_W[static_cast<std::size_t>(f)];
      if (now.swings.Under(f, now.time_s).on_edge)
        CommandSwing(now, f, {}, command);  // a sole on its edge would tip: it turns as planned
      else
        CommandStance(now, f, stance, command);
      continue;
    }
    const SwingNow swing = now.swings.At(f, now.time_s);
    Motion1 hover;
    if (swing.swings) {
      hover = Hover(now, swing);
      if (swing.touchdown_s - now.time_s > options_.settle_s) {
        offset.wanted.head<2>() =
            predictive != nullptr && predictive->active() ? predictive->Step(f) : WantedStep(now, swing, stance);
        offset.wanted.z() = WantedHeight(now, f);
      }
      MoveOffset(now, swing, offset);
    } else if (Contains(now.scheduled, f)) {
      SearchGround(now, swing, offset);
    } else {
      offset.rate.setZero();
      offset.acceleration.setZero();
    }
    CommandSwing(now, f, hover, command);
  }
}

/// The DCM error at touch-down is corrected by a foothold shift of (e^{w T} - lambda) / (e^{w T} - 1) times it, with T
/// the next stance plus the flight after it, if any. The foothold stays within reach of the predicted base.
Vector2 SwingFeedback::WantedStep(const Situation& now, const SwingNow& swing, const StanceFeedback& stance) const {
  constexpr double kLongest = 0.5;  // [s]
  const double left = std::clamp(swing.touchdown_s - now.time_s, 0.0, kLongest);
  const StanceFeedback::Drift drift = stance.PredictedDrift(now, left);
  const double growth = std::exp(now.omega_rad_s * std::min(swing.next_support_s - swing.touchdown_s, kLongest));
  const Vector2 caught = options_.step_gain * (growth - options_.step_decay) / (growth - 1.0) * drift.dcm_W;
  const double reach = options_.step_reach * model_.leg_length_m();
  const Vector2 away = caught - drift.com_W;
  return away.norm() > reach ? Vector2(drift.com_W + away * reach / away.norm()) : caught;
}

/// Height of the ground at the planned place, relative to the plan: of the plane through the soles' contact points,
/// else under the standing feet.
double SwingFeedback::WantedHeight(const Situation& now, int foot) const {
  const Vector3 p_WF = now.planned.X_WF[static_cast<std::size_t>(foot)].translation();
  return ground_.has_points() ? ground_.RiseAt(p_WF.head<2>()) : footing_.mean_offset_W.z();
}

/// Moves along a minimum-jerk trajectory from the current to the wanted offset, at rest at touch-down. The move is
/// shortened so that its acceleration does not exceed `swing_acceleration_m_s2`.
void SwingFeedback::MoveOffset(const Situation& now, const SwingNow& swing, Offset& offset) const {
  const double h = now.step_s, left = std::max(swing.touchdown_s - now.time_s, options_.settle_s);
  constexpr double kPeak = 5.7735;  // acceleration of a minimum-jerk move of 1 m in 1 s [m/s^2]
  Vector3 change = offset.wanted - offset.value;
  const double most = options_.swing_acceleration_m_s2 * left * left / kPeak;
  const Vector3 coast = offset.rate * left * 0.5;
  if ((change - coast).norm() > most) change = coast + (change - coast) * most / (change - coast).norm();
  const Vector3 jerk =
      60.0 * change / (left * left * left) - 36.0 * offset.rate / (left * left) - 9.0 * offset.acceleration / left;
  offset.value += h * (offset.rate + h * (0.5 * offset.acceleration + h / 6.0 * jerk));
  offset.rate += h * (offset.acceleration + 0.5 * h * jerk);
  offset.acceleration += h * jerk;
}

/// The foot should be on the ground but has no contact: moves it downward until it touches. The speed increases from
/// zero, so that ground just below the foot is not hit hard. A foot that is about to lift off stays in place.
void SwingFeedback::SearchGround(const Situation& now, const SwingNow& next, Offset& offset) const {
  if (next.liftoff_s - now.time_s < options_.settle_s) {
    offset.rate.setZero();
    offset.acceleration.setZero();
    return;
  }
  constexpr double kRamp = 0.01;  // to the whole acceleration [s]
  const double fastest = -options_.search_m_s, most = -options_.swing_acceleration_m_s2;
  const double before = std::min(offset.rate.z(), 0.0);
  const double wanted = std::max(std::min(offset.acceleration.z(), 0.0) + most * now.step_s / kRamp, most);
  const double rate = std::max(before + wanted * now.step_s, fastest);
  offset.acceleration = Vector3(0.0, 0.0, (rate - before) / now.step_s);
  offset.rate = Vector3(0.0, 0.0, rate);
  offset.value += now.step_s * offset.rate;
}

/// Height of a swing above its plan. Planned swings come to rest on the ground so slowly that an error of 0.5 mm makes
/// them touch much too early.
Motion1 SwingFeedback::Hover(const Situation& now, const SwingNow& swing) const {
  const double t = now.time_s + now.lead_s, half_s = 0.5 * (swing.touchdown_s - swing.liftoff_s);
  const double landing_s = std::min(options_.settle_s, 0.5 * half_s);
  const bool lands = swing.touchdown_s - t < landing_s;
  const double from_s = swing.touchdown_s - (lands ? 0.0 : half_s);
  const double per_s = 1.0 / (lands ? -landing_s : half_s - landing_s);
  const Motion1 share = SmoothStep(per_s * (t - from_s));
  const double high = options_.hover * model_.leg_length_m();
  return {high * share.value, high * per_s * share.rate, high * per_s * per_s * share.acceleration};
}

FootMotion SwingFeedback::WantedMotion(int foot, const Motion1& hover) const {
  const Foot& f = model_.feet[static_cast<std::size_t>(foot)];
  const Offset& offset = offsets_[static_cast<std::size_t>(foot)];
  FootMotion wanted;
  wanted.X_WF = FramePose(next_scratch_, f.body, f.X_BF);
  wanted.X_WF.translation() += offset.value + hover.value * Vector3::UnitZ();
  wanted.X_WF.linear() = RotationExp(footing_.ground_tilt_W) * wanted.X_WF.linear();
  wanted.v_WF = PointVelocity(next_scratch_, f.body, f.X_BF.translation());
  wanted.v_WF.head<3>() += offset.rate + hover.rate * Vector3::UnitZ();
  wanted.a_extra_WF = offset.acceleration + hover.acceleration * Vector3::UnitZ();
  return wanted;
}

/// Contact forces keep the balance; the motors only keep the foot from sliding. They let a sole turn onto the ground
/// that it finds.
void SwingFeedback::CommandStance(const Situation& now, int leg, const StanceFeedback& stance, JointCommand& command) {
  v_ = now.measured.v;
  const double creep_m_s = options_.stance_creep * std::sqrt(kGravity * model_.leg_length_m());
  const Vector3& normal_W = now.swings.Under(leg, now.time_s).normal_W;
  legs_.Hold(leg, normal_W, creep_m_s, now.measured.q, v_);
  const VectorX shares = legs_.SettlingShares(leg, normal_W);
  const std::vector<int>& dofs = legs_.dofs(leg);
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const int dof = dofs[i];
    command.q[dof] = now.measured.q[7 + dof];
    command.v[dof] = v_[6 + dof] + now.lead_s * now.sample.a[6 + dof];
    command.stiffness[dof] = 0.0;
    command.damping[dof] *= options_.stance_damping * shares[static_cast<Eigen::Index>(i)];
  }
  FootMotion wanted;
  wanted.a_extra_WF.z() = -stance.lifted_m_s2();
  const VectorX extra = legs_.ExtraTorque(leg, wanted, mass_);
  for (std::size_t i = 0; i < dofs.size(); ++i) command.tau_ff[dofs[i]] += extra[static_cast<Eigen::Index>(i)];
}

void SwingFeedback::CommandSwing(const Situation& now, int leg, const Motion1& hover, JointCommand& command) {
  const FootMotion wanted = WantedMotion(leg, hover);
  q_ = now.measured.q;
  v_ = now.measured.v;
  v_.head<6>() += now.lead_s * now.sample.a.head<6>();
  q_.head<3>() += now.lead_s * v_.head<3>();
  legs_.Solve(leg, wanted, now.planned.q, q_, v_);
  const VectorX extra = legs_.ExtraTorque(leg, wanted, mass_);
  const std::vector<int>& dofs = legs_.dofs(leg);
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    command.q[dofs[i]] = q_[7 + dofs[i]];
    command.v[dofs[i]] = v_[6 + dofs[i]];
    command.tau_ff[dofs[i]] += extra[static_cast<Eigen::Index>(i)];
    command.stiffness[dofs[i]] *= options_.swing_stiffness;
    command.damping[dofs[i]] *= std::sqrt(options_.swing_stiffness);
  }
}

}  // namespace gaitwright
