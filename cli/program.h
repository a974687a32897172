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

/// The exit statuses in words, for the help.
inline constexpr char kExitStatuses[] =
    "Exit status:\n  0  done, and the verdict is a pass\n  1  the input or the usage is wrong\n  2  no plan was found "
    "within the limits\n  3  the plan was made or played, and the verdict is a fail\n  130  interrupted";

/// Flags that every verb takes.
struct Common {
  bool json = false;
  bool quiet = false;
  int seed = 0;
  std::vector<std::string> sets;  ///< key=value
};

/// Adds the flags of Common to a verb. Appends the examples (command lines without the program's name) and the exit
/// statuses to its help.
void AddCommon(Verb verb, Common& common, std::initializer_list<std::string_view> examples);

/// Prints a failure: one line on standard error, and with --json the error object on standard output. @return its exit
/// status.
int Report(const Failure& failure, const Common& common);

/// Sets what a verb does; `status` gets the exit status. An exception of `work` becomes a failure. In an MPI run of
/// several processes each would do all the work and write the same files, so the first process refuses.
void SetWork(Verb verb, const Common& common, int& status, const std::function<int()>& work);

/// Sets what a verb does, as SetWork does, for work that the processes of an MPI run share.
void SetWorkInRanks(Verb verb, const Common& common, int& status, const std::function<int()>& work);

// Each function adds one verb to the program; `status` gets the exit status after the verb has run.
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
void AddRepair(Verb program, int& status);
void AddView(Verb program, int& status);
void AddRender(Verb program, int& status);
void AddLive(Verb program, int& status);
void AddDo(Verb program, int& status);
void AddGrade(Verb program, int& status);

}  // namespace gaitwright::cli
