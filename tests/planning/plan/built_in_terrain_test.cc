// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/built_in_terrain.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {
namespace {

Terrain Made(const std::string& spec, const TerrainScale& scale = {}) {
  Result<Terrain> made = MakeTerrain(spec, scale);
  EXPECT_TRUE(made.ok()) << made.failure().message;
  return made.ok() ? *made : Terrain{};
}

std::string ReasonBuiltInTerrainRefused(const std::string& spec) {
  const Result<Terrain> made = MakeTerrain(spec, {});
  EXPECT_FALSE(made.ok()) << spec;
  return made.ok() ? "" : made.failure().message;
}

double Height(const Terrain& terrain, double x, double y = 0.0) {
  const GroundPoint ground = GroundAt(terrain, {x, y});
  return ground.patch < 0 ? -1e9 : ground.height_m;
}

std::vector<TerrainScale> Scales() {
  std::vector<TerrainScale> scales = {{}};
  for (const char* robot : {"a1", "nao"}) scales.push_back(ScaleOf(*LoadNamedRobot(robot)));
  return scales;
}

double ParameterOf(const std::string& spec, const std::string& key, const TerrainScale& scale) {
  const Result<std::vector<TerrainParameter>> parameters = TerrainParameters(spec, scale);
  for (const TerrainParameter& parameter : *parameters) {
    if (parameter.key == key) return std::stod(parameter.value);
  }
  ADD_FAILURE() << spec << " has no " << key;
  return 0.0;
}

/// Whether a point is inside of an obstacle with vertical walls, in plan view.
bool Within(const Obstacle& box, const Vector2& p, double beside) {
  const Vector2 from = (p - box.X_WO.translation().head<2>()).cwiseAbs() - 0.5 * box.size_m.head<2>();
  return from.maxCoeff() < beside;
}

bool Blocked(const Terrain& terrain, const Vector2& p, double beside) {
  return std::any_of(terrain.obstacles.begin(), terrain.obstacles.end(),
                     [&](const Obstacle& obstacle) { return Within(obstacle, p, beside); });
}

TEST(BuiltInTerrain, BeginsOneBodyLengthInFrontOfEveryRobot) {
  for (const TerrainScale& scale : Scales()) {
    for (const BuiltInTerrain& entry : BuiltInTerrains()) {
      SCOPED_TRACE(entry.name);
      const Terrain terrain = Made(entry.name, scale);
      EXPECT_EQ(terrain.name, entry.name);
      const double start = scale.front_m + scale.body_length_m;
      for (double x = -scale.front_m - 1.0; x < 0.94 * start; x += 0.05 * start) {
        for (double y = -2.0; y <= 2.0; y += 0.25) {
          ASSERT_EQ(Height(terrain, x, y), 0.0) << x << ", " << y;
          ASSERT_FALSE(Blocked(terrain, {x, y}, 0.0)) << x << ", " << y;
        }
      }
      if (entry.name == "flat") continue;
      bool different = false;
      const double x = ParameterOf(entry.name, "start_m", scale) + 0.02;
      EXPECT_NEAR(x, start, 0.02 + 0.05 * start);
      for (double y = -0.5; y <= 0.5; y += 0.02) {
        different = different || Height(terrain, x, y) != 0.0 || Blocked(terrain, {x, y}, 0.02);
      }
      EXPECT_TRUE(different) << "there is something at the start of it";
    }
  }
}

TEST(BuiltInTerrain, ItsPartsAreSound) {
  for (const TerrainScale& scale : Scales()) {
    for (const BuiltInTerrain& entry : BuiltInTerrains()) {
      SCOPED_TRACE(entry.name);
      const Terrain terrain = Made(entry.name, scale);
      std::set<std::string> names;
      for (const TerrainPatch& patch : terrain.patches) {
        EXPECT_TRUE(names.insert(patch.name).second) << patch.name << " is given twice";
        EXPECT_GT(patch.X_WT.linear()(2, 2), 0.5);
        EXPECT_NEAR((patch.X_WT.linear().transpose() * patch.X_WT.linear() - Matrix3::Identity()).norm(), 0.0, 1e-12);
        if (!patch.outline_T.empty()) {
          EXPECT_NEAR(ShareOfHull(patch.outline_T), 1.0, 1e-9);
        }
      }
      for (const HeightField& field : terrain.height_fields)
        EXPECT_EQ(field.height_m.size(), static_cast<std::size_t>(field.columns * field.rows));
      for (const Obstacle& obstacle : terrain.obstacles) {
        EXPECT_TRUE(names.insert(obstacle.name).second) << obstacle.name << " is given twice";
        EXPECT_GT(obstacle.size_m.minCoeff(), 0.0);
      }
    }
  }
}

TEST(BuiltInTerrain, StairsGoUpAndDownAsAsked) {
  const Terrain stairs = Made("stairs:rise_m=0.07,tread_m=0.25,count=3,start_m=1,landing_m=0.8");
  const std::vector<std::pair<double, double>> known = {{0.99, 0.0},  {1.01, 0.07}, {1.24, 0.07}, {1.26, 0.14},
                                                        {1.49, 0.14}, {1.51, 0.21}, {2.29, 0.21}, {2.31, 0.14},
                                                        {2.54, 0.14}, {2.56, 0.07}, {2.79, 0.07}, {2.81, 0.0}};
  for (const auto& [x, height] : known) EXPECT_NEAR(Height(stairs, x), height, 1e-12) << x;
  EXPECT_EQ(stairs.name, "stairs:rise_m=0.07,tread_m=0.25,count=3,start_m=1,landing_m=0.8");
  EXPECT_EQ(stairs.patches[1].name, "step 1");
  for (const TerrainScale& scale : Scales())
    EXPECT_GE(ParameterOf("stairs", "landing_m", scale), scale.body_length_m) << "room for the robot on top";
}

TEST(BuiltInTerrain, SlopesHaveTheirAngle) {
  const Terrain slope = Made("slope:angle_deg=15,start_m=1,length_m=2,plateau_m=1");
  const double rise = std::tan(15.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(Height(slope, 2.0), rise, 1e-12);
  EXPECT_NEAR(Height(slope, 3.5), 2.0 * rise, 1e-12);
  EXPECT_NEAR(Height(slope, 5.0), rise, 1e-12);
  EXPECT_EQ(Height(slope, 6.01), 0.0);
  const double cosine = std::cos(15.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(GroundAt(slope, {2.0, 0.0}).normal_W.z(), cosine, 1e-12);
  const Terrain ramp = Made("ramp:angle_deg=15,start_m=1,length_m=2");
  EXPECT_NEAR(Height(ramp, 2.0), rise, 1e-12);
  EXPECT_NEAR(Height(ramp, 9.0), 2.0 * rise, 1e-12) << "the ground stays high";
}

TEST(BuiltInTerrain, GapsAndBeamsHaveNothingBeside) {
  const Terrain gap = Made("gap:start_m=1,width_m=0.15");
  for (const double y : {-5.0, 0.0, 5.0}) {
    EXPECT_EQ(Height(gap, 0.999, y), 0.0);
    EXPECT_EQ(GroundAt(gap, {1.001, y}).patch, -1);
    EXPECT_EQ(GroundAt(gap, {1.149, y}).patch, -1);
    EXPECT_EQ(Height(gap, 1.151, y), 0.0);
  }
  const Terrain beam = Made("beam:start_m=1,width_m=0.3,length_m=2");
  EXPECT_EQ(Height(beam, 2.0, 0.149), 0.0);
  EXPECT_EQ(GroundAt(beam, {2.0, 0.151}).patch, -1);
  EXPECT_EQ(Height(beam, 1.0), 0.0) << "no crack at the seam";
  EXPECT_EQ(Height(beam, 3.0), 0.0);
}

TEST(BuiltInTerrain, StonesStayInTheirPlacesAndApart) {
  const std::string spec =
      "stepping-stones:size_m=0.12,spacing_m=0.2,jitter_m=0.03,height_jitter_m=0.02,rows=3,count=9";
  const Terrain stones = Made(spec + ",seed=4");
  ASSERT_EQ(stones.patches.size(), 2U + 27U);
  double least_gap = 1.0, spread = 0.0;
  for (std::size_t i = 2; i < stones.patches.size(); ++i) {
    const Vector3 p = stones.patches[i].X_WT.translation();
    EXPECT_LE(std::abs(p.z()), 0.02);
    spread = std::max(spread, std::abs(p.z()));
    for (std::size_t j = 2; j < i; ++j) {
      const Vector3 by = p - stones.patches[j].X_WT.translation();
      least_gap = std::min(least_gap, by.head<2>().cwiseAbs().maxCoeff() - 0.12);
    }
  }
  EXPECT_GE(least_gap, 0.2 - 0.12 - 2.0 * 0.03 - 1e-12);
  EXPECT_GT(spread, 0.01) << "they do differ in height";
  const Terrain again = Made(spec + ",seed=4"), other = Made(spec + ",seed=5");
  EXPECT_EQ(again.patches[5].X_WT.translation(), stones.patches[5].X_WT.translation());
  EXPECT_NE(other.patches[5].X_WT.translation(), stones.patches[5].X_WT.translation());
  EXPECT_NE(ReasonBuiltInTerrainRefused("stepping-stones:size_m=0.12,spacing_m=0.2,jitter_m=0.05")
                .find("jitter_m may be 0.04"),
            std::string::npos);
}

TEST(BuiltInTerrain, RoughGroundRisesFromTheLevelAroundIt) {
  for (const TerrainScale& scale : Scales()) {
    const Terrain rough = Made("rough:amplitude_m=0.03,seed=3", scale);
    const HeightField& field = rough.height_fields.at(0);
    const auto [low, high] = std::minmax_element(field.height_m.begin(), field.height_m.end());
    EXPECT_GE(*low, 0.0);
    EXPECT_LE(*high, 0.06);
    EXPECT_GT(*high, 0.035);
    for (int i = 0; i < field.columns; ++i) {
      EXPECT_EQ(field.height_m[static_cast<std::size_t>(i)], 0.0);
      EXPECT_EQ(field.height_m[static_cast<std::size_t>((field.rows - 1) * field.columns + i)], 0.0);
    }
    double steepest = 0.0;  // no cliff anywhere, including the rim
    for (double x = field.origin_W.x() - 0.1; x < field.origin_W.x() + 1.0; x += 0.005)
      steepest = std::max(steepest, std::abs(Height(rough, x + 0.005, 0.1) - Height(rough, x, 0.1)));
    EXPECT_LT(steepest, 0.005);
    EXPECT_GT(steepest, 0.0001);
  }
  EXPECT_NE(Made("rough:seed=1").height_fields[0].height_m, Made("rough:seed=2").height_fields[0].height_m);
  EXPECT_NE(ReasonBuiltInTerrainRefused("rough:length_m=100,width_m=100,resolution_m=0.001").find("points"),
            std::string::npos);
}

TEST(BuiltInTerrain, CinderBlocksTiltButNeverSinkBelowTheGround) {
  const Terrain blocks = Made("cinder-blocks:tilt_deg=10,height_m=0.02,block_m=0.2,count=20,rows=5");
  const double upright = std::cos(10.0 * std::numbers::pi / 180.0);
  int level = 0, tilted = 0;
  for (std::size_t i = 1; i < blocks.patches.size(); ++i) {
    const TerrainPatch& block = blocks.patches[i];
    const double z = block.X_WT.linear()(2, 2);
    (z > 1.0 - 1e-12 ? level : tilted) += 1;
    EXPECT_TRUE(z > 1.0 - 1e-12 || std::abs(z - upright) < 1e-12);
    for (const Vector2& corner : block.outline_T)
      EXPECT_GE((block.X_WT * Vector3(corner.x(), corner.y(), 0.0)).z(), 0.02 - 1e-9);
  }
  EXPECT_EQ(level + tilted, 100);
  EXPECT_GT(level, 5);
  EXPECT_GT(tilted, 50);
}

TEST(BuiltInTerrain, ADoorwayIsOpenAsWideAndHighAsSaid) {
  const Terrain door = Made("doorway:start_m=1,passage_m=0.8,height_m=0.7,thickness_m=0.1,length_m=4,offset_m=0.5");
  EXPECT_TRUE(Blocked(door, {1.05, 0.09}, 0.0));
  EXPECT_TRUE(Blocked(door, {1.05, 0.91}, 0.0));
  EXPECT_TRUE(Blocked(door, {1.05, -1.99}, 0.0));
  EXPECT_FALSE(Blocked(door, {1.05, 2.01}, 0.0));
  const Obstacle& lintel = door.obstacles[2];
  EXPECT_TRUE(Within(lintel, {1.05, 0.5}, 0.0));
  EXPECT_NEAR(lintel.X_WO.translation().z() - 0.5 * lintel.size_m.z(), 0.7, 1e-12);
  EXPECT_NE(ReasonBuiltInTerrainRefused("doorway:length_m=1,offset_m=2").find("not within"), std::string::npos);
}

/// Whether a point gets from the start to the goal of a maze over the cells of a grid, with distance `beside` to every
/// wall.
bool HasWay(const Terrain& terrain, double end_x, double beside) {
  constexpr double kStep = 0.1;
  const int columns = static_cast<int>(end_x / kStep) + 10, rows = 260, middle = rows / 2;
  std::vector<char> seen(static_cast<std::size_t>(columns * rows), 0);
  std::vector<int> open = {rows / 2};
  seen[static_cast<std::size_t>(open[0])] = 1;
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    const int column = at / rows, row = at % rows;
    if (column * kStep > end_x) return true;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int x = column + dx, y = row + dy;
      if (x < 0 || y < 0 || x >= columns || y >= rows) continue;
      // The search cannot go around the maze: its field ends where the maze ends.
      const std::size_t next = static_cast<std::size_t>(x * rows + y);
      const Vector2 p(x * kStep, (y - middle) * kStep);
      if (seen[next] || Blocked(terrain, p, beside)) continue;
      seen[next] = 1;
      open.push_back(x * rows + y);
    }
  }
  return false;
}

TEST(BuiltInTerrain, EveryMazeHasARouteThrough) {
  for (int seed = 0; seed < 20; ++seed) {
    // Wide enough that the search cannot go around: 25 cells of 1.1 m over 26 m.
    const Terrain maze =
        Made(fmt::format("maze:start_m=1,columns=4,rows=25,passage_m=1,thickness_m=0.1,seed={}", seed));
    EXPECT_TRUE(HasWay(maze, 6.0, 0.3)) << seed;
    EXPECT_FALSE(HasWay(maze, 6.0, 0.51)) << "a passage is as wide as it says";
  }
  EXPECT_NE(Made("maze:seed=1").obstacles.size(), 0U);
}

TEST(BuiltInTerrain, WrongTextsAreRefusedWithWhatWouldBeAccepted) {
  EXPECT_NE(ReasonBuiltInTerrainRefused("stair").find("nearest is 'stairs'"), std::string::npos);
  for (const BuiltInTerrain& entry : BuiltInTerrains())
    EXPECT_NE(ReasonBuiltInTerrainRefused("steps").find("'" + entry.name + "'"), std::string::npos);
  EXPECT_EQ(ReasonBuiltInTerrainRefused("stairs:rise=0.07"),
            "terrain 'stairs': unknown option 'rise'; the nearest is 'rise_m'");
  EXPECT_NE(ReasonBuiltInTerrainRefused("stairs:rise_m=300").find("is 300 m; accepted: 0.001 to 1"), std::string::npos);
  EXPECT_NE(ReasonBuiltInTerrainRefused("stairs:rise_m=nan").find("rise_m"), std::string::npos);
  EXPECT_NE(ReasonBuiltInTerrainRefused("stairs:count=2.5").find("whole number"), std::string::npos);
  EXPECT_NE(ReasonBuiltInTerrainRefused("stairs:rise_m=0.1,rise_m=0.2").find("twice"), std::string::npos);
  for (const char* spec : {"stairs:", "stairs:rise_m", "stairs:=3", "stairs:rise_m=0.1,"})
    EXPECT_NE(ReasonBuiltInTerrainRefused(spec).find("key=value"), std::string::npos) << spec;
  EXPECT_NE(ReasonBuiltInTerrainRefused("").find("'flat'"), std::string::npos);
}

TEST(ScaleOf, MeasuresTheStandingRobot) {
  const TerrainScale a1 = ScaleOf(*LoadNamedRobot("a1")), nao = ScaleOf(*LoadNamedRobot("nao"));
  EXPECT_NEAR(a1.foot_length_m, 0.04, 1e-9) << "the diameter of its spheres";
  EXPECT_GT(a1.body_length_m, 0.36) << "longer than from hip to hip";
  EXPECT_LT(a1.body_length_m, 0.8);
  EXPECT_GT(nao.foot_length_m, 0.1);
  EXPECT_GT(nao.stance_width_m, nao.foot_width_m);
  EXPECT_GT(nao.body_height_m, 0.45);
  for (const TerrainScale& scale : {a1, nao}) {
    EXPECT_LE(scale.front_m, scale.body_length_m);
    EXPECT_LE(scale.stance_width_m, scale.body_width_m);
  }
}

}  // namespace
}  // namespace gaitwright
