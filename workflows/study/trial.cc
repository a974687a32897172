// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/hash.h"
#include "kinematics/base/version.h"
#include "planning/plan/plan_json.h"
#include "playback/policy/fit_policy_internal.h"
#include "playback/score/gates.h"
#include "workflows/study/trial_conditions.h"

namespace gaitwright {
namespace {

constexpr char kSensorPrefix[] = "sensors.";

bool IsNoise(const std::string& key) {
  const auto has = [&](const char* word) { return key.find(word) != std::string::npos; };
  return key.starts_with(kSensorPrefix) && (has("noise") || has("bias") || has("walk"));
}

void SetNumber(OptionFields& fields, const std::string& key, double value) {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const OptionField& f) { return f.key == key; });
  const bool whole = field != fields.end() && std::holds_alternative<int*>(field->target);
  SetOption(fields, key, whole ? fmt::format("{}", std::lround(value)) : fmt::format("{}", value));
}

bool HasField(const OptionFields& fields, const std::string& key) {
  return std::any_of(fields.begin(), fields.end(), [&](const OptionField& f) { return f.key == key; });
}

double NumberOf(const OptionFields& fields, const std::string& key) {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const OptionField& f) { return f.key == key; });
  if (field == fields.end()) return 0.0;  // SetNumber refuses the key
  const auto* whole = std::get_if<int*>(&field->target);
  return whole != nullptr ? static_cast<double>(**whole) : *std::get<double*>(field->target);
}

/// Combines a drawn value with the present value of its option.
double Together(double own, const DrawnOption& drawn) {
  if (drawn.effect == DisturbanceEffect::kFactor) return own * drawn.value;
  return drawn.effect == DisturbanceEffect::kOffset ? own + drawn.value : drawn.value;
}

/// A delay rounded to whole time steps; a delay that is too long stays too long.
double InSteps(double delay_s, double step_s) {
  constexpr double kRounding = 1e-9;
  if (delay_s > kLongestDelay * (1.0 + kRounding)) return delay_s;
  const double most = std::floor(kLongestDelay / step_s * (1.0 + kRounding));
  return step_s * std::min(std::round(delay_s / step_s), most);
}

/// The nearest rate whose period is a whole number of time steps; 0 stays 0.
double WithPeriodInSteps(double rate_hz, double step_s) {
  if (!(rate_hz > 0.0)) return rate_hz;
  return 1.0 / (step_s * std::max(1.0, std::round(1.0 / (rate_hz * step_s))));
}

/// A drawn value, rounded so that a playback accepts it.
double OnTheClock(const std::string& key, double value, double step_s) {
  if (key == "command_delay_s") return InSteps(value, step_s);
  return key.starts_with(kSensorPrefix) && key.ends_with("_rate_hz") ? WithPeriodInSteps(value, step_s) : value;
}

/// The options of a playback that differ from their defaults.
std::vector<std::string> ChangedKeys(PlayRequest request) {
  PlayRequest usual;
  std::vector<std::string> keys;
  for (const OptionChange& change : ChangesFrom(usual.Fields(), TextsOf(request.Fields()))) keys.push_back(change.key);
  return keys;
}

/// Failure if an option is both sampled and set. Exceptions: single values of a set of sensors may be sampled, and each
/// trial has its own seed.
std::optional<Failure> SaidTwice(const PlayRequest& request, const Disturbances& disturbances) {
  std::vector<std::string> keys = ChangedKeys(request);
  std::erase_if(keys, [](const std::string& key) { return key.starts_with(kSensorPrefix) || key == "play.seed"; });
  const std::vector<std::string> twice = DrawnInPlaceOf(disturbances, keys);
  if (twice.empty()) return std::nullopt;
  return Failure{FailureKind::kBadInput,
                 FailureCode::kSaidTwice,
                 "PlayTrial",
                 fmt::format("the disturbances sample {}, which a playback option also sets", QuotedList(twice)),
                 {"leave one of them out"}};
}

