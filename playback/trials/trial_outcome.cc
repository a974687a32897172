// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/trial_outcome.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kinematics/base/hash.h"
#include "kinematics/base/result.h"
#include "planning/plan/json_part_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

void Append(std::string& bytes, const VectorX& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), static_cast<std::size_t>(values.size()) * sizeof(double));
}

Json SampledJson(const std::vector<SampledValue>& sampled) {
  Json list = Json::array();
  for (const SampledValue& one : sampled)
    list.push_back({one.name, one.unit, one.word.empty() ? Json(one.value) : Json(one.word)});
  return list;
}

/// @throws InvalidArgument for a value that is impossible in a trial.
double In(const char* what, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return value;
  throw InvalidArgument(fmt::format("a line is not an outcome of a trial: its {} is {}; accepted: {} to {}", what,
                                    value, lowest, highest));
}

constexpr double kMost = 1e30;   // of any number, in its unit
constexpr double kLatest = 1e7;  // on a plan's clock [s]
constexpr int kMostTrials = 1000000000;

std::vector<SampledValue> SampledFrom(const Json& list) {
  std::vector<SampledValue> sampled;
  for (const Json& one : list) {
    SampledValue value{one.at(0).get<std::string>(), one.at(1).get<std::string>()};
    one.at(2).is_string() ? void(value.word = one.at(2).get<std::string>())
                          : void(value.value = In("drawn value", one.at(2).get<double>(), -kMost, kMost));
    sampled.push_back(std::move(value));
  }
  return sampled;
}

/// One list per step: its three disturbances, and three values of its landing if it landed.
Json StepsJson(const std::vector<GaitStep>& steps) {
  Json list = Json::array();
  for (const GaitStep& s : steps) {
    list.push_back({s.ground_m, s.push_forward_n_s, s.push_left_n_s});
    if (s.landed) list.back().insert(list.back().end(), {s.late_s, s.forward_m, s.left_m});
  }
  return list;
}

std::vector<GaitStep> StepsFrom(const Json& list) {
  std::vector<GaitStep> steps;
  for (const Json& one : list) {
    const auto number = [&](std::size_t i) { return In("step", one.at(i).get<double>(), -kMost, kMost); };
    steps.push_back({number(0), number(1), number(2), one.size() > 3, 0.0, 0.0, 0.0});
    GaitStep& step = steps.back();
    if (!step.landed) continue;
    step.late_s = number(3);
    step.forward_m = number(4);
    step.left_m = number(5);
  }
  return steps;
}

}  // namespace

std::string SamplesHash(const PlaybackLog& log) {
  std::string bytes;
  for (const LogSample& sample : log.samples) {
    Append(bytes, VectorX::Constant(1, sample.time_s));
    Append(bytes, sample.q);
    Append(bytes, sample.v);
    Append(bytes, sample.tau);
    for (const ContactWrench& wrench : sample.wrenches) {
      Append(bytes, wrench.force_W);
      Append(bytes, wrench.moment_W);
    }
  }
  return HexHash(bytes);
}

TrialOutcome OutcomeOf(int number, const SampledTrial& trial, const PlaybackLog& log, const StabilityReport& report) {
  TrialOutcome outcome;
  outcome.number = number;
  outcome.seed = trial.seed;
  outcome.survived = report.At("fell").value.value_or(1.0) == 0.0;
  outcome.passed = report.pass;
  outcome.score = report.score;
  outcome.ended_s = log.samples.empty() ? log.start_s : log.samples.back().time_s;
  if (const auto& fell_after = report.At("time_to_fall_s").value; !outcome.survived && fell_after)
    outcome.ended_s = log.start_s + *fell_after;
  outcome.cause = report.cause;
  outcome.reason = report.reason;
  outcome.log_hash = SamplesHash(log);
  outcome.sampled = trial.values;
  for (const Metric& metric : report.metrics) {
    outcome.metrics.emplace_back(metric.key, metric.value);
    if (metric.applied) outcome.gates.push_back(metric.key);
    if (!metric.pass) outcome.broken_gates.push_back(metric.key);
  }
  return outcome;
}

std::string OutcomeToLine(const TrialOutcome& o) {
  Json metrics = Json::array();
  for (const auto& [key, value] : o.metrics) metrics.push_back({key, value ? Json(*value) : Json()});
  const Json line = {{"number", o.number},
                     {"seed", o.seed},
                     {"survived", o.survived},
                     {"passed", o.passed},
                     {"score", o.score},
                     {"ended_s", o.ended_s},
                     {"cause", o.cause},
                     {"reason", o.reason},
                     {"log_hash", o.log_hash},
                     {"sampled", SampledJson(o.sampled)},
                     {"metrics", metrics},
                     {"gates", o.gates},
                     {"broken_gates", o.broken_gates},
                     {"steps", StepsJson(o.steps)}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

TrialOutcome OutcomeFromLine(const std::string& line) {
  try {
    const Json j = Json::parse(line);
    TrialOutcome o;
    o.number = JsonPart(j.at("number")).Whole(0, kMostTrials - 1);
    o.seed = JsonPart(j.at("seed")).Natural();
    o.survived = j.at("survived").get<bool>();
    o.passed = j.at("passed").get<bool>();
    if (o.passed && !o.survived)
      throw InvalidArgument("a line is not an outcome of a trial: it passed but did not survive");
    o.score = In("score", j.at("score").get<double>(), 0.0, 100.0);
    o.ended_s = In("end", j.at("ended_s").get<double>(), -kLatest, kLatest);
    o.cause = j.at("cause").get<std::string>();
    o.reason = j.at("reason").get<std::string>();
    o.log_hash = j.at("log_hash").get<std::string>();
    o.sampled = SampledFrom(j.at("sampled"));
    for (const Json& metric : j.at("metrics")) {
      const Json& value = metric.at(1);
      o.metrics.emplace_back(
          metric.at(0).get<std::string>(),
          value.is_null() ? std::nullopt : std::optional<double>(In("metric", value.get<double>(), -kMost, kMost)));
    }
    o.gates = j.at("gates").get<std::vector<std::string>>();
    o.broken_gates = j.at("broken_gates").get<std::vector<std::string>>();
    o.steps = StepsFrom(j.at("steps"));
    return o;
  } catch (const Json::exception& error) {
    throw InvalidArgument(fmt::format("a line is not an outcome of a trial: {}", error.what()));
  }
}

}  // namespace gaitwright
