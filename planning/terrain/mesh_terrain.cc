// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/mesh_terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "kinematics/stability/polygon.h"
#include "planning/terrain/flat_pieces.h"
#include "planning/terrain/sense.h"

namespace gaitwright {
namespace {

/// Faces steeper than this are walls between two heights and not ground [rad].
constexpr double kWall = 88.0 * std::numbers::pi / 180.0;

/// Largest number of height field points visited for all triangles together; takes a few seconds.
constexpr long kMostLooks = 200000000;

using Box = Eigen::AlignedBox2d;

/// The corners of a triangle, counter-clockwise from above for an upward triangle.
std::array<Vector3, 3> Corners(const Mesh& mesh, std::size_t triangle) {
  const Eigen::Vector3i& t = mesh.triangles[triangle];
  return {mesh.vertices[static_cast<std::size_t>(t[0])], mesh.vertices[static_cast<std::size_t>(t[1])],
          mesh.vertices[static_cast<std::size_t>(t[2])]};
}

bool LooksUp(const std::array<Vector3, 3>& c) {
  const Vector3 normal = (c[1] - c[0]).cross(c[2] - c[0]);
  return normal.z() > std::cos(kWall) * normal.norm();
}

/// The mesh in metres at its place. @throws InvalidArgument for a corner that is too far away.
Mesh Placed(const Mesh& mesh, const MeshTerrainOptions& options) {
  Mesh placed = mesh;
  for (std::size_t i = 0; i < placed.vertices.size(); ++i) {
    Vector3& v = placed.vertices[i];
    v = options.scale * v + Vector3(options.x_m, options.y_m, options.z_m);
    if (v.head<2>().cwiseAbs().maxCoeff() <= kFarthest && std::abs(v.z()) <= kHighest) continue;
    throw InvalidArgument(
        fmt::format("has corner {} at ({:.6g}, {:.6g}, {:.6g}) m; accepted: {} m around the origin, {} m up and down; "
                    "if it is in millimetres, write ':scale=0.001'",
                    i + 1, v.x(), v.y(), v.z(), kFarthest, kHighest));
  }
  return placed;
}

/// Moves corners vertically into their best-fit plane and keeps only those of their hull in plan view, so that rounding
/// leaves the outline flat and convex.
std::vector<Vector3> InOnePlane(const std::vector<Vector3>& corners) {
  Vector3 middle = Vector3::Zero(), normal = Vector3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    middle += corners[i] / static_cast<double>(corners.size());
    normal += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  }
  std::vector<Vector2> plan;
  for (const Vector3& corner : corners) plan.emplace_back(corner.head<2>());
  std::vector<Vector3> flat;
  for (const Vector2& p : ConvexHull(plan)) {
    const double height = middle.z() - normal.head<2>().dot(p - middle.head<2>()) / normal.z();
    flat.emplace_back(p.x(), p.y(), height);
  }
  return flat;
}

/// Whether a circle of the size of a foot fits in.
bool HasRoom(const TerrainPatch& patch, double least_m) { return !Shrunk(patch.outline_T, 0.5 * least_m).empty(); }

/// Raises the height field to a triangle. @return number of visited points.
long Raise(const std::array<Vector3, 3>& c, HeightField& field) {
  const Vector2 a = c[0].head<2>(), ab = c[1].head<2>() - a, ac = c[2].head<2>() - a;
  const double area = Cross(ab, ac);
  Box box;
  for (const Vector3& corner : c) box.extend((corner.head<2>() - field.origin_W) / field.resolution_m);
  constexpr double kRim = 1e-9;  // tolerance of barycentric coordinates, so that no point between triangles is missed
  const int row0 = std::max(0, static_cast<int>(std::floor(box.min().y())));
  const int row1 = std::min(field.rows - 1, static_cast<int>(std::ceil(box.max().y())));
  const int column0 = std::max(0, static_cast<int>(std::floor(box.min().x())));
  const int column1 = std::min(field.columns - 1, static_cast<int>(std::ceil(box.max().x())));
  for (int row = row0; row <= row1; ++row) {
    for (int column = column0; column <= column1; ++column) {
      const Vector2 p = field.origin_W + field.resolution_m * Vector2(column, row) - a;
      const double u = Cross(p, ac) / area, v = Cross(ab, p) / area;
      if (u < -kRim || v < -kRim || u + v > 1.0 + kRim) continue;
      double& height = field.height_m[static_cast<std::size_t>(row * field.columns + column)];
      height = std::max(height, c[0].z() + u * (c[1].z() - c[0].z()) + v * (c[2].z() - c[0].z()));
    }
  }
  return row1 < row0 || column1 < column0 ? 0L : (row1 - row0 + 1L) * (column1 - column0 + 1L);
}

/// Heights of the mesh's highest points over a box. @throws InvalidArgument if too many visits are needed.
HeightField FieldOver(const Mesh& mesh, const Box& box, double lowest, const MeshTerrainOptions& options) {
  const Vector2 cells = (box.sizes() / options.resolution_m).array().ceil().max(1.0);
  if ((cells.x() + 1.0) * (cells.y() + 1.0) > kMostNodes) {
    throw InvalidArgument(
        fmt::format("needs {:.0f} by {:.0f} points at resolution_m {}; at most {} points in all are accepted",
                    cells.x() + 1.0, cells.y() + 1.0, options.resolution_m, kMostNodes));
  }
  HeightField field;
  field.name = "height field";
  field.origin_W = box.min();
  field.resolution_m = options.resolution_m;
  field.columns = static_cast<int>(cells.x()) + 1;
  field.rows = static_cast<int>(cells.y()) + 1;
  field.friction = options.friction;
  field.height_m.assign(static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows), lowest);
  long looked_at = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<Vector3, 3> corners = Corners(mesh, t);
    if (LooksUp(corners)) looked_at += Raise(corners, field);
    if (looked_at > kMostLooks) {
      throw InvalidArgument(fmt::format(
          "has faces that overlap {} times or more on average at the {} points of its height field; remove hidden "
          "faces, or give a larger resolution_m",
          looked_at / static_cast<long>(field.height_m.size()), field.height_m.size()));
    }
  }
  return field;
}

