// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/ground_index.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/base/non_finite.h"

namespace gaitwright {
namespace {

void Bound(const Polygon& outline, Vector2& lowest, Vector2& highest) {
  lowest.setConstant(kInfinity);
  highest.setConstant(-kInfinity);
  for (const Vector2& corner : outline) {
    lowest = lowest.cwiseMin(corner);
    highest = highest.cwiseMax(corner);
  }
}

/// Points in W whose hull contains an obstacle. A cylinder is replaced by the prism around it.
std::vector<Vector3> CornersOf(const Obstacle& obstacle) {
  std::vector<Vector3> corners;
  if (obstacle.type == ShapeType::kMesh) {
    for (const Vector3& v_O : obstacle.vertices_O) corners.push_back(obstacle.X_WO * v_O);
    return corners;
  }
  constexpr int kSides = 16;
  const bool box = obstacle.type == ShapeType::kBox;
  const Vector3 half = box ? Vector3(0.5 * obstacle.size_m) : Vector3(0.0, 0.0, 0.5 * obstacle.size_m.y());
  const double around = obstacle.size_m.x() / std::cos(std::numbers::pi / kSides);
  for (int i = 0; i < (box ? 4 : kSides); ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    const Vector2 side = box ? Vector2(i % 2 == 0 ? half.x() : -half.x(), i < 2 ? half.y() : -half.y())
                             : Vector2(around * std::cos(angle), around * std::sin(angle));
    for (const double end : {-half.z(), half.z()}) corners.push_back(obstacle.X_WO * Vector3(side.x(), side.y(), end));
  }
  return corners;
}

double HighestOf(const HeightField& field) { return *std::max_element(field.height_m.begin(), field.height_m.end()); }

}  // namespace

double GroundSurface::Inside(const Vector2& p_W) const {
  double least = kInfinity;
  for (std::size_t i = 0; i < inward.size(); ++i) least = std::min(least, inward[i].dot(p_W - outline_W[i]));
  return least;
}

GroundIndex::GroundIndex(const Terrain& terrain, double cell_m) : terrain_(&terrain) {
  fields_.height_fields = terrain.height_fields;
  for (const TerrainPatch& patch : terrain.patches) AddPatch(patch);
  for (const Obstacle& obstacle : terrain.obstacles) AddObstacle(obstacle);
  MakeGrid(cell_m);
  FillCells();
  LookBeyondEdges();
}

void GroundIndex::AddPatch(const TerrainPatch& patch) {
  GroundSurface surface;
  surface.normal_W = patch.X_WT.linear().col(2);
  surface.friction = patch.friction;
  const Vector3 p = patch.X_WT.translation(), n = surface.normal_W / surface.normal_W.z();
  surface.plane = Vector3(-n.x(), -n.y(), n.dot(p));
  for (const Vector2& corner : patch.outline_T)
    surface.outline_W.push_back((patch.X_WT * Vector3(corner.x(), corner.y(), 0.0)).head<2>());
  for (std::size_t i = 0; i < surface.outline_W.size(); ++i) {
    const Vector2 along = (surface.outline_W[(i + 1) % surface.outline_W.size()] - surface.outline_W[i]).normalized();
    surface.inward.emplace_back(-along.y(), along.x());
  }
  surface.beyond.assign(surface.outline_W.size(), GroundSurface::Beyond::kLower);
  Bound(surface.outline_W, surface.lowest_W, surface.highest_W);
  if (surface.outline_W.empty()) endless_.push_back(static_cast<int>(surfaces_.size()));
  surfaces_.push_back(std::move(surface));
}

void GroundIndex::AddObstacle(const Obstacle& obstacle) {
  ObstacleOutline outline;
  outline.bottom_m = kInfinity;
  outline.top_m = -kInfinity;
  for (const Vector3& corner : CornersOf(obstacle)) {
    outline.outline_W.push_back(corner.head<2>());
    outline.bottom_m = std::min(outline.bottom_m, corner.z());
    outline.top_m = std::max(outline.top_m, corner.z());
  }
  outline.outline_W = ConvexHull(outline.outline_W);
  obstacles_.push_back(std::move(outline));
}

void GroundIndex::MakeGrid(double cell_m) {
  constexpr double kMostCells = 256.0;  // cells along one side
  Vector2 low = Vector2::Constant(kInfinity), high = -low;
  const auto take = [&](const Vector2& a, const Vector2& b) {
    low = low.cwiseMin(a);
    high = high.cwiseMax(b);
  };
  for (const GroundSurface& surface : surfaces_)
    if (!surface.outline_W.empty()) take(surface.lowest_W, surface.highest_W);
  for (const ObstacleOutline& obstacle : obstacles_) {
    Vector2 a, b;
    Bound(obstacle.outline_W, a, b);
    take(a, b);
  }
  for (const HeightField& field : terrain_->height_fields)
    take(field.origin_W, field.origin_W + field.resolution_m * Vector2(field.columns - 1, field.rows - 1));
  if (!(low.x() <= high.x())) return;
  origin_W_ = low;
  cell_m_ = std::max(cell_m, (high - low).maxCoeff() / kMostCells);
  columns_ = 1 + static_cast<int>((high.x() - low.x()) / cell_m_);
  rows_ = 1 + static_cast<int>((high.y() - low.y()) / cell_m_);
  Cell empty;
  empty.highest_m = -kInfinity;
  cells_.assign(static_cast<std::size_t>(columns_ * rows_), empty);
}

GroundIndex::CellRange GroundIndex::Cells(const Vector2& lowest_W, const Vector2& highest_W) const {
  const auto index = [this](double p, double origin, int count) {
    return static_cast<int>(std::clamp(std::floor((p - origin) / cell_m_), -1.0, static_cast<double>(count)));
  };
  return {std::max(0, index(lowest_W.x(), origin_W_.x(), columns_)),
          std::min(columns_ - 1, index(highest_W.x(), origin_W_.x(), columns_)),
          std::max(0, index(lowest_W.y(), origin_W_.y(), rows_)),
          std::min(rows_ - 1, index(highest_W.y(), origin_W_.y(), rows_))};
}

void GroundIndex::FillCells() {
  constexpr double kRounding = 1e-9;  // [m]
  const auto each = [&](const Vector2& low, const Vector2& high, const auto& use) {
    const CellRange range = Cells(low - Vector2::Constant(kRounding), high + Vector2::Constant(kRounding));
    for (int row = range.row_low; row <= range.row_high; ++row)
      for (int column = range.column_low; column <= range.column_high; ++column)
        use(cells_[static_cast<std::size_t>(row * columns_ + column)]);
  };
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const GroundSurface& surface = surfaces_[i];
    if (surface.outline_W.empty()) continue;
    double top = -kInfinity;
    for (const Vector2& corner : surface.outline_W) top = std::max(top, surface.HeightAt(corner));
    each(surface.lowest_W, surface.highest_W, [&](Cell& cell) {
      cell.patches.push_back(static_cast<int>(i));
      cell.highest_m = std::max(cell.highest_m, top);
    });
  }
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    Vector2 low, high;
    Bound(obstacles_[i].outline_W, low, high);
    each(low, high, [&](Cell& cell) { cell.obstacles.push_back(static_cast<int>(i)); });
  }
  for (const HeightField& field : terrain_->height_fields) {
    const Vector2 span = field.resolution_m * Vector2(field.columns - 1, field.rows - 1);
    const double top = HighestOf(field);
    each(field.origin_W, field.origin_W + span, [&](Cell& cell) { cell.highest_m = std::max(cell.highest_m, top); });
  }
}

