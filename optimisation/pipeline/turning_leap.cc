// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/ik/whole_body_ik.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/fit_detour.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/pipeline/turning_leap_internal.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

/// A point that a curve passes at a time with a velocity.
struct Waypoint {
  double time_s;
  Vector3 p_W, v_W;
};

/// Place on the cubic between two points; outside it the nearer point.
Vector3 CubicBetween(const Waypoint& from, const Waypoint& to, double time_s) {
  const double h = to.time_s - from.time_s, u = std::clamp((time_s - from.time_s) / h, 0.0, 1.0), w = 1.0 - u;
  return from.p_W * (w * w * (1.0 + 2.0 * u)) + to.p_W * (u * u * (3.0 - 2.0 * u)) +
         h * u * w * (w * from.v_W - u * to.v_W);
}

/// Feet on the ground, their mean place, and the mean place of their hips relative to the centre of mass in standing.
struct PushingFeet {
  Vector3 ground_W = Vector3::Zero(), hips_C = Vector3::Zero();
};

class TurningLeap {
 public:
  TurningLeap(const RobotModel& model, const Vector3& turn_W, const LeapShape& shape, const MotionPlan& plan)
      : model_(model),
        shape_(shape),
        plan_(plan),
        axis_W_(turn_W.normalized()),
        turn_rad_(turn_W.norm()),
        ik_(model),
        standing_(StandingConfiguration(model)),
        scratch_(model) {
    tuck_ = last_q_ = standing_;
    lift_.assign(model.feet.size(), standing_);
    land_ = lift_;
    lift_set_.assign(model.feet.size(), true);
    FindTimes();
    FindPlaces();
  }

  /// The configuration of each row. @param q  of the row before.
  Result<int> Solve(double time_s, VectorX& q) {
    Result<int> solved = ik_.SolvePosition(TargetAt(time_s), q);
    if (solved) last_q_ = q;
    return solved;
  }
  std::optional<Failure> Prepare() {
    VectorX q = standing_;
    const double low = liftoff_s_ - shape_.push_s;
    if (auto s = ik_.SolvePosition(TargetAt(low), q); !s) return s.failure();
    tuck_ = q;
    last_q_ = q;
    // Joints at the landings, backward from the crouch after them.
    land_.assign(model_.feet.size(), tuck_);
    q = tuck_;
    for (double t = touchdown_s_ + shape_.push_s; t > touchdown_s_ - 1e-9; t -= 0.005) {
      if (auto s = ik_.SolvePosition(TargetAt(t), q); !s) return s.failure();
      for (std::size_t f = 0; f < model_.feet.size(); ++f) {
        for (const SwingTrajectory& swing : plan_.swings)
          if (swing.foot == static_cast<int>(f) && t >= swing.end_s - 1e-6) land_[f] = q;
      }
    }
    lift_.assign(model_.feet.size(), tuck_);
    lift_set_.assign(model_.feet.size(), false);
    return std::nullopt;
  }
  const VectorX& standing() const { return standing_; }

 private:
  void FindTimes();
  void FindPlaces();
  PushingFeet FeetOf(FootSet feet, double time_s) const;
  double AngleAt(double time_s) const;
  Vector3 CentreAt(double time_s) const;
  Vector3 FootAt(int foot, double time_s, const Matrix3& R, const Vector3& c_W);
  BodyTarget TargetAt(double time_s);
  Vector3 HipOf(int foot) const { return hips_C_[static_cast<std::size_t>(foot)]; }

  const RobotModel& model_;
  const LeapShape& shape_;
  const MotionPlan& plan_;
  const Vector3 axis_W_;
  const double turn_rad_;
  WholeBodyIk ik_;
  const VectorX standing_;
  double liftoff_s_ = 0.0, touchdown_s_ = 0.0;  // of the flight
  FootSet last_ = 0, first_ = 0;                // feet that lift off last and land first
  double slowing_s_ = 0.0;                      // in which the turn ends after the first touch-down
  double rate_rad_s_ = 0.0, angle_liftoff_rad_ = 0.0, angle_touchdown_rad_ = 0.0;
  DynamicsScratch scratch_;
  Vector3 c_standing_W_ = Vector3::Zero();
  VectorX tuck_, last_q_;
  std::vector<VectorX> lift_, land_;
  std::vector<bool> lift_set_;
  std::vector<Vector3> hips_C_;  // by foot: hip relative to the centre of mass, in standing
  std::vector<Vector3> feet_C_;  // by foot: centre of the foot likewise
  Vector3 start_W_, low_W_, off_W_, on_W_, low_end_W_, end_W_, v_off_W_, v_on_W_;
};

