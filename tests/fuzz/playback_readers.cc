// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "playback/log/log_json.h"
#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {
namespace {

void CheckSamples(const PlaybackLog& log) {
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    const LogSample& sample = log.samples[k];
    Require(sample.q.allFinite() && sample.v.allFinite() && sample.tau.allFinite() && sample.tau_peak.allFinite(),
            "states are finite");
    Require(std::abs(sample.q.segment<4>(3).norm() - 1.0) < 2e-3, "quaternions are of unit length");
    Require(sample.q.size() == log.samples[0].q.size() && sample.v.size() == sample.q.size() - 1,
            "sizes belong together");
    Require(k == 0 || sample.time_s > log.samples[k - 1].time_s, "times are sorted");
    Require(sample.wrenches.size() == log.samples[0].wrenches.size() && sample.wrenches.size() <= 64,
            "feet are as many");
    Require((sample.contact & ~AllFeet(static_cast<int>(sample.wrenches.size()))) == 0, "feet that touch are there");
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
  Require(LogToJson(*back) == text, "a log is read back as it was");
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
  for (int k = 0; k < 3; ++k) {
    LogSample sample;
    sample.time_s = 0.005 * (k + 1);
    sample.q = VectorX::Constant(9, 0.1);
    sample.q.segment<4>(3) << 0.0, 0.0, 0.0, 1.0;
    sample.v = VectorX::Constant(8, -0.2);
    sample.tau = Vector2(1.0, -2.0);
    sample.tau_peak = Vector2(1.5, 2.5);
    sample.wrenches.resize(2);
    sample.contact = 3;
    log.samples.push_back(sample);
  }
  PlaybackLog empty;
  empty.saturated_s = Vector2::Zero();
  return {LogToJson(log), LogToJson(empty)};
}

}  // namespace

const std::vector<Reader>& Readers() {
  static const std::vector<Reader> readers = {
      {"log",
       ReadLogFile,
       {"null", "true", "{}", "[]", "-1", "1e400", "18446744073709551615", "\"schema\"", "\"stances\"", "\"contact\"",
        "\"q\"", "\"time_s\"", "\"body_contacts\"", "\"saturated_s\"", "\"contact_wrenches\"", "[0,0,0,0,0,0,1]",
        "\\u0000"},
       {},
       MadeLogs}};
  return readers;
}

}  // namespace gaitwright::fuzz