void GroundIndex::LookBeyondEdges() {
  constexpr double kOut = 2e-3, kFlush = 2e-3;  // [m]
  constexpr int kLooks = 5;
  for (GroundSurface& surface : surfaces_) {
    for (std::size_t i = 0; i < surface.outline_W.size(); ++i) {
      const Vector2 &a = surface.outline_W[i], &b = surface.outline_W[(i + 1) % surface.outline_W.size()];
      bool lower = false;
      for (int k = 0; k < kLooks; ++k) {
        const Vector2 p = a + (k + 0.5) / kLooks * (b - a) - kOut * surface.inward[i];
        const GroundPoint ground = At(p);
        const double rise = ground.patch < 0 ? -kInfinity : ground.height_m - surface.HeightAt(p);
        if (rise > kFlush) surface.beyond[i] = GroundSurface::Beyond::kHigher;
        lower = lower || rise < -kFlush;
      }
      if (!lower && surface.beyond[i] != GroundSurface::Beyond::kHigher)
        surface.beyond[i] = GroundSurface::Beyond::kSame;
    }
  }
}

GroundPoint GroundIndex::At(const Vector2& p_W) const {
  GroundPoint highest;
  const auto take = [&](int i) {
    const GroundSurface& surface = surfaces_[static_cast<std::size_t>(i)];
    const double height = surface.HeightAt(p_W);
    if (highest.patch >= 0 && (height < highest.height_m || (height == highest.height_m && i > highest.patch))) return;
    if (surface.Inside(p_W) < 0.0) return;
    highest = {i, height, surface.normal_W, surface.friction};
  };
  for (const int i : endless_) take(i);
  const CellRange range = Cells(p_W, p_W);
  if (range.row_low == range.row_high && range.column_low == range.column_high) {
    for (const int i : cells_[static_cast<std::size_t>(range.row_low * columns_ + range.column_low)].patches) take(i);
  }
  if (fields_.height_fields.empty()) return highest;
  GroundPoint field = GroundAt(fields_, p_W);
  if (field.patch < 0 || (highest.patch >= 0 && field.height_m <= highest.height_m)) return highest;
  field.patch += static_cast<int>(terrain_->patches.size());
  return field;
}

