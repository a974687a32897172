// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/stance_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kinematics/base/non_finite.h"
#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/base_height.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/spatial/rotation.h"
#include "planning/footsteps/plan_view.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/heel_off_internal.h"

namespace gaitwright {
namespace {

// Distance of the planned base from the base fitted to its feet, as a share of the leg length: during a stance the base
// moves on, and its height is smoothed. A lower base is worse for all legs.
constexpr double kDrift = 0.03;
constexpr double kUncrossed = 0.25;  // share of the feet's distance in the standing posture
constexpr std::array<double, 4> kHeights = {1.0, 0.95, 0.9, 0.85};  // base heights as shares of the standing height

Matrix3 TiltOf(const BaseOverFeet& base) {
  return YawRotation(base.plan.yaw_rad) * RotationExp(base.pitch_rad * Vector3::UnitY()) *
         RotationExp(base.roll_rad * Vector3::UnitX());
}

Pose PoseOver(const BaseOverFeet& base, double height_m) {
  Pose X_WB = Pose::Identity();
  X_WB.linear() = TiltOf(base);
  X_WB.translation() = Vector3(base.plan.x_m, base.plan.y_m, base.ground_m + height_m);
  return X_WB;
}

/// Corners of a box in B, transformed to W.
std::array<Vector3, 8> CornersOf(const Pose& X_WB, const Vector3& low, const Vector3& high) {
  std::array<Vector3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] = X_WB * Vector3((i & 1U) != 0 ? high.x() : low.x(), (i & 2U) != 0 ? high.y() : low.y(),
                                (i & 4U) != 0 ? high.z() : low.z());
  }
  return corners;
}

}  // namespace

std::string Describe(StanceFault fault) {
  static const std::array<std::string, 7> kWords = {"none",
                                                    "feet crossed or overlapping",
                                                    "out of reach of a leg",
                                                    "the body tilted too far",
                                                    "body too near to the ground",
                                                    "a thigh or shank too near to the ground",
                                                    "body too near to an obstacle"};
  return kWords[static_cast<std::size_t>(fault)];
}

std::vector<int> LoneSoles(const RobotModel& model, const Gait& gait) {
  std::vector<int> lone;
  for (const std::vector<int>& group : FootGroups(gait)) {
    if (group.size() + 1 != model.feet.size()) continue;
    for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
      if (std::find(group.begin(), group.end(), f) == group.end() && model.feet[static_cast<std::size_t>(f)].has_sole())
        lone.push_back(f);
    }
  }
  return lone;
}

StanceChecker::StanceChecker(const RobotModel& model, const GroundIndex& ground, const FootstepQuery& query,
                             const FootholdOptions& footholds, const FootstepSearchOptions& options)
    : model_(&model),
      ground_(&ground),
      query_(&query),
      options_(options),
      margin_m_(footholds.margin_m),
      standing_(StandingFeet(model)),
      workspaces_(options.workspaces != nullptr ? options.workspaces : std::make_shared<LegWorkspaces>()),
      lone_(LoneSoles(model, query.gait)),
      leg_room_(model, ground, options.leg_clearance * model.leg_length_m()),
      leg_m_(model.leg_length_m()) {
  for (int leg = 0; leg < static_cast<int>(model.legs.size()); ++leg) {
    legs_.push_back(&workspaces_->Of(model, leg, options.reserve));
  }
  MeasureBody(model);
}

