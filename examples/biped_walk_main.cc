// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/biped_walk.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("A biped walks, and its ZMP stays inside the support polygon", "biped_walk");
  std::string robot = "nao";
  int steps = 6;
  double step_length_m = 0.04;
  app.add_option("--robot", robot, "Name of a built-in biped")->capture_default_str();
  app.add_option("--steps", steps, "Number of footfalls; the last one closes the stance")->capture_default_str();
  app.add_option("--step-length", step_length_m, "Forward advance in a footfall [m]")->capture_default_str();
  try {
    app.parse(argc, argv);
    const examples::BipedWalk walk = examples::WalkBiped(robot, steps, step_length_m);
    fmt::print("walked  {:.3f} m in {} steps\n", walk.report.At("distance_m").value.value_or(0.0), steps);
    fmt::print("ZMP     at least {:.1f} mm inside the support on one foot, {:.1f} mm on both\n",
               1e3 * walk.margin_one_foot_m, 1e3 * walk.margin_both_feet_m);
    fmt::print("scored  {}, {:.1f} of 100: {}\n", walk.report.pass ? "pass" : "fail", walk.report.score,
               walk.report.reason);
    return walk.report.pass ? 0 : 3;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "biped_walk: {}\n", error.what());
    return 1;
  }
}
