// SPDX-License-Identifier: BSD-3-Clause
#include "cli/program.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "workflows/cluster/ranks.h"
#include "workflows/study/job_journal.h"

namespace gaitwright::cli {

void AddCommon(CLI::App& verb, Common& common, const std::vector<std::string>& examples) {
  verb.option_defaults()->group("Flags of every verb");
  verb.add_flag("--json", common.json, "Print one JSON object on standard output, and nothing else there.");
  verb.add_flag("--quiet", common.quiet, "Print only the verdict (pass or fail), of a list only the names.");
  AddWholeNumber(verb, "--seed", 0, common.seed,
                 "Seed of whatever is random, such as --ground-bumps, 0 or more; default 0.");
  verb.add_option(
          "--set", common.sets,
          "Set one of the many options behind the flags; may be repeated, with each key once. They win over flags.")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  verb.option_defaults()->group("Options");
  std::string footer = examples.size() > 1 ? "Examples:\n" : "Example:\n";
  for (const std::string& example : examples) footer += "  gaitwright " + example + "\n";
  verb.footer(footer + "\n" + kExitStatuses);
}

int Report(const Failure& failure, const Common& common) {
  const std::string hints = failure.hints.empty() ? "" : fmt::format(" (try: {})", fmt::join(failure.hints, "; or: "));
  fmt::print(stderr, "gaitwright: {}{}\n", failure.message, hints);
  if (common.json) {
    const nlohmann::ordered_json error = {
        {"error",
         {{"code", failure.code}, {"stage", failure.stage}, {"message", failure.message}, {"hints", failure.hints}}}};
    fmt::print("{}\n", error.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  }
  return failure.kind == FailureKind::kInfeasible ? kNoPlan : kWrongInput;
}

int Guarded(const Common& common, const std::function<int()>& verb) {
  return GuardedInRanks(common, [&]() -> int {
    const Ranks ranks = Ranks::Join();
    if (ranks.count() == 1) return verb();
    if (!ranks.leads()) return kPass;
    return Report({FailureKind::kBadInput,
                   "several_processes",
                   "program",
                   fmt::format("this verb runs in one process, and MPI has started {}", ranks.count()),
                   {"start it without mpirun or srun; trials and sweep share their work"}},
                  common);
  });
}

int GuardedInRanks(const Common& common, const std::function<int()>& verb) {
  try {
    return verb();
  } catch (const InvalidArgument& error) {
    return Report({FailureKind::kBadInput, "invalid_argument", "program", error.what(), {}}, common);
  } catch (const CannotKeep& error) {
    const std::vector<std::string> hints = {"make room on the disk", "the same command with --resume goes on"};
    return Report({FailureKind::kBadInput, "so_far", "JobJournal", error.what(), hints}, common);
  } catch (const std::exception& error) {
    const std::string message = fmt::format("the program failed, which is its own fault: {}", error.what());
    return Report({FailureKind::kBadInput, "internal", "program", message, {}}, common);
  }
}

}  // namespace gaitwright::cli
