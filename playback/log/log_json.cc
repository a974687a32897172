// SPDX-License-Identifier: BSD-3-Clause
#include "playback/log/log_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "kinematics/base/file.h"
#include "planning/plan/json_part_internal.h"
#include "playback/log/check_log.h"
#include "playback/log/log_shape.h"
#include "playback/log/log_shape_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;
constexpr Eigen::Index kEstimateRow = 13;

template <class Vector>
Json ToJson(const Vector& v) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(v[i]);
  return list;
}

Json StancesJson(const std::vector<StanceRecord>& stances) {
  Json list = Json::array();
  for (const StanceRecord& s : stances) {
    list.push_back({{"foot", s.foot},
                    {"touchdown_s", s.touchdown_s},
                    {"liftoff_s", s.liftoff_s},
                    {"touchdown_m", ToJson(s.p_touchdown_W)},
                    {"touchdown_speed_m_s", s.touchdown_speed_m_s},
                    {"slip_m", s.slip_m},
                    {"peak_normal_n", s.peak_normal_n},
                    {"penetration_m", s.penetration_m},
                    {"friction_use_max", s.friction_use_max}});
  }
  return list;
}

Json PushesJson(const std::vector<TimedPush>& pushes) {
  Json list = Json::array();
  for (const TimedPush& p : pushes)
    list.push_back({{"at_s", p.at_s}, {"for_s", p.for_s}, {"force_n", ToJson(p.force_W)}, {"on", p.on}});
  return list;
}

Json GatesJson(const std::vector<GateRecord>& gates) {
  Json list = Json::array();
  for (const GateRecord& g : gates)
    list.push_back({{"phase", g.phase}, {"at_s", g.at_s}, {"waited_s", g.waited_s}, {"met", g.met}});
  return list;
}

Json HeadJson(const PlaybackLog& log) {
  Json contacts = Json::array();
  for (const BodyContact& c : log.body_contacts) contacts.push_back({{"time_s", c.time_s}, {"link", c.link}});
  Json options = Json::object();
  for (const auto& [key, value] : log.options) options[key] = value;
  Json head = {{"format", kLogFormat},
               {"schema", PlaybackLog::kSchema},
               {"program_version", log.program_version},
               {"robot", log.robot},
               {"robot_hash", log.robot_hash},
               {"plan_hash", log.plan_hash},
               {"controller", log.controller},
               {"start_s", log.start_s},
               {"log_rate_hz", log.log_rate_hz},
               {"step_s", log.step_s},
               {"total_mass_kg", log.total_mass_kg},
               {"friction", log.friction},
               {"options", options},
               {"saturated_s", ToJson(log.saturated_s)},
               {"stances", StancesJson(log.stances)},
               {"body_contacts", contacts}};
  if (!log.gates.empty()) head["gates"] = GatesJson(log.gates);
  if (!log.pushes.empty()) head["pushes"] = PushesJson(log.pushes);
  if (log.start_penetration)
    head["start_penetration"] = {{"depth_m", log.start_penetration->depth_m},
                                 {"link", log.start_penetration->link},
                                 {"solid", log.start_penetration->solid}};
  if (!log.broke_off.empty()) {
    head["broke_off"] = log.broke_off;
    head["broke_off_by"] = StoppedByName(log.broke_off_by);
  }
  return head;
}

/// One row and one line per sample; written directly, because the samples are most of a log.
template <class Row>
void AppendRows(std::string& text, const char* key, const std::vector<LogSample>& samples, Row row) {
  fmt::format_to(std::back_inserter(text), ",\n\"{}\": [", key);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    text += k == 0 ? "\n[" : ",\n[";
    const VectorX values = row(samples[k]);
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (i > 0) text += ',';
      fmt::format_to(std::back_inserter(text), "{}", values[i]);
    }
    text += ']';
  }
  text += ']';
}

bool HasEstimates(const PlaybackLog& log) {
  return !log.samples.empty() &&
         std::all_of(log.samples.begin(), log.samples.end(), [](const LogSample& s) { return s.estimate.has_value(); });
}

VectorX EstimateRow(const LogSample& sample) {
  VectorX row(kEstimateRow);
  row << sample.estimate->p_WB, sample.estimate->R_WB.coeffs(), sample.estimate->v_WB, sample.estimate->w_WB;
  return row;
}

VectorX WrenchRow(const LogSample& sample) {
  VectorX row(6 * static_cast<Eigen::Index>(sample.wrenches.size()));
  for (std::size_t f = 0; f < sample.wrenches.size(); ++f) {
    row.segment<6>(6 * static_cast<Eigen::Index>(f)) << sample.wrenches[f].force_W, sample.wrenches[f].moment_W;
  }
  return row;
}

Vector3 ToVector3(const Json& j) { return JsonPart(j).Vector(3); }