template <class Member>
void GroundIndex::Collect(const Vector2& lowest_W, const Vector2& highest_W, Member member,
                          std::vector<int>& found) const {
  const CellRange range = Cells(lowest_W, highest_W);
  for (int row = range.row_low; row <= range.row_high; ++row) {
    for (int column = range.column_low; column <= range.column_high; ++column) {
      const std::vector<int>& here = cells_[static_cast<std::size_t>(row * columns_ + column)].*member;
      found.insert(found.end(), here.begin(), here.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

void GroundIndex::PatchesIn(const Vector2& lowest_W, const Vector2& highest_W, std::vector<int>& found) const {
  found = endless_;
  Collect(lowest_W, highest_W, &Cell::patches, found);
}

void GroundIndex::ObstaclesIn(const Vector2& lowest_W, const Vector2& highest_W, std::vector<int>& found) const {
  found.clear();
  if (!obstacles_.empty()) Collect(lowest_W, highest_W, &Cell::obstacles, found);
}

double GroundIndex::HighestIn(const Vector2& lowest_W, const Vector2& highest_W) const {
  double highest = -kInfinity;
  for (const int i : endless_) {
    const GroundSurface& surface = surfaces_[static_cast<std::size_t>(i)];
    for (const double x : {lowest_W.x(), highest_W.x()})
      for (const double y : {lowest_W.y(), highest_W.y()}) highest = std::max(highest, surface.HeightAt({x, y}));
  }
  const CellRange range = Cells(lowest_W, highest_W);
  for (int row = range.row_low; row <= range.row_high; ++row)
    for (int column = range.column_low; column <= range.column_high; ++column)
      highest = std::max(highest, cells_[static_cast<std::size_t>(row * columns_ + column)].highest_m);
  return highest;
}

}  // namespace gaitwright
