// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/trials.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("Survival rate of a walk under disturbances, with its confidence interval", "trials");
  std::string robot = "a1", disturbances = "examples/disturbances/a1_hobby.yaml";
  int trials = 20, seed = 1;
  app.add_option("--robot", robot, "Name of a built-in robot")->capture_default_str();
  app.add_option("--disturbances", disturbances, "Disturbance file, see docs/trials.md")->capture_default_str();
  app.add_option("-n,--trials", trials, "Number of trials")->capture_default_str();
  app.add_option("--seed", seed, "Random seed of the study")->capture_default_str();
  try {
    app.parse(argc, argv);
    const examples::TriedWalk tried = examples::TryWalk(robot, disturbances, trials, seed);
    const ShareInterval& survival = tried.report.survival;
    fmt::print("survived  {} of {}: {:.0f} %, 95 % interval {:.0f} % to {:.0f} %\n", tried.report.survived,
               tried.report.n, 1e2 * survival.share, 1e2 * survival.low, 1e2 * survival.high);
    fmt::print("worst     seed {}, score {:.1f}: {}\n", tried.worst.seed, tried.worst.score, tried.worst.reason);
    fmt::print("repeated  {}\n", tried.repeated.log_hash == tried.worst.log_hash ? "the same log" : "another log");
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "trials: {}\n", error.what());
    return 1;
  }
}
