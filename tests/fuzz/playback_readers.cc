// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "kinematics/base/options.h"
#include "playback/log/log_json.h"
#include "playback/trials/trial_outcome.h"
#include "tests/fuzz/policy_readers.h"
#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {
namespace {

void CheckSamples(const PlaybackLog& log) {
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    const LogSample& sample = log.samples[k];
    Require(sample.q.allFinite() && sample.v.allFinite() && sample.tau.allFinite() && sample.tau_peak.allFinite(),
            "states are finite");
    Require(sample.effort_use.minCoeff() >= 0.0 && sample.effort_use.maxCoeff() <= 1.0, "shares are 0 to 1");
    Require(std::abs(sample.q.segment<4>(3).norm() - 1.0) < 2e-3, "quaternions are of unit length");
    Require(sample.q.size() == log.samples[0].q.size() && sample.v.size() == sample.q.size() - 1,
            "sizes belong together");
    Require(k == 0 || sample.time_s > log.samples[k - 1].time_s, "times are sorted");
    Require(sample.wrenches.size() == log.samples[0].wrenches.size() && sample.wrenches.size() <= 64,
            "the number of feet is constant");
    Require((sample.contact & ~AllFeet(static_cast<int>(sample.wrenches.size()))) == 0, "feet in contact exist");
  }
}

Verdict ReadLogFile(const std::string& input) {
  const Result<PlaybackLog> log = LogFromJson(input, "input");
  if (!log) return Verdict::kRefused;
  Require(log->step_s > 0.0 && log->log_rate_hz > 0.0 && std::isfinite(log->start_s), "samples have times");
  Require(log->total_mass_kg >= 0.0 && log->friction >= 0.0, "mass and friction are not negative");
  CheckSamples(*log);
  const std::string text = LogToJson(*log);
  const Result<PlaybackLog> back = LogFromJson(text, "again");
  Require(back.ok(), "a log is read back: " + (back.ok() ? "" : back.failure().message));
  for (std::size_t k = 0; k < log->samples.size(); ++k) {
    Require(back->samples[k].q == log->samples[k].q && back->samples[k].wrenches == log->samples[k].wrenches &&
                back->samples[k].contact == log->samples[k].contact,
            "a log is read back as it was");
  }
  const std::string once_more = LogToJson(*back);  // the first text may have -0, which JSON reads as 0
  Require(LogToJson(LogFromJson(once_more, "once more").value()) == once_more, "a log is read back as it was");
  return Verdict::kAccepted;
}

std::vector<std::string> MadeLogs() {
  PlaybackLog log;
  log.robot = "four";
  log.robot_hash = log.plan_hash = "0123456789abcdef";
  log.controller = "joint-pd";
  log.total_mass_kg = 12.0;
  log.friction = 0.8;
  log.options = {{"play.step_s", "0.001"}};
  log.saturated_s = Vector2(0.0, 0.1);
  log.stances = {{1, 0.1, 0.7, Vector3(0.3, 2.0, 3.0), 0.2, 1e-7, 55.5, 2e-6, 0.3}};
  log.body_contacts = {{0.55, "trunk"}};
  log.gates = {{"lift", 0.01, 0.25, true}};
  for (int k = 0; k < 3; ++k) {
    LogSample sample;
    sample.time_s = 0.005 * (k + 1);
    sample.q = VectorX::Constant(9, 0.1);
    sample.q.segment<4>(3) << 0.0, 0.0, 0.0, 1.0;
    sample.v = VectorX::Constant(8, -0.2);
    sample.tau = Vector2(1.0, -2.0);
    sample.tau_peak = Vector2(1.5, 2.5);
    sample.effort_use = Vector2(0.5, 1.0);
    sample.wrenches.resize(2);
    sample.contact = 3;
    log.samples.push_back(sample);
  }
  PlaybackLog empty;
  empty.saturated_s = Vector2::Zero();
  return {LogToJson(log), LogToJson(empty)};
}

/// Sensors that disturbances may name.
OptionFields SensorFields() {
  static double noise = 0.0;
  return {{"noise_rad", &noise, "rad", 0.0, 0.1, "", {}}};
}

