// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/pose_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/spatial/dense_solvers.h"
#include "kinematics/spatial/rotation.h"
#include "planning/paths/travel_cost.h"
#include "planning/plan/terrain_shapes.h"

namespace gaitwright {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string SurfaceName(const Terrain& terrain, int surface) {
  const auto i = static_cast<std::size_t>(surface), patches = terrain.patches.size();
  const std::string& name = i < patches ? terrain.patches[i].name : terrain.height_fields[i - patches].name;
  return name.empty() ? fmt::format("surface {}", i) : name;
}

/// Text on the width of the gap through a point, along a heading.
std::string GapAlong(const Terrain& terrain, const Vector2& p_W, double yaw) {
  constexpr double kStep = 0.005, kFar = 5.0;  // [m]
  const Vector2 forward(std::cos(yaw), std::sin(yaw));
  const auto until_ground = [&](double sign) {
    double gone = 0.0;
    while (gone < kFar && GroundAt(terrain, p_W + sign * gone * forward).patch < 0) gone += kStep;
    return gone;
  };
  const double before = until_ground(-1.0), after = until_ground(1.0);
  if (before >= kFar || after >= kFar) return "the ground ends there";
  const Vector2 edge = p_W - before * forward;
  return fmt::format("the gap from ({:.2f}, {:.2f}) on is {:.2f} m wide", edge.x(), edge.y(), before + after);
}

Terrain WithoutFields(const Terrain& terrain) { return {terrain.name, terrain.patches, {}, terrain.obstacles}; }

Terrain ObstaclesOf(const Terrain& terrain) { return {terrain.name, {}, {}, terrain.obstacles}; }

/// A lattice of offsets within an ellipse, sorted by distance.
std::vector<Vector2> OffsetsWithin(double forward, double lateral, double spacing) {
  std::vector<Vector2> offsets;
  const int columns = static_cast<int>(forward / spacing), rows = static_cast<int>(lateral / spacing);
  for (int i = -columns; i <= columns; ++i) {
    for (int j = -rows; j <= rows; ++j) {
      const Vector2 offset(i * spacing, j * spacing);
      if (std::hypot(offset.x() / std::max(forward, spacing), offset.y() / std::max(lateral, spacing)) <= 1.0)
        offsets.push_back(offset);
    }
  }
  std::stable_sort(offsets.begin(), offsets.end(),
                   [](const Vector2& a, const Vector2& b) { return a.squaredNorm() < b.squaredNorm(); });
  return offsets;
}

/// Matrix that maps heights to the slope of the best-fit plane; zero in directions without enough spread.
MatrixX SlopeOfHeights(const std::vector<Vector2>& feet, const Vector2& middle) {
  constexpr double kSpread = 0.05;  // share of the largest spread
  const auto n = static_cast<Eigen::Index>(feet.size());
  MatrixX places(n, 2);
  for (Eigen::Index f = 0; f < n; ++f) places.row(f) = (feet[static_cast<std::size_t>(f)] - middle).transpose();
  if (n <= 2 || places.col(0).norm() <= kSpread * places.col(1).norm()) return MatrixX::Zero(2, n);
  const MatrixX from_centred = SolveLeastSquares(places, MatrixX::Identity(n, n));
  return from_centred * (MatrixX::Identity(n, n) - MatrixX::Constant(n, n, 1.0 / static_cast<double>(n)));
}

}  // namespace

