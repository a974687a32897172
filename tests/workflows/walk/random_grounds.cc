// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/random_grounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {
namespace {

/// A value as written to the file: four digits after the decimal point.
double Written(double value) { return std::round(1e4 * value) / 1e4; }

/// Random numbers that are equal with every standard library.
class Draws {
 public:
  Draws(RandomGroundKind kind, std::uint64_t seed) : engine_(3 * seed + static_cast<std::uint64_t>(kind)) {}

  double Between(double low, double high) {
    const double share = static_cast<double>(engine_() >> 11U) * 0x1p-53;
    return Written(low + share * (high - low));
  }
  /// An integer from low to high, both included.
  int Number(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_;
};

RandomGround Straight(const std::string& terrain, double distance_m) {
  RandomGround ground;
  ground.terrain = terrain;
  ground.command.distance_m = distance_m;
  ground.flags = fmt::format("--terrain {} --distance {:.4g}", terrain, distance_m);
  return ground;
}

/// Distance beyond a feature at which the whole robot has passed it.
double Beyond(const TerrainScale& scale) { return scale.body_length_m - scale.front_m + 0.25 * scale.leg_length_m; }

RandomGround Stones(Draws& draws, std::uint64_t seed, const TerrainScale& scale) {
  const double leg = scale.leg_length_m;
  const double start = scale.front_m + 0.25 * leg;
  const double size = std::max(1.25 * scale.foot_length_m, 0.3 * leg) * draws.Between(0.8, 1.3);
  const double gap = leg * draws.Between(0.08, 0.4);
  const double jitter = 0.5 * gap * draws.Between(0.0, 0.9), height = leg * draws.Between(0.0, 0.1);
  const int count = std::max(1, static_cast<int>(leg * draws.Between(2.0, 3.5) / (size + gap)));
  const double end = start + gap + count * (size + gap);
  return Straight(fmt::format("stepping-stones:start_m={:.4f},size_m={:.4f},spacing_m={:.4f},jitter_m={:.4f},"
                              "height_jitter_m={:.4f},count={},seed={}",
                              start, size, size + gap, jitter, height, count, seed),
                  std::round(100.0 * std::clamp(end + Beyond(scale), 4.0 * leg, 6.0 * leg)) / 100.0);
}

RandomGround Rough(Draws& draws, std::uint64_t seed, const TerrainScale& scale) {
  const double leg = scale.leg_length_m, amplitude = 0.02 * leg * draws.Between(0.5, 1.5);
  return Straight(fmt::format("rough:start_m={:.4f},amplitude_m={:.4f},length_m={:.4f},seed={}",
                              scale.front_m + 0.25 * leg, amplitude, 3.0 * leg, seed),
                  std::round(100.0 * leg * draws.Between(4.0, 5.0)) / 100.0);
}

/// A wall in plan view.
struct Wall {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0, length_m = 0.0;