void TurningLeap::FindTimes() {
  const std::vector<ContactPhase>& phases = plan_.schedule.phases;
  for (std::size_t k = 1; k + 1 < phases.size(); ++k) {
    if (phases[k].stance != 0) continue;
    liftoff_s_ = phases[k].start_s;
    touchdown_s_ = phases[k].end_s;
    last_ = phases[k - 1].stance;
    first_ = phases[k + 1].stance;
  }
  const double flight_s = touchdown_s_ - liftoff_s_;
  double first_liftoff_s = liftoff_s_, last_touchdown_s = touchdown_s_;
  for (const SwingTrajectory& swing : plan_.swings) {
    first_liftoff_s = std::min(first_liftoff_s, swing.start_s);
    last_touchdown_s = std::max(last_touchdown_s, swing.end_s);
  }
  const double ratio = (last_touchdown_s - touchdown_s_) / std::max(liftoff_s_ - first_liftoff_s, 1e-3);
  slowing_s_ = shape_.push_s * std::clamp(ratio, 0.05, 1.0);
  rate_rad_s_ = turn_rad_ / (flight_s + (shape_.push_s + slowing_s_) / (shape_.ramp_power + 1.0));
  angle_liftoff_rad_ = rate_rad_s_ * shape_.push_s / (shape_.ramp_power + 1.0);
  angle_touchdown_rad_ = turn_rad_ - rate_rad_s_ * slowing_s_ / (shape_.ramp_power + 1.0);
}

double TurningLeap::AngleAt(double time_s) const {
  const auto ramp = [&](double u) { return std::pow(std::clamp(u, 0.0, 1.0), shape_.ramp_power + 1.0); };
  if (time_s <= liftoff_s_) return angle_liftoff_rad_ * ramp(1.0 - (liftoff_s_ - time_s) / shape_.push_s);
  if (time_s >= touchdown_s_)
    return turn_rad_ - (turn_rad_ - angle_touchdown_rad_) * ramp(1.0 - (time_s - touchdown_s_) / slowing_s_);
  return angle_liftoff_rad_ + rate_rad_s_ * (time_s - liftoff_s_);
}

PushingFeet TurningLeap::FeetOf(FootSet feet, double time_s) const {
  PushingFeet mean;
  double count = 0.0;
  for (int foot = 0; foot < static_cast<int>(model_.feet.size()); ++foot) {
    if (!Contains(feet, foot)) continue;
    const auto& foothold =
        plan_.footsteps.footholds[static_cast<std::size_t>(FootholdAt(plan_.footsteps, foot, time_s))];
    mean.ground_W += foothold.X_WF.translation();
    mean.hips_C += HipOf(foot);
    count += 1.0;
  }
  mean.ground_W /= count;
  mean.hips_C /= count;
  return mean;
}

void TurningLeap::FindPlaces() {
  DynamicsScratch scratch(model_);
  ForwardKinematics(model_, standing_, scratch);
  const Vector3 c_W = CentreOfMass(model_, scratch);
  c_standing_W_ = c_W;
  for (std::size_t f = 0; f < model_.feet.size(); ++f) {
    const Leg& leg = model_.legs[f];
    hips_C_.push_back(scratch.p_WB[static_cast<std::size_t>(std::max(leg.hip_joint, leg.joints.front()) + 1)] - c_W);
    feet_C_.push_back(FramePose(scratch, model_.feet[f].body, model_.feet[f].X_BF).translation() - c_W);
  }
  const double leg_m = model_.leg_length_m(), flight_s = touchdown_s_ - liftoff_s_;
  const FootSet all = AllFeet(static_cast<int>(model_.feet.size()));
  const double from_s = plan_.schedule.start_s(), to_s = plan_.schedule.end_s();
  const PushingFeet start = FeetOf(all, from_s), end = FeetOf(all, to_s), last = FeetOf(last_, from_s),
                    first = FeetOf(first_, to_s);
  const auto above = [&](const PushingFeet& feet, double angle, double height_m) -> Vector3 {
    return feet.ground_W + height_m * Vector3::UnitZ() - Eigen::AngleAxisd(angle, axis_W_) * feet.hips_C;
  };
  const auto stands = [&](const PushingFeet& feet, double height_m) -> Vector3 {
    const Vector3 mean_feet = FeetOf(all, from_s).ground_W;
    Vector3 place = feet.ground_W + (c_W - mean_feet).cwiseProduct(Vector3(1.0, 1.0, 0.0));
    place.z() = feet.ground_W.z() + height_m;
    return place;
  };
  start_W_ = stands(start, c_W.z());
  end_W_ = stands(end, c_W.z());
  low_W_ = stands(start, shape_.crouched * leg_m - start.hips_C.z());
  low_end_W_ = stands(end, shape_.crouched * leg_m - end.hips_C.z());
  off_W_ = above(last, angle_liftoff_rad_, shape_.extended * leg_m);
  on_W_ = above(first, angle_touchdown_rad_ - turn_rad_, shape_.extended * leg_m);
  v_off_W_ = (on_W_ - off_W_) / flight_s + 0.5 * kGravity * flight_s * Vector3::UnitZ();
  v_on_W_ = v_off_W_ - kGravity * flight_s * Vector3::UnitZ();
}

