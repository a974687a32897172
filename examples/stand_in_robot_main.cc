// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "examples/stand_in_robot.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("A simulated robot that takes joint commands over UDP; prints its port, then answers commands",
               "stand_in_robot");
  examples::StandInOptions options;
  double leaves_after_s = 1.0;
  constexpr double kWaitsForTheFirst = 60.0;  // [s]
  app.add_option("--step", options.step_s, "Time between two commands [s]")
      ->capture_default_str()
      ->check(CLI::Range(2e-4, 0.02));
  app.add_option("--load-error", options.load_error, "Fraction by which a joint's load exceeds its feed-forward")
      ->capture_default_str();
  app.add_option("--loses-every", options.loses_every, "Every N-th answer is lost; 0: none")->capture_default_str();
  app.add_option("--silent-after", options.silent_after, "Number of answers after which it is silent; 0: never")
      ->capture_default_str();
  app.add_option("--leaves-after", leaves_after_s,
                 "Time without a command after which the program ends, once the first has come [s]")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 3600.0));
  try {
    app.parse(argc, argv);
    examples::StandInRobot robot(options);
    fmt::print("{}\n", robot.port());
    std::fflush(stdout);
    for (bool heard = robot.Serve(kWaitsForTheFirst); heard;) heard = robot.Serve(leaves_after_s);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stand_in_robot: {}\n", error.what());
    return 1;
  }
}
