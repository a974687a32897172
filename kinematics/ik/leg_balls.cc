// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/leg_balls.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {
namespace {

/// The motion of all parts beyond a joint of the chain, by the joint's position.
Pose MotionOf(const LegChain::Link& link, const VectorX& coordinates) {
  const double position = link.multiplier * coordinates[link.coordinate] + link.offset;
  Pose E = Pose::Identity();
  if (link.turns) {
    E.linear() = Eigen::AngleAxisd(position, link.axis_B).toRotationMatrix();
    E.translation() = link.point_B - E.linear() * link.point_B;
  } else {
    E.translation() = position * link.axis_B;
  }
  return E;
}

/// Positions of ball centres along one edge of a box, so that the balls are inside the box.
std::vector<double> Places(double low, double high, double radius, double spacing) {
  constexpr int kMost = 16;
  const double free = std::max(0.0, high - low - 2.0 * radius);
  const int parts = std::clamp(static_cast<int>(std::ceil(free / spacing - 0.5)), 0, kMost - 1);
  std::vector<double> places;
  for (int i = 0; i <= parts; ++i) {
    const double share = parts == 0 ? 0.5 : static_cast<double>(i) / parts;
    places.push_back(0.5 * (low + high) + (share - 0.5) * free);
  }
  return places;
}

}  // namespace

LegBalls::LegBalls(const RobotModel& model, int leg) : chain_(model, leg), spacing_m_(0.05 * chain_.length_m) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const Pose X_BW = FramePose(scratch, 0, Pose::Identity()).inverse();
  const Leg& described = model.legs[static_cast<std::size_t>(leg)];
  const Foot& foot = model.feet[static_cast<std::size_t>(described.foot)];
  Pose moved = Pose::Identity();
  for (std::size_t i = 0; i < chain_.links.size(); ++i) {
    moved = moved * MotionOf(chain_.links[i], chain_.standing);
    const Pose back = moved.inverse() * X_BW;
    for (const Shape& shape : model.collision_shapes) {
      if (shape.body != described.joints[i] + 1 || IsShapeOfFoot(foot, shape)) continue;
      Fill(shape, back * FramePose(scratch, shape.body, shape.X_BS), i);
    }
  }
}

void LegBalls::Fill(const Shape& shape, const Pose& X_BS, std::size_t link) {
  Vector3 low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = SupportPoint(shape, -Vector3::Unit(axis))[axis];
    high[axis] = SupportPoint(shape, Vector3::Unit(axis))[axis];
  }
  const double radius = 0.5 * (high - low).minCoeff(), spacing = std::max(2.0 * radius, spacing_m_);
  std::array<std::vector<double>, 3> places;
  for (int axis = 0; axis < 3; ++axis)
    places[static_cast<std::size_t>(axis)] = Places(low[axis], high[axis], radius, spacing);
  for (const double x : places[0])
    for (const double y : places[1])
      for (const double z : places[2]) balls_.push_back({link, X_BS * Vector3(x, y, z), radius});
}

void LegBalls::CentresAt(const VectorX& coordinates, std::vector<Vector3>& centres_B) const {
  Pose moved = Pose::Identity();
  std::size_t link = 0;
  for (const LinkBall& ball : balls_) {
    for (; link <= ball.link; ++link) moved = moved * MotionOf(chain_.links[link], coordinates);
    centres_B.emplace_back(moved * ball.centre_B);
  }
}

}  // namespace gaitwright
