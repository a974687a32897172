// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/base_path.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

/// sin(a)/a and (1 - cos(a))/a, accurate near zero.
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
  return ProgressAt(time_s, duration_s, ramp_s, ramp_s);
}

double ProgressAt(double time_s, double duration_s, double start_ramp_s, double stop_ramp_s) {
  const double ramps = start_ramp_s + stop_ramp_s, fit = ramps > duration_s ? duration_s / ramps : 1.0;
  const double start = fit * start_ramp_s, stop = fit * stop_ramp_s;
  const double rate = 1.0 / (duration_s - 0.5 * (start + stop));
  const double t = std::clamp(time_s, 0.0, duration_s);
  if (t < start) return rate * start * RampArea(t / start);
  if (t > duration_s - stop) return 1.0 - rate * stop * RampArea((duration_s - t) / stop);
  return rate * (t - 0.5 * start);
}

PlanarPose Carried(const PlanarPose& from, const PlanarPose& pose) {
  const double c = std::cos(from.yaw_rad), s = std::sin(from.yaw_rad);
  return {from.x_m + c * pose.x_m - s * pose.y_m, from.y_m + s * pose.x_m + c * pose.y_m, from.yaw_rad + pose.yaw_rad};
}

BasePath MakeBasePath(const std::vector<PathPiece>& pieces, double end_s) {
  constexpr double kStep = 0.01;
  const int samples = 1 + static_cast<int>(std::ceil(end_s / kStep - 1e-9));
  BasePath path;
  for (int k = 0; k < samples; ++k) {
    const double t = std::min(k * kStep, end_s);
    PlanarPose pose;
    for (const PathPiece& piece : pieces) {
      const double progress = ProgressAt(t - piece.start_s, piece.duration_s, piece.start_ramp_s, piece.stop_ramp_s);
      pose = Carried(pose, PoseAlong(piece.twist, progress));
    }
    path.time_s.push_back(t);
    path.pose.push_back(pose);
  }
  return path;
}

BasePath MakeBasePath(const PlanarTwist& twist, double start_s, double duration_s, double ramp_s, double end_s) {
  return MakeBasePath({{twist, start_s, duration_s, ramp_s, ramp_s}}, end_s);
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