  /// Distance of a point from its centre line.
  double From(double x, double y) const {
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    const double along = c * (x - x_m) + s * (y - y_m), across = c * (y - y_m) - s * (x - x_m);
    return std::hypot(std::max(0.0, std::abs(along) - 0.5 * length_m), across);
  }
};

std::vector<Wall> WallsBetween(Draws& draws, const Vector2& goal_W, double radius_m) {
  constexpr double kFreeStart = 1.5, kFreeGoal = 0.8;  // free space around them, as multiples of the robot's radius
  std::vector<Wall> walls(static_cast<std::size_t>(draws.Number(2, 5)));
  for (Wall& wall : walls) {
    do {
      wall.x_m = draws.Between(radius_m, goal_W.x());
      wall.y_m = draws.Between(-3.0 * radius_m, 3.0 * radius_m);
      wall.yaw_rad = draws.Between(0.0, std::numbers::pi);
      wall.length_m = draws.Between(radius_m, 4.0 * radius_m);
    } while (wall.From(0.0, 0.0) < kFreeStart * radius_m || wall.From(goal_W.x(), goal_W.y()) < kFreeGoal * radius_m);
  }
  return walls;
}

std::vector<Wall> WallsAround(Draws& draws, double x_m, double y_m, double radius_m) {
  const double turned = draws.Between(0.0, 0.5 * std::numbers::pi), away = 1.8 * radius_m;
  std::vector<Wall> walls;
  for (int side = 0; side < 4; ++side) {
    const double at = turned + 0.5 * std::numbers::pi * side;
    walls.push_back({x_m + away * std::cos(at), y_m + away * std::sin(at), at + 0.5 * std::numbers::pi, 2.2 * away});
  }
  return walls;
}

std::string YamlOf(const std::vector<Wall>& walls, const TerrainScale& scale) {
  std::string text = "patches:\n  - {name: ground, height_m: 0}\nobstacles:\n";
  const double height = 1.2 * scale.body_height_m, thickness = 0.2 * scale.leg_length_m;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Wall& wall = walls[i];
    text += fmt::format(
        "  - {{name: wall {}, type: box, size_m: [{:.4f}, {:.4f}, {:.4f}], position_m: [{:.4f}, {:.4f}, {:.4f}], "
        "yaw_deg: {:.2f}}}\n",
        i + 1, wall.length_m, thickness, height, wall.x_m, wall.y_m, 0.5 * height,
        std::remainder(wall.yaw_rad * 180.0 / std::numbers::pi, 360.0));
  }
  return text;
}

RandomGround Walls(Draws& draws, std::uint64_t seed, const TerrainScale& scale, const std::string& folder) {
  constexpr std::uint64_t kClosed = 6;  // one goal in this number is walled in
  const double leg = scale.leg_length_m, radius = 0.5 * std::hypot(scale.body_length_m, scale.body_width_m);
  RandomGround ground;
  WalkCommand& command = ground.command;
  command.extent = WalkCommand::Extent::kGoal;
  command.goal_x_m = Written(leg * draws.Between(4.0, 6.0));
  command.goal_y_m = Written(leg * draws.Between(-1.0, 1.0));
  command.goal_yaw_rad = Written(0.25 * std::numbers::pi * draws.Number(-2, 2));
  const std::vector<Wall> walls = seed % kClosed == 0
                                      ? WallsAround(draws, command.goal_x_m, command.goal_y_m, radius)
                                      : WallsBetween(draws, {command.goal_x_m, command.goal_y_m}, radius);
  std::filesystem::create_directories(folder);
  ground.terrain = fmt::format("{}/walls-{:.0f}mm-{}.yaml", folder, 1e3 * leg, seed);
  std::ofstream file(ground.terrain);
  file << YamlOf(walls, scale);
  if (!file.good()) throw InvalidArgument("cannot write " + ground.terrain);
  ground.flags = fmt::format("--terrain {} --goal={:.4f},{:.4f},{:.4f}", ground.terrain, command.goal_x_m,
                             command.goal_y_m, command.goal_yaw_rad);
  return ground;
}

}  // namespace

std::string NameOf(RandomGroundKind kind) {
  switch (kind) {
    case RandomGroundKind::kStones:
      return "stones";
    case RandomGroundKind::kRough:
      return "rough";
    case RandomGroundKind::kWalls:
      return "walls";
  }
  return "";
}

void PrintTo(RandomGroundKind kind, std::ostream* out) { *out << NameOf(kind); }

RandomGround MakeRandomGround(RandomGroundKind kind, std::uint64_t seed, const TerrainScale& scale,
                              const std::string& folder) {
  Draws draws(kind, seed);
  switch (kind) {
    case RandomGroundKind::kStones:
      return Stones(draws, seed, scale);
    case RandomGroundKind::kRough:
      return Rough(draws, seed, scale);
    case RandomGroundKind::kWalls:
      return Walls(draws, seed, scale, folder);
  }
  throw InvalidArgument("no such kind of ground");
}

}  // namespace gaitwright