VectorX ToVector(const Json& j) {
  const std::vector<double> values = JsonPart(j).Numbers();
  return Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The list at a key. @throws InvalidArgument if it is not a list.
const Json& ListAt(const Json& j, const char* key) {
  if (!j.at(key).is_array()) throw InvalidArgument(fmt::format("'{}' is not a list", key));
  return j.at(key);
}

StanceRecord ToStance(const Json& j) {
  JsonPart(j).Object(StanceShape());
  return {JsonPart(j).At("foot").Whole(0, 63),       j.at("touchdown_s").get<double>(),
          j.at("liftoff_s").get<double>(),           ToVector3(j.at("touchdown_m")),
          j.at("touchdown_speed_m_s").get<double>(), j.at("slip_m").get<double>(),
          j.at("peak_normal_n").get<double>(),       j.at("penetration_m").get<double>(),
          j.at("friction_use_max").get<double>()};
}

/// Reads the rows of a key into the samples. @throws InvalidArgument unless there is one row per sample, all of one
/// length.
template <class Take>
void ReadRows(const Json& j, const char* key, std::vector<LogSample>& samples, Take take) {
  const Json& rows = ListAt(j, key);
  if (rows.size() != samples.size()) {
    throw InvalidArgument(fmt::format("'{}' has {} rows; {} are needed", key, rows.size(), samples.size()));
  }
  Eigen::Index length = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const VectorX row = ToVector(rows[k]);
    if (k == 0) length = row.size();
    if (row.size() != length) {
      throw InvalidArgument(
          fmt::format("row {} of '{}' has {} numbers, but the first has {}", k, key, row.size(), length));
    }
    take(row, samples[k]);
  }
}

BaseEstimate ToEstimate(const VectorX& row) {
  if (row.size() != kEstimateRow)
    throw InvalidArgument(fmt::format("'estimate' needs {} numbers per row", kEstimateRow));
  return {row.head<3>(), Quaternion(Eigen::Vector4d(row.segment<4>(3))), row.segment<3>(7), row.tail<3>()};
}

void ReadSamples(const Json& j, PlaybackLog& log) {
  std::vector<LogSample>& samples = log.samples;
  samples.resize(ListAt(j, "q").size());
  ReadRows(j, "time_s", samples, [](const VectorX& row, LogSample& s) {
    if (row.size() != 1) throw InvalidArgument("'time_s' needs one number per row");
    s.time_s = row[0];
  });
  ReadRows(j, "q", samples, [](const VectorX& row, LogSample& s) { s.q = row; });
  ReadRows(j, "v", samples, [](const VectorX& row, LogSample& s) { s.v = row; });
  ReadRows(j, "tau_nm", samples, [](const VectorX& row, LogSample& s) { s.tau = row; });
  ReadRows(j, "tau_peak_nm", samples, [](const VectorX& row, LogSample& s) { s.tau_peak = row; });
  ReadRows(j, "effort_use", samples, [](const VectorX& row, LogSample& s) { s.effort_use = row; });
  ReadRows(j, "contact_wrenches", samples, [](const VectorX& row, LogSample& s) {
    if (row.size() % 6 != 0) throw InvalidArgument("'contact_wrenches' needs six numbers per foot");
    for (Eigen::Index f = 0; f < row.size(); f += 6) s.wrenches.push_back({row.segment<3>(f), row.segment<3>(f + 3)});
  });
  if (j.contains("estimate")) {
    ReadRows(j, "estimate", samples, [](const VectorX& row, LogSample& s) { s.estimate = ToEstimate(row); });
  }
  const std::vector<JsonPart> contact = JsonPart(j).At("contact").List();
  if (contact.size() != samples.size()) {
    throw InvalidArgument(fmt::format("'contact' has {} numbers; {} are needed", contact.size(), samples.size()));
  }
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k].contact = contact[k].Natural();
  if (samples.empty()) return;
  const LogSample& s = samples.front();
  if (s.q.size() < 7 || s.v.size() != s.q.size() - 1 || s.tau.size() != s.v.size() - 6 ||
      s.tau_peak.size() != s.tau.size() || s.effort_use.size() != s.tau.size() ||
      log.saturated_s.size() != s.tau.size()) {
    throw InvalidArgument(
        "the columns 'q', 'v', 'tau_nm', 'tau_peak_nm', 'effort_use' and 'saturated_s' have inconsistent sizes");
  }
}

std::vector<TimedPush> ToPushes(const Json& list) {
  std::vector<TimedPush> pushes;
  for (const Json& push : list) {
    JsonPart(push).Object(LogPushShape());
    const VectorX force_W = ToVector(push.at("force_n"));
    if (force_W.size() != 3) throw InvalidArgument("'force_n' of a push needs three numbers");
    pushes.push_back(
        {force_W, push.at("at_s").get<double>(), push.at("for_s").get<double>(), push.at("on").get<std::string>()});
  }
  return pushes;
}

