// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

#include "examples/stream_plan.h"

namespace {

std::string BesideThis(const std::string& program) {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / program).string();
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("Streams the joint commands of a plan over UDP, to a robot or to a simulated stand-in",
               "hardware_adapter");
  std::string robot = "a1";
  std::uint16_t port = 0;
  examples::StandInOptions stand_in;
  examples::StreamOptions stream;
  app.add_option("--robot", robot, "Name of a built-in robot")->capture_default_str();
  app.add_option("--port", port, "Port of the robot on 127.0.0.1; default: a stand-in robot is started");
  app.add_option("--period", stream.period_s, "Time between two commands [s]")
      ->capture_default_str()
      ->check(CLI::Range(2e-4, 0.02));
  app.add_option("--watchdog", stream.watchdog_s, "Time without a state after which the watchdog stops the plan [s]")
      ->capture_default_str();
  app.add_option("--loses-every", stand_in.loses_every, "Every N-th answer of the stand-in is lost; 0: none")
      ->capture_default_str();
  app.add_option("--silent-after", stand_in.silent_after,
                 "Number of answers after which the stand-in is silent; 0: never")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
    stream.patience_s = 0.5 * stream.period_s;
    stand_in.step_s = stream.period_s;
    std::optional<examples::StandInProcess> started;
    if (port == 0) port = started.emplace(BesideThis("stand_in_robot"), stand_in).port();
    const examples::StreamReport report = examples::StreamWalk(robot, port, stream);
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