void StanceChecker::MeasureBody(const RobotModel& model) {
  const std::vector<bool> of_leg = BodiesOfLegs(model);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const Pose X_BW = FramePose(scratch, 0, Pose::Identity()).inverse();
  trunk_low_.setConstant(kInfinity);
  whole_low_.setConstant(kInfinity);
  trunk_high_.setConstant(-kInfinity);
  whole_high_.setConstant(-kInfinity);
  for (const Shape& shape : model.collision_shapes) {
    const Pose X_BS = X_BW * FramePose(scratch, shape.body, shape.X_BS);
    Vector3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3 along_S = X_BS.linear().row(axis).transpose();
      low[axis] = (X_BS * SupportPoint(shape, -along_S))[axis];
      high[axis] = (X_BS * SupportPoint(shape, along_S))[axis];
    }
    whole_low_ = whole_low_.cwiseMin(low);
    whole_high_ = whole_high_.cwiseMax(high);
    if (of_leg[static_cast<std::size_t>(shape.body)]) continue;
    has_trunk_ = true;
    trunk_low_ = trunk_low_.cwiseMin(low);
    trunk_high_ = trunk_high_.cwiseMax(high);
  }
  if (lone_.empty()) return;
  for (const Pose& X_BF : standing_) {  // sway of the body above each of them
    const double sway = options_.easy_sway * X_BF.translation().y();
    (sway < 0.0 ? whole_low_ : whole_high_).y() += sway;
  }
}

BaseOverFeet StanceChecker::BaseOf(const std::vector<Pose>& X_WF) const {
  return FitBase(standing_, X_WF, MeanHeading(standing_, X_WF));
}

StanceFault StanceChecker::Check(const std::vector<Pose>& X_WF, const std::vector<const Polygon*>& outlines) {
  const BaseOverFeet base = BaseOf(X_WF);
  if (!FeetApart(X_WF, outlines, base.plan.yaw_rad)) return StanceFault::kFeetClose;
  constexpr double kSteepest = 40.0 * std::numbers::pi / 180.0;
  if (std::max(std::abs(base.pitch_rad), std::abs(base.roll_rad)) > kSteepest) return StanceFault::kTilt;
  const auto height = std::find_if(kHeights.begin(), kHeights.end(), [&](double share) {
    return ReachFrom(X_WF, PoseOver(base, BaseHeightAtShare(*model_, share)));
  });
  if (height == kHeights.end()) return StanceFault::kReach;
  const StanceFault fault = BodyRoom(base, PoseOver(base, model_->standing_base_height_m));
  if (fault != StanceFault::kNone) return fault;
  if (!LegsClear(X_WF, PoseOver(base, BaseHeightAtShare(*model_, *height)))) return StanceFault::kLegLow;
  if (query_->body_free && !query_->body_free(base.plan, base.ground_m)) return StanceFault::kBodyObstacle;
  return StanceFault::kNone;
}

bool StanceChecker::FeetApart(const std::vector<Pose>& X_WF, const std::vector<const Polygon*>& outlines,
                              double yaw_rad) const {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  for (std::size_t a = 0; a < X_WF.size(); ++a) {
    for (std::size_t b = a + 1; b < X_WF.size(); ++b) {
      const Vector2 d = (X_WF[b].translation() - X_WF[a].translation()).head<2>();
      const Vector2 d_B(c * d.x() + s * d.y(), c * d.y() - s * d.x());
      const Vector2 standing = (standing_[b].translation() - standing_[a].translation()).head<2>();
      if (d_B.dot(standing) < kUncrossed * standing.squaredNorm()) return false;
      if (d.squaredNorm() < leg_m_ * leg_m_ && !ApartBy(*outlines[a], *outlines[b], margin_m_)) return false;
    }
  }
  return true;
}

bool StanceChecker::AllReach(const std::vector<Pose>& X_WF, const Pose& X_WB) {
  const Pose X_BW = X_WB.inverse();
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const auto f = static_cast<std::size_t>(model_->legs[i].foot);
    Pose X_BF = X_BW * X_WF[f];
    X_BF.translation() += model_->feet[f].radius * X_BF.linear().col(2);
    if (!legs_[i]->Reaches(X_BF) && !ReachesRaised(i, X_BW, X_WF[f])) return false;
  }
  return true;
}

