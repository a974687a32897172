// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The solid under heights at the nodes of a grid along x and y of W. Each cell is two triangles, divided by the
/// diagonal from its lowest x and y to its highest, and the volume below them.
struct GridSolid {
  std::string name;
  Vector2 origin_W = Vector2::Zero();  ///< position of the first node [m]
  double resolution_m = 0.02;          ///< distance between nodes
  int columns = 0, rows = 0;           ///< numbers of nodes along x and along y, at least 2 each
  std::vector<double> height_m;        ///< height of node (column, row) at [row * columns + column]
  double depth_m = 1.0;                ///< depth of the solid
};

/// Everything on one side of a plane: normal_W . p <= offset_m.
struct HalfSpace {
  std::string name;
  Vector3 normal_W = Vector3::UnitZ();  ///< unit, out of the solid
  double offset_m = 0.0;
};

/// Convex solids that do not move.
struct FixedSolids {
  std::vector<Shape> shapes;  ///< X_BS is X_WS; `link` is the name of the solid
  std::vector<HalfSpace> half_spaces;
};

/// A shape prepared for repeated queries of a scene. Not thread-safe.
class PreparedShape {
 public:
  explicit PreparedShape(const Shape& shape);
  ~PreparedShape();
  PreparedShape(PreparedShape&&) noexcept;
  PreparedShape& operator=(PreparedShape&&) noexcept;

  const Shape& shape() const { return shape_; }
  /// Radius of a sphere about the origin of S that contains the shape [m].
  double radius_m() const { return radius_m_; }

 private:
  friend class ShapeScene;
  struct Body;
  Shape shape_;
  double radius_m_ = 0.0;
  std::unique_ptr<Body> body_;
};

/// The solid of a scene that is nearest to a shape.
struct NearestSolid {
  double distance_m = 0.0;  ///< 0 or the negative depth if they touch; at most the queried range
  int solid = -1;           ///< number of the solid; -1 if there is none within the range
};

/// Static solids for queries with moving shapes. Solids are numbered: shapes, then grids, then half spaces. Distances
/// are computed by FCL (Pan, Chitta and Manocha, ICRA 2012) after a tree of boxes; they are accurate to 1e-5 m and
/// never too large. Depths are those of FCL's portal refinement, which may be too large for a shape deep in a solid.
/// They are limited to the shortest distance out through a side of a box or of a mesh of up to 32 vertices. A mesh
/// without vertices touches nothing. Use from one thread at a time; results do not depend on earlier queries.
class ShapeScene {
 public:
  /// @param fixed_W  shapes whose X_BS is X_WS; `link` is the name of the solid.
  explicit ShapeScene(const std::vector<Shape>& fixed_W, const std::vector<GridSolid>& grids = {},
                      const std::vector<HalfSpace>& half_spaces = {});
  ~ShapeScene();
  ShapeScene(ShapeScene&&) noexcept;
  ShapeScene& operator=(ShapeScene&&) noexcept;

  /// Whether a shape at a pose touches any solid. Poses are X_WS; X_BS of the shape is ignored.
  bool Touches(const PreparedShape& shape, const Pose& X_WS) const;
  bool Touches(const Shape& shape, const Pose& X_WS) const;

  /// The nearest solid within a distance; if several are touched, the one with the largest depth.
  NearestSolid Nearest(const PreparedShape& shape, const Pose& X_WS, double within_m) const;
  /// Distance of the nearest solid, at most within_m; 0 or the negative depth if they touch.
  double Distance(const PreparedShape& shape, const Pose& X_WS, double within_m) const;
  double Distance(const Shape& shape, const Pose& X_WS, double within_m) const;

  int num_solids() const;
  /// @throws InvalidArgument for a solid that does not exist.
  const std::string& SolidName(int solid) const;

 private:
  struct Solids;
  std::unique_ptr<Solids> solids_;
};

}  // namespace gaitwright