PoseCheck::PoseCheck(const RobotModel& model, const Terrain& terrain, const BodySpaceOptions& options)
    : model_(model),
      terrain_(terrain),
      space_(BodySpaceOf(model, options)),
      scene_(SolidsOf(WithoutFields(terrain))),
      obstacles_(SolidsOf(ObstaclesOf(terrain))),
      map_(terrain, obstacles_, space_),
      offsets_(OffsetsWithin(space_.reach_forward_m, space_.reach_lateral_m, map_.resolution_m())) {
  for (const Vector2& foot : space_.feet_G) middle_G_ += foot / static_cast<double>(space_.feet_G.size());
  slope_of_heights_ = SlopeOfHeights(space_.feet_G, middle_G_);
  height_m_.resize(space_.feet_G.size());
  nearest_m_.resize(space_.feet_G.size());
  local_slope_.resize(space_.feet_G.size(), Vector2::Zero());
  if (!space_.boxes.empty()) half_legs_ = 0.5 * space_.boxes.front().size.head<2>();
  for (const Shape& box : space_.boxes) boxes_.emplace_back(box);
  for (const HeightField& field : terrain.height_fields) fields_.emplace_back(field);
  step_m_ = std::max(space_.margin_m, 0.02 * space_.leg_length_m);
}

bool PoseCheck::NearestFootholds(const PlanarPose& at, Footing& footing) {
  const Eigen::Rotation2Dd R(at.yaw_rad);
  for (std::size_t f = 0; f < space_.feet_G.size(); ++f) {
    const double side = space_.feet_G[f].y() < 0.0 ? -1.0 : 1.0;  // so that left and right are treated alike
    bool found = false;
    for (const Vector2& offset : offsets_) {
      const Vector2 p_G = space_.feet_G[f] + Vector2(offset.x(), side * offset.y());
      const FootholdMap::Cell& cell = map_.At(Vector2(at.x_m, at.y_m) + R * p_G);
      if (cell.kind != FootholdMap::Kind::kFoothold) continue;
      height_m_[f] = cell.height_m;
      local_slope_[f] = Vector2(cell.by_x, cell.by_y);
      found = true;
      break;
    }
    if (!found) footing.lacking = static_cast<int>(f);
    if (!found) return false;
  }
  return true;
}

bool PoseCheck::FootholdsNear(const PlanarPose& at, double height_m) {
  const Eigen::Rotation2Dd R(at.yaw_rad);
  for (std::size_t f = 0; f < space_.feet_G.size(); ++f) {
    const double side = space_.feet_G[f].y() < 0.0 ? -1.0 : 1.0;
    double best = 1e9;
    for (const Vector2& offset : offsets_) {
      const Vector2 p_G = space_.feet_G[f] + Vector2(offset.x(), side * offset.y());
      const FootholdMap::Cell& cell = map_.At(Vector2(at.x_m, at.y_m) + R * p_G);
      if (cell.kind != FootholdMap::Kind::kFoothold || std::abs(cell.height_m - height_m) >= best) continue;
      best = std::abs(cell.height_m - height_m);
      height_m_[f] = cell.height_m;
      local_slope_[f] = Vector2(cell.by_x, cell.by_y);
    }
    if (best > 1e8) return false;
  }
  return true;
}

void PoseCheck::FitPlane(const PlanarPose& at, Footing& footing) const {
  double mean = 0.0;
  footing.slope_G.setZero();
  for (std::size_t f = 0; f < height_m_.size(); ++f) {
    mean += height_m_[f] / static_cast<double>(height_m_.size());
    footing.slope_G += slope_of_heights_.col(static_cast<Eigen::Index>(f)) * height_m_[f];
  }
  footing.height_m = mean - footing.slope_G.dot(middle_G_);
  footing.tilted = footing.slope_G.norm() > std::tan(space_.max_tilt_rad);
  footing.too_high = -1;
  double worst = space_.step_height_m;
  const bool level = height_m_.size() <= 2;
  for (std::size_t f = 0; f < height_m_.size(); ++f) {
    const double off = std::abs(height_m_[f] - footing.height_m - footing.slope_G.dot(space_.feet_G[f]));
    if ((level ? 2.0 * off : off) <= worst) continue;
    worst = level ? 2.0 * off : off;
    footing.too_high = static_cast<int>(f);
  }
  footing.rise_m = 0.0;
  if (!level) return;
  // The plane through two feet has no defined slope, so the local ground of each foot is used.
  Vector2 slope_W = Vector2::Zero();
  for (const Vector2& slope : local_slope_) slope_W += slope / static_cast<double>(local_slope_.size());
  const Vector2 slope_G = Eigen::Rotation2Dd(-at.yaw_rad) * slope_W;
  footing.rise_m = slope_G.cwiseAbs().dot(half_legs_);
}

