// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/stream_plan.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("A plan's joints over UDP, to a stand-in for the robot", "hardware_adapter");
  std::string robot = "a1";
  examples::StandInOptions stand_in;
  examples::StreamOptions stream;
  app.add_option("--robot", robot, "A robot that comes with the program")->capture_default_str();
  app.add_option("--period", stream.period_s, "From one command to the next [s]")
      ->capture_default_str()
      ->check(CLI::Range(2e-4, 0.02));
  app.add_option("--watchdog", stream.watchdog_s, "Without a state for so long it stops [s]")->capture_default_str();
  app.add_option("--load-error", stand_in.load_error, "Share by which loads are not as planned")->capture_default_str();
  app.add_option("--loses-every", stand_in.loses_every, "One of so many answers gets lost; 0: none")
      ->capture_default_str();
  app.add_option("--silent-after", stand_in.silent_after, "Answers after which the robot is silent; 0: never")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
    stream.patience_s = 0.5 * stream.period_s;
    const examples::StreamReport report = examples::StreamToStandIn(robot, stand_in, stream);
    fmt::print("{} commands at {:.1f} Hz, {} without an answer\n", report.sent, report.rate_hz, report.lost);
    fmt::print("largest tracking error {:.2f} mrad\n", 1e3 * report.largest_error);
    fmt::print("{}\n", report.stopped ? "stopped by the watchdog" : "done");
    return report.stopped ? 3 : 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "hardware_adapter: {}\n", error.what());
    return 1;
  }
}