Failure CannotBePlayed(FailureCode code, const std::string& why, std::vector<Suggestion> suggestions = {}) {
  suggestions.emplace_back("narrow the sampled ranges");
  return {FailureKind::kBadInput, code, "PlayTrial",
          fmt::format("some trials of these disturbances cannot be played: {}", why), std::move(suggestions)};
}

/// The failure of `check` for the request at either end of the disturbances; also a failure for options out of range.
template <class Check>
std::optional<Failure> AtBothEnds(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                                  const Disturbances& disturbances, Check check) {
  if (auto failure = SaidTwice(request, disturbances)) return failure;
  double noise_scale = 1.0;
  try {
    for (const RangeEnd end : {RangeEnd::kLowest, RangeEnd::kHighest}) {
      const SampledTrial trial = ExtremeTrial(disturbances, model, plan, end);
      noise_scale = trial.sensor_noise_scale;
      PlayRequest at_end = DisturbedRequest(request, trial);
      CheckOptions(at_end.Fields());
      if (const std::optional<Failure> failure = check(at_end))
        return CannotBePlayed(failure->code, failure->message, failure->suggestions);
    }
  } catch (const InvalidArgument& error) {
    const std::string why = error.what();
    const bool scaled = noise_scale > 1.0 && why.find(std::string("'") + kSensorPrefix) != std::string::npos;
    return CannotBePlayed(FailureCode::kDisturbances,
                          why + (scaled ? fmt::format(", with a sensor_noise_scale of {}", noise_scale) : ""));
  }
  return std::nullopt;
}

void AddPushes(const std::vector<TimedPush>& pushes, PlayOptions& play) {
  auto next = pushes.begin();
  if (next != pushes.end() && play.push_force_W.isZero(0.0)) {  // the push that the texts of the log describe
    play.push_force_W = next->force_W;
    play.push_at_s = next->at_s;
    play.push_for_s = next->for_s;
    play.push_on = next->on;
    ++next;
  }
  play.more_pushes.insert(play.more_pushes.end(), next, pushes.end());
}

}  // namespace

OptionFields SensorFields(PlayRequest& request) {
  OptionFields own;
  for (OptionField field : request.Fields()) {
    if (!field.key.starts_with(kSensorPrefix)) continue;
    field.key.erase(0, sizeof(kSensorPrefix) - 1);
    own.push_back(field);
  }
  return own;
}

PlayRequest DisturbedRequest(const PlayRequest& request, const SampledTrial& trial) {
  PlayRequest disturbed = request;
  OptionFields fields = disturbed.Fields();
  for (const char* seed : {"play.seed", "sensors.seed"}) {
    if (HasField(fields, seed)) SetNumber(fields, seed, trial.noise_seed);
  }
  for (const DrawnOption& drawn : trial.options) {
    const double value = Together(NumberOf(fields, drawn.key), drawn);
    SetNumber(fields, drawn.key, OnTheClock(drawn.key, value, disturbed.play.world.step_s));
  }
  for (const OptionField& field : fields) {
    if (IsNoise(field.key) && std::holds_alternative<double*>(field.target))
      *std::get<double*>(field.target) *= trial.sensor_noise_scale;
  }
  AddPushes(trial.pushes, disturbed.play);
  disturbed.play.start_joints = trial.start_joints;
  return disturbed;
}

Disturbances StandardBesides(const RobotModel& model, const PlayRequest& request,
                             const std::vector<std::string>& varied) {
  std::vector<std::string> said = ChangedKeys(request);
  said.insert(said.end(), varied.begin(), varied.end());
  if (std::find(said.begin(), said.end(), "play.ground_slope_deg") != said.end())
    said.emplace_back("play.ground_slope_direction_deg");  // otherwise sampling would turn the given slope
  Disturbances standard = StandardDisturbances(model);
  const std::vector<std::string> twice = DrawnInPlaceOf(standard, said);
  std::erase_if(standard.figures, [&](const Disturbance& figure) {
    return std::find(twice.begin(), twice.end(), figure.key) != twice.end();
  });
  return standard;
}

