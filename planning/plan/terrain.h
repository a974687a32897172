// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A convex plane surface to walk on, with solid ground below. T: origin in the plane, z is the outward normal.
struct TerrainPatch {
  std::string name;
  Pose X_WT = Pose::Identity();
  std::vector<Vector2> outline_T;  ///< counter-clockwise; empty for an infinite plane
  double friction = 0.8;
};

/// Ground given by heights on a grid along x and y of W, with solid ground below. Each cell is two triangles, divided
/// by the diagonal from its corner of lowest x and y to that of highest x and y. There is no ground outside the grid.
struct HeightField {
  std::string name;
  Vector2 origin_W = Vector2::Zero();  ///< position of the first node [m]
  double resolution_m = 0.02;          ///< distance between nodes
  int columns = 0, rows = 0;           ///< number of nodes along x and along y, at least 2 each
  std::vector<double> height_m;        ///< height of node (column, row) at index [row * columns + column]
  double friction = 0.8;
};

/// An object that must not be touched, and on which no foot is placed: a wall, a post, a lintel.
struct Obstacle {
  std::string name;
  ShapeType type = ShapeType::kBox;  ///< box, cylinder along z, or kMesh: the convex hull of `vertices_O`
  Pose X_WO = Pose::Identity();
  Vector3 size_m = Vector3::Zero();  ///< as in Shape: box: edge lengths; cylinder: (radius, length, 0)
  std::vector<Vector3> vertices_O;   ///< kMesh
};

/// A named point on the ground, without any object.
struct TerrainMarker {
  std::string name;
  Vector2 p_W = Vector2::Zero();  ///< [m]
};

/// The ground and the objects on it, as one value for planner, optimiser, audit, simulator and viewer. Where surfaces
/// overlap in plan view, the highest one is the ground. Surfaces are numbered: patches first, then height fields.
struct Terrain {
  std::string name;
  std::vector<TerrainPatch> patches;
  std::vector<HeightField> height_fields;
  std::vector<Obstacle> obstacles;
  std::vector<TerrainMarker> markers = {};

  int num_surfaces() const { return static_cast<int>(patches.size() + height_fields.size()); }
};

/// Kinds of ground that planning methods distinguish, the simplest first.
enum class GroundKind {
  kFlat,     ///< one infinite level plane at z = 0, without objects
  kLevel,    ///< one infinite level plane at another height, without objects
  kBounded,  ///< one level plane with edges, without objects
  kUneven,   ///< anything else
};
GroundKind KindOfGround(const Terrain& terrain);

/// Infinite level ground at z = 0.
Terrain FlatTerrain(double friction = 0.8);

/// A bounded patch through corners in one plane: T is at their mean, x of T points along x of W in plan view.
/// @param corners_W  three or more, convex and counter-clockwise in plan view [m].
/// @throws InvalidArgument for other corners, or corners more than 1 mm off their plane.
TerrainPatch PatchThrough(const std::string& name, const std::vector<Vector3>& corners_W, double friction);

/// The ground under a point in plan view.
struct GroundPoint {
  int patch = -1;  ///< number of the surface; -1 without ground
  double height_m = 0.0;
  Vector3 normal_W = Vector3::UnitZ();
  double friction = 0.0;
};

/// The highest ground at (x, y); patch is -1 without ground.
GroundPoint GroundAt(const Terrain& terrain, const Vector2& p_W);

/// The friction coefficient of a surface; 0 for an unknown surface.
double FrictionOf(const Terrain& terrain, int surface);

/// Depth of the solid under a bounded surface [m].
inline constexpr double kSolidDepth = 1.0;

/// The corners in W of the solid under a bounded patch: its outline, and the outline moved down by kSolidDepth.
std::vector<Vector3> SolidUnder(const TerrainPatch& patch);

/// Types of obstacles, with their names in files: "box", "cylinder", "mesh".
const std::vector<ShapeType>& ObstacleTypes();
const std::vector<std::string>& ObstacleTypeNames();
/// The name of an obstacle type. @throws InvalidArgument for any other type.
const std::string& ObstacleTypeName(ShapeType type);

/// An obstacle as a shape in W.
Shape ShapeOf(const Obstacle& obstacle);

}  // namespace gaitwright
