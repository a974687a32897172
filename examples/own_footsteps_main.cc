// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/own_footsteps.h"
#include "examples/walk_own_footsteps.h"
#include "kinematics/model/load_robot.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("A user's own footsteps along an arc; the rest of the motion is planned over them", "own_footsteps");
  std::string robot = "a1";
  double radius_m = 0.6, turn_rad = 1.2, stride_m = 0.12;
  app.add_option("--robot", robot, "Name of a built-in robot")->capture_default_str();
  app.add_option("--radius", radius_m, "Radius of the arc [m]")->capture_default_str();
  app.add_option("--turn", turn_rad, "Angle of the arc, positive to the left [rad]")->capture_default_str();
  app.add_option("--stride", stride_m, "Largest advance in a cycle of all feet [m]")->capture_default_str();
  try {
    app.parse(argc, argv);
    const Result<RobotModel> model = LoadNamedRobot(robot);
    if (!model) throw InvalidArgument(model.failure().message);
    const auto steps = examples::StepsOnArc(*model, radius_m, turn_rad, stride_m);
    const examples::WalkedSteps walk = examples::WalkSteps(*model, steps);
    fmt::print("planned  {} steps, {:.2f} s\n", steps.size(), walk.plan.duration_s());
    fmt::print("audited  {} at {} samples\n", walk.audit.pass() ? "pass" : "fail", walk.audit.samples);
    fmt::print("played   each foot within {:.1f} mm of its step\n", 1e3 * walk.miss_m);
    fmt::print("scored   {}, {:.1f} of 100: {}\n", walk.report.pass ? "pass" : "fail", walk.report.score,
               walk.report.reason);
    return walk.audit.pass() && walk.report.pass ? 0 : 3;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "own_footsteps: {}\n", error.what());
    return 1;
  }
}
