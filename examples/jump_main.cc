// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/jump.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("A quadruped leaps; prints its time in the air and the height it gains", "jump");
  std::string robot = "a1";
  double length_m = 0.4;
  app.add_option("--robot", robot, "Name of a built-in quadruped")->capture_default_str();
  app.add_option("--length", length_m, "Forward distance [m]")->capture_default_str();
  try {
    app.parse(argc, argv);
    const examples::Leap leap = examples::LeapForward(robot, length_m);
    fmt::print("in the air  {:.3f} s, planned {:.3f} s\n", leap.air_s, leap.planned_air_s);
    fmt::print("height      {:.3f} m gained, then {:.3f} m down\n", leap.rise_m, leap.drop_m);
    fmt::print("scored      {}, {:.1f} of 100: {}\n", leap.report.pass ? "pass" : "fail", leap.report.score,
               leap.report.reason);
    return leap.report.pass ? 0 : 3;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "jump: {}\n", error.what());
    return 1;
  }
}
