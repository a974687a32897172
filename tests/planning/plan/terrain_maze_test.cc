// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "planning/plan/terrain_kinds_internal.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {
namespace {

/// A maze with walls 0.1 m thick and passages 1 m wide.
struct MadeMaze {
  MadeMaze(int columns, int rows, int seed) : ground(TerrainScale{}) {
    ground.start_m = 2.0;
    ground.passage_m = 1.0;
    ground.thickness_m = 0.1;
    ground.columns = columns;
    ground.rows = rows;
    ground.seed = seed;
    terrain = ground.Build();
  }
  Vector2 Middle(int column, int row) const {
    // NOLINTNEXTLINE(bugprone-integer-division): the middle row has its middle at y = 0
    return {2.05 + 0.55 + 1.1 * column, 1.1 * (row - ground.rows / 2)};
  }
  bool Blocked(const Vector2& p) const {
    return std::any_of(terrain.obstacles.begin(), terrain.obstacles.end(), [&](const Obstacle& wall) {
      const Vector2 from = (p - wall.X_WO.translation().head<2>()).cwiseAbs() - 0.5 * wall.size_m.head<2>();
      return from.maxCoeff() < 0.0;
    });
  }
  /// Whether there is a direct passage from a cell to its neighbour.
  bool Open(int column, int row, int dx, int dy) const {
    return !Blocked(Middle(column, row) + 0.55 * Vector2(dx, dy));
  }
  /// Number of passages between cells, and number of cells that can be reached from the entrance.
  std::pair<int, int> Count() const {
    const int columns = ground.columns, rows = ground.rows;
    int passages = 0;
    std::vector<int> reached(static_cast<std::size_t>(columns * rows), 0), open = {rows / 2};
    reached[static_cast<std::size_t>(rows / 2)] = 1;
    for (int c = 0; c < columns; ++c) {
      for (int r = 0; r < rows; ++r) {
        if (c + 1 < columns && Open(c, r, 1, 0)) ++passages;
        if (r + 1 < rows && Open(c, r, 0, 1)) ++passages;
      }
    }
    while (!open.empty()) {
      const int cell = open.back(), c = cell / rows, r = cell % rows;
      open.pop_back();
      const int directions[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
      for (const auto& [dx, dy] : directions) {
        const int x = c + dx, y = r + dy;
        if (x < 0 || y < 0 || x >= columns || y >= rows || !Open(c, r, dx, dy)) continue;
        int& seen = reached[static_cast<std::size_t>(x * rows + y)];
        if (seen == 0) open.push_back(x * rows + y);
        seen = 1;
      }
    }
    return {passages, static_cast<int>(std::count(reached.begin(), reached.end(), 1))};
  }

  terrain::MazeGround ground;
  Terrain terrain;
};

TEST(MazeGround, IsATreeThatReachesEachCell) {
  for (const auto& [columns, rows] : {std::pair(5, 5), std::pair(1, 1), std::pair(7, 3), std::pair(2, 6)}) {
    for (const int seed : {1, 2, 3}) {
      const MadeMaze maze(columns, rows, seed);
      const auto [passages, reached] = maze.Count();
      EXPECT_EQ(reached, columns * rows) << columns << " by " << rows << ", seed " << seed;
      EXPECT_EQ(passages, columns * rows - 1) << "one way between any two cells";
    }
  }
}

TEST(MazeGround, OpensInTheMiddleRowAtBothEndsAndNowhereElse) {
  const MadeMaze maze(4, 5, 7);
  for (int row = 0; row < 5; ++row) {
    EXPECT_EQ(maze.Open(0, row, -1, 0), row == 2) << row;
    EXPECT_EQ(maze.Open(3, row, 1, 0), row == 2) << row;
  }
  for (int column = 0; column < 4; ++column) {
    EXPECT_FALSE(maze.Open(column, 0, 0, -1));
    EXPECT_FALSE(maze.Open(column, 4, 0, 1));
  }
}

TEST(MazeGround, EachCellHasItsWholePassage) {
  const MadeMaze maze(5, 5, 4);
  for (int column = 0; column < 5; ++column) {
    for (int row = 0; row < 5; ++row) {
      for (const Vector2& off : {Vector2(0.49, 0.49), Vector2(-0.49, 0.49), Vector2(0.49, -0.49), Vector2(0.0, 0.0)})
        EXPECT_FALSE(maze.Blocked(maze.Middle(column, row) + off)) << column << ", " << row;
    }
  }
  for (const Obstacle& wall : maze.terrain.obstacles) {
    EXPECT_NEAR(std::min(wall.size_m.x(), wall.size_m.y()), 0.1, 1e-12);
    EXPECT_NEAR(wall.X_WO.translation().z() - 0.5 * wall.size_m.z(), 0.0, 1e-12) << "it stands on the ground";
  }
}

TEST(MazeGround, IsTheSameForASeedAndAnotherForAnother) {
  const auto layout = [](int seed) {
    const MadeMaze maze(6, 6, seed);
    std::vector<bool> open;
    for (int c = 0; c + 1 < 6; ++c) {
      for (int r = 0; r < 6; ++r) open.push_back(maze.Open(c, r, 1, 0));
    }
    return open;
  };
  EXPECT_EQ(layout(1), layout(1));
  EXPECT_NE(layout(1), layout(2));
}

TEST(MazeGround, PassagesAreWideEnoughForTheRobotToTurn) {
  TerrainScale scale;
  for (const double size : {0.3, 1.0}) {
    scale.body_length_m = size;
    scale.body_width_m = 0.5 * size;
    EXPECT_GT(terrain::MazeGround(scale).passage_m, std::hypot(size, 0.5 * size));
  }
}

}  // namespace
}  // namespace gaitwright
