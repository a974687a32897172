// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/cluster/shared_trials.h"

#include <utility>

namespace gaitwright {

Result<RobustnessReport> RunSharedTrials(SharedWork& work, const TrialStudy& study, const TrialOptions& options,
                                         TrialBook& book) {
  const auto run_seed = static_cast<std::uint64_t>(options.seed);
  const Result<std::vector<PieceRunner>> runners = work.Runners({.work = HashOf(study, run_seed), .problem = ""});
  if (!runners) return runners.failure();
  std::vector<TrialRunner> elsewhere;
  for (const PieceRunner& run : *runners) {
    elsewhere.emplace_back([&run](int number) { return OutcomeFromLine(run(number)); });
  }
  TrialOptions here = options;
  if (!elsewhere.empty() && here.threads == 0) here.threads = 1;
  return RunTrials(study, here, book, elsewhere);
}

void ServeTrials(SharedWork& work, const TrialStudy& study, const TrialOptions& options) {
  const auto run_seed = static_cast<std::uint64_t>(options.seed);
  work.Serve({.work = HashOf(study, run_seed), .problem = ""}, [&](int number) {
    Result<PlayedTrial> trial = PlayTrial(study, number, SeedOfTrial(run_seed, number));
    if (!trial) throw InvalidArgument(trial.failure().message);
    return OutcomeToLine(trial->outcome);
  });
}

}  // namespace gaitwright
