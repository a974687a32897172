// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/write_heights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planning/plan/terrain_shapes.h"
#include "planning/terrain/height_map.h"
#include "planning/terrain/sense.h"
#include "planning/terrain/write_png.h"

namespace gaitwright {
namespace {

constexpr double kUsualSpacing = 0.02, kCoarsestSpacing = 1.0;  // of nodes [m]
constexpr double kMostNodesASide = 4096.0;
constexpr double kNoGround = -std::numeric_limits<double>::infinity();
constexpr double kGridRounding = 1e-6;  // share of the spacing

/// The highest ground at the points of a grid, as a height field; kNoGround without ground.
using SampledGround = HeightField;

double NodesAlong(double length, double spacing) { return std::floor(length / spacing + kGridRounding) + 1.0; }

/// Spacing of points over a rectangle: `finest` times the smallest whole number that makes the points few enough.
double SpacingOver(const Vector2& size, double finest) {
  const double longest = size.maxCoeff();
  double factor = std::max(1.0, std::floor(longest / (kMostNodesASide * finest)));
  const auto is_too_fine = [&] {
    const double x = NodesAlong(size.x(), factor * finest), y = NodesAlong(size.y(), factor * finest);
    return std::max(x, y) > kMostNodesASide || x * y > kMostNodes;
  };
  while (is_too_fine() && factor * finest <= kCoarsestSpacing) factor += 1.0;
  return factor * finest;
}

/// A grid without heights over the extent. @throws InvalidArgument if it needs too many nodes.
SampledGround GridOver(const Terrain& terrain, const Eigen::AlignedBox2d& extent) {
  double finest = kUsualSpacing;
  if (!terrain.height_fields.empty()) {
    const double spacing = terrain.height_fields.front().resolution_m;
    finest = spacing / std::max(1.0, std::ceil(spacing / kUsualSpacing - kGridRounding));
  }
  SampledGround grid;
  grid.resolution_m = SpacingOver(extent.sizes(), finest);
  if (grid.resolution_m > kCoarsestSpacing) {
    throw InvalidArgument(
        fmt::format("is {:.4g} by {:.4g} m large; a picture has at most {} points, at most {} m apart. Write a .xml or "
                    ".obj file instead",
                    extent.sizes().x(), extent.sizes().y(), kMostNodes, kCoarsestSpacing));
  }
  const auto place = [&](int axis, int& nodes) {
    const double low = extent.min()[axis], length = extent.sizes()[axis], r = grid.resolution_m;
    if (terrain.height_fields.empty()) {
      nodes = std::max(2, static_cast<int>(NodesAlong(length, r)));
      grid.origin_W[axis] = low + 0.5 * (length - (nodes - 1) * r);
      return;
    }
    const double anchor = terrain.height_fields.front().origin_W[axis];
    grid.origin_W[axis] = anchor + r * std::ceil((low - anchor) / r - kGridRounding);
    nodes = std::max(2, static_cast<int>(NodesAlong(low + length - grid.origin_W[axis], r)));
  };
  place(0, grid.columns);
  place(1, grid.rows);
  grid.height_m.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), kNoGround);
  return grid;
}

/// Raises the grid to one surface; `terrain` contains only that surface.
void RaiseTo(const Terrain& terrain, const Eigen::AlignedBox2d& extent, SampledGround& grid) {
  Eigen::AlignedBox2d box = ExtentOf(terrain, false);
  if (!terrain.patches.empty() && terrain.patches.front().outline_T.empty()) box = extent;
  // A point on the edge of a surface belongs to it, in spite of rounding.
  constexpr double kWithin = 1e-9;  // [m]
  const Vector2 low = box.min().array() + kWithin, high = box.max().array() - kWithin;
  const Vector2 from = (box.min() - grid.origin_W) / grid.resolution_m,
                to = (box.max() - grid.origin_W) / grid.resolution_m;
  const int row1 = std::min(grid.rows - 1, static_cast<int>(std::ceil(to.y())));
  const int column1 = std::min(grid.columns - 1, static_cast<int>(std::ceil(to.x())));
  for (int row = std::max(0, static_cast<int>(std::floor(from.y()))); row <= row1; ++row) {
    for (int column = std::max(0, static_cast<int>(std::floor(from.x()))); column <= column1; ++column) {
      const Vector2 node = grid.origin_W + grid.resolution_m * Vector2(column, row);
      const Vector2 p =
          node.cwiseMax(extent.min()).cwiseMin(extent.max());  // ground narrower than a cell has two points
      if (box.exteriorDistance(p) > kGridRounding * grid.resolution_m) continue;
      const GroundPoint ground = GroundAt(terrain, p.cwiseMax(low).cwiseMin(high));
      double& height = grid.height_m[static_cast<std::size_t>(row * grid.columns + column)];
      if (ground.patch >= 0) height = std::max(height, ground.height_m);
    }
  }
}