PlaybackLog ReadLog(const Json& j) {
  JsonPart(j).Object(LogShape());
  PlaybackLog log;
  log.program_version = j.at("program_version").get<std::string>();
  log.robot = j.at("robot").get<std::string>();
  log.robot_hash = j.at("robot_hash").get<std::string>();
  log.plan_hash = j.at("plan_hash").get<std::string>();
  log.controller = j.at("controller").get<std::string>();
  log.start_s = j.at("start_s").get<double>();
  log.log_rate_hz = j.at("log_rate_hz").get<double>();
  log.step_s = j.at("step_s").get<double>();
  log.total_mass_kg = j.at("total_mass_kg").get<double>();
  log.friction = j.at("friction").get<double>();
  if (!j.at("options").is_object()) throw InvalidArgument("'options' is not an object with text values");
  for (const auto& [key, value] : j.at("options").items()) log.options.emplace_back(key, value.get<std::string>());
  log.saturated_s = ToVector(j.at("saturated_s"));
  for (const Json& stance : ListAt(j, "stances")) log.stances.push_back(ToStance(stance));
  for (const Json& c : ListAt(j, "body_contacts")) {
    JsonPart(c).Object(BodyContactShape());
    log.body_contacts.push_back({c.at("time_s").get<double>(), c.at("link").get<std::string>()});
  }
  if (j.contains("gates")) {
    for (const Json& g : ListAt(j, "gates")) {
      JsonPart(g).Object(LogGateShape());
      log.gates.push_back({g.at("phase").get<std::string>(), g.at("at_s").get<double>(), g.at("waited_s").get<double>(),
                           g.at("met").get<bool>()});
    }
  }
  if (j.contains("pushes")) log.pushes = ToPushes(ListAt(j, "pushes"));
  if (j.contains("start_penetration")) {
    const Json& deepest = j.at("start_penetration");
    JsonPart(deepest).Object(PenetrationShape());
    log.start_penetration = {deepest.at("depth_m").get<double>(), deepest.at("link").get<std::string>(),
                             deepest.at("solid").get<std::string>()};
  }
  if (j.contains("broke_off")) log.broke_off = j.at("broke_off").get<std::string>();
  if (j.value("broke_off_by", "") == StoppedByName(StoppedBy::kController)) log.broke_off_by = StoppedBy::kController;
  ReadSamples(j, log);
  CheckLog(log);
  return log;
}

Failure Refused(const std::string& source, const std::string& why) {
  return {
      FailureKind::kBadInput, FailureCode::kLogFile, "LoadLog", fmt::format("'{}' is refused: {}", source, why), {}};
}

}  // namespace

const char* StoppedByName(StoppedBy by) { return by == StoppedBy::kController ? "controller" : "physics"; }

std::string LogToJson(const PlaybackLog& log) {
  std::string text = HeadJson(log).dump();
  text.pop_back();  // the closing brace
  AppendRows(text, "time_s", log.samples, [](const LogSample& s) { return VectorX::Constant(1, s.time_s); });
  AppendRows(text, "q", log.samples, [](const LogSample& s) { return s.q; });
  AppendRows(text, "v", log.samples, [](const LogSample& s) { return s.v; });
  AppendRows(text, "tau_nm", log.samples, [](const LogSample& s) { return s.tau; });
  AppendRows(text, "tau_peak_nm", log.samples, [](const LogSample& s) { return s.tau_peak; });
  AppendRows(text, "effort_use", log.samples, [](const LogSample& s) { return s.effort_use; });
  AppendRows(text, "contact_wrenches", log.samples, [](const LogSample& s) { return WrenchRow(s); });
  if (HasEstimates(log)) AppendRows(text, "estimate", log.samples, [](const LogSample& s) { return EstimateRow(s); });
  text += ",\n\"contact\": [";
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "{}{}", k == 0 ? "" : ",", log.samples[k].contact);
  }
  text += "]\n}\n";
  return text;
}

Result<PlaybackLog> LogFromJson(const std::string& text, const std::string& source) {
  try {
    const Json j = ParseJsonOnce(text);
    if (!j.is_object() || !j.contains("format") || j.at("format") != kLogFormat) {
      return Refused(source, "it is not a playback log");
    }
    const int schema = JsonPart(j).At("schema").Whole(0, std::numeric_limits<int>::max());
    if (schema != PlaybackLog::kSchema) {
      return Refused(source,
                     fmt::format("it has schema {}; this program reads schema {}", schema, PlaybackLog::kSchema));
    }
    return ReadLog(j);
  } catch (const Json::parse_error& error) {
    return Refused(source, fmt::format("its JSON is cut short or broken at byte {}", error.byte));
  } catch (const Json::exception& error) {
    return Refused(source, fmt::format("a part is missing or of the wrong kind: {}", error.what()));
  } catch (const InvalidArgument& error) {
    return Refused(source, error.what());
  }
}

Result<std::string> SaveLog(const PlaybackLog& log, const std::string& path) {
  return WriteFileAtomically(path, LogToJson(log));
}

Result<PlaybackLog> LoadLog(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  return LogFromJson(*text, path);
}

}  // namespace gaitwright
