// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/collision/shape_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/result.h"
#include "kinematics/collision/facets_internal.h"
#include "kinematics/collision/fcl_shape_internal.h"
#include "kinematics/collision/grid_prisms_internal.h"
#include "kinematics/collision/shape_extent.h"

namespace gaitwright {

struct PreparedShape::Body {
  fcl::CollisionObjectd object;
};

PreparedShape::PreparedShape(const Shape& shape) : shape_(shape), radius_m_(BoundingRadius(shape)) {
  if (const auto geometry = FclGeometry(shape)) body_ = std::make_unique<Body>(Body{fcl::CollisionObjectd(geometry)});
}

PreparedShape::~PreparedShape() = default;
PreparedShape::PreparedShape(PreparedShape&&) noexcept = default;
PreparedShape& PreparedShape::operator=(PreparedShape&&) noexcept = default;

namespace {

/// A shape of the scene; FCL's object points back to it.
struct Fixed {
  int number;
  std::vector<Facet> facets;
  fcl::CollisionObjectd object;
};

}  // namespace

struct ShapeScene::Solids {
  std::vector<std::string> names;
  std::vector<std::unique_ptr<Fixed>> shapes;
  fcl::DynamicAABBTreeCollisionManagerd tree;
  std::vector<GridPrisms> grids;
  std::vector<HalfSpace> half_spaces;
  int first_grid = 0, first_half_space = 0;
};

ShapeScene::ShapeScene(const std::vector<Shape>& fixed_W, const std::vector<GridSolid>& grids,
                       const std::vector<HalfSpace>& half_spaces)
    : solids_(std::make_unique<Solids>()) {
  std::vector<fcl::CollisionObjectd*> leaves;
  for (const Shape& shape : fixed_W) {
    const auto number = static_cast<int>(solids_->names.size());
    solids_->names.push_back(shape.link);
    const auto geometry = FclGeometry(shape);
    if (geometry == nullptr) continue;
    solids_->shapes.push_back(std::make_unique<Fixed>(
        Fixed{number, FacetsOf(shape, shape.X_BS), fcl::CollisionObjectd(geometry, shape.X_BS)}));
    fcl::CollisionObjectd& object = solids_->shapes.back()->object;
    object.setUserData(solids_->shapes.back().get());
    leaves.push_back(&object);
  }
  solids_->tree.registerObjects(leaves);
  solids_->tree.setup();
  solids_->first_grid = static_cast<int>(solids_->names.size());
  for (const GridSolid& grid : grids) {
    solids_->names.push_back(grid.name);
    solids_->grids.emplace_back(grid);
  }
  solids_->first_half_space = static_cast<int>(solids_->names.size());
  solids_->half_spaces = half_spaces;
  for (const HalfSpace& half_space : half_spaces) solids_->names.push_back(half_space.name);
}

ShapeScene::~ShapeScene() = default;
ShapeScene::ShapeScene(ShapeScene&&) noexcept = default;
ShapeScene& ShapeScene::operator=(ShapeScene&&) noexcept = default;

namespace {

/// A query of the tree, with the result so far.
struct Query {
  const Shape& shape;
  const Pose& X_WS;
  NearestSolid nearest;
  bool touched = false;
};

const Fixed& FixedOf(const fcl::CollisionObjectd& object) { return *static_cast<const Fixed*>(object.getUserData()); }

bool TouchCall(fcl::CollisionObjectd* solid, fcl::CollisionObjectd* moving, void* data) {
  auto& query = *static_cast<Query*>(data);
  if (BeyondFacets(FixedOf(*solid).facets, query.shape, query.X_WS) > 0.0) return false;
  fcl::CollisionResultd result;
  query.touched = fcl::collide(solid, moving, fcl::CollisionRequestd(), result) > 0;
  return query.touched;
}

/// Keeps the nearest solid. `reach` is the search distance of the tree; it stays positive, so that all solids that may
/// touch are visited.
bool NearestCall(fcl::CollisionObjectd* solid, fcl::CollisionObjectd* moving, void* data, double& reach) {
  auto& [shape, X_WS, nearest, touched] = *static_cast<Query*>(data);
  const Fixed& fixed = FixedOf(*solid);
  reach = std::max(nearest.distance_m, std::numeric_limits<double>::min());
  if (solid->getAABB().distance(moving->getAABB()) >= reach) return false;
  const double beyond = BeyondFacets(fixed.facets, shape, X_WS);
  if (beyond >= nearest.distance_m) return false;
  double gap = SignedGap(*solid, *moving);
  if (gap < 0.0) gap = std::max(gap, std::min(beyond, 0.0));
  if (gap < nearest.distance_m) nearest = {gap, fixed.number};
  reach = std::max(nearest.distance_m, std::numeric_limits<double>::min());
  return false;
}

double DistanceTo(const HalfSpace& half_space, const Shape& shape, const Pose& X_WS) {
  const Vector3 down_S = -(X_WS.linear().transpose() * half_space.normal_W);
  return half_space.normal_W.dot(X_WS * SupportPoint(shape, down_S)) - half_space.offset_m;
}

}  // namespace

bool ShapeScene::Touches(const PreparedShape& shape, const Pose& X_WS) const {
  if (shape.body_ == nullptr) return false;
  for (const HalfSpace& half_space : solids_->half_spaces) {
    if (DistanceTo(half_space, shape.shape(), X_WS) <= 0.0) return true;
  }
  fcl::CollisionObjectd& object = shape.body_->object;
  object.setTransform(X_WS);
  object.computeAABB();
  Query query{shape.shape(), X_WS, {}};
  solids_->tree.collide(&object, &query, TouchCall);
  for (const GridPrisms& grid : solids_->grids) {
    constexpr double kTouching = 1e-12;  // [m]
    if (query.touched || grid.Distance(object, kTouching, true) <= 0.0) return true;
  }
  return query.touched;
}

NearestSolid ShapeScene::Nearest(const PreparedShape& shape, const Pose& X_WS, double within_m) const {
  NearestSolid nearest{within_m, -1};
  if (shape.body_ == nullptr) return nearest;
  const auto take = [&](double distance, int solid) {
    if (distance < nearest.distance_m) nearest = {distance, solid};
  };
  for (std::size_t i = 0; i < solids_->half_spaces.size(); ++i)
    take(DistanceTo(solids_->half_spaces[i], shape.shape(), X_WS), solids_->first_half_space + static_cast<int>(i));
  fcl::CollisionObjectd& object = shape.body_->object;
  object.setTransform(X_WS);
  object.computeAABB();
  if (!solids_->shapes.empty()) {
    Query query{shape.shape(), X_WS, nearest};
    solids_->tree.distance(&object, &query, NearestCall);
    nearest = query.nearest;
  }
  for (std::size_t i = 0; i < solids_->grids.size(); ++i)
    take(solids_->grids[i].Distance(object, nearest.distance_m, false), solids_->first_grid + static_cast<int>(i));
  return nearest;
}

double ShapeScene::Distance(const PreparedShape& shape, const Pose& X_WS, double within_m) const {
  return Nearest(shape, X_WS, within_m).distance_m;
}

bool ShapeScene::Touches(const Shape& shape, const Pose& X_WS) const { return Touches(PreparedShape(shape), X_WS); }

double ShapeScene::Distance(const Shape& shape, const Pose& X_WS, double within_m) const {
  return Distance(PreparedShape(shape), X_WS, within_m);
}

int ShapeScene::num_solids() const { return static_cast<int>(solids_->names.size()); }

const std::string& ShapeScene::SolidName(int solid) const {
  if (solid < 0 || solid >= num_solids())
    throw InvalidArgument(
        fmt::format("ShapeScene: solid {} does not exist; the number of solids is {}", solid, num_solids()));
  return solids_->names[static_cast<std::size_t>(solid)];
}

}  // namespace gaitwright