PoseCheck::Footing PoseCheck::FootingAt(const PlanarPose& at) {
  Footing nearest;
  if (!NearestFootholds(at, nearest)) return nearest;
  FitPlane(at, nearest);
  nearest.clear = nearest.stands() && IsClear(at, nearest);
  if (nearest.clear) return nearest;
  nearest_m_ = height_m_;
  std::sort(nearest_m_.begin(), nearest_m_.end());  // so that the order of the feet does not matter
  if (nearest_m_.front() == nearest_m_.back()) return nearest;
  for (const double height : nearest_m_) {
    Footing other;
    if (!FootholdsNear(at, height)) continue;
    FitPlane(at, other);
    other.clear = other.stands() && IsClear(at, other);
    if (other.clear) return other;
    if (other.stands() && !nearest.stands()) nearest = other;
  }
  return nearest;
}

Pose PoseCheck::PlaneAt(const PlanarPose& at, const Footing& footing) const {
  Pose X_WG = Pose::Identity();
  const double pitch = -std::atan(footing.slope_G.x()), roll = std::atan(footing.slope_G.y() * std::cos(pitch));
  X_WG.linear() = YawRotation(at.yaw_rad);
  if (footing.slope_G != Vector2::Zero()) {
    X_WG.linear() *= (Eigen::AngleAxisd(pitch, Vector3::UnitY()) * Eigen::AngleAxisd(roll, Vector3::UnitX())).matrix();
  }
  X_WG.translation() = Vector3(at.x_m, at.y_m, footing.height_m);
  return X_WG;
}

Pose PoseCheck::PoseOfBox(std::size_t box, const Pose& X_WG, double rise_m) const {
  Pose X_WS = X_WG * boxes_[box].shape().X_BS;
  if (box == 0) X_WS.translation().z() += rise_m;
  return X_WS;
}

bool PoseCheck::IsClear(const PlanarPose& at, const Footing& footing) const {
  const Pose X_WG = PlaneAt(at, footing);
  for (std::size_t box = 0; box < boxes_.size(); ++box) {
    const Pose X_WS = PoseOfBox(box, X_WG, footing.rise_m);
    for (const FieldRoom& field : fields_) {
      if (field.Touches(boxes_[box].shape(), X_WS)) return false;
    }
    if (scene_.Touches(boxes_[box], X_WS)) return false;
  }
  return true;
}

bool PoseCheck::IsFree(const PlanarPose& at) {
  ++num_checks_;
  return FootingAt(at).clear;
}

bool PoseCheck::IsFreeBetween(const PlanarPose& a, const PlanarPose& b) {
  if (!IsFree(b)) return false;
  const double moved = std::hypot(b.x_m - a.x_m, b.y_m - a.y_m) + space_.radius_m * std::abs(b.yaw_rad - a.yaw_rad);
  const int n = static_cast<int>(std::ceil(moved / step_m_));
  int stride = 1;
  while (2 * stride < n) stride *= 2;
  // The middle first: obstacles in between are found sooner.
  for (; stride >= 1; stride /= 2) {
    for (int k = stride; k < n; k += 2 * stride) {
      if (!IsFree(Between(a, b, static_cast<double>(k) / n))) return false;
    }
  }
  return true;
}

