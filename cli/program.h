// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright::cli {

/// Exit statuses of the program.
enum Exit { kPass = 0, kWrongInput = 1, kNoPlan = 2, kVerdictFail = 3 };

/// The same in words, for the help.
inline constexpr char kExitStatuses[] =
    "Exit status:\n"
    "  0  done, and the verdict is a pass\n"
    "  1  the input or the usage is wrong\n"
    "  2  no plan exists within the limits\n"
    "  3  the plan was made or played, and the verdict is a fail";

/// Flags that every verb takes.
struct Common {
  bool json = false;
  bool quiet = false;
  int seed = 0;
  std::vector<std::string> sets;  ///< key=value
};

/// Adds the flags of Common to a verb, and to the end of its help the examples (command lines without the program's
/// name) and the exit statuses.
void AddCommon(CLI::App& verb, Common& common, const std::vector<std::string>& examples);

/// Prints a failure (one line on standard error; with --json the error object on standard output) and gives its
/// status.
int Report(const Failure& failure, const Common& common);

/// Runs a verb; an exception becomes a failure like any other. Of several processes of an MPI run each would do all of
/// it and write the same files: it is refused, by the first of them.
int Guarded(const Common& common, const std::function<int()>& verb);

/// The same of a verb whose work the processes of an MPI run share.
int GuardedInRanks(const Common& common, const std::function<int()>& verb);

// One function for each verb: adds it to the program; `status` gets the exit status when it has run.
void AddWalk(CLI::App& app, int& status);
void AddPlan(CLI::App& app, int& status);
void AddAudit(CLI::App& app, int& status);
void AddPlay(CLI::App& app, int& status);
void AddTrials(CLI::App& app, int& status);
void AddSweep(CLI::App& app, int& status);
void AddTune(CLI::App& app, int& status);
void AddRobots(CLI::App& app, int& status);
void AddGaits(CLI::App& app, int& status);
void AddTerrains(CLI::App& app, int& status);
void AddBench(CLI::App& app, int& status);
void AddExport(CLI::App& app, int& status);
void AddCompare(CLI::App& app, int& status);
void AddImport(CLI::App& app, int& status);
void AddView(CLI::App& app, int& status);
void AddRender(CLI::App& app, int& status);
void AddLive(CLI::App& app, int& status);
void AddDo(CLI::App& app, int& status);
void AddGrade(CLI::App& app, int& status);

}  // namespace gaitwright::cli
