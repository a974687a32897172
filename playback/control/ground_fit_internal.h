// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Estimate of the ground's height and slope relative to the plan, from the points on which soles stand.
///
/// A plane  dz = z0 + slope . (p - p0)  is fitted by least squares to the height errors dz of the contact points of
/// each foot's present stance and of its last one. The tilt of one sole is not the slope of the ground: on bumps it
/// changes with each step. The feet are farther apart than the edges of a sole and give a better slope.
class GroundFit {
 public:
  /// A contact point: its place in the plan, and its measured height above that place.
  struct Point {
    Vector2 p_W = Vector2::Zero();
    double rise_m = 0.0;
  };

  /// Forgets all points.
  void Reset(std::size_t feet);
  /// Records the present points of a foot in stance; they replace those of the same stance.
  void Stand(std::size_t foot, std::vector<Point> points);
  /// Ends the stance of a foot. Its points are kept until the end of the next one.
  void Leave(std::size_t foot);
  /// Fits the plane to all points. Without points the ground is as planned.
  void Fit();

  bool has_points() const { return has_points_; }
  /// Height of the ground above the plan's [m].
  double RiseAt(const Vector2& p_W) const { return rise_m_ + slope_.dot(p_W - middle_W_); }
  /// Rotation vector of the ground relative to the plan's.
  Vector3 Tilt_W() const { return {slope_.y(), -slope_.x(), 0.0}; }

 private:
  struct Stances {
    std::vector<Point> present, last;
    bool stands = false;
  };

  std::vector<Stances> feet_;
  bool has_points_ = false;
  Vector2 middle_W_ = Vector2::Zero(), slope_ = Vector2::Zero();
  double rise_m_ = 0.0;
};

}  // namespace gaitwright
