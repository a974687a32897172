// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/time_route.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "planning/paths/travel_cost.h"

namespace gaitwright {
namespace {

constexpr double kSampleStep = 0.01;      // [s]
constexpr double kMostChange = 0.3;       // largest jump of the motion between two parts of a route, in full speeds
constexpr double kSmoothing = 1.0 / 3.0;  // share of the ramp: time over which progress is averaged

/// Motion of the body over a part of the route, each component as a share of its full speed, and the duration at full
/// speed.
struct Part {
  Vector3 motion = Vector3::Zero();
  double time_s = 0.0;
};

Part PartOf(const PlanarPose& a, const PlanarPose& b, const RouteTiming& timing) {
  const double yaw = 0.5 * (a.yaw_rad + b.yaw_rad), c = std::cos(yaw), s = std::sin(yaw);
  const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
  // The heading turns within a part, so each component is its maximum over the part.
  const double half = 0.5 * std::abs(b.yaw_rad - a.yaw_rad), distance = std::hypot(dx, dy);
  const double forward = c * dx + s * dy, lateral = c * dy - s * dx, most = distance * std::sin(std::min(half, 1.5));
  Part part;
  part.time_s = std::max({std::min(std::abs(forward) + most, distance) / timing.speed_m_s,
                          std::min(std::abs(lateral) + most, distance) / timing.lateral_speed_m_s,
                          std::abs(b.yaw_rad - a.yaw_rad) / timing.yaw_rate_rad_s});
  part.motion = Vector3(forward / timing.speed_m_s, lateral / timing.lateral_speed_m_s,
                        (b.yaw_rad - a.yaw_rad) / timing.yaw_rate_rad_s) /
                std::max(part.time_s, 1e-12);
  return part;
}

void Check(const std::vector<PlanarPose>& waypoints, const RouteTiming& timing) {
  if (waypoints.empty()) throw InvalidArgument("TimeRoute: there is no waypoint; one or more are needed");
  for (const double speed : {timing.speed_m_s, timing.lateral_speed_m_s, timing.yaw_rate_rad_s}) {
    if (!(speed > 0.0) || !std::isfinite(speed))
      throw InvalidArgument(fmt::format("TimeRoute: a speed is {}; it must be more than 0", speed));
  }
  if (!(timing.ramp_s >= 0.0))
    throw InvalidArgument(fmt::format("TimeRoute: the ramp is {} s; it must not be negative", timing.ramp_s));
}

/// Progress along a route in short pieces. Progress is the time at which the place would be reached at full speed.
struct Progress {
  std::vector<double> at_s;    ///< progress at the ends of the pieces, from 0
  std::vector<double> speed;   ///< speed at these ends, as a share of the full speed
  std::vector<double> time_s;  ///< time since departure
};

/// Speed profile within the limits of corners, with changes of at most 1 / ramp, from rest to rest. Within a piece, the
/// square of the speed is linear in progress.
Progress Profile(const std::vector<Part>& parts, double ramp_s) {
  Progress progress{{0.0}, {0.0}, {0.0}};
  std::vector<double> square = {0.0};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const int pieces = 1 + static_cast<int>(parts[i].time_s / kSampleStep);
    const double start = progress.at_s.back();
    for (int k = 1; k <= pieces; ++k) {
      progress.at_s.push_back(start + parts[i].time_s * k / pieces);
      square.push_back(1.0);
    }
    if (i + 1 == parts.size()) break;
    const double change = (parts[i + 1].motion - parts[i].motion).norm();
    if (change > kMostChange) square.back() = std::pow(kMostChange / change, 2);
  }
  square.front() = square.back() = 0.0;
  const std::size_t n = square.size();
  const double gain = 2.0 / std::max(ramp_s, 1e-9);
  for (std::size_t i = 1; i < n; ++i)
    square[i] = std::min(square[i], square[i - 1] + gain * (progress.at_s[i] - progress.at_s[i - 1]));
  for (std::size_t i = n - 1; i-- > 0;)
    square[i] = std::min(square[i], square[i + 1] + gain * (progress.at_s[i + 1] - progress.at_s[i]));
  for (std::size_t i = 1; i < n; ++i) {
    progress.speed.push_back(std::sqrt(square[i]));
    const double both = std::max(progress.speed[i - 1] + progress.speed[i], 1e-12);
    progress.time_s.push_back(progress.time_s.back() + 2.0 * (progress.at_s[i] - progress.at_s[i - 1]) / both);
  }
  return progress;
}

/// Progress at the sample times, averaged over the last `window` samples.
std::vector<double> Sampled(const Progress& progress, int window) {
  const double end = progress.time_s.back();
  const int samples = 1 + static_cast<int>(std::ceil(end / kSampleStep - 1e-9)) + window;
  std::vector<double> sum = {0.0}, averaged;
  std::size_t i = 0;
  for (int k = 0; k < samples; ++k) {
    const double t = k * kSampleStep;
    while (i + 2 < progress.time_s.size() && progress.time_s[i + 1] <= t) ++i;
    double at = progress.at_s.back();
    if (t < end) {
      const double step = progress.time_s[i + 1] - progress.time_s[i], into = t - progress.time_s[i];
      at = progress.at_s[i] +
           into * (progress.speed[i] + 0.5 * into / step * (progress.speed[i + 1] - progress.speed[i]));
    }
    sum.push_back(sum.back() + at);
    const int first = std::max(0, k - window);  // progress is 0 before the start
    averaged.push_back((sum[static_cast<std::size_t>(k + 1)] - sum[static_cast<std::size_t>(first)]) / (window + 1));
  }
  averaged.back() = progress.at_s.back();
  return averaged;
}

/// The timed parts of a route, and progress along it by sample.
struct Followed {
  std::vector<PlanarPose> pose;  ///< ends of the parts
  std::vector<double> at_s;      ///< progress at these ends
  std::vector<double> progress_s;
};

Followed Follow(const std::vector<PlanarPose>& waypoints, const RouteTiming& timing) {
  Check(waypoints, timing);
  Followed followed{{waypoints.front()}, {0.0}, {0.0}};
  std::vector<Part> parts;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const Part part = PartOf(waypoints[i - 1], waypoints[i], timing);
    if (part.time_s <= 0.0) continue;
    parts.push_back(part);
    followed.pose.push_back(waypoints[i]);
    followed.at_s.push_back(followed.at_s.back() + part.time_s);
  }
  if (parts.empty()) return followed;
  const double smoothing = kSmoothing * timing.ramp_s;
  followed.progress_s = Sampled(Profile(parts, timing.ramp_s - smoothing), static_cast<int>(smoothing / kSampleStep));
  return followed;
}

}  // namespace