Vector3 TurningLeap::CentreAt(double time_s) const {
  const double push_s = liftoff_s_ - shape_.push_s, land_s = touchdown_s_ + shape_.push_s;
  const Vector3 rest = Vector3::Zero();
  const Waypoint low{push_s, low_W_, rest}, off{liftoff_s_, off_W_, v_off_W_};
  const Waypoint on{touchdown_s_, on_W_, v_on_W_}, low_end{land_s, low_end_W_, rest};
  if (time_s <= push_s) return CubicBetween({push_s - shape_.crouch_s, start_W_, rest}, low, time_s);
  if (time_s <= liftoff_s_) return CubicBetween(low, off, time_s);
  if (time_s >= land_s) return CubicBetween(low_end, {land_s + shape_.crouch_s, end_W_, rest}, time_s);
  if (time_s >= touchdown_s_) return CubicBetween(on, low_end, time_s);
  const double t = time_s - liftoff_s_;
  return off_W_ + t * v_off_W_ - 0.5 * kGravity * t * t * Vector3::UnitZ();
}

/// The centre of a foot: on its foothold, and in the air tucked in below its hip.
Vector3 TurningLeap::FootAt(int foot, double time_s, const Matrix3& R, const Vector3& c_W) {
  const auto f = static_cast<std::size_t>(foot);
  const auto on = [&](double at_s) -> Vector3 {
    const auto& foothold = plan_.footsteps.footholds[static_cast<std::size_t>(FootholdAt(plan_.footsteps, foot, at_s))];
    return foothold.X_WF.translation() + model_.feet[f].radius * foothold.X_WF.linear().col(2);
  };
  for (const SwingTrajectory& swing : plan_.swings) {
    if (swing.foot != foot || time_s <= swing.start_s + 1e-9 || time_s >= swing.end_s - 1e-9) continue;
    const double u = (time_s - swing.start_s) / (swing.end_s - swing.start_s);
    if (!lift_set_[f]) {
      lift_[f] = last_q_;
      lift_set_[f] = true;
    }
    const double half = 0.45;
    const double in = SmoothStep(std::min(1.0, u / half)).value,
                 out = SmoothStep(std::max(0.0, (u - 1.0 + half) / half)).value;
    VectorX q = standing_;
    q.tail(q.size() - 7) =
        (lift_[f] * (1.0 - in) + tuck_ * in).tail(q.size() - 7) * (1.0 - out) + land_[f].tail(q.size() - 7) * out;
    ForwardKinematics(model_, q, scratch_);
    const Vector3 p = FramePose(scratch_, model_.feet[f].body, model_.feet[f].X_BF).translation();
    return c_W + R * (p - c_standing_W_);
  }
  return on(time_s);
}

BodyTarget TurningLeap::TargetAt(double time_s) {
  const Matrix3 R = Eigen::AngleAxisd(AngleAt(time_s), axis_W_).toRotationMatrix();
  BodyTarget target;
  target.p_WC = CentreAt(time_s);
  target.R_WB = R * BaseRotation(standing_);
  for (int foot = 0; foot < static_cast<int>(model_.feet.size()); ++foot) {
    FootTarget wanted;
    wanted.p_WF = FootAt(foot, time_s, R, target.p_WC);
    wanted.R_WF = Matrix3::Identity();
    wanted.normal_anchor_W = Vector3::Zero();  // feet do not roll in a first guess
    target.feet.push_back(wanted);
  }
  return target;
}

/// Velocities and accelerations of the rows by differences.
void SetRates(WholeBodyTrajectory& w) {
  const std::size_t rows = w.q.size();
  const Eigen::Index n = w.q.front().size() - 1;
  const auto between = [&](std::size_t k) {
    VectorX step(n);
    step << w.q[k + 1].head<3>() - w.q[k].head<3>(),
        RotationLog(BaseRotation(w.q[k + 1]) * BaseRotation(w.q[k]).transpose()), (w.q[k + 1] - w.q[k]).tail(n - 6);
    return VectorX(step / w.step_s);
  };
  w.v.assign(rows, VectorX::Zero(n));
  w.a.assign(rows, VectorX::Zero(n));
  for (std::size_t k = 1; k + 1 < rows; ++k) {
    const VectorX before = between(k - 1), after = between(k);
    w.v[k] = 0.5 * (before + after);
    w.a[k] = (after - before) / w.step_s;
  }
}

}  // namespace

