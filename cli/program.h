// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "cli/verb.h"
#include "kinematics/base/result.h"

namespace gaitwright::cli {

/// Exit statuses of the program.
enum Exit { kPass = 0, kWrongInput = 1, kNoPlan = 2, kVerdictFail = 3 };

/// The same in words, for the help.
inline constexpr char kExitStatuses[] =
    "Exit status:\n  0  done, and the verdict is a pass\n  1  the input or the usage is wrong\n  2  no plan was found "
    "within the limits\n  3  the plan was made or played, and the verdict is a fail";

/// Flags that every verb takes.
struct Common {
  bool json = false;
  bool quiet = false;
  int seed = 0;
  std::vector<std::string> sets;  ///< key=value
};

/// Adds the flags of Common to a verb, and to the end of its help the examples (command lines without the program's
/// name) and the exit statuses.
void AddCommon(Verb verb, Common& common, std::initializer_list<std::string_view> examples);

/// Prints a failure (one line on standard error; with --json the error object on standard output) and gives its
/// status.
int Report(const Failure& failure, const Common& common);

/// Sets what a verb does; `status` gets the exit status. An exception of `work` becomes a failure like any other. Of
/// several processes of an MPI run each would do all of the work and write the same files: the first of them refuses.
void SetWork(Verb verb, const Common& common, int& status, const std::function<int()>& work);

/// Sets what a verb does, as SetWork, for work that the processes of an MPI run share.
void SetWorkInRanks(Verb verb, const Common& common, int& status, const std::function<int()>& work);

// One function for each verb: adds it to the program; `status` gets the exit status when it has run.
void AddWalk(Verb program, int& status);
void AddPlan(Verb program, int& status);
void AddAudit(Verb program, int& status);
void AddPlay(Verb program, int& status);
void AddTrials(Verb program, int& status);
void AddSweep(Verb program, int& status);
void AddTune(Verb program, int& status);
void AddRobots(Verb program, int& status);
void AddGaits(Verb program, int& status);
void AddTerrains(Verb program, int& status);
void AddBench(Verb program, int& status);
void AddExport(Verb program, int& status);
void AddCompare(Verb program, int& status);
void AddImport(Verb program, int& status);
void AddView(Verb program, int& status);
void AddRender(Verb program, int& status);
void AddLive(Verb program, int& status);
void AddDo(Verb program, int& status);
void AddGrade(Verb program, int& status);

}  // namespace gaitwright::cli
