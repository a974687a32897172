// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "examples/own_controller.h"
#include "playback/score/report_text.h"

int main(int argc, char** argv) {
  try {
    const auto report = gaitwright::examples::WalkWithOwnController(argc > 1 ? argv[1] : "a1", 0.2);
    std::fputs(gaitwright::ReportText(report).c_str(), stdout);
    return report.pass ? 0 : 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "own_controller: %s\n", error.what());
    return 1;
  }
}
