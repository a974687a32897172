// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/cluster/shared_trials.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "planning/plan/failure_json.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

/// First characters of the answer for a trial that could not be played.
constexpr char kFailure[] = "{\"failure\":";

}  // namespace

std::string AnswerOf(const Result<TrialOutcome>& trial) {
  if (trial) return OutcomeToLine(*trial);
  const Failure& failure = trial.failure();
  Json answer = Json::object();
  answer["failure"] = Json::parse(FailureJson(failure));
  answer["failure"]["infeasible"] = failure.kind == FailureKind::kInfeasible;
  return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<TrialOutcome> TrialOfAnswer(const std::string& answer) {
  if (!answer.starts_with(kFailure)) return OutcomeFromLine(answer);
  try {
    const Json of = Json::parse(answer).at("failure");
    const auto code = FailureCodeOfName(of.at("code").get<std::string>());
    if (!code) throw InvalidArgument(fmt::format("a failure has the unknown code {}", of.at("code").dump()));
    Failure failure{of.at("infeasible").get<bool>() ? FailureKind::kInfeasible : FailureKind::kBadInput,
                    *code,
                    of.at("stage").get<std::string>(),
                    of.at("message").get<std::string>(),
                    {}};
    for (const Json& hint : of.at("hints")) failure.suggestions.emplace_back(hint.get<std::string>());
    return failure;
  } catch (const Json::exception& error) {
    throw InvalidArgument(fmt::format("an answer is neither the outcome of a trial nor a failure: {}", error.what()));
  }
}

Result<RobustnessReport> RunSharedTrials(SharedWork& work, const TrialStudy& study, const TrialOptions& options,
                                         TrialBook& book) {
  const auto run_seed = static_cast<std::uint64_t>(options.seed);
  const Result<std::vector<PieceRunner>> runners = work.Runners({.work = HashOf(study, run_seed), .problem = ""});
  if (!runners) return runners.failure();
  std::vector<TrialRunner> elsewhere;
  for (const PieceRunner& run : *runners) {
    elsewhere.emplace_back([&run](int number) { return TrialOfAnswer(run(number)); });
  }
  TrialOptions here = options;
  if (!elsewhere.empty() && here.threads == 0) here.threads = 1;
  return RunTrials(study, here, book, elsewhere);
}

void ServeTrials(SharedWork& work, const TrialStudy& study, const TrialOptions& options) {
  const auto run_seed = static_cast<std::uint64_t>(options.seed);
  work.Serve({.work = HashOf(study, run_seed), .problem = ""}, [&](int number) {
    Result<PlayedTrial> trial = PlayTrial(study, number, SeedOfTrial(run_seed, number));
    return AnswerOf(trial ? Result<TrialOutcome>(std::move(trial->outcome)) : trial.failure());
  });
}

}  // namespace gaitwright
