// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A convex piece of walkable plane, solid below. T: origin in the plane, z its outward normal.
struct TerrainPatch {
  std::string name;
  Pose X_WT = Pose::Identity();
  std::vector<Vector2> outline_T;  ///< counter-clockwise; empty for a plane without end
  double friction = 0.8;
};

/// Ground by heights at the nodes of a grid along x and y of W, solid below. Each cell is two triangles, divided by the
/// diagonal from its lowest x and y to its highest. There is no ground outside the grid.
struct HeightField {
  std::string name;
  Vector2 origin_W = Vector2::Zero();  ///< of the first node [m]
  double resolution_m = 0.02;          ///< between nodes
  int columns = 0, rows = 0;           ///< nodes along x and along y, at least 2 each
  std::vector<double> height_m;        ///< of node (column, row) at [row * columns + column]
  double friction = 0.8;
};

/// Something that must not be touched, and that no foot is put on: a wall, a post, a lintel.
struct Obstacle {
  std::string name;
  ShapeType type = ShapeType::kBox;  ///< box, cylinder along z, or kMesh: the convex hull of `vertices_O`
  Pose X_WO = Pose::Identity();
  Vector3 size_m = Vector3::Zero();  ///< as of Shape: box: edge lengths; cylinder: (radius, length, 0)
  std::vector<Vector3> vertices_O;   ///< kMesh
};

/// A place on the ground that has a name; nothing is there.
struct TerrainMarker {
  std::string name;
  Vector2 p_W = Vector2::Zero();  ///< [m]
};

/// The ground and what stands on it, as one value for planner, optimiser, audit, Bullet and viewer.
/// Where surfaces overlap in plan view the highest one holds. Surfaces are numbered: patches first, then height fields.
struct Terrain {
  std::string name;
  std::vector<TerrainPatch> patches;
  std::vector<HeightField> height_fields;
  std::vector<Obstacle> obstacles;
  std::vector<TerrainMarker> markers = {};

  int num_surfaces() const { return static_cast<int>(patches.size() + height_fields.size()); }
};

/// The kinds of ground that methods tell apart, the plainest first.
enum class GroundKind {
  kFlat,     ///< one level plane without end at z = 0, with nothing on it
  kLevel,    ///< one level plane without end at another height, with nothing on it
  kBounded,  ///< one level plane with edges, with nothing on it
  kUneven,   ///< anything else
};
GroundKind KindOfGround(const Terrain& terrain);

/// Level ground without end at z = 0.
Terrain FlatTerrain(double friction = 0.8);

/// A bounded patch through corners that lie in one plane: T at their mean, x of T along x of W in plan view.
/// @param corners_W  three or more, convex and counter-clockwise in plan view [m].
/// @throws InvalidArgument unless they are so, or stand farther than 1 mm off their plane.
TerrainPatch PatchThrough(const std::string& name, const std::vector<Vector3>& corners_W, double friction);

/// The ground under a point in plan view.
struct GroundPoint {
  int patch = -1;  ///< number of the surface; -1 where there is no ground
  double height_m = 0.0;
  Vector3 normal_W = Vector3::UnitZ();
  double friction = 0.0;
};

/// The highest ground at (x, y); patch -1 without ground.
GroundPoint GroundAt(const Terrain& terrain, const Vector2& p_W);

/// The friction of a surface by its number; 0 of one that is not there.
double FrictionOf(const Terrain& terrain, int surface);

/// How deep the solid under a bounded surface reaches [m].
inline constexpr double kSolidDepth = 1.0;

/// The corners of the solid under a bounded patch in W: its outline, and the same kSolidDepth straight down.
std::vector<Vector3> SolidUnder(const TerrainPatch& patch);

/// Types of obstacles, with their names in files: "box", "cylinder", "mesh".
const std::vector<ShapeType>& ObstacleTypes();
const std::vector<std::string>& ObstacleTypeNames();
/// The name of one of them. @throws InvalidArgument for any other type.
const std::string& ObstacleTypeName(ShapeType type);

/// An obstacle as a shape in W.
Shape ShapeOf(const Obstacle& obstacle);

}  // namespace gaitwright
