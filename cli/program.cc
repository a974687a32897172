// SPDX-License-Identifier: BSD-3-Clause
#include "cli/program.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/word_list.h"
#include "planning/plan/failure_json.h"
#include "workflows/cluster/ranks.h"
#include "workflows/study/job_journal.h"

namespace gaitwright::cli {
namespace {

/// Runs the work of a verb; an exception becomes a failure.
int Guarded(const Common& common, const std::function<int()>& work) {
  try {
    return work();
  } catch (const InvalidArgument& error) {
    return Report({FailureKind::kBadInput, FailureCode::kInvalidArgument, "program", error.what(), {}}, common);
  } catch (const CannotKeep& error) {
    const std::vector<Suggestion> suggestions = {"free space on the disk",
                                                 "run the same command with --resume to continue"};
    return Report({FailureKind::kBadInput, FailureCode::kSoFar, "JobJournal", error.what(), suggestions}, common);
  } catch (const std::exception& error) {
    const std::string message = fmt::format("internal error: {} (this is a bug; please report it)", error.what());
    return Report({FailureKind::kBadInput, FailureCode::kInternal, "program", message, {}}, common);
  }
}

}  // namespace

void AddCommon(Verb verb, Common& common, std::initializer_list<std::string_view> examples) {
  verb.SetGroup("Flags of every verb");
  verb.AddSwitch("--json", common.json, "Print one JSON object on standard output, and nothing else there.");
  verb.AddSwitch("--quiet", common.quiet, "Print only the verdict (pass or fail); for lists, only the names.");
  AddWholeNumber(verb, "--seed", 0, common.seed,
                 "Seed of all random numbers, such as those of --ground-bumps; 0 or more; default 0.");
  verb.SetGroup("Options");
  std::string footer = examples.size() > 1 ? "Examples:\n" : "Example:\n";
  for (const std::string_view example : examples) footer += fmt::format("  gaitwright {}\n", example);
  verb.SetFooter(footer + "\n" + kExitStatuses);
}

int Report(const Failure& failure, const Common& common) {
  std::vector<std::string> hints;
  for (const Suggestion& suggestion : failure.suggestions) hints.push_back(suggestion.text);
  const std::string tries = hints.empty() ? "" : fmt::format(" (try: {})", JoinWords(hints, "; or: "));
  fmt::print(stderr, "gaitwright: {}{}\n", failure.message, tries);
  if (common.json) {
    const nlohmann::ordered_json error = {{"error", ParsedJson(FailureJson(failure))}};
    PrintJson(error);
  }
  return failure.kind == FailureKind::kInfeasible ? kNoPlan : kWrongInput;
}

void SetWork(Verb verb, const Common& common, int& status, const std::function<int()>& work) {
  SetWorkInRanks(verb, common, status, [work, &common]() -> int {
    const Ranks ranks = Ranks::Join();
    if (ranks.count() == 1) return work();
    if (!ranks.leads()) return kPass;
    return Report(
        {FailureKind::kBadInput,
         FailureCode::kSeveralProcesses,
         "program",
         fmt::format("this verb runs in one process, and MPI has started {}", ranks.count()),
         {"start it without mpirun or srun; only trials, sweep and repair of a folder run in several processes"}},
        common);
  });
}

void SetWorkInRanks(Verb verb, const Common& common, int& status, const std::function<int()>& work) {
  verb.SetWork([work, &common, &status] { status = Guarded(common, work); });
}

}  // namespace gaitwright::cli