bool PoseCheck::IsFreeAlong(const std::vector<PlanarPose>& path) {
  std::size_t stride = 1;
  while (2 * stride < path.size()) stride *= 2;
  // The middle first: obstacles in between are found sooner.
  for (std::size_t s = stride; s > 1; s /= 2) {
    for (std::size_t i = s; i < path.size(); i += 2 * s) {
      if (!IsFree(path[i])) return false;
    }
  }
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!IsFreeBetween(path[i - 1], path[i])) return false;
  }
  return true;
}

Hindrance PoseCheck::NoFoothold(const PlanarPose& at, const Footing& footing) {
  const auto f = static_cast<std::size_t>(std::max(footing.lacking, footing.too_high));
  const Vector2 p_W = Vector2(at.x_m, at.y_m) + Eigen::Rotation2Dd(at.yaw_rad) * space_.feet_G[f];
  const std::string place = fmt::format("foot '{}' at ({:.2f}, {:.2f})", model_.feet[f].name, p_W.x(), p_W.y());
  const GroundPoint ground = GroundAt(terrain_, p_W);
  Hindrance hindrance{ground.patch < 0 ? "" : SurfaceName(terrain_, ground.patch), at, ""};
  const double slope_deg = kDegrees * std::acos(std::clamp(ground.normal_W.z(), -1.0, 1.0));
  if (footing.too_high >= 0) {
    hindrance.text = fmt::format("{}: '{}' is more than a step of {:.3f} m above or below the ground of the other feet",
                                 place, hindrance.what, space_.step_height_m);
  } else if (ground.patch < 0) {
    hindrance.text = fmt::format("there is no ground for {}, which reaches {:.2f} m from its nominal position; {}",
                                 place, space_.reach_forward_m, GapAlong(terrain_, p_W, at.yaw_rad));
  } else if (map_.At(p_W).kind == FootholdMap::Kind::kTooSteep) {
    hindrance.text = fmt::format(
        "'{}' is too steep for {}: {:.1f} deg; the slope limit is {:.1f} deg and the friction limit {:.1f} deg",
        hindrance.what, place, slope_deg, kDegrees * space_.max_slope_rad, kDegrees * std::atan(ground.friction));
  } else {
    hindrance.text = fmt::format("'{}' has no free place large enough for {}", hindrance.what, place);
  }
  return hindrance;
}

std::optional<Hindrance> PoseCheck::ReasonRefused(const PlanarPose& at) {
  const Footing footing = FootingAt(at);
  if (footing.lacking >= 0 || footing.too_high >= 0) return NoFoothold(at, footing);
  const std::string place = fmt::format("at ({:.2f}, {:.2f}), facing {:.2f} rad", at.x_m, at.y_m, at.yaw_rad);
  if (footing.tilted) {
    const int surface = GroundAt(terrain_, {at.x_m, at.y_m}).patch;
    return Hindrance{surface < 0 ? "" : SurfaceName(terrain_, surface), at,
                     fmt::format("the ground under its feet {} is tilted by {:.1f} deg; {:.1f} deg are accepted", place,
                                 kDegrees * std::atan(footing.slope_G.norm()), kDegrees * space_.max_tilt_rad)};
  }
  if (footing.clear) return std::nullopt;
  const Pose X_WG = PlaneAt(at, footing);
  NearestSolid deepest{space_.margin_m, -1};
  std::string field;
  for (std::size_t box = 0; box < boxes_.size(); ++box) {
    const Pose X_WS = PoseOfBox(box, X_WG, footing.rise_m);
    const NearestSolid nearest = scene_.Nearest(boxes_[box], X_WS, deepest.distance_m);
    if (nearest.solid >= 0) deepest = nearest;
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      if (fields_[f].Touches(boxes_[box].shape(), X_WS))
        field = SurfaceName(terrain_, static_cast<int>(terrain_.patches.size() + f));
    }
  }
  const std::string name = field.empty() ? scene_.SolidName(std::max(deepest.solid, 0)) : field;
  return Hindrance{name, at, fmt::format("'{}' blocks the robot {}", name, place)};
}

}  // namespace gaitwright
