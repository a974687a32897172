// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/base_path.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

/// sin(a)/a and (1 - cos(a))/a, exact near zero.
struct ArcFactors {
  double along, across;
  explicit ArcFactors(double a)
      : along(std::abs(a) < 1e-6 ? 1.0 - a * a / 6.0 : std::sin(a) / a),
        across(std::abs(a) < 1e-6 ? 0.5 * a : (1.0 - std::cos(a)) / a) {}
};

/// Integral of the minimum-jerk step over [0, u].
double RampArea(double u) {
  const double u2 = u * u;
  return u2 * u2 * (2.5 + u * (u - 3.0));
}

}  // namespace

PlanarPose PoseAlong(const PlanarTwist& twist, double progress) {
  const double yaw = progress * twist.yaw_rad;
  const ArcFactors arc(yaw);
  return {progress * (arc.along * twist.x_m - arc.across * twist.y_m),
          progress * (arc.across * twist.x_m + arc.along * twist.y_m), yaw};
}

PlanarTwist TwistTo(const PlanarPose& pose) {
  const ArcFactors arc(pose.yaw_rad);
  const double determinant = arc.along * arc.along + arc.across * arc.across;
  return {(arc.along * pose.x_m + arc.across * pose.y_m) / determinant,
          (arc.along * pose.y_m - arc.across * pose.x_m) / determinant, pose.yaw_rad};
}

double ProgressAt(double time_s, double duration_s, double ramp_s) {
  const double ramp = std::min(ramp_s, 0.5 * duration_s);
  const double rate = 1.0 / (duration_s - ramp);
  const double t = std::clamp(time_s, 0.0, duration_s);
  if (t < ramp) return rate * ramp * RampArea(t / ramp);
  if (t > duration_s - ramp) return 1.0 - rate * ramp * RampArea((duration_s - t) / ramp);
  return rate * (t - 0.5 * ramp);
}

BasePath MakeBasePath(const PlanarTwist& twist, double start_s, double duration_s, double ramp_s, double end_s) {
  constexpr double kStep = 0.01;
  const int samples = 1 + static_cast<int>(std::ceil(end_s / kStep - 1e-9));
  BasePath path;
  for (int k = 0; k < samples; ++k) {
    const double t = std::min(k * kStep, end_s);
    path.time_s.push_back(t);
    path.pose.push_back(PoseAlong(twist, ProgressAt(t - start_s, duration_s, ramp_s)));
  }
  return path;
}

PlanarPose PoseAt(const BasePath& path, double time_s) {
  const auto after = std::upper_bound(path.time_s.begin(), path.time_s.end(), time_s);
  if (after == path.time_s.begin()) return path.pose.front();
  if (after == path.time_s.end()) return path.pose.back();
  const auto i = static_cast<std::size_t>(after - path.time_s.begin());
  const double u = (time_s - path.time_s[i - 1]) / (path.time_s[i] - path.time_s[i - 1]);
  const PlanarPose &a = path.pose[i - 1], &b = path.pose[i];
  return {a.x_m + u * (b.x_m - a.x_m), a.y_m + u * (b.y_m - a.y_m), a.yaw_rad + u * (b.yaw_rad - a.yaw_rad)};
}

}  // namespace gaitwright
