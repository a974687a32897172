// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/cluster/shared_sweep.h"

namespace gaitwright {

Result<std::vector<PointOutcome>> RunSharedSweep(SharedWork& work, const Study& study, const std::string& identity,
                                                 JobJournal& journal, const JobOptions& options) {
  const Result<std::vector<PieceRunner>> runners = work.Runners({.work = identity, .problem = ""});
  if (!runners) return runners.failure();
  std::vector<PointRunner> elsewhere;
  for (const PieceRunner& run : *runners) {
    elsewhere.emplace_back([&run](std::size_t point) { return run(static_cast<int>(point)); });
  }
  JobOptions here = options;
  if (!elsewhere.empty() && here.threads == 0) here.threads = 1;
  return RunSweep(study, journal, here, elsewhere);
}

void ServeSweep(SharedWork& work, const Study& study, const std::string& identity) {
  work.Serve({.work = identity, .problem = ""}, [&](int piece) {
    const auto point = static_cast<std::size_t>(piece);
    StudyPlans plans(study, {point});
    return PointToLine(RunPoint(study, point, plans));
  });
}

}  // namespace gaitwright
