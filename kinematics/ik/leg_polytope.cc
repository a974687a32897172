// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/leg_polytope.h"

#include <algorithm>
#include <limits>

namespace gaitwright {
namespace {

/// Directions to the nodes of a grid on the surface of a cube, with `steps` to half an edge, always in the same order.
std::vector<Vector3> Directions(int steps) {
  std::vector<Vector3> directions;
  for (int x = -steps; x <= steps; ++x) {
    for (int y = -steps; y <= steps; ++y) {
      for (int z = -steps; z <= steps; ++z) {
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == steps)
          directions.push_back(Vector3(x, y, z).normalized());
      }
    }
  }
  return directions;
}

/// Rays from the standing position of a foot, along which the reach of its leg is tested.
class Rays {
 public:
  Rays(LegWorkspace& workspace, double farthest_m, const Vector3& up_B)
      : workspace_(workspace), farthest_m_(farthest_m), up_B_(up_B) {
    if (workspace.BallsAt(workspace.standing(), balls_)) HeightsOverFoot(workspace.standing(), standing_m_);
  }

  /// Reach of the foot along a direction [m].
  double Reach(const Vector3& direction) {
    constexpr double kSteps = 100.0;
    Pose X_BF = workspace_.standing();
    double reach = 0.0;
    for (double at = farthest_m_ / kSteps; at <= farthest_m_; at += farthest_m_ / kSteps) {
      X_BF.translation() = workspace_.standing().translation() + at * direction;
      if (!Stands(X_BF)) break;
      reach = at;
    }
    return reach;
  }

 private:
  /// Whether the leg reaches a pose of its foot without other parts coming close to the ground.
  bool Stands(const Pose& X_BF) {
    constexpr double kMargin = 0.1;  // share of farthest_m: smallest height of parts that stand twice as high or more
    if (!workspace_.Reaches(X_BF)) return false;
    if (standing_m_.empty()) return true;
    workspace_.BallsAt(X_BF, balls_);
    HeightsOverFoot(X_BF, heights_m_);
    for (std::size_t i = 0; i < heights_m_.size(); ++i) {
      if (standing_m_[i] > 2.0 * kMargin * farthest_m_ && heights_m_[i] < kMargin * farthest_m_) return false;
    }
    return true;
  }

  void HeightsOverFoot(const Pose& X_BF, std::vector<double>& heights_m) const {
    heights_m.clear();
    for (const Ball& ball : balls_) heights_m.push_back(up_B_.dot(ball.centre_B - X_BF.translation()) - ball.radius_m);
  }

  LegWorkspace& workspace_;
  const double farthest_m_;
  const Vector3 up_B_;
  std::vector<Ball> balls_;
  std::vector<double> standing_m_, heights_m_;  // by ball
};

}  // namespace

std::vector<WorkspaceSide> LegPolytope(LegWorkspace& workspace, double farthest_m, const Vector3& up_B) {
  constexpr int kCoarse = 1, kFine = 3;
  constexpr double kAlong = 1e-3;  // cosine below which a side does not end a ray
  constexpr double kLeast = 0.02;  // share of farthest_m: smallest distance of a side from the standing position
  const std::vector<Vector3> normals = Directions(kCoarse), rays = Directions(kFine);
  std::vector<double> reaches;
  Rays tried(workspace, farthest_m, up_B);
  for (const Vector3& ray : rays) reaches.push_back(tried.Reach(ray));
  std::vector<double> ends;
  for (const Vector3& normal : normals) ends.push_back(std::max(kLeast * farthest_m, tried.Reach(normal)));
  // If no side limits a ray to its reach, move the side that needs the smallest relative change. This also limits other
  // rays, so the shortest rays come first.
  std::vector<std::size_t> order(rays.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return reaches[a] < reaches[b]; });
  const auto end_of = [&](std::size_t side, const Vector3& ray) {
    const double along = normals[side].dot(ray);
    return along > kAlong ? ends[side] / along : std::numeric_limits<double>::infinity();
  };
  for (const std::size_t i : order) {
    double end = std::numeric_limits<double>::infinity();
    std::size_t moved = 0;
    double share = 0.0;
    for (std::size_t side = 0; side < normals.size(); ++side) {
      end = std::min(end, end_of(side, rays[i]));
      const double left = reaches[i] * normals[side].dot(rays[i]) / ends[side];
      if (left <= share) continue;
      share = left;
      moved = side;
    }
    if (end <= reaches[i]) continue;
    ends[moved] = std::max(kLeast * farthest_m, share * ends[moved]);
  }
  std::vector<bool> needed(normals.size(), false);
  for (const Vector3& ray : rays) {
    std::size_t first = 0;
    for (std::size_t side = 0; side < normals.size(); ++side) {
      if (end_of(side, ray) < end_of(first, ray)) first = side;
    }
    needed[first] = true;
  }
  std::vector<WorkspaceSide> sides;
  for (std::size_t side = 0; side < normals.size(); ++side) {
    if (needed[side])
      sides.push_back({normals[side], normals[side].dot(workspace.standing().translation()) + ends[side]});
  }
  return sides;
}

}  // namespace gaitwright
