// SPDX-License-Identifier: BSD-3-Clause
#include "playback/viewer/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kinematics/base/result.h"
#include "playback/score/motion_series.h"
#include "playback/score/report_text.h"
#include "playback/viewer/scene_parts_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json Mark(double at_s, const char* kind, const std::string& text) {
  return {{"at_s", at_s}, {"kind", kind}, {"text", text}};
}

/// Adds the faults in a log: the fall, contacts of the body, and the worst times of failed gates.
void AddFaults(const ShownMotion& shown, Json& marks) {
  for (const BodyContact& contact : shown.log->body_contacts)
    marks.push_back(Mark(contact.time_s, "contact", contact.link + " touches"));
  if (shown.report == nullptr) return;
  for (const Metric& metric : shown.report->metrics) {
    if (!metric.at_s || metric.pass) continue;
    if (metric.key == "fell") {
      marks.push_back(Mark(*metric.at_s, "fall", shown.report->reason));
    } else {
      const std::string value = metric.value ? FigureText(metric, *metric.value) : "-";
      marks.push_back(Mark(*metric.at_s, "worst", metric.key + " is " + value + ", limit " + LimitText(metric)));
    }
  }
}

Json MarksScene(const ShownMotion& shown) {
  Json marks = Json::array();
  const double shift_s = shown.log == nullptr ? 0.0 : shown.log->start_s - shown.plan.whole_body.start_s;
  for (std::size_t k = 1; k < shown.plan.parts.size(); ++k) {
    const MotionPart& part = shown.plan.parts[k];
    marks.push_back(Mark(shift_s + part.start_s, "part", part.gait.name + " begins"));
  }
  if (shown.log != nullptr) AddFaults(shown, marks);
  return marks;
}

Json VerdictScene(const ShownMotion& shown) {
  if (shown.report == nullptr) return nullptr;
  return {{"pass", shown.report->pass && shown.objection.empty()},
          {"score", shown.report->score},
          {"reason", shown.objection.empty() ? shown.report->reason : shown.objection}};
}

MotionSeries SeriesOf(const ShownMotion& shown) {
  if (shown.log != nullptr) return MakeMotionSeries(shown.model, shown.plan, *shown.log, ScoreOptionsOf(*shown.log));
  return MakePlannedSeries(shown.model, shown.plan, std::min(shown.rate_hz, kSceneRateHz), {});
}

Json MotionScene(const ShownMotion& shown) {
  const MotionSeries series = SeriesOf(shown);
  if (series.planned.empty()) throw InvalidArgument("SceneJson: the log has no sample with finite values");
  const double most_hz = std::min(shown.rate_hz, kSceneRateHz);
  const double rate_hz = shown.log == nullptr ? most_hz : shown.log->log_rate_hz;
  const std::size_t stride = static_cast<std::size_t>(std::max(1.0, std::round(rate_hz / most_hz)));
  TrackScenes tracks = TracksScene(shown.model, shown.plan, shown.log, series, stride);
  return {{"title", shown.title},
          {"verdict", VerdictScene(shown)},
          {"robot", RobotScene(shown.model, shown.mesh_folder)},
          {"terrain", TerrainScene(shown.plan.terrain)},
          {"time_s", std::move(tracks.time_s)},
          {"planned", std::move(tracks.planned)},
          {"measured", std::move(tracks.measured)},
          {"ghost", shown.ghost ? GhostScene(shown, series, stride) : Json()},
          {"footholds", FootholdsScene(shown.model, shown.plan)},
          {"swings", SwingsScene(shown.plan)},
          {"marks", MarksScene(shown)}};
}

/// JSON that is safe in a page: characters that could end a script or begin a tag are written as \u003c and the like.
std::string ForPage(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<' || c == '>' || c == '&') {
      text += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string SceneJson(const std::vector<ShownMotion>& motions) {
  if (motions.empty()) throw InvalidArgument("SceneJson: there is no motion to show");
  Json list = Json::array();
  for (const ShownMotion& motion : motions) list.push_back(MotionScene(motion));
  const Json scene = {{"format", "gaitwright-scene"}, {"schema", 1}, {"motions", std::move(list)}};
  return ForPage(scene.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string RobotAndGroundJson(const RobotModel& model, const Terrain& terrain,
                               const std::optional<std::string>& mesh_folder) {
  const Json both = {{"robot", RobotScene(model, mesh_folder)}, {"terrain", TerrainScene(terrain)}};
  return both.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gaitwright
