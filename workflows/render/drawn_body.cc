// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

#include "kinematics/model/mesh_file.h"
#include "kinematics/spatial/convex_hull.h"
#include "playback/report/svg_tools.h"
#include "workflows/render/drawn_view_internal.h"

namespace gaitwright {
namespace {

constexpr int kRoundCorners = 24;  // corners of a polygon that approximates a circle

/// Points in S whose hull, enlarged by the returned radius, is the shape. Empty for a mesh without points.
double SpanningPoints(const Shape& shape, std::vector<Vector3>& points_S) {
  const Vector3 half = 0.5 * shape.size;
  switch (shape.type) {
    case ShapeType::kSphere:
      points_S = {Vector3::Zero()};
      return shape.size.x();
    case ShapeType::kCapsule:
      points_S = {Vector3(0.0, 0.0, -half.y()), Vector3(0.0, 0.0, half.y())};
      return shape.size.x();
    case ShapeType::kCylinder:
      for (int i = 0; i < kRoundCorners; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kRoundCorners;
        for (const double z : {-half.y(), half.y()})
          points_S.emplace_back(shape.size.x() * std::cos(turn), shape.size.x() * std::sin(turn), z);
      }
      return 0.0;
    case ShapeType::kBox:
      for (int i = 0; i < 8; ++i) {
        points_S.emplace_back((i & 1) != 0 ? half.x() : -half.x(), (i & 2) != 0 ? half.y() : -half.y(),
                              (i & 4) != 0 ? half.z() : -half.z());
      }
      return 0.0;
    case ShapeType::kMesh:
      break;
  }
  points_S = shape.vertices;
  return 0.0;
}

/// Points that span the hulls of mesh files; reads each file once.
class DrawnMeshes {
 public:
  explicit DrawnMeshes(const std::string& folder) : folder_(folder) {}

  /// The points of a file; empty if the file cannot be read.
  const std::vector<Vector3>& PointsOf(const std::string& file) {
    const auto [at, is_new] = points_.try_emplace(file);
    if (!is_new || folder_.empty()) return at->second;
    const Result<std::string> path = FindMeshFile(file, folder_);
    if (!path) return at->second;
    Result<Mesh> mesh = ReadMesh(*path);
    if (mesh) at->second = HullPoints(std::move(mesh->vertices));
    return at->second;
  }

 private:
  std::string folder_;
  std::map<std::string, std::vector<Vector3>> points_;
};

std::optional<DrawnSolid> SolidOf(const Shape& shape, const DynamicsScratch& scratch, DrawnMeshes& meshes) {
  DrawnSolid solid;
  solid.radius = SpanningPoints(shape, solid.points_W);
  if (solid.points_W.empty()) {
    for (const Vector3& p : meshes.PointsOf(shape.mesh_file)) solid.points_W.push_back(shape.size.cwiseProduct(p));
  }
  if (solid.points_W.empty()) return std::nullopt;
  const Pose X_WS = FramePose(scratch, shape.body, shape.X_BS);
  for (Vector3& p : solid.points_W) p = X_WS * p;
  return solid;
}

double DepthOf(const DrawnView& view, const DrawnSolid& solid) {
  const Vector3 sum = std::accumulate(solid.points_W.begin(), solid.points_W.end(), Vector3(Vector3::Zero()));
  return view.toward_W.dot(sum) / static_cast<double>(solid.points_W.size());
}

}  // namespace

std::vector<DrawnSolid> SolidsOf(const RobotModel& model, const DynamicsScratch& scratch,
                                 const std::string& mesh_folder) {
  DrawnMeshes meshes(mesh_folder);
  std::vector<DrawnSolid> solids;
  std::set<std::string> seen;  // links with visual geometry that is drawn
  const auto add = [&](const Shape& shape) {
    std::optional<DrawnSolid> solid = SolidOf(shape, scratch, meshes);
    if (solid) solids.push_back(std::move(*solid));
    return solid.has_value();
  };
  for (const Shape& shape : model.visual_shapes) {
    if (add(shape)) seen.insert(shape.link);
  }
  for (const Shape& shape : model.collision_shapes) {
    if (seen.count(shape.link) == 0) add(shape);
  }
  return solids;
}

std::vector<Vector2> OutlineOf(const DrawnView& view, const DrawnSolid& solid) {
  std::vector<Vector2> points;
  for (const Vector3& p_W : solid.points_W) {
    const Vector2 p = view.InPlane(p_W);
    if (solid.radius <= 0.0) {
      points.push_back(p);
      continue;
    }
    for (int i = 0; i < kRoundCorners; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kRoundCorners;
      points.emplace_back(p + solid.radius * Vector2(std::cos(turn), std::sin(turn)));
    }
  }
  return ConvexHull(points);
}

std::string DrawnBody(const DrawnView& view, const RobotModel& model, const DynamicsScratch& scratch,
                      const std::vector<DrawnSolid>& solids) {
  std::vector<const DrawnSolid*> order;
  for (const DrawnSolid& solid : solids) order.push_back(&solid);
  std::stable_sort(order.begin(), order.end(),
                   [&](const DrawnSolid* a, const DrawnSolid* b) { return DepthOf(view, *a) < DepthOf(view, *b); });
  std::string svg;
  for (const DrawnSolid* solid : order) {
    std::string points;
    for (const Vector2& p : OutlineOf(view, *solid)) {
      const Vector2 px = view.PlaneToPx(p);
      points += fmt::format("{:.1f},{:.1f} ", px.x(), px.y());
    }
    svg += "<polygon class=\"solid\" points=\"" + points + "\"/>";
  }
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const auto parent = static_cast<std::size_t>(model.joints[j].parent_body);
    svg += SvgSegment(view.ToPx(scratch.p_WB[parent]), view.ToPx(scratch.p_WB[j + 1]), "bone");
  }
  for (const Foot& foot : model.feet) {
    const Vector3 p_WF = FramePose(scratch, foot.body, foot.X_BF).translation();
    svg += SvgSegment(view.ToPx(scratch.p_WB[static_cast<std::size_t>(foot.body)]), view.ToPx(p_WF), "bone");
  }
  return svg;
}

}  // namespace gaitwright
