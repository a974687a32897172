// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "examples/standing.h"
#include "kinematics/base/file.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  try {
    const std::string robot = argc > 1 ? argv[1] : "humanoid";
    const auto all = examples::CompareStanding(robot);
    std::printf("%-12s %10s %10s %10s   largest push of 0.1 s withstood\n", "strategy", "ahead", "back", "left");
    for (const auto& one : all)
      std::printf("%-12s %8.0f N %8.0f N %8.0f N\n", one.strategy.c_str(), one.ahead_n, one.back_n, one.left_n);
    const auto written = WriteFileAtomically("standing.svg", examples::StandingPlot(robot, all));
    if (!written) throw std::runtime_error(written.failure().message);
    std::printf("plot    standing.svg\n");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "standing: %s\n", error.what());
    return 1;
  }
}
