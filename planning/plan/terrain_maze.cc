// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "planning/plan/terrain_kinds_internal.h"
#include "planning/plan/value_noise.h"

namespace gaitwright::terrain {
namespace {

/// Walls of a maze. The passages are a tree that reaches every cell, so there is exactly one route between any two
/// cells. They are made by a depth-first search with random neighbours.
class Maze {
 public:
  Maze(int columns, int rows, std::uint64_t seed) : columns_(columns), rows_(rows), seed_(seed) {
    forward_.assign(static_cast<std::size_t>((columns + 1) * rows), 1);
    beside_.assign(static_cast<std::size_t>(columns * (rows + 1)), 1);
    Carve();
    forward_[Forward(0, rows / 2)] = forward_[Forward(columns, rows / 2)] = 0;  // entrance and exit
  }

  /// Whether there is a wall at the low-x side of a cell; column `columns` is the far end.
  bool WallForward(int column, int row) const { return forward_[Forward(column, row)] != 0; }
  /// Whether there is a wall at the low-y side of a cell; row `rows` is the left end.
  bool WallBeside(int column, int row) const { return beside_[Beside(column, row)] != 0; }

 private:
  std::size_t Forward(int column, int row) const { return static_cast<std::size_t>(column * rows_ + row); }
  std::size_t Beside(int column, int row) const { return static_cast<std::size_t>(row * columns_ + column); }

  void Carve() {
    struct Cell {
      int column, row;
    };
    std::vector<char> visited(static_cast<std::size_t>(columns_ * rows_), 0);
    const auto seen = [&](const Cell& c) -> char& {
      return visited[static_cast<std::size_t>(c.column * rows_ + c.row)];
    };
    std::vector<Cell> path = {{0, rows_ / 2}};
    seen(path.back()) = 1;
    for (std::int64_t turn = 0; !path.empty(); ++turn) {
      const Cell here = path.back();
      std::vector<Cell> open;
      for (const Cell& by : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
        const Cell next{here.column + by.column, here.row + by.row};
        if (next.column < 0 || next.row < 0 || next.column >= columns_ || next.row >= rows_ || seen(next)) continue;
        open.push_back(next);
      }
      if (open.empty()) {
        path.pop_back();
        continue;
      }
      const double u = 0.5 * (1.0 + UniformAt(turn, 0, seed_));
      const Cell next = open[std::min(static_cast<std::size_t>(u * static_cast<double>(open.size())), open.size() - 1)];
      if (next.row == here.row) {
        forward_[Forward(std::max(next.column, here.column), here.row)] = 0;
      } else {
        beside_[Beside(here.column, std::max(next.row, here.row))] = 0;
      }
      seen(next) = 1;
      path.push_back(next);
    }
  }

  int columns_, rows_;
  std::uint64_t seed_;
  std::vector<char> forward_, beside_;
};

/// Calls add(first, last + 1) for each run of consecutive numbers below `count` for which `wall` is true.
template <class Wall, class Add>
void ForRuns(int count, Wall wall, Add add) {
  for (int i = 0; i < count; ++i) {
    if (!wall(i)) continue;
    const int first = i;
    while (i < count && wall(i)) ++i;
    add(first, i);
  }
}

}  // namespace

MazeGround::MazeGround(const TerrainScale& scale)
    : Walls(scale, 1.3 * std::hypot(scale.body_length_m, scale.body_width_m)) {}

OptionFields MazeGround::Fields() {
  return With(
      {{"columns", &columns, "1", 1, 60, "Number of cells along the x axis; entrance and exit are in the middle row."},
       {"rows", &rows, "1", 1, 60, "Number of cells along the y axis."},
       SeedField(&seed)});
}

Terrain MazeGround::Build() const {
  const Maze maze(columns, rows, static_cast<std::uint64_t>(seed));
  const double pitch = passage_m + thickness_m, half = 0.5 * thickness_m;
  const auto x = [&](int column) { return start_m + half + column * pitch; };
  const int middle = rows / 2;
  const auto y = [&](int row) { return (row - middle - 0.5) * pitch; };
  Terrain terrain = FlatTerrain(friction);
  const auto add = [&](double x0, double x1, double y0, double y1) {
    terrain.obstacles.push_back(BoxOver(fmt::format("wall {}", terrain.obstacles.size() + 1),
                                        {x0 - half, x1 + half, y0 - half, y1 + half}, 0.0, height_m));
  };
  for (int c = 0; c <= columns; ++c) {
    ForRuns(
        rows, [&](int r) { return maze.WallForward(c, r); },
        [&](int first, int end) { add(x(c), x(c), y(first), y(end)); });
  }
  for (int r = 0; r <= rows; ++r) {
    ForRuns(
        columns, [&](int c) { return maze.WallBeside(c, r); },
        [&](int first, int end) { add(x(first), x(end), y(r), y(r)); });
  }
  return terrain;
}

}  // namespace gaitwright::terrain
