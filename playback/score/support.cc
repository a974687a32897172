// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/stability/polygon.h"
#include "planning/plan/heel_off_internal.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

constexpr double kCoplanar = 0.005;   // [m]
constexpr double kLineWidth = 0.001;  // [m]

/// Normal of the ground under a foot.
Vector3 NormalUnder(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain, int foot) {
  const Foot& f = model.feet[static_cast<std::size_t>(foot)];
  return GroundAt(terrain, FramePose(scratch, f.body, f.X_BF).translation().head<2>()).normal_W;
}

/// The point rounded to a grid of 1 nm. Points of one line with rounding errors then lie exactly on a line, as a hull
/// with a tolerance for collinear corners requires.
Vector2 OnGrid(const Vector3& p) {
  constexpr double kGrid = 1e-9;  // [m]
  return {kGrid * std::round(p.x() / kGrid), kGrid * std::round(p.y() / kGrid)};
}

/// The surfaces under a sole's corners, the middles of its edges and the middle of the sole.
std::vector<int> SurfacesUnder(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain) {
  std::vector<int> surfaces;
  const auto look = [&](const Vector2& p_F) {
    const int surface = GroundAt(terrain, (X_WF * Vector3(p_F.x(), p_F.y(), 0.0)).head<2>()).patch;
    if (surface >= 0 && std::find(surfaces.begin(), surfaces.end(), surface) == surfaces.end())
      surfaces.push_back(surface);
  };
  look(Centroid(sole_F));
  for (std::size_t i = 0; i < sole_F.size(); ++i) {
    look(sole_F[i]);
    look(0.5 * (sole_F[i] + sole_F[(i + 1) % sole_F.size()]));
  }
  return surfaces;
}

/// Points of a foot that can carry load at its pose. Of a sole: its parts on the patches below, except parts that lie
/// lower than others. All points of another foot, and of a sole without a patch or above a height field. Real ground
/// may be offset from the patches, so that only relative heights are used.
std::vector<Vector3> CarryingPoints(const Foot& foot, const Pose& X_WF, const Terrain& terrain) {
  constexpr double kInside = 1e-4;  // [m] keeps points on the patch itself
  constexpr double kLower = 0.004;  // [m]
  if (!foot.has_sole()) return ContactPoints(foot, X_WF);
  std::vector<std::pair<double, std::vector<Vector3>>> parts;  // least height over the patch, corners
  double least = std::numeric_limits<double>::infinity();
  for (const int surface : SurfacesUnder(foot.sole_F, X_WF, terrain)) {
    if (surface >= static_cast<int>(terrain.patches.size())) return ContactPoints(foot, X_WF);
    const TerrainPatch& patch = terrain.patches[static_cast<std::size_t>(surface)];
    auto& [height, points] = parts.emplace_back(std::numeric_limits<double>::infinity(), std::vector<Vector3>());
    for (const Vector2& p_F : PartOnPatch(foot.sole_F, X_WF, patch, kInside)) {
      points.emplace_back(X_WF * Vector3(p_F.x(), p_F.y(), 0.0));
      height = std::min(height, patch.X_WT.linear().col(2).dot(points.back() - patch.X_WT.translation()));
    }
    least = std::min(least, height);
  }
  std::vector<Vector3> carrying;
  for (const auto& [height, points] : parts) {
    if (height <= least + kLower) carrying.insert(carrying.end(), points.begin(), points.end());
  }
  return carrying.empty() ? ContactPoints(foot, X_WF) : carrying;
}

bool Coplanar(const std::vector<Vector3>& points, const Vector3& normal) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Vector3& p) { return std::abs((p - points.front()).dot(normal)) <= kCoplanar; });
}

}  // namespace

Pose ContactFrame(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain, int foot) {
  return ContactFrame(model, scratch, foot, NormalUnder(model, scratch, terrain, foot));
}

std::vector<Vector3> ContactPoints(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain,
                                   int foot) {
  return ContactPoints(model, scratch, foot, NormalUnder(model, scratch, terrain, foot));
}

Support SupportOf(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain, FootSet stance,
                  FootSet on_edge) {
  Support support;
  std::vector<Vector2> flat;
  std::vector<Vector3> ground;
  Vector3 normal = Vector3::Zero();
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    if (!Contains(stance, foot)) continue;
    support.tilts = stance == FootBit(foot) && model.feet[static_cast<std::size_t>(foot)].type == FootType::kLine;
    const Pose X_WF = ContactFrame(model, scratch, terrain, foot);
    Foot shape = model.feet[static_cast<std::size_t>(foot)];
    if (Contains(on_edge, foot)) shape.sole_F = FrontEdge(shape.sole_F);
    for (const Vector3& p : ContactPoints(shape, X_WF)) {
      support.points_W.push_back(p);
      support.reference_W += p;
    }
    for (const Vector3& p : CarryingPoints(shape, X_WF, terrain)) {
      flat.push_back(OnGrid(p));
      const GroundPoint below = GroundAt(terrain, p.head<2>());
      if (below.patch < 0) continue;
      normal += below.normal_W;
      ground.emplace_back(p.x(), p.y(), below.height_m);
    }
  }
  support.base_yaw_rad = YawOf(scratch.R_WB[0]);
  if (support.empty()) return support;
  support.reference_W /= static_cast<double>(support.points_W.size());
  support.normal_W = normal.norm() > 0.0 ? Vector3(normal.normalized()) : Vector3::UnitZ();
  support.coplanar = Coplanar(ground, support.normal_W);
  support.polygon = ConvexHull(std::move(flat));
  return support;
}

double PlaneHeight(const Support& support, const Vector2& p_W) {
  const Vector3& n = support.normal_W;
  return support.reference_W.z() - n.head<2>().dot(p_W - support.reference_W.head<2>()) / n.z();
}

bool HasArea(const Support& support) {
  const Polygon& polygon = support.polygon;
  if (support.tilts) return false;
  double perimeter = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) perimeter += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
  return Area(polygon) > 0.5 * perimeter * kLineWidth;
}

Vector2 SupportMotion::Back(const Vector2& p_W) const { return from_W + Eigen::Rotation2Dd(-yaw_rad) * (p_W - to_W); }

SupportMotion MotionBetween(const Support& planned, const Support& measured) {
  SupportMotion motion{planned.reference_W.head<2>(), measured.reference_W.head<2>(), 0.0};
  double dot = 0.0, cross = 0.0, spread = 0.0;
  for (std::size_t i = 0; i < std::min(planned.points_W.size(), measured.points_W.size()); ++i) {
    const Vector2 a = planned.points_W[i].head<2>() - motion.from_W;
    const Vector2 b = measured.points_W[i].head<2>() - motion.to_W;
    dot += a.dot(b);
    cross += a.x() * b.y() - a.y() * b.x();
    spread += a.squaredNorm();
  }
  motion.yaw_rad = spread > 1e-8 ? std::atan2(cross, dot) : WrapAngle(measured.base_yaw_rad - planned.base_yaw_rad);
  return motion;
}

}  // namespace gaitwright