Terrain Make(const Mesh& mesh, const MeshTerrainOptions& options) {
  Terrain terrain;
  std::vector<char> covered(mesh.triangles.size(), 0);
  for (const FlatPiece& piece : FlatPieces(mesh, options.steepest_deg * std::numbers::pi / 180.0)) {
    if (piece.corners.size() < 3) continue;
    const std::vector<Vector3> corners = InOnePlane(piece.corners);
    if (corners.size() < 3) continue;
    TerrainPatch patch = PatchThrough(fmt::format("face {}", terrain.patches.size() + 1), corners, options.friction);
    if (!HasRoom(patch, options.least_m)) continue;
    terrain.patches.push_back(std::move(patch));
    for (const int triangle : piece.triangles) covered[static_cast<std::size_t>(triangle)] = 1;
  }
  Box rest;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<Vector3, 3> corners = Corners(mesh, t);
    if (!LooksUp(corners)) continue;
    for (const Vector3& corner : corners) {
      lowest = std::min(lowest, corner.z());
      if (covered[t] == 0) rest.extend(Vector2(corner.head<2>()));
    }
  }
  if (!std::isfinite(lowest)) throw InvalidArgument("has no face that points up; z must be up");
  if (!rest.isEmpty()) terrain.height_fields.push_back(FieldOver(mesh, rest, lowest, options));
  return terrain;
}

}  // namespace

OptionFields MeshTerrainOptions::Fields() {
  return {
      {"scale", &scale, "1", 1e-6, 1e6, "Length of one unit of the file in metres."},
      {"least_m", &least_m, "m", 0.001, 10.0, "Smallest width of a flat face that becomes a patch."},
      {"steepest_deg", &steepest_deg, "deg", 1.0, 80.0, "Largest slope of a flat face that becomes a patch."},
      {"resolution_m", &resolution_m, "m", 0.001, 1.0, "Resolution of the height field over faces that are not flat."},
      {"x_m", &x_m, "m", -kFarthest, kFarthest, "Position of the file's origin along x."},
      {"y_m", &y_m, "m", -kFarthest, kFarthest, "Position of the file's origin along y."},
      {"z_m", &z_m, "m", -kHighest, kHighest, "Position of the file's origin along z."},
      {"friction", &friction, "1", 0.01, 5.0, "Friction coefficient of the ground."}};
}

Result<Terrain> TerrainFromMesh(const Mesh& mesh, const MeshTerrainOptions& options, const std::string& name) {
  MeshTerrainOptions checked = options;
  try {
    CheckOptions(checked.Fields());
    return Make(Placed(mesh, options), options);
  } catch (const InvalidArgument& error) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kTerrainFile,
                   "TerrainFromMesh",
                   fmt::format("'{}' {}", name, error.what()),
                   {}};
  }
}

}  // namespace gaitwright
