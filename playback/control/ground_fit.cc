// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <utility>

#include "playback/control/ground_fit_internal.h"

namespace gaitwright {

void GroundFit::Reset(std::size_t feet) {
  feet_.assign(feet, {});
  Fit();
}

void GroundFit::Stand(std::size_t foot, std::vector<Point> points) {
  Stances& stances = feet_.at(foot);
  if (!stances.stands) stances.last = std::move(stances.present);
  stances.stands = true;
  stances.present = std::move(points);
}

void GroundFit::Leave(std::size_t foot) { feet_.at(foot).stands = false; }

void GroundFit::Fit() {
  // Share of the points' spread that reduces the slope, so that points in a line give no slope across it.
  constexpr double kReduced = 0.01, kLeast = 1e-9;  // [1], [m^2]
  std::vector<Point> points;
  for (const Stances& stances : feet_) {
    points.insert(points.end(), stances.present.begin(), stances.present.end());
    points.insert(points.end(), stances.last.begin(), stances.last.end());
  }
  has_points_ = !points.empty();
  middle_W_ = slope_ = Vector2::Zero();
  rise_m_ = 0.0;
  if (!has_points_) return;
  for (const Point& point : points) {
    middle_W_ += point.p_W / static_cast<double>(points.size());
    rise_m_ += point.rise_m / static_cast<double>(points.size());
  }
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Vector2 right = Vector2::Zero();
  for (const Point& point : points) {
    const Vector2 arm = point.p_W - middle_W_;
    normal += arm * arm.transpose();
    right += (point.rise_m - rise_m_) * arm;
  }
  normal.diagonal().array() += kReduced * normal.trace() + kLeast;
  slope_ = normal.llt().solve(right);
}

}  // namespace gaitwright
