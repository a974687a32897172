// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>

#include "planning/plan/json_part_internal.h"
#include "workflows/compare/comparison_text.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json SeriesJson(const SeriesDifference& one) {
  if (one.samples == 0) return nullptr;
  return {{"unit", one.unit},
          {"rms", one.rms},
          {"largest", one.largest},
          {"at_s", one.at_s},
          {"tolerance", one.tolerance},
          {"noise", one.noise},
          {"first_beyond_s", JsonOrNull(one.first_s)}};
}

Json NamedSeries(const std::vector<SeriesDifference>& series) {
  Json object = Json::object();
  for (const SeriesDifference& one : series) object[one.quantity] = SeriesJson(one);
  return object;
}

Json FirstJson(const FirstDifference& one) {
  return {{"quantity", one.quantity}, {"at_s", one.time_s},        {"a", one.a}, {"b", one.b},
          {"unit", one.unit},         {"tolerance", one.tolerance}};
}

Json WordsJson(const std::vector<WordDifference>& words) {
  Json list = Json::array();
  for (const WordDifference& word : words) list.push_back({{"key", word.key}, {"a", word.a}, {"b", word.b}});
  return list;
}

Json MetricsJson(const std::vector<MetricPair>& metrics) {
  Json object = Json::object();
  for (const MetricPair& m : metrics) {
    const bool both = m.a && m.b;
    object[m.key] = {{"a", JsonOrNull(m.a)},
                     {"b", JsonOrNull(m.b)},
                     {"change", both ? JsonOrNull(*m.b - *m.a) : Json(nullptr)},
                     {"unit", m.unit},
                     {"limit", JsonOrNull(m.limit)},
                     {"pass_a", m.pass_a},
                     {"pass_b", m.pass_b},
                     {"differs", m.differs}};
  }
  return object;
}

Json JointsJson(const std::vector<JointDifference>& joints) {
  Json object = Json::object();
  for (const JointDifference& joint : joints) {
    object[joint.joint] = {{"position", SeriesJson(joint.position)},
                           {"speed", SeriesJson(joint.speed)},
                           {"torque", SeriesJson(joint.torque)}};
  }
  return object;
}

Json FeetJson(const std::vector<FootDifference>& feet) {
  Json object = Json::object();
  for (const FootDifference& foot : feet) {
    object[foot.foot] = {{"stances_a", foot.stances_a},
                         {"stances_b", foot.stances_b},
                         {"unmatched", foot.unmatched},
                         {"timing_rms_s", foot.timing.rms},
                         {"timing_largest_s", foot.timing.largest},
                         {"at_s", foot.timing.at_s},
                         {"tolerance_s", foot.timing.tolerance},
                         {"first_beyond_s", JsonOrNull(foot.timing.first_s)}};
  }
  return object;
}

Json FiguresJson(const std::vector<FigurePair>& figures) {
  Json object = Json::object();
  for (const FigurePair& figure : figures)
    object[figure.key] = {{"a", JsonOrNull(figure.a)}, {"b", JsonOrNull(figure.b)}, {"unit", figure.unit}};
  return object;
}

Json AlignmentJson(const MotionComparison& c) {
  Json json = {{"by", c.aligned_by}, {"offset_s", c.offset_s}, {"best_offset_s", nullptr}, {"agreement", nullptr}};
  if (c.best_offset) {
    json["best_offset_s"] = c.best_offset->offset_s;
    json["agreement"] = c.best_offset->agreement;
  }
  return json;
}

std::string Dumped(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::string ComparisonJson(const MotionComparison& c, const std::vector<MetricPair>& metrics) {
  Json json;
  json["compared"] = "motions";
  json["a"] = {{"name", c.name_a}, {"kind", c.kind_a}, {"robot", c.robot_a}};
  json["b"] = {{"name", c.name_b}, {"kind", c.kind_b}, {"robot", c.robot_b}};
  json["same"] = c.same();
  json["first_difference"] = c.same() ? Json(nullptr) : FirstJson(c.in_order.front());
  json["in_order"] = Json::array();
  for (const FirstDifference& one : c.in_order) json["in_order"].push_back(FirstJson(one));
  json["alignment"] = AlignmentJson(c);
  json["start_s"] = c.start_s;
  json["end_s"] = c.end_s;
  json["samples"] = c.samples;
  json["joints"] = JointsJson(c.joints);
  json["joints_only_a"] = c.joints_only_a;
  json["joints_only_b"] = c.joints_only_b;
  json["base"] = NamedSeries(c.base);
  json["balance"] = NamedSeries(c.balance);
  json["feet"] = FeetJson(c.feet);
  json["figures"] = FiguresJson(c.figures);
  json["metrics"] = MetricsJson(metrics);
  json["words"] = WordsJson(c.words);
  json["notes"] = c.notes;
  return Dumped(json);
}

std::string ComparisonJson(const ReportComparison& c) {
  Json json;
  json["compared"] = "reports";
  json["a"] = {{"name", c.name_a}, {"kind", "report"}, {"score", c.score_a}};
  json["b"] = {{"name", c.name_b}, {"kind", "report"}, {"score", c.score_b}};
  json["same"] = c.same();
  json["metrics"] = MetricsJson(c.metrics);
  json["words"] = WordsJson(c.words);
  return Dumped(json);
}

}  // namespace gaitwright
