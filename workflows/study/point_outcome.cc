// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/point_outcome.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "planning/plan/json_part_internal.h"
#include "playback/trials/wilson.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMost = 1e30;  // largest magnitude of any value, in its unit

/// Reads a number or null. @throws InvalidArgument for a number out of range.
std::optional<double> OrNothing(const Json& json, double lowest = -kMost, double highest = kMost) {
  if (json.is_null()) return std::nullopt;
  const double value = json.get<double>();
  if (value >= lowest && value <= highest) return value;
  throw InvalidArgument(fmt::format("a value is {}; accepted: {} to {}", value, lowest, highest));
}

PointStatus StatusOf(const std::string& name) {
  for (const PointStatus status : kPointStatuses) {
    if (StatusName(status) == name) return status;
  }
  throw InvalidArgument(fmt::format("there is no status '{}'", name));
}

Json EngineRows(const std::vector<EngineVerdict>& engines) {
  Json list = Json::array();
  for (const EngineVerdict& v : engines) list.push_back({v.engine, v.pass, v.fell, v.score, v.cause});
  return list;
}

EngineVerdict EngineOfRow(const Json& json) {
  return {json.at(0).get<std::string>(), json.at(1).get<bool>(), json.at(2).get<bool>(),
          JsonPart(json.at(3)).NumberIn(0.0, 100.0), json.at(4).get<std::string>()};
}

PointOutcome FromJson(const Json& json) {
  PointOutcome o;
  o.point = JsonPart(json.at("point")).Natural();
  o.status = StatusOf(json.at("status").get<std::string>());
  o.code = json.at("code").get<std::string>();
  o.reason = json.at("reason").get<std::string>();
  o.score = OrNothing(json.at("score"), 0.0, 100.0);
  o.fell_at_s = OrNothing(json.at("fell_at_s"));
  for (const Json& value : json.at("metrics")) o.metrics.push_back(OrNothing(value));
  if (const Json& s = json.at("survival"); !s.is_null()) {
    const int trials = JsonPart(s.at(0)).Whole(1, std::numeric_limits<int>::max()),
              survived = JsonPart(s.at(1)).Whole(0, trials);
    o.survival = PointSurvival{trials,
                               survived,
                               s.at(2).get<double>(),
                               s.at(3).get<double>(),
                               s.at(4).get<double>(),
                               JsonPart(s.at(5)).NumberIn(0.0, 100.0)};
    if (SurvivalOf(o.survival->trials, o.survival->survived, o.survival->score_mean) != *o.survival)
      throw InvalidArgument("its survival rate does not match its trials");
  }
  if (json.contains("engines")) {
    for (const Json& verdict : json.at("engines")) o.engines.push_back(EngineOfRow(verdict));
  }
  return o;
}

}  // namespace

std::string StatusName(PointStatus status) {
  switch (status) {
    case PointStatus::kPass:
      return "pass";
    case PointStatus::kGateMissed:
      return "gate_missed";
    case PointStatus::kFell:
      return "fell";
    case PointStatus::kAuditFailed:
      return "audit_failed";
    case PointStatus::kRefused:
      break;
  }
  return "refused";
}

PointSurvival SurvivalOf(int trials, int survived, double score_mean) {
  const ShareInterval interval = WilsonInterval(survived, trials);
  return {trials, survived, interval.share, interval.low, interval.high, score_mean};
}

std::string PointToLine(const PointOutcome& o) {
  Json metrics = Json::array(), survival;
  for (const std::optional<double>& value : o.metrics) metrics.push_back(JsonOrNull(value));
  if (o.survival) {
    const PointSurvival& s = *o.survival;
    survival = Json::array({s.trials, s.survived, s.share, s.low, s.high, s.score_mean});
  }
  Json json = {{"point", o.point},
               {"status", StatusName(o.status)},
               {"code", o.code},
               {"reason", o.reason},
               {"score", JsonOrNull(o.score)},
               {"fell_at_s", JsonOrNull(o.fell_at_s)},
               {"metrics", metrics},
               {"survival", survival}};
  if (!o.engines.empty()) json["engines"] = EngineRows(o.engines);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<PointOutcome> PointFromLine(const std::string& line) {
  try {
    return FromJson(Json::parse(line));
  } catch (const std::exception& error) {  // thrown by the JSON reader, or for an unknown status
    return Failure{FailureKind::kBadInput,
                   FailureCode::kJournalLine,
                   "PointFromLine",
                   fmt::format("a line of the journal is not an outcome: {}", error.what()),
                   {}};
  }
}

bool IsBetter(const PointOutcome& a, const PointOutcome& b) {
  const auto share = [](const PointOutcome& o) { return o.survival ? o.survival->share : 0.0; };
  const auto passes = [](const PointOutcome& o) { return o.status == PointStatus::kPass; };
  if (a.audit_pass() != b.audit_pass()) return a.audit_pass();
  if (share(a) != share(b)) return share(a) > share(b);
  if (passes(a) != passes(b)) return passes(a);
  const double score_a = a.score.value_or(-1.0), score_b = b.score.value_or(-1.0);
  return score_a != score_b ? score_a > score_b : a.point < b.point;
}

}  // namespace gaitwright