BasePath TimeRoute(const std::vector<PlanarPose>& waypoints, const RouteTiming& timing) {
  const Followed followed = Follow(waypoints, timing);
  BasePath path;
  if (timing.start_s > 0.0) {
    path.time_s.push_back(0.0);
    path.pose.push_back(waypoints.front());
  }
  std::size_t i = 0;
  for (std::size_t k = 0; k < followed.progress_s.size(); ++k) {
    const double at = followed.progress_s[k];
    while (i + 2 < followed.at_s.size() && followed.at_s[i + 1] <= at) ++i;
    path.time_s.push_back(timing.start_s + static_cast<double>(k) * kSampleStep);
    if (followed.at_s.size() < 2) {
      path.pose.push_back(waypoints.front());
    } else {
      const double u = std::min(1.0, (at - followed.at_s[i]) / (followed.at_s[i + 1] - followed.at_s[i]));
      path.pose.push_back(Between(followed.pose[i], followed.pose[i + 1], u));
    }
  }
  if (path.time_s.back() < timing.end_s) {
    path.time_s.push_back(timing.end_s);
    path.pose.push_back(path.pose.back());
  }
  return path;
}

double RouteDuration(const std::vector<PlanarPose>& waypoints, const RouteTiming& timing) {
  return static_cast<double>(Follow(waypoints, timing).progress_s.size() - 1) * kSampleStep;
}

}  // namespace gaitwright
