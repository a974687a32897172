// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "examples/stand_up.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  try {
    const auto tell = [](const GateRecord& phase) {
      std::printf("%-10s ends at %.2f s, after waiting for %.3f s%s\n", phase.phase.c_str(), phase.at_s, phase.waited_s,
                  phase.met ? "" : "; its end condition was not met");
    };
    const examples::StoodUp up = examples::StandUp(argc > 1 ? argv[1] : "a1", tell);
    std::printf("%s: the ZMP is %.1f mm from the planned ZMP\n", up.report.pass ? "the robot stands" : "fail",
                1e3 * up.zmp_error_m);
    return up.report.pass ? 0 : 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stand_up: %s\n", error.what());
    return 1;
  }
}