void CheckDistributions(const std::vector<Disturbance>& figures) {
  for (const auto& [key, distribution] : figures) {
    Require(!key.empty(), "quantities have keys");
    Require(std::isfinite(distribution.lowest) && std::isfinite(distribution.highest), "ranges are finite");
    Require(distribution.lowest <= distribution.highest, "distributions do not run backward");
    NamedRandom random(1, key);
    if (distribution.kind == Distribution::Kind::kWords) continue;
    const double drawn = Draw(distribution, random);
    Require(drawn >= distribution.lowest && drawn <= distribution.highest, "drawn values are within the range");
  }
}

Verdict ReadDisturbancesFile(const std::string& input) {
  const Result<Disturbances> read = ReadDisturbances(input, SensorFields(), "input");
  if (!read) return Verdict::kRefused;
  CheckDistributions(read->figures);
  for (const DisturbedPush& push : read->pushes) CheckDistributions(push);
  if (read->figures.empty() && read->pushes.empty()) return Verdict::kAccepted;
  const std::string text = DisturbancesText(*read);
  const Result<Disturbances> back = ReadDisturbances(text, SensorFields(), "again");
  Require(back.ok(), "disturbances are read back: " + (back.ok() ? "" : back.failure().message));
  Require(DisturbancesText(*back) == text, "disturbances are read back as they were");
  return Verdict::kAccepted;
}

std::vector<std::string> MadeDisturbances() {
  return {"mass_scale: {normal: {mean: 1, std: 0.1, lowest: 0.8, highest: 1.2}}\nstart: {yaw_rad: 0.1}\n",
          "sensors: {noise_rad: {choice: [0, 0.01]}}\npushes:\n  - {size_n: {uniform: [0, 50]}, place: {choice: [base, "
          "robot]}, at_share: 0.5}\n"};
}

Verdict ReadOutcome(const std::string& input) {
  TrialOutcome outcome;
  try {
    outcome = OutcomeFromLine(input);
  } catch (const InvalidArgument&) {
    return Verdict::kRefused;
  }
  Require(std::isfinite(outcome.score) && std::isfinite(outcome.ended_s), "numbers of an outcome are finite");
  const std::string line = OutcomeToLine(outcome);
  Require(OutcomeToLine(OutcomeFromLine(line)) == line, "an outcome is read back as it was");
  return Verdict::kAccepted;
}

std::vector<std::string> MadeOutcomes() {
  TrialOutcome outcome;
  outcome.cause = "a foot slid";
  outcome.sampled = {{"mass_scale", "1", 0.9, ""}, {"push1.place", "", 0.0, "base"}};
  outcome.metrics = {{"fell", 0.0}, {"goal_error_m", std::nullopt}};
  outcome.steps = {{0.001, 2.5, -1.0, true, 0.012, 0.003, -0.002}, {0.0, 0.0, 0.0, false, 0.0, 0.0, 0.0}};
  return {OutcomeToLine(outcome)};
}

}  // namespace

const std::vector<Reader>& Readers() {
  static const std::vector<Reader> readers = {
      {"log",
       ReadLogFile,
       {"null", "true", "{}", "[]", "-1", "1e400", "18446744073709551615", "\"schema\"", "\"stances\"", "\"contact\"",
        "\"q\"", "\"time_s\"", "\"gates\"", "\"body_contacts\"", "\"saturated_s\"", "\"contact_wrenches\"",
        "[0,0,0,0,0,0,1]", "\\u0000"},
       {},
       MadeLogs},
      {"disturbances",
       ReadDisturbancesFile,
       {"uniform", "normal",  "choice", "fixed", "mean",     "std", "lowest", "highest", "pushes",
        "start",   "sensors", "size_n", "place", "friction", "[",   "]",      "{",       "}",
        ": ",      "\n  - ",  ".nan",   ".inf",  "-1e400",   "&a",  "*a"},
       {"examples/disturbances/a1_hobby.yaml", "examples/disturbances/nao_room.yaml"},
       MadeDisturbances},
      {"outcome",
       ReadOutcome,
       {"null", "true", "{}", "[]", "-1", "1e400", "\"number\"", "\"sampled\"", "\"metrics\"", "\\u0000"},
       {},
       MadeOutcomes},
      NetworkReader(),
      ContractReader(),
      CommandsReader()};
  return readers;
}

}  // namespace gaitwright::fuzz
