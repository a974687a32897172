// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/ground_watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/base/non_finite.h"
#include "kinematics/collision/shape_extent.h"
#include "planning/plan/terrain_shapes.h"

namespace gaitwright {
namespace {

constexpr double kLook = 0.25;   // [m] limit of the distance queries
constexpr double kGrain = 1e-4;  // [m] radius of the sphere used for a point

Shape BallOf(int body, const std::string& link, double radius_m) {
  Shape ball;
  ball.type = ShapeType::kSphere;
  ball.body = body;
  ball.link = link;
  ball.size.x() = radius_m;
  return ball;
}

/// Height above which nothing is solid [m].
double HighestSolid(const Terrain& terrain) {
  double highest = -kInfinity;
  for (const TerrainPatch& patch : terrain.patches) {
    const bool level = patch.X_WT.linear()(2, 2) > 1.0 - 1e-12;
    if (patch.outline_T.empty()) highest = std::max(highest, level ? patch.X_WT.translation().z() : kInfinity);
    for (const Vector3& corner : SolidUnder(patch)) highest = std::max(highest, corner.z());
  }
  for (const HeightField& field : terrain.height_fields) {
    for (const double height : field.height_m) highest = std::max(highest, height);
  }
  for (const Obstacle& obstacle : terrain.obstacles)
    highest = std::max(highest, obstacle.X_WO.translation().z() + BoundingRadius(ShapeOf(obstacle)));
  return highest;
}

/// Distance by which a shape extends beyond its foot's surface where that meets the ground. For a sphere or a point, at
/// any tilt up to 60 degrees.
double ReachBeyond(const Foot& foot, const Shape& shape, const Pose& X_FS) {
  double beyond = 0.0;
  const int tilts = foot.has_sole() ? 1 : 3, turns = foot.has_sole() ? 1 : 8;
  for (int tilt = 0; tilt < tilts; ++tilt) {
    for (int turn = 0; turn < turns; ++turn) {
      const double polar = tilt * std::numbers::pi / 6.0, azimuth = 2.0 * std::numbers::pi * turn / turns;
      const Vector3 down_F(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), -std::cos(polar));
      const Vector3 farthest_F = X_FS * SupportPoint(shape, X_FS.linear().transpose() * down_F);
      beyond = std::max(beyond, farthest_F.dot(down_F) - foot.radius);
    }
  }
  return beyond;
}

/// Upper bound of the motion of any point of a shape between two poses.
double MovedAtMost(const Pose& from, const Pose& to, double radius_m) {
  const double chord = (to.linear() - from.linear()).norm() / std::numbers::sqrt2;
  return (to.translation() - from.translation()).norm() + radius_m * chord;
}

}  // namespace

GroundWatch::GroundWatch(const RobotModel& model, const Terrain& terrain)
    : solids_(SolidsOf(terrain)), highest_m_(HighestSolid(terrain)), grain_(BallOf(0, "", kGrain)) {
  AddFeet(model);
  for (const Shape& shape : model.collision_shapes) AddShape(model, shape);
}

void GroundWatch::AddFeet(const RobotModel& model) {
  for (std::size_t f = 0; f < model.feet.size(); ++f) {
    const Foot& foot = model.feet[f];
    if (foot.radius <= 0.0) continue;
    Shape ball = BallOf(foot.body, foot.link, foot.radius);
    ball.X_BS = foot.X_BF;
    parts_.push_back({PreparedShape(ball), static_cast<int>(f)});
  }
}

void GroundWatch::AddShape(const RobotModel& model, const Shape& shape) {
  Part part{PreparedShape(shape)};
  for (std::size_t f = 0; f < model.feet.size() && part.foot < 0; ++f) {
    if (IsShapeOfFoot(model.feet[f], shape)) part.foot = static_cast<int>(f);
  }
  if (part.foot >= 0) {
    constexpr double kInside = 1e-6;  // [m]
    const Foot& foot = model.feet[static_cast<std::size_t>(part.foot)];
    part.X_FS = foot.X_BF.inverse() * shape.X_BS;
    if (part.X_FS.translation().norm() + part.shape.radius_m() <= foot.radius + kInside) return;  // in the ball
    part.reaches_m = ReachBeyond(foot, shape, part.X_FS);
  }
  parts_.push_back(std::move(part));
}

const std::vector<GroundHit>& GroundWatch::Look(const DynamicsScratch& scratch, const GroundLimits& limits) {
  hits_.clear();
  for (Part& part : parts_) {
    const Shape& shape = part.shape.shape();
    const auto body = static_cast<std::size_t>(shape.body);
    const double limit =
        part.foot < 0 ? limits.body_m : limits.foot_m[static_cast<std::size_t>(part.foot)] - part.reaches_m;
    const Vector3 middle = scratch.p_WB[body] + scratch.R_WB[body] * shape.X_BS.translation();
    if (middle.z() - part.shape.radius_m() > highest_m_ + limit) continue;
    const Pose X_WS = FramePose(scratch, shape.body, shape.X_BS);
    if (part.known_m - MovedAtMost(part.X_WS, X_WS, part.shape.radius_m()) >= limit) continue;
    part.X_WS = X_WS;
    part.known_m = solids_.Distance(part.shape, X_WS, kLook);
    if (!(part.known_m >= limit))
      hits_.push_back(
          {&shape.link, part.foot, part.known_m + part.reaches_m, static_cast<int>(&part - parts_.data()), shape.body});
  }
  return hits_;
}

ExitPlane GroundWatch::ExitPlaneOf(const GroundHit& hit) const {
  constexpr double kStep = 1e-3;  // [m]
  const Part& part = parts_[static_cast<std::size_t>(hit.part)];
  ExitPlane out;
  Vector3 slope = Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    Pose X_WS = part.X_WS;
    X_WS.translation()[axis] += kStep;
    slope[axis] = solids_.Distance(part.shape, X_WS, kLook);
    X_WS.translation()[axis] -= 2.0 * kStep;
    slope[axis] -= solids_.Distance(part.shape, X_WS, kLook);
  }
  if (slope.norm() > 0.0) out.normal_W = slope.normalized();
  out.p_W = part.X_WS * SupportPoint(part.shape.shape(), -(part.X_WS.linear().transpose() * out.normal_W));
  return out;
}

NearestSolid GroundWatch::NearestToFoot(int foot, const Pose& X_WF, double within_m) const {
  NearestSolid nearest{within_m, -1};
  for (const Part& part : parts_) {
    if (part.foot != foot) continue;
    const double within = std::max(nearest.distance_m - part.reaches_m, 0.0);
    const NearestSolid of_part = solids_.Nearest(part.shape, X_WF * part.X_FS, within);
    if (of_part.solid >= 0 && of_part.distance_m + part.reaches_m < nearest.distance_m)
      nearest = {of_part.distance_m + part.reaches_m, of_part.solid};
  }
  return nearest;
}

double GroundWatch::PointDistance(const Vector3& p_W) const {
  constexpr double kWithin = 0.1;  // [m]
  Pose X_WS = Pose::Identity();
  X_WS.translation() = p_W;
  return std::min(solids_.Distance(grain_, X_WS, kWithin) + kGrain, kWithin);
}

}  // namespace gaitwright