std::optional<Failure> ReasonNotSampled(const RobotModel& model, const PlayRequest& request,
                                        const Disturbances& disturbances) {
  PlayRequest undisturbed = request;
  CheckOptions(undisturbed.Fields());
  return AtBothEnds(model, MotionPlan(), request, disturbances,
                    [](const PlayRequest&) -> std::optional<Failure> { return std::nullopt; });
}

std::optional<Failure> ReasonNotTried(const TrialStudy& study) {
  PlayRequest undisturbed = study.request;
  CheckOptions(undisturbed.Fields());
  if (auto failure = ReasonNotPlayed(study.model, study.plan, study.request.play)) return failure;
  return AtBothEnds(study.model, study.plan, study.request, study.disturbances,
                    [&](const PlayRequest& at_end) { return ReasonNotPlayed(study.model, study.plan, at_end.play); });
}

Result<PlayedTrial> PlayTrial(const TrialStudy& study, int number, std::uint64_t seed) {
  if (auto failure = ReasonNotTried(study)) return *failure;
  const SampledTrial trial = SampleTrial(study.disturbances, study.model, study.plan, seed);
  const PlayRequest disturbed = DisturbedRequest(study.request, trial);
  Result<PlayedWalk> played = PlayWalk(study.model, study.plan, disturbed);
  if (!played) return played.failure();
  const ScoredPlayback& decisive = played->decisive();
  PlayedTrial result;
  result.outcome = OutcomeOf(number, trial, decisive.log, decisive.report);
  if (result.outcome.survived)
    result.outcome.steps = GaitStepsOf(study.model, study.plan, disturbed.play, decisive.log);
  for (const SampledValue& one : trial.values)
    played->log.options.emplace_back("trial." + one.name, one.word.empty() ? fmt::format("{}", one.value) : one.word);
  result.played = std::move(*played);
  return result;
}

TrialSubject SubjectOf(const TrialStudy& study, std::uint64_t run_seed) {
  PlayRequest request = study.request;
  TrialSubject subject;
  subject.robot = study.model.name;
  subject.robot_hash = study.model.hash;
  subject.plan_hash = MotionHash(study.plan);
  subject.whole_plan_hash = PlanHash(study.plan);
  subject.controller = request.controller;
  subject.disturbances = DisturbancesText(study.disturbances);
  subject.options = TextsOf(request.Fields());
  subject.seed = run_seed;
  const bool standard = study.disturbances == StandardBesides(study.model, request);
  const std::string controller = request.policy == nullptr ? request.controller : PlayRequest().controller;
  const std::string flags = FlagsOf(controller, subject.options, DrawnOptions(study.disturbances));
  const std::string played =
      request.policy == nullptr ? "PLAN" : fmt::format("--policy POLICY --contract CONTRACT {}", request.policy->flags);
  subject.repeat = fmt::format("gaitwright play {} --disturbances {} --seed SEED{}{}", played,
                               standard ? "standard" : "FILE", flags.empty() ? "" : " ", flags);
  subject.gait_scale = GaitScaleOf(study.model, study.plan);
  if (!request.play.push_force_W.isZero(0.0)) subject.own_push_s = request.play.push_at_s;
  const GateScale scale = ScaleOf(study.model, study.plan);
  for (const MetricRule& rule : MetricRules()) {
    if (const auto limit = LimitOf(rule, scale)) subject.limits.emplace_back(rule.key, *limit);
  }
  return subject;
}

std::string HashOf(const TrialStudy& study, std::uint64_t run_seed) {
  const TrialSubject subject = SubjectOf(study, run_seed);
  std::string bytes = fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", Version(), study.model.hash, subject.whole_plan_hash,
                                  subject.controller, subject.disturbances, run_seed);
  for (const auto& [key, text] : subject.options) bytes += key + "=" + text + "\n";
  return HexHash(bytes);
}

}  // namespace gaitwright