bool StanceChecker::ReachesRaised(std::size_t leg, const Pose& X_BW, const Pose& X_WF) {
  constexpr std::array<double, 3> kShares = {1.0 / 3.0, 2.0 / 3.0, 1.0};
  const Foot& foot = model_->feet[static_cast<std::size_t>(model_->legs[leg].foot)];
  return options_.heel_off_rad > 0.0 && foot.type == FootType::kSole &&
         std::any_of(kShares.begin(), kShares.end(), [&](double share) {
           return legs_[leg]->Reaches(X_BW * TurnedAboutEdge(foot, X_WF, share * options_.heel_off_rad));
         });
}

bool StanceChecker::ReachFrom(const std::vector<Pose>& X_WF, const Pose& X_WB) {
  if (!AllReach(X_WF, X_WB)) return false;
  return std::all_of(lone_.begin(), lone_.end(), [&](int f) {
    Pose moved = X_WB;
    const Vector3 to = X_WF[static_cast<std::size_t>(f)].translation() - X_WB.translation();
    moved.translation().head<2>() += options_.sway * to.head<2>();
    return AllReach(X_WF, moved);
  });
}

bool StanceChecker::LegsClear(const std::vector<Pose>& X_WF, const Pose& X_WB) {
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const auto f = static_cast<std::size_t>(model_->legs[i].foot);
    if (!leg_room_.MayMeet(X_WF[f])) continue;
    for (const double forward : {-kDrift, kDrift}) {
      Pose moved = X_WB;
      moved.translation() += leg_m_ * (forward * X_WB.linear().col(0) - kDrift * Vector3::UnitZ());
      if (!leg_room_.IsClear(*legs_[i], model_->feet[f], X_WF[f], moved)) return false;
    }
  }
  return true;
}

StanceFault StanceChecker::BodyRoom(const BaseOverFeet& base, const Pose& X_WB) const {
  if (has_trunk_) {
    const double clearance = options_.body_clearance * leg_m_;
    const auto corners = CornersOf(X_WB, trunk_low_, trunk_high_);
    double lowest = corners[0].z();
    Polygon plan;
    for (const Vector3& corner : corners) {
      lowest = std::min(lowest, corner.z());
      plan.emplace_back(corner.head<2>());
    }
    const PlanBox box = BoxOf(plan, 0.0);
    if (ground_->HighestIn(box.lowest, box.highest) > lowest - clearance) {
      constexpr int kLong = 8, kWide = 4;
      for (int i = 0; i <= kLong; ++i) {
        for (int k = 0; k <= kWide; ++k) {
          const Vector3 share(static_cast<double>(i) / kLong, static_cast<double>(k) / kWide, 0.0);
          const Vector3 p = X_WB * (trunk_low_ + share.cwiseProduct(trunk_high_ - trunk_low_));
          const GroundPoint under = ground_->At(p.head<2>());
          if (under.patch >= 0 && under.height_m > p.z() - clearance) return StanceFault::kBodyLow;
        }
      }
    }
  }
  if (ground_->obstacles().empty()) return StanceFault::kNone;
  Polygon plan;
  double bottom = base.ground_m + margin_m_, top = bottom;
  for (const Vector3& corner : CornersOf(X_WB, whole_low_, whole_high_)) {
    plan.emplace_back(corner.head<2>());
    top = std::max(top, corner.z());
  }
  plan = ConvexHull(plan);
  const PlanBox box = BoxOf(plan, margin_m_);
  std::vector<int> near;
  ground_->ObstaclesIn(box.lowest, box.highest, near);
  const bool hits = std::any_of(near.begin(), near.end(), [&](int i) {
    const ObstacleOutline& obstacle = ground_->obstacles()[static_cast<std::size_t>(i)];
    const double lift = options_.step_height * leg_m_;  // the legs step over obstacles up to this height
    if (obstacle.top_m <= bottom + lift || obstacle.bottom_m >= top) return false;
    return !ApartBy(plan, obstacle.outline_W, margin_m_);
  });
  return hits ? StanceFault::kBodyObstacle : StanceFault::kNone;
}

}  // namespace gaitwright
