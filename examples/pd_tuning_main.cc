// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/pd_tuning.h"
#include "examples/standing_by_pd.h"
#include "examples/step_picture.h"
#include "kinematics/base/file.h"
#include "kinematics/model/load_robot.h"

namespace {

using namespace gaitwright;
using namespace gaitwright::examples;

void PrintStep(const JointStep& step) {
  const StepShape got = ShapeOf(step.simulated, step.step_s), known = ShapeOf(step.formula, step.step_s);
  fmt::print("{:7g} {:7g} {:9.1f} {:8.2f}  {:6.3f} ({:5.3f})  {:6.1f} ({:4.1f})  {:6.3f} ({:5.3f})  {:7.0f}\n",
             step.stiffness, step.damping, step.frequency_rad_s, step.damping_ratio, got.rise_s, known.rise_s,
             1e2 * got.overshoot, 1e2 * known.overshoot, got.settling_s, known.settling_s, 1e2 * step.torque_use);
}

void PrintStanding(const RobotModel& model, double scale) {
  const StoodByPd ankles = StandByPd(model, scale, true), whole = StandByPd(model, scale, false);
  const std::string lean = fmt::format("{:.4f} ({:.4f})", ankles.lean_rad, ankles.lean_formula_rad);
  fmt::print("{:7.3f} {:9.1f} {:9.2f}  {:>21}  {:>14}\n", scale, ankles.ankles_nm_rad,
             ankles.ankles_nm_rad / ankles.needed_nm_rad, ankles.stands ? lean : "falls",
             whole.stands ? fmt::format("{:.2f}", 1e3 * whole.sag_m) : "falls");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Effect of stiffness and damping on one joint in the air, and on a standing robot", "pd_tuning");
  std::string robot = "nao", joint = "LHipPitch", plot;
  std::vector<double> stiffness = {5.0, 10.0, 20.0}, damping = {0.2, 0.6, 1.4},
                      scales = {2.0, 1.0, 0.5, 0.25, 0.15, 0.1, 0.07, 0.05};
  double step_rad = 0.05;
  app.add_option("--robot", robot, "Name of a built-in robot")->capture_default_str();
  app.add_option("--joint", joint, "Joint with the step in its target")->capture_default_str();
  app.add_option("--step", step_rad, "Size of the step [rad]")->capture_default_str();
  app.add_option("--stiffness", stiffness, "kp, one or more [N m/rad]")->capture_default_str();
  app.add_option("--damping", damping, "kd, each with each kp [N m s/rad]")->capture_default_str();
  app.add_option("--scales", scales, "Factor on all gains, for standing")->capture_default_str();
  app.add_option("--plot", plot, "SVG to write: the step responses");
  try {
    app.parse(argc, argv);
    const Result<RobotModel> model = LoadNamedRobot(robot);
    if (!model) throw InvalidArgument(model.failure().message);
    std::vector<JointStep> steps;
    fmt::print("Step of {} in the air; values of the formula in brackets\n", joint);
    fmt::print("     kp      kd   w rad/s     zeta    rise s         overshoot %    settling s      torque %\n");
    for (const double kp : stiffness)
      for (const double kd : damping) {
        steps.push_back(StepJoint(*model, joint, kp, kd, step_rad));
        PrintStep(steps.back());
      }
    if (!plot.empty()) {
      const auto written = WriteFileAtomically(plot, StepPicture(steps, static_cast<int>(damping.size())));
      if (!written) throw InvalidArgument(written.failure().message);
      fmt::print("{}\n", *written);
    }
    if (!model->feet.front().has_sole()) return 0;  // no ankles
    fmt::print("\nStanding without feed-forward, with all joints but the ankles welded, and with all joints free\n");
    fmt::print("  scale  k N m/rad  k / m g h    lean of ankles rad    sag of base mm\n");
    for (const double scale : scales) PrintStanding(*model, scale);
    fmt::print("smallest scale at which it stands: {:.3f} with ankles alone, {:.3f} with all joints\n",
               LeastScale(*model, true), LeastScale(*model, false));
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "pd_tuning: {}\n", error.what());
    return 1;
  }
}
