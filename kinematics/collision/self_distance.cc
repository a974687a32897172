// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <limits>
#include <numbers>
#include <utility>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/collision/self_distance_internal.h"
#include "kinematics/model/shape_support.h"

namespace gaitwright {

SelfDistance::SelfDistance(const RobotModel& model) : model_(model) {
  for (const Shape& shape : model.collision_shapes) parts_.push_back({BoundingRadius(shape)});
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const CollisionChecker checker(model);
  for (const auto& [a, b] : checker.pairs()) {
    pairs_.push_back({a, b, 0.0, -std::numeric_limits<double>::infinity()});
    pairs_.back().standing_m = At(num_pairs() - 1, scratch).distance_m;
  }
}

std::string SelfDistance::NameOf(int pair) const {
  return fmt::format("'{}' and '{}'", ShapeOf(pairs_[Of(pair)].a).link, ShapeOf(pairs_[Of(pair)].b).link);
}

ConvexDistance SelfDistance::At(int pair, const DynamicsScratch& scratch) const {
  const Shape &a = ShapeOf(pairs_[Of(pair)].a), &b = ShapeOf(pairs_[Of(pair)].b);
  return DistanceOf(a, FramePose(scratch, a.body, a.X_BS), b, FramePose(scratch, b.body, b.X_BS));
}

/// The derivative of the position of a point of a body along a direction, without the columns of the base.
void SelfDistance::AddPointGradient(int body, const Vector3& p_WQ, const Vector3& along_W,
                                    const DynamicsScratch& scratch, Eigen::Ref<VectorX> gradient) const {
  while (body > 0) {
    const Joint& joint = model_.joints[Of(body - 1)];
    const Vector3& axis_W = scratch.axis_W[Of(body - 1)];
    const Vector3 moves_W = joint.is_prismatic() ? axis_W : axis_W.cross(p_WQ - scratch.p_WB[Of(body)]).eval();
    gradient[6 + joint.dof] += joint.multiplier * along_W.dot(moves_W);
    body = joint.parent_body;
  }
}

void SelfDistance::AddGradient(int pair, const ConvexDistance& at, const DynamicsScratch& scratch, double multiple,
                               Eigen::Ref<VectorX> gradient) const {
  const Pair& of = pairs_[Of(pair)];
  AddPointGradient(ShapeOf(of.b).body, at.p_WB, multiple * at.n_W, scratch, gradient);
  AddPointGradient(ShapeOf(of.a).body, at.p_WA, -multiple * at.n_W, scratch, gradient);
}

void SelfDistance::Move(const DynamicsScratch& scratch) {
  Pose X_WB = Pose::Identity();
  X_WB.linear() = scratch.R_WB[0];
  X_WB.translation() = scratch.p_WB[0];
  const Pose X_BW = X_WB.inverse();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Shape& shape = model_.collision_shapes[i];
    Part& part = parts_[i];
    const Pose X_BS = X_BW * FramePose(scratch, shape.body, shape.X_BS);
    const double chord = (X_BS.linear() - part.X_BS.linear()).norm() / std::numbers::sqrt2;
    part.path_m += (X_BS.translation() - part.X_BS.translation()).norm() + part.radius * chord;
    part.X_BS = X_BS;
  }
}

const std::vector<NearPair>& SelfDistance::Near(const DynamicsScratch& scratch, double within_m) {
  Move(scratch);
  near_.clear();
  for (int i = 0; i < num_pairs(); ++i) {
    Pair& pair = pairs_[Of(i)];
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