SampledGround Sampled(const Terrain& terrain, const Eigen::AlignedBox2d& extent) {
  SampledGround grid = GridOver(terrain, extent);
  for (const TerrainPatch& patch : terrain.patches) RaiseTo({"", {patch}, {}, {}}, extent, grid);
  for (const HeightField& field : terrain.height_fields) RaiseTo({"", {}, {field}, {}}, extent, grid);
  return grid;
}

/// The lowest and the highest height with ground, and whether some points have no ground.
struct SampledRange {
  double low = -kNoGround, high = kNoGround;
  bool has_holes = false;
};

SampledRange RangeOf(const SampledGround& grid) {
  SampledRange range;
  for (const double height : grid.height_m) {
    if (height == kNoGround) {
      range.has_holes = true;
      continue;
    }
    range.low = std::min(range.low, height);
    range.high = std::max(range.high, height);
  }
  return range;
}

/// @throws InvalidArgument for a height difference that ReadHeightMap refuses.
void CheckSteps(const SampledGround& grid, double lowest) {
  const auto at = [&](int column, int row) {
    return std::max(lowest, grid.height_m[static_cast<std::size_t>(row * grid.columns + column)]);
  };
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double here = at(column, row);
      const double step = std::max(std::abs(here - at(std::max(column - 1, 0), row)),
                                   std::abs(here - at(column, std::max(row - 1, 0))));
      if (step <= kSteepestStep) continue;
      const Vector2 p = grid.origin_W + grid.resolution_m * Vector2(column, row);
      throw InvalidArgument(
          fmt::format("has a step of {:.4g} m at ({:.4g}, {:.4g}) m; a picture may have steps of at most {} m. Write a "
                      ".xml or .obj file instead",
                      step, p.x(), p.y(), kSteepestStep));
    }
  }
}

/// As seen from above: the first row has the largest y.
GreyImage PictureOf(const SampledGround& grid, double lowest, double rise) {
  GreyImage image{grid.columns, grid.rows, 65535, {}};
  image.values.reserve(grid.height_m.size());
  for (int row = grid.rows - 1; row >= 0; --row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double height = grid.height_m[static_cast<std::size_t>(row * grid.columns + column)];
      const double share = std::clamp((height - lowest) / rise, 0.0, 1.0);
      image.values.push_back(static_cast<std::uint16_t>(std::lround(image.full * share)));
    }
  }
  return image;
}

std::string HeightMapParameters(const SampledGround& grid, double lowest, double rise, const std::string& friction) {
  const Vector2 middle = grid.origin_W + 0.5 * grid.resolution_m * Vector2(grid.columns - 1, grid.rows - 1);
  std::string text = fmt::format("resolution_m={},scale_m={}", grid.resolution_m, rise);
  for (const auto& [key, value] : {std::pair{"x_m", middle.x()}, {"y_m", middle.y()}, {"z_m", lowest}}) {
    if (value != 0.0) text += fmt::format(",{}={}", key, value);
  }
  return friction.empty() ? text : text + "," + friction;
}

Result<WrittenGround> WriteGrid(const Terrain& terrain, const Eigen::AlignedBox2d& extent) {
  const SampledGround grid = Sampled(terrain, extent);
  const SampledRange range = RangeOf(grid);
  if (!(range.low <= range.high))
    throw InvalidArgument(fmt::format("has no surface at any point {} m apart", grid.resolution_m));
  const double lowest = range.has_holes ? std::max(range.low - kSolidDepth, -kHighest) : range.low;
  const double rise = range.high > lowest ? range.high - lowest : 1.0;  // any value: everything is black
  if (rise > kHighest)
    throw InvalidArgument(
        fmt::format("rises by {:.4g} m; a picture may rise by at most {} m. Write a .xml or .obj "
                    "file instead",
                    rise, kHighest));
  CheckSteps(grid, lowest);
  WrittenGround written;
  written.notes = NotesOfCutPlanes(terrain, extent);
  if (range.has_holes) {
    written.notes.push_back(
        fmt::format("places without ground are black, {:.4g} m below the lowest ground", range.low - lowest));
  }
  if (!terrain.obstacles.empty())
    written.notes.push_back(
        fmt::format("obstacles are left out ({}): the file contains heights only", terrain.obstacles.size()));
  written.parameters = HeightMapParameters(grid, lowest, rise, FrictionParameter(terrain, written.notes));
  Result<std::string> bytes = WriteGreyPng(PictureOf(grid, lowest, rise));
  if (!bytes) return bytes.failure();
  written.bytes = std::move(*bytes);
  return written;
}

}  // namespace

Result<WrittenGround> WriteHeights(const Terrain& terrain) {
  try {
    const Eigen::AlignedBox2d extent = ExtentOf(terrain, false);
    if (extent.isEmpty()) throw InvalidArgument("has no surfaces; there is nothing to write");
    return WriteGrid(terrain, extent);
  } catch (const InvalidArgument& error) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kTerrainFile,
                   "WriteHeights",
                   fmt::format("ground '{}' {}", terrain.name, error.what()),
                   {}};
  }
}

}  // namespace gaitwright
