// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/own_robot.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("Plans a walk for a robot from its URDF alone", "own_robot");
  std::string urdf;
  app.add_option("URDF", urdf, "Path of the URDF file")->required();
  try {
    app.parse(argc, argv);
    const Result<RobotModel> model = examples::ReadOwnRobot(urdf);
    if (!model) {
      fmt::print(stderr, "own_robot: {}", examples::ReasonRefused(model.failure()));
      return 1;
    }
    fmt::print("{}", examples::WhatWasDerived(*model));
    const Result<PlannedWalk> walk = examples::PlanOwnWalk(*model);
    if (!walk) {
      fmt::print("cannot walk: {}", examples::ReasonRefused(walk.failure()));
      return 2;
    }
    const MotionPlan& plan = walk->motion.plan;
    fmt::print("walks {:.2f} m in {:.2f} s of {}\n", plan.goal.x_m, plan.duration_s(), GaitNames(plan.parts));
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "own_robot: {}\n", error.what());
    return 1;
  }
}
