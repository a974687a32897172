// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/stairs.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("A quadruped climbs stairs; prints on which steps its feet came down", "stairs");
  std::string robot = "a1", terrain = "stairs:rise_m=0.07,tread_m=0.25,count=3";
  double distance_m = 4.0;
  app.add_option("--robot", robot, "Name of a built-in robot")->capture_default_str();
  app.add_option("--terrain", terrain, "Ground, see docs/terrain-format.md")->capture_default_str();
  app.add_option("--distance", distance_m, "Forward distance [m]")->capture_default_str();
  try {
    app.parse(argc, argv);
    const examples::Climb climb = examples::ClimbStairs(robot, terrain, distance_m);
    fmt::print("{:<14} {:>8} {:>8} {:>10}\n", "patch", "planned", "stepped", "height");
    for (const examples::PatchTread& tread : climb.treads)
      fmt::print("{:<14} {:>8} {:>8} {:>8.3f} m\n", tread.patch, tread.planned, tread.measured, tread.height_m);
    fmt::print("{}, {:.1f} of 100: {}\n", climb.report.pass ? "pass" : "fail", climb.report.score, climb.report.reason);
    return climb.report.pass ? 0 : 3;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stairs: {}\n", error.what());
    return 1;
  }
}