LeapShape LeapShapeOf(const RobotModel& model) {
  constexpr double kPush = 1.64, kCrouch = 1.93;  // in sqrt(leg length / g)
  const double scale_s = std::sqrt(model.leg_length_m() / kGravity);
  LeapShape shape;
  shape.push_s = kPush * scale_s;
  shape.crouch_s = kCrouch * scale_s;
  return shape;
}

std::optional<Failure> SetTurningLeap(const RobotModel& model, const Vector3& turn_W, const LeapShape& shape,
                                      double step_s, MotionPlan& plan) {
  TurningLeap leap(model, turn_W, shape, plan);
  if (auto failure = leap.Prepare()) {
    failure->message = "landing: " + failure->message;
    return failure;
  }
  WholeBodyTrajectory& w = plan.whole_body;
  w = {plan.schedule.start_s(), step_s, {}, {}, {}, {}, {}};
  const int rows = static_cast<int>(std::lround((plan.schedule.end_s() - w.start_s) / step_s)) + 1;
  VectorX q = leap.standing();
  for (int row = 0; row < rows; ++row) {
    const double time_s = w.start_s + row * step_s;
    if (const Result<int> solved = leap.Solve(time_s, q); !solved) {
      Failure failure = solved.failure();
      failure.message = fmt::format("at {:.3f} s: {}", time_s, failure.message);
      return failure;
    }
    w.q.push_back(q);
  }
  SetRates(w);
  w.tau.assign(w.q.size(), VectorX::Zero(model.num_dofs()));
  w.wrenches.assign(w.q.size(), std::vector<ContactWrench>(model.feet.size()));
  return std::nullopt;
}

namespace {

/// Sets the detour of a swing so that its curve follows the foot in the rows, less what the foot has rolled since its
/// lift-off. @return the largest distance that is left [m].
double FitSwing(const RobotModel& model, const WholeBodyTrajectory& motion, SwingTrajectory& swing) {
  constexpr int kPoints = 60;
  const Foot& foot = model.feet[static_cast<std::size_t>(swing.foot)];
  const Vector3 normal_W = swing.X_WF_start.linear().col(2);
  const int pieces = static_cast<int>(std::lround((swing.end_s - swing.start_s) / motion.step_s));
  const auto time = [&](int k) { return swing.start_s + k * (swing.end_s - swing.start_s) / pieces; };
  DynamicsScratch scratch(model);
  WholeBodySample sample;
  std::vector<Vector3> path_W;
  Matrix3 R_before = Matrix3::Identity();
  Vector3 rolled_W = Vector3::Zero();
  for (int k = 0; k <= pieces; ++k) {
    SampleWholeBody(motion, time(k), sample);
    ForwardKinematics(model, sample.q, scratch);
    const Pose X_WF = FramePose(scratch, foot.body, foot.X_BF);
    if (k > 0) rolled_W += foot.radius * RotationLog(X_WF.linear() * R_before.transpose()).cross(normal_W);
    R_before = X_WF.linear();
    path_W.push_back(X_WF.translation() - rolled_W - foot.radius * normal_W);
  }
  swing.lift_m = swing.cruise = 0.0;
  swing.detour_W.clear();
  SwingCurve fitted = CurveOf(swing);
  fitted.X_WF_end.translation() -= rolled_W;
  std::vector<double> shares;
  std::vector<Vector3> off_W;
  for (int k = 1; k < pieces; ++k) {
    shares.push_back(static_cast<double>(k) / pieces);
    off_W.emplace_back(path_W[static_cast<std::size_t>(k)] - Evaluate(fitted, time(k)).X_WF.translation());
  }
  swing.detour_W = fitted.detour_W = FitDetour(shares, off_W, std::min(kPoints, pieces - 1));
  double largest_m = 0.0;
  for (int k = 0; k <= pieces; ++k) {
    const Vector3 path_of_curve_W = Evaluate(fitted, time(k)).X_WF.translation();
    largest_m = std::max(largest_m, (path_of_curve_W - path_W[static_cast<std::size_t>(k)]).norm());
  }
  return largest_m;
}

}  // namespace

void FitSwings(const RobotModel& model, MotionPlan& plan) {
  for (SwingTrajectory& swing : plan.swings) FitSwing(model, plan.whole_body, swing);
}

}  // namespace gaitwright
