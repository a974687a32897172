// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/collision/link_distances_internal.h"
#include "kinematics/collision/shape_extent.h"
#include "kinematics/model/shape_support.h"

namespace gaitwright {
namespace {

/// The corners of a box or a mesh; of a round shape, the point that is farthest along a direction, and for a cylinder
/// or a capsule the same point of its other end. In S.
std::vector<Vector3> CornersAlong(const Shape& shape, const Vector3& direction_S) {
  if (shape.type == ShapeType::kBox) return BoxCorners(shape.size);
  if (shape.type == ShapeType::kMesh) return shape.vertices;
  const Vector3 end = SupportPoint(shape, direction_S);
  if (shape.type == ShapeType::kSphere) return {end};
  return {end, end - Vector3(0.0, 0.0, std::copysign(shape.size.y(), direction_S.z()))};
}

/// The corner of a shape, in W, that is nearest to a half space, at least `apart_m` from all of some points of W;
/// nothing if there is none.
std::optional<Vector3> NextCorner(const std::vector<Vector3>& corners_S, const Pose& X_WS, const HalfSpace& side,
                                  double apart_m, const std::vector<ConvexDistance>& taken) {
  std::optional<Vector3> next_W;
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3& corner_S : corners_S) {
    const Vector3 corner_W = X_WS * corner_S;
    const double height = side.normal_W.dot(corner_W);
    const bool is_apart =
        std::ranges::all_of(taken, [&](const ConvexDistance& at) { return (at.p_WA - corner_W).norm() >= apart_m; });
    if (!is_apart || height >= least) continue;
    least = height;
    next_W = corner_W;
  }
  return next_W;
}

ConvexDistance PointOver(const HalfSpace& half_space, const Vector3& p_WA) {
  ConvexDistance at;
  at.n_W = -half_space.normal_W;
  at.p_WA = p_WA;
  at.distance_m = half_space.normal_W.dot(p_WA) - half_space.offset_m;
  at.p_WB = p_WA + at.distance_m * at.n_W;
  return at;
}

ConvexDistance ApartFrom(const HalfSpace& half_space, const Shape& shape, const Pose& X_WS) {
  return PointOver(half_space, X_WS * SupportPoint(shape, -(X_WS.linear().transpose() * half_space.normal_W)));
}

}  // namespace

LinkDistances::LinkDistances(const RobotModel& model, FixedSolids solids) : model_(model), solids_(std::move(solids)) {
  for (const Shape& shape : model.collision_shapes) parts_.push_back({BoundingRadius(shape)});
  for (const Shape& shape : solids_.shapes) parts_.push_back({BoundingRadius(shape)});
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const CollisionChecker checker(model);
  for (const auto& [a, b] : checker.pairs()) {
    pairs_.push_back({a, b, 0.0, -std::numeric_limits<double>::infinity()});
    pairs_.back().standing_m = At(num_pairs() - 1, scratch).distance_m;
  }
  AddSolidPairs(scratch);
}

/// Shapes of feet have no such pairs, because footholds and swings decide where feet are. Shapes that touch the ground
/// in the standing posture have none either.
void LinkDistances::AddSolidPairs(const DynamicsScratch& standing) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const HalfSpace ground;
  const int solids = static_cast<int>(solids_.shapes.size() + solids_.half_spaces.size());
  for (int a = 0; a < num_shapes(); ++a) {
    const bool of_foot =
        std::ranges::any_of(model_.feet, [&](const Foot& foot) { return IsShapeOfFoot(foot, ShapeOf(a)); });
    const double standing_m = ApartFrom(ground, ShapeOf(a), PoseOf(a, standing)).distance_m;
    for (int b = num_shapes(); b < num_shapes() + solids && !of_foot && standing_m > 0.0; ++b)
      pairs_.push_back({a, b, standing_m, -kNone});
  }
}

/// Null for a shape.
const HalfSpace* LinkDistances::HalfSpaceOf(int i) const {
  const int first = num_shapes() + static_cast<int>(solids_.shapes.size());
  return i < first ? nullptr : &solids_.half_spaces[Of(i - first)];
}

const Shape& LinkDistances::ShapeOf(int i) const {
  return IsSolid(i) ? solids_.shapes[Of(i - num_shapes())] : model_.collision_shapes[Of(i)];
}

const std::string& LinkDistances::NameOfPart(int i) const {
  const HalfSpace* half_space = HalfSpaceOf(i);
  return half_space != nullptr ? half_space->name : ShapeOf(i).link;
}

Pose LinkDistances::PoseOf(int i, const DynamicsScratch& scratch) const {
  const Shape& shape = ShapeOf(i);
  return IsSolid(i) ? shape.X_BS : FramePose(scratch, shape.body, shape.X_BS);
}

std::string LinkDistances::NameOf(int pair) const {
  return fmt::format("'{}' and '{}'", NameOfPart(pairs_[Of(pair)].a), NameOfPart(pairs_[Of(pair)].b));
}

ConvexDistance LinkDistances::At(int pair, const DynamicsScratch& scratch) const {
  const auto& [a, b, standing_m, free_m] = pairs_[Of(pair)];
  if (const HalfSpace* half_space = HalfSpaceOf(b)) return ApartFrom(*half_space, ShapeOf(a), PoseOf(a, scratch));
  return DistanceOf(ShapeOf(a), PoseOf(a, scratch), ShapeOf(b), PoseOf(b, scratch));
}

