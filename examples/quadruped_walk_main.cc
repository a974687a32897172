// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/quadruped_walk.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("Plans, audits, plays and scores a walk of 1 m of a quadruped", "quadruped_walk");
  std::string robot = "a1", gait = "trot";
  double speed_m_s = 0.5;
  app.add_option("--robot", robot, "Name of a built-in robot")->capture_default_str();
  app.add_option("--gait", gait, "Name of a gait for its number of feet")->capture_default_str();
  app.add_option("--speed", speed_m_s, "Speed [m/s]")->capture_default_str();
  try {
    app.parse(argc, argv);
    const examples::WalkedQuadruped walk = examples::WalkQuadruped(robot, gait, speed_m_s);
    fmt::print("planned  {:.2f} s of {}\n", walk.plan.duration_s(), GaitNames(walk.plan.parts));
    fmt::print("audited  {} at {} samples\n", walk.audit.pass() ? "pass" : "fail", walk.audit.samples);
    fmt::print("played   {:.3f} m/s reached of {:.3f} m/s\n", walk.speed_m_s, speed_m_s);
    fmt::print("scored   {}, {:.1f} of 100: {}\n", walk.report.pass ? "pass" : "fail", walk.report.score,
               walk.report.reason);
    return walk.audit.pass() && walk.report.pass ? 0 : 3;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "quadruped_walk: {}\n", error.what());
    return 1;
  }
}
