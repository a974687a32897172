// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/whole_body/body_path.h"

#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/footsteps/base_over_feet.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

constexpr double kKnotStep = 0.025;  // [s]

int Knots(const ContactSchedule& schedule) {
  return 1 + std::max(2, static_cast<int>(std::lround((schedule.end_s() - schedule.start_s()) / kKnotStep)));
}

double StepOf(const ContactSchedule& schedule) {
  return (schedule.end_s() - schedule.start_s()) / (Knots(schedule) - 1);
}

/// Pose of a foot at a time: on its foothold, or between two footholds.
Pose PlaceAt(const FootstepPlan& footsteps, int foot, double time_s) {
  const auto& all = footsteps.footholds;
  const auto index = static_cast<std::size_t>(FootholdAt(footsteps, foot, time_s));
  Pose X_WF = all[index].X_WF;
  if (time_s <= all[index].liftoff_s) return X_WF;
  const auto next = std::find_if(all.begin() + static_cast<std::ptrdiff_t>(index) + 1, all.end(),
                                 [&](const Foothold& f) { return f.foot == foot; });
  if (next == all.end()) return X_WF;
  const double u = (time_s - all[index].liftoff_s) / (next->touchdown_s - all[index].liftoff_s);
  X_WF.translation() += SmoothStep(u).value * (next->X_WF.translation() - X_WF.translation());
  return X_WF;
}

/// Moving average. Values are constant beyond the ends.
std::vector<double> Evened(const std::vector<double>& values, int half_width) {
  std::vector<double> evened;
  const int last = static_cast<int>(values.size()) - 1;
  for (int k = 0; k <= last; ++k) {
    double sum = 0.0;
    for (int d = -half_width; d <= half_width; ++d) sum += values[static_cast<std::size_t>(std::clamp(k + d, 0, last))];
    evened.push_back(sum / (2 * half_width + 1));
  }
  return evened;
}

std::vector<double> Yaws(const FootstepSkeleton& skeleton) {
  const BasePath& path = skeleton.path;
  std::vector<double> yaw;
  std::size_t i = 0;
  for (int k = 0; k < Knots(skeleton.schedule); ++k) {
    const double t = skeleton.schedule.start_s() + k * StepOf(skeleton.schedule);
    while (i + 2 < path.time_s.size() && path.time_s[i + 1] < t) ++i;
    if (path.time_s.size() < 2) {
      yaw.push_back(path.pose.front().yaw_rad);
      continue;
    }
    const double u = std::clamp((t - path.time_s[i]) / (path.time_s[i + 1] - path.time_s[i]), 0.0, 1.0);
    yaw.push_back((1.0 - u) * path.pose[i].yaw_rad + u * path.pose[i + 1].yaw_rad);
  }
  return yaw;
}

/// One component of the base's pose above its feet, at the knots of a spline.
std::vector<double> Follow(const RobotModel& model, const FootstepSkeleton& skeleton, double even_s,
                           double BaseOverFeet::*number) {
  const std::vector<Pose> standing = StandingFeet(model);
  const double step = StepOf(skeleton.schedule);
  std::vector<double> values;
  std::vector<Pose> feet(standing.size());
  for (int k = 0; k < Knots(skeleton.schedule); ++k) {
    const double t = skeleton.schedule.start_s() + k * step;
    for (std::size_t f = 0; f < feet.size(); ++f) feet[f] = PlaceAt(skeleton.footsteps, static_cast<int>(f), t);
    values.push_back(FitBase(standing, feet, MeanHeading(standing, feet)).*number);
  }
  const int half_width = static_cast<int>(std::lround(0.5 * even_s / step));
  return Evened(values, half_width);
}

}  // namespace

BodyPath::BodyPath(const RobotModel& model, const FootstepSkeleton& skeleton, double even_s)
    : start_s_(skeleton.schedule.start_s()),
      step_s_(StepOf(skeleton.schedule)),
      pitch_rad_(Follow(model, skeleton, even_s, &BaseOverFeet::pitch_rad)),
      over_feet_m_(Follow(model, skeleton, even_s, &BaseOverFeet::ground_m)),
      ground_m_(over_feet_m_),
      yaw_(start_s_, step_s_, Yaws(skeleton)),
      pitch_(start_s_, step_s_, pitch_rad_),
      roll_(start_s_, step_s_, Follow(model, skeleton, even_s, &BaseOverFeet::roll_rad)),
      ground_(start_s_, step_s_, ground_m_) {}

void BodyPath::Lean(double angle_rad, double bend_s) {
  const double end_s = KnotTime(knots() - 1);
  for (int k = 0; k < knots(); ++k) {
    const double in = SmoothStep((KnotTime(k) - start_s_) / bend_s).value,
                 out = SmoothStep((end_s - KnotTime(k)) / bend_s).value;
    pitch_rad_[static_cast<std::size_t>(k)] += angle_rad * std::min(in, out);
  }
  pitch_ = CubicSpline(start_s_, step_s_, pitch_rad_);
}

void BodyPath::KeepWithin(const std::vector<Bounds>& ground_m, double bend_s) {
  constexpr double kFirm = 4.0;  // weight of a single knot's bound
  const double stiff = bend_s / step_s_;
  ground_m_ = SmoothWithin(over_feet_m_, ground_m, stiff, kFirm * stiff * stiff);
  ground_ = CubicSpline(start_s_, step_s_, ground_m_);
}

BaseTurning BodyPath::TurningAt(double time_s) const {
  return TurningOf(yaw_.At(time_s), pitch_.At(time_s), roll_.At(time_s));
}

BaseTurning TurningOf(const Motion1& yaw, const Motion1& pitch, const Motion1& roll) {
  BaseTurning turning;
  const Vector3 z = Vector3::UnitZ(), y = YawRotation(yaw.value).col(1);
  const Matrix3 R_pitched = YawRotation(yaw.value) * Eigen::AngleAxisd(pitch.value, Vector3::UnitY());
  const Vector3 x = R_pitched.col(0), w_y = yaw.rate * z, w_x = w_y + pitch.rate * y;  // angular velocities of y and x
  turning.R_WB = R_pitched * Eigen::AngleAxisd(roll.value, Vector3::UnitX());
  turning.w_WB = w_x + roll.rate * x;
  turning.alpha_WB = yaw.acceleration * z + pitch.acceleration * y + pitch.rate * w_y.cross(y) + roll.acceleration * x +
                     roll.rate * w_x.cross(x);
  return turning;
}

}  // namespace gaitwright