/// The half space of the plane side of a solid at a link's nearest point; nothing if an edge or a corner is nearest, or
/// a round side.
std::optional<HalfSpace> LinkDistances::SideFacing(int solid, const ConvexDistance& nearest) const {
  if (const HalfSpace* half_space = HalfSpaceOf(solid)) return *half_space;
  constexpr double kOnSide = 1e-6;  // [m]
  constexpr std::size_t kOfSide = 3;
  const Shape& shape = ShapeOf(solid);
  HalfSpace side{shape.link, -nearest.n_W, -nearest.n_W.dot(nearest.p_WB)};
  std::size_t on_side = 0;
  for (const Vector3& corner_S : CornersAlong(shape, shape.X_BS.linear().transpose() * side.normal_W))
    on_side += std::abs(side.normal_W.dot(shape.X_BS * corner_S) - side.offset_m) < kOnSide ? 1 : 0;
  if (on_side < kOfSide) return std::nullopt;
  return side;
}

void LinkDistances::PointsAt(int pair, const DynamicsScratch& scratch, std::vector<ConvexDistance>& points) const {
  constexpr double kApart = 0.2;  // of a link's radius
  const Pair& of = pairs_[Of(pair)];
  points.assign(1, At(pair, scratch));
  if (!IsSolid(of.b)) return;
  if (const std::optional<HalfSpace> side = SideFacing(of.b, points.front())) {
    const Shape& link = ShapeOf(of.a);
    const Pose X_WS = PoseOf(of.a, scratch);
    const std::vector<Vector3> corners_S = CornersAlong(link, -(X_WS.linear().transpose() * side->normal_W));
    while (static_cast<int>(points.size()) < kPointsOfSolids) {
      const auto next_W = NextCorner(corners_S, X_WS, *side, kApart * parts_[Of(of.a)].radius, points);
      if (!next_W) break;
      points.push_back(PointOver(*side, *next_W));
    }
  }
  points.resize(kPointsOfSolids, points.front());
}

/// The derivative of the position of a point of a body along a direction, without the columns of the base.
void LinkDistances::AddPointGradient(int body, const Vector3& p_WQ, const Vector3& along_W,
                                     const DynamicsScratch& scratch, Eigen::Ref<VectorX> gradient) const {
  while (body > 0) {
    const Joint& joint = model_.joints[Of(body - 1)];
    const Vector3& axis_W = scratch.axis_W[Of(body - 1)];
    const Vector3 moves_W = joint.is_prismatic() ? axis_W : axis_W.cross(p_WQ - scratch.p_WB[Of(body)]).eval();
    gradient[6 + joint.dof] += joint.multiplier * along_W.dot(moves_W);
    body = joint.parent_body;
  }
}

void LinkDistances::AddGradient(int pair, const ConvexDistance& at, const DynamicsScratch& scratch, double multiple,
                                Eigen::Ref<VectorX> gradient) const {
  const Pair& of = pairs_[Of(pair)];
  if (IsSolid(of.b)) {  // the base carries the link's point
    gradient.head<3>() -= multiple * at.n_W;
    gradient.segment<3>(3) -= multiple * (at.p_WA - scratch.p_WB[0]).cross(at.n_W);
  } else {
    AddPointGradient(ShapeOf(of.b).body, at.p_WB, multiple * at.n_W, scratch, gradient);
  }
  AddPointGradient(ShapeOf(of.a).body, at.p_WA, -multiple * at.n_W, scratch, gradient);
}

void LinkDistances::Move(const DynamicsScratch& scratch) {
  Pose X_WB = Pose::Identity();
  X_WB.linear() = scratch.R_WB[0];
  X_WB.translation() = scratch.p_WB[0];
  const Pose X_BW = X_WB.inverse();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    const Pose X_BS = X_BW * PoseOf(static_cast<int>(i), scratch);
    const double chord = (X_BS.linear() - part.X_BS.linear()).norm() / std::numbers::sqrt2;
    part.path_m += (X_BS.translation() - part.X_BS.translation()).norm() + part.radius * chord;
    part.X_BS = X_BS;
  }
}

const std::vector<NearPair>& LinkDistances::Near(const DynamicsScratch& scratch, double within_m) {
  Move(scratch);
  near_.clear();
  for (int i = 0; i < num_pairs(); ++i) {
    Pair& pair = pairs_[Of(i)];
    if (const HalfSpace* half_space = HalfSpaceOf(pair.b)) {
      const double middle_m = half_space->normal_W.dot(PoseOf(pair.a, scratch).translation()) - half_space->offset_m;
      if (middle_m - parts_[Of(pair.a)].radius >= within_m) continue;
      if (const double apart_m = At(i, scratch).distance_m; apart_m < within_m) near_.push_back({i, apart_m});
      continue;
    }
    const Part &a = parts_[Of(pair.a)], &b = parts_[Of(pair.b)];
    const double path_m = a.path_m + b.path_m;
    if (pair.free_m - path_m >= within_m) continue;
    double apart_m = (a.X_BS.translation() - b.X_BS.translation()).norm() - a.radius - b.radius;
    if (apart_m < within_m) apart_m = At(i, scratch).distance_m;
    pair.free_m = path_m + apart_m;
    if (apart_m < within_m) near_.push_back({i, apart_m});
  }
  return near_;
}

}  // namespace gaitwright
