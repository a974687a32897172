// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "examples/shift_picture.h"
#include "examples/zmp_demonstration.h"
#include "kinematics/base/file.h"
#include "kinematics/model/load_robot.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("A standing robot shifts its body, slowly and fast: how its ZMP moves, and when the robot tips",
               "zmp_demonstration");
  std::string robot = "nao", plot;
  double forward_m = 0.0, left_m = 0.03;
  std::vector<double> durations_s = {2.0, 1.0, 0.6, 0.4, 0.3, 0.25, 0.2};
  app.add_option("--robot", robot, "Name of a built-in robot")->capture_default_str();
  app.add_option("--ahead", forward_m, "Forward shift of the centre of mass [m]")->capture_default_str();
  app.add_option("--left", left_m, "Shift of the centre of mass to the left [m]")->capture_default_str();
  app.add_option("--durations", durations_s, "Durations of the shifts, in order [s]")->capture_default_str();
  app.add_option("--plot", plot, "SVG to write: ZMP, centre of mass and support over time");
  try {
    app.parse(argc, argv);
    const Result<RobotModel> model = LoadNamedRobot(robot);
    if (!model) throw InvalidArgument(model.failure().message);
    fmt::print("   in   ZMP off the CoM  off c - (z/g) c''  margin planned  measured    tilt\n");
    std::vector<examples::ShownShift> shifts;
    for (const double duration_s : durations_s) {
      shifts.push_back(examples::ShiftBody(*model, {forward_m, left_m}, duration_s));
      const examples::ShownShift& s = shifts.back();
      fmt::print("{:.2f} s  {:12.1f} mm  {:14.1f} mm  {:11.1f} mm  {:5.1f} mm  {:5.3f} rad{}\n", s.duration_s,
                 1e3 * s.lead_m, 1e3 * s.off_formula_m, 1e3 * s.margin_planned_m, 1e3 * s.margin_measured_m, s.tilt_rad,
                 s.fell ? ", falls" : "");
    }
    if (plot.empty()) return 0;
    const auto written =
        WriteFileAtomically(plot, examples::ShiftPicture(shifts, std::abs(forward_m) > std::abs(left_m) ? 0 : 1));
    if (!written) throw InvalidArgument(written.failure().message);
    fmt::print("{}\n", *written);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "zmp_demonstration: {}\n", error.what());
    return 1;
  }
}
