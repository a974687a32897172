// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "cli/command_line.h"
#include "cli/listed_options.h"
#include "cli/program.h"
#include "cli/reference_pages.h"
#include "cli/usage.h"

int main(int argc, char** argv) {
  using namespace gaitwright::cli;
  CommandLine command_line(
      "Gaitwright plans gaits for legged robots and proves them in physics.\nStart with: gaitwright walk --robot a1\n",
      std::string("Each verb has its own help: gaitwright walk --help\nAll units are SI; angles are in degrees only if "
                  "the name ends in deg.\n\n") +
          kExitStatuses);
  const Verb program = command_line.program();
  int status = kPass;
  AddWalk(program, status);
  AddPlan(program, status);
  AddDo(program, status);
  AddAudit(program, status);
  AddPlay(program, status);
  AddTrials(program, status);
  AddSweep(program, status);
  AddTune(program, status);
  AddGrade(program, status);
  AddRobots(program, status);
  AddGaits(program, status);
  AddTerrains(program, status);
  AddBench(program, status);
  AddExport(program, status);
  AddCompare(program, status);
  AddImport(program, status);
  AddRepair(program, status);
  AddView(program, status);
  AddRender(program, status);
  AddLive(program, status);
  AddReference(program, status);
  command_line.LayOutHelp();
  try {
    if (const std::optional<int> ended = command_line.Run(argc, argv)) return *ended;
  } catch (const ListedOptions& asked) {
    PrintOptions(asked.fields(), asked.as_json());
  } catch (const UsageError& error) {
    Common common;
    common.json = std::find(argv + 1, argv + argc, std::string_view("--json")) != argv + argc;
    return Report(UsageFailure(program, error), common);
  }
  return status;
}
