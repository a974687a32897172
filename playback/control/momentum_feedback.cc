// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/momentum_feedback.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

MomentumGains GainsFor(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options) {
  if (LongestFlight(plan.schedule) == 0.0 || plan.whole_body.size() < 2) return {};
  const double length = std::max(model.leg_length_m(), 1e-3);
  MomentumErrors errors;
  errors.position_m = options.ahead_error * length;
  errors.velocity_m_s = options.ahead_error * std::sqrt(kGravity * length);
  errors.turn_rad = options.ahead_turn_rad;
  errors.rate_rad_s = options.ahead_turn_rad * std::sqrt(kGravity / length);
  errors.step_m = options.ahead_step * length;
  return DeriveMomentumGains(model, plan, errors);
}

}  // namespace

MomentumFeedback::MomentumFeedback(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options)
    : model_(model), gains_(GainsFor(model, plan, options)) {
  error_ = VectorX::Zero(MomentumGains::kFeet + 2 * static_cast<Eigen::Index>(model.feet.size()));
}

void MomentumFeedback::Update(const Situation& now, const Footing& footing) {
  if (!active()) return;
  row_ = &gains_.At(now.time_s);
  error_.setZero();
  error_.segment<3>(0) = now.measured.p_WC - now.planned.p_WC;
  error_[2] -= footing.mean_offset_W.z();
  error_.segment<3>(3) = now.measured.v_WC - now.planned.v_WC;
  error_.segment<3>(6) = RotationLog(now.measured.R_WB() * now.planned.R_WB().transpose());
  error_.segment<3>(9) = LockedInertia(model_, now.measured.scratch).inverse() * (now.measured.l_W - now.planned.l_W);
  for (std::size_t f = 0; f < model_.feet.size(); ++f) {
    if (!Contains(now.scheduled, static_cast<int>(f))) continue;
    error_.segment<2>(MomentumGains::kFeet + 2 * static_cast<Eigen::Index>(f)) =
        (now.measured.X_WF[f].translation() - now.planned.X_WF[f].translation()).head<2>();
  }
}

PointWrench MomentumFeedback::Wanted(const Situation& now) const {
  constexpr double kLess = 0.8, kMore = 1.0;  // of the load
  PointWrench wanted{now.measured.p_WC, Vector3::Zero(), Vector3::Zero()};
  for (std::size_t f = 0; f < model_.feet.size(); ++f) {
    if (!Contains(now.scheduled, static_cast<int>(f))) continue;
    const ContactWrench& planned = now.sample.wrenches[f];
    const Vector3& normal = now.swings.Under(static_cast<int>(f), now.time_s).normal_W;
    const double load = std::max(planned.force_W.dot(normal), 0.0);
    Vector6 change = load * row_->wrench_per_n[f] * error_;
    const double pressed = change.head<3>().dot(normal);
    change.head<3>() += (std::clamp(pressed, -kLess * load, kMore * load) - pressed) * normal;
    const Vector3 force = planned.force_W + change.head<3>();
    wanted.force_W += force;
    wanted.moment_W +=
        planned.moment_W + change.tail<3>() + (now.measured.X_WF[f].translation() - now.measured.p_WC).cross(force);
  }
  return wanted;
}

Vector2 MomentumFeedback::Step(int foot) const { return row_->steps.middleRows<2>(2 * foot) * error_; }

}  // namespace gaitwright
