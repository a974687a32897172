// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string_view>

#include "cli/program.h"
#include "cli/usage.h"
#include "kinematics/base/version.h"

int main(int argc, char** argv) {
  using namespace gaitwright::cli;
  CLI::App app(
      "Gaitwright plans gaits for legged robots and proves them in physics.\n"
      "First words: gaitwright walk --robot a1",
      "gaitwright");
  app.set_version_flag("--version", gaitwright::Version());
  app.require_subcommand(1);
  int status = kPass;
  AddWalk(app, status);
  AddPlan(app, status);
  AddAudit(app, status);
  AddPlay(app, status);
  AddRobots(app, status);
  AddGaits(app, status);
  AddTerrains(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help and --version
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    Common common;
    common.json = std::find(argv + 1, argv + argc, std::string_view("--json")) != argv + argc;
    return Report(UsageFailure(app, error), common);
  }
  return status;
}
