// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "examples/instruction.h"
#include "playback/score/report_text.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  try {
    const examples::Obeyed obeyed = examples::Obey(argc > 1 ? argv[1] : "walk two steps, then wave with your left hand",
                                                   argc > 2 ? argv[2] : "nao");
    for (const Task& task : obeyed.tasks.tasks) std::printf("%s\n", TaskText(task).c_str());
    std::fputs(ReportText(obeyed.report).c_str(), stdout);
    return obeyed.report.pass ? 0 : 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "instruction: %s\n", error.what());
    return 1;
  }
}
