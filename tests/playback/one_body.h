// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kinematics/model/robot_model.h"

/// Robots of one rigid body without joints; the foot is its contact with the ground.
namespace gaitwright::one_body {

inline constexpr double kMass = 2.0, kRadius = 0.1;

inline RobotModel OneBody(const Foot& foot, const Matrix3& inertia) {
  RobotModel model;
  model.name = "one_body";
  model.bodies.push_back({.name = "body", .mass = kMass, .I_C = inertia});
  model.total_mass_kg = kMass;
  model.feet = {foot};
  model.standing_joints = model.stiffness = model.damping = VectorX();
  return model;
}

/// A homogeneous ball.
inline RobotModel Ball() {
  Foot foot;
  foot.name = foot.link = "body";
  foot.type = FootType::kSphere;
  foot.radius = kRadius;
  return OneBody(foot, 0.4 * kMass * kRadius * kRadius * Matrix3::Identity());
}

/// A homogeneous block on its lower face.
inline RobotModel Block(double length, double width, double height) {
  Foot foot;
  foot.name = foot.link = "body";
  foot.type = FootType::kSole;
  foot.X_BF.translation() = Vector3(0.0, 0.0, -0.5 * height);
  const double x = 0.5 * length, y = 0.5 * width;
  foot.sole_F = {{x, -y}, {x, y}, {-x, y}, {-x, -y}};
  const Vector3 sides(length * length, width * width, height * height);
  const Vector3 moments = kMass / 12.0 * (Vector3::Constant(sides.sum()) - sides);
  return OneBody(foot, moments.asDiagonal());
}

/// A body above the origin at a distance from a slope that descends along x, turned along with it.
inline VectorX OnSlope(double height, double slope_rad) {
  VectorX q = VectorX::Zero(7);
  const Eigen::AngleAxisd turn(slope_rad, Vector3::UnitY());
  q[2] = height / std::cos(slope_rad);
  q.segment<4>(3) = Quaternion(turn).coeffs();
  return q;
}

}  // namespace gaitwright::one_body
