// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/standing_control.h"
#include "kinematics/base/file.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("Classic standing strategies: the largest push that each of them withstands", "standing_control");
  std::string robot = "humanoid", plot;
  double most_n = 500.0;
  std::vector<double> directions_deg = {0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0};
  std::vector<std::string> strategies = examples::StandingStrategies();
  app.add_option("--robot", robot, "Name of a built-in robot; the ankle and hip strategies are for bipeds")
      ->capture_default_str();
  app.add_option("--ways", strategies, "Standing strategies to try")->capture_default_str();
  app.add_option("--directions", directions_deg, "Directions of the pushes: 0 is forward, 90 is left [degree]")
      ->capture_default_str();
  app.add_option("--most", most_n, "Largest push to try [N]")->capture_default_str();
  app.add_option("--plot", plot, "SVG to write: the largest pushes by direction");
  try {
    app.parse(argc, argv);
    const examples::Stander stander = examples::MakeStander(robot);
    fmt::print("largest push for 0.1 s [N] by direction [degree]\n{:>14}", "");
    for (const double direction_deg : directions_deg) fmt::print("{:6.0f}", direction_deg);
    fmt::print("\n");
    std::vector<examples::PushesTaken> taken;
    for (const std::string& strategy : strategies) {
      fmt::print("{:>14}", strategy);
      taken.push_back({strategy, directions_deg, {}});
      for (const double direction_deg : directions_deg) {
        taken.back().largest_n.push_back(examples::LargestPush(stander, strategy, direction_deg, most_n));
        fmt::print("{:6.0f}", taken.back().largest_n.back());
      }
      fmt::print("\n");
    }
    if (plot.empty()) return 0;
    const auto written = WriteFileAtomically(plot, examples::PushPicture(taken));
    if (!written) throw InvalidArgument(written.failure().message);
    fmt::print("{}\n", *written);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "standing_control: {}\n", error.what());
    return 1;
  }
}
