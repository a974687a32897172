// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>

#include "cli/program.h"
#include "cli/usage.h"
#include "kinematics/base/version.h"

int main(int argc, char** argv) {
  using namespace gaitwright::cli;
  CLI::App app(
      "Gaitwright plans gaits for legged robots and proves them in physics.\n"
      "First words: gaitwright walk --robot a1\n",
      "gaitwright");
  app.set_version_flag("--version", gaitwright::Version(), "Print the version and exit.");
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "Print this help and exit.");
  app.footer(
      std::string("Each verb has its own: gaitwright walk --help\nSI units throughout; degrees only where a name says "
                  "so.\n\n") +
      kExitStatuses);
  int status = kPass;
  AddWalk(app, status);
  AddPlan(app, status);
  AddDo(app, status);
  AddAudit(app, status);
  AddPlay(app, status);
  AddTrials(app, status);
  AddSweep(app, status);
  AddTune(app, status);
  AddGrade(app, status);
  AddRobots(app, status);
  AddGaits(app, status);
  AddTerrains(app, status);
  AddBench(app, status);
  AddExport(app, status);
  AddCompare(app, status);
  AddImport(app, status);
  AddView(app, status);
  AddRender(app, status);
  AddLive(app, status);
  LayOutHelp(app);
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
