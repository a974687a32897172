// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "cli/program.h"
#include "kinematics/base/version.h"

int main(int argc, char** argv) {
  using namespace gaitwright::cli;
  CLI::App app(
      "Gaitwright plans gaits for legged robots and proves them in physics.\n"
      "First words: gaitwright walk --robot a1",
      "gaitwright");
  app.set_version_flag("--version", gaitwright::Version());
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);
  int status = kPass;
  AddWalk(app, status);
  AddPlan(app, status);
  AddAudit(app, status);
  AddPlay(app, status);
  AddRobots(app, status);
  AddGaits(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kPass : kWrongInput;
  }
  return status;
}
