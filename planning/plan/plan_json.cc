// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/plan_json.h"

#include <fmt/format.h>

#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "kinematics/base/file.h"
#include "kinematics/base/hash.h"
#include "planning/plan/plan_reading_internal.h"
#include "planning/plan/plan_shape_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json ToJson(const Vector& v) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(v[i]);
  return list;
}

Json ToJson(const Pose& X) {
  Json list = ToJson(Vector3(X.translation()));
  const Quaternion quaternion(X.linear());
  for (const double c : quaternion.coeffs()) list.push_back(c);
  return list;
}

Json ToJson(const PlanarPose& p) { return {{"x_m", p.x_m}, {"y_m", p.y_m}, {"yaw_rad", p.yaw_rad}}; }

template <class Vector>
Json ToJson(const std::vector<Vector>& points) {
  Json list = Json::array();
  for (const Vector& p : points) list.push_back(ToJson(p));
  return list;
}

Json CommandJson(const WalkCommand& c) {
  return {{"extent", PlanExtents()[static_cast<std::size_t>(c.extent)]},
          {"speed_m_s", c.speed_m_s},
          {"lateral_speed_m_s", c.lateral_speed_m_s},
          {"yaw_rate_rad_s", c.yaw_rate_rad_s},
          {"distance_m", c.distance_m},
          {"duration_s", c.duration_s},
          {"goal_x_m", c.goal_x_m},
          {"goal_y_m", c.goal_y_m},
          {"goal_yaw_rad", c.goal_yaw_rad},
          {"steps", c.steps},
          {"step_length_m", c.step_length_m}};
}

Json PartsJson(const std::vector<MotionPart>& parts) {
  Json list = Json::array();
  for (const MotionPart& part : parts) {
    Json gait = {{"name", part.gait.name},
                 {"description", part.gait.description},
                 {"cycle_s", part.gait.cycle_s},
                 {"phase", part.gait.phase},
                 {"duty_factor", part.gait.duty_factor}};
    if (part.gait.roll_turns != 0.0) gait["roll_turns"] = part.gait.roll_turns;
    if (part.gait.pitch_turns != 0.0) gait["pitch_turns"] = part.gait.pitch_turns;
    list.push_back({{"start_s", part.start_s},
                    {"end_s", part.end_s},
                    {"command", CommandJson(part.command)},
                    {"goal", ToJson(part.goal)},
                    {"gait", std::move(gait)}});
  }
  return list;
}

Json HeightFieldJson(const HeightField& field) {
  return {{"name", field.name},
          {"origin_m", ToJson(field.origin_W)},
          {"resolution_m", field.resolution_m},
          {"columns", field.columns},
          {"rows", field.rows},
          {"heights_m", field.height_m},
          {"friction", field.friction}};
}

Json ObstacleJson(const Obstacle& obstacle) {
  Json json = {{"name", obstacle.name}, {"type", ObstacleTypeName(obstacle.type)}, {"pose", ToJson(obstacle.X_WO)}};
  if (obstacle.type == ShapeType::kMesh) {
    json["vertices_m"] = ToJson(obstacle.vertices_O);
  } else {
    const Eigen::Index sizes = obstacle.type == ShapeType::kBox ? 3 : 2;
    json["size_m"] = ToJson(VectorX(obstacle.size_m.head(sizes)));
  }
  return json;
}

Json TerrainJson(const Terrain& terrain) {
  Json patches = Json::array(), fields = Json::array(), obstacles = Json::array();
  for (const TerrainPatch& patch : terrain.patches) {
    patches.push_back({{"name", patch.name},
                       {"pose", ToJson(patch.X_WT)},
                       {"outline_m", ToJson(patch.outline_T)},
                       {"friction", patch.friction}});
  }
  for (const HeightField& field : terrain.height_fields) fields.push_back(HeightFieldJson(field));
  for (const Obstacle& obstacle : terrain.obstacles) obstacles.push_back(ObstacleJson(obstacle));
  Json json = {{"name", terrain.name}, {"patches", patches}, {"height_fields", fields}, {"obstacles", obstacles}};
  for (const TerrainMarker& marker : terrain.markers)
    json["markers"].push_back({{"name", marker.name}, {"place_m", ToJson(marker.p_W)}});
  return json;
}

Json GatesJson(const std::vector<PlanGate>& gates) {
  Json list = Json::array();
  for (const PlanGate& gate : gates) {
    list.push_back({{"at_s", gate.at_s},
                    {"phase", gate.phase},
                    {"joints_within", gate.joints_within},
                    {"contact", gate.contact},
                    {"longest_s", gate.longest_s}});
  }
  return list;
}

Json ScheduleJson(const ContactSchedule& schedule) {
  Json phases = Json::array();
  for (const ContactPhase& p : schedule.phases) phases.push_back({p.start_s, p.end_s, p.stance});
  return phases;
}

Json FootstepsJson(const FootstepPlan& plan) {
  Json footholds = Json::array();
  for (const Foothold& f : plan.footholds) {
    footholds.push_back({{"foot", f.foot},
                         {"pose", ToJson(f.X_WF)},
                         {"roll_m", ToJson(f.roll_W)},
                         {"patch", f.patch},
                         {"touchdown_s", f.touchdown_s},
                         {"liftoff_s", f.liftoff_s}});
    if (f.heel_off_s) footholds.back()["heel_off_s"] = *f.heel_off_s;
  }
  return footholds;
}

Json SwingsJson(const std::vector<SwingTrajectory>& swings) {
  Json list = Json::array();
  for (const SwingTrajectory& s : swings) {
    list.push_back({{"foot", s.foot},
                    {"start_s", s.start_s},
                    {"end_s", s.end_s},
                    {"start_pose", ToJson(s.X_WF_start)},
                    {"end_pose", ToJson(s.X_WF_end)},
                    {"lift_m", s.lift_m},
                    {"clearance_m", s.clearance_m},
                    {"detour_m", ToJson(s.detour_W)},
                    {"cruise", s.cruise}});
  }
  return list;
}

Json ProvenanceJson(const Provenance& provenance) {
  Json options = Json::object();
  for (const auto& [key, value] : provenance.options) options[key] = value;
  return {{"program_version", provenance.program_version},
          {"made_by", provenance.made_by},
          {"seed", provenance.seed},
          {"options", options}};
}

/// Rows of numbers, one row per line. Written without the JSON library for speed, since most of a plan is rows.
template <class Row>
void AppendRows(std::string& text, const char* key, std::size_t rows, Row row) {
  fmt::format_to(std::back_inserter(text), ",\n\"{}\": [", key);
  std::vector<double> values;
  for (std::size_t k = 0; k < rows; ++k) {
    values.clear();
    row(k, values);
    text += k == 0 ? "\n[" : ",\n[";
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) text += ',';
      fmt::format_to(std::back_inserter(text), "{}", values[i]);
    }
    text += ']';
  }
  text += "]";
}

template <class Vector>
void Append(std::vector<double>& values, const Vector& v) {
  for (Eigen::Index i = 0; i < v.size(); ++i) values.push_back(v[i] + 0.0);  // avoids -0 in files
}

Json MeshesJson(const std::vector<MeshHull>& meshes) {
  Json list = Json::array();
  for (const MeshHull& mesh : meshes) list.push_back({{"file", mesh.file}, {"vertices_m", ToJson(mesh.vertices)}});
  return list;
}

/// Room for all rows, so that the text of a long plan is not copied while it grows.
void ReserveRows(std::string& text, const MotionPlan& plan) {
  constexpr std::size_t kOfNumber = 21, kOfRow = 10;  // characters, about
  const WholeBodyTrajectory& w = plan.whole_body;
  if (w.q.empty()) return;
  const auto numbers = static_cast<std::size_t>(w.q.front().size() + (w.v.empty() ? 0 : 2 * w.v.front().size()) +
                                                (w.tau.empty() ? 0 : w.tau.front().size()) + 11);
  const std::size_t wrenches = w.wrenches.empty() ? 0 : 6 * w.wrenches.front().size();
  text.reserve(text.size() + w.q.size() * (kOfRow + kOfNumber * (numbers + wrenches)));
}

void AppendTrajectories(std::string& text, const MotionPlan& plan) {
  const CentroidalTrajectory& c = plan.centroidal;
  ReserveRows(text, plan);
  AppendRows(text, "centroidal", c.p_WC.size(), [&](std::size_t k, std::vector<double>& row) {
    Append(row, c.p_WC[k]);
    Append(row, c.v_WC[k]);
    Append(row, c.a_WC[k]);
    Append(row, c.p_WZ[k]);
  });
  const WholeBodyTrajectory& w = plan.whole_body;
  const auto columns = [&](const char* key, const std::vector<VectorX>& list) {
    AppendRows(text, key, list.size(), [&](std::size_t k, std::vector<double>& row) { Append(row, list[k]); });
  };
  columns("q", w.q);
  columns("v", w.v);
  columns("a", w.a);
  columns("tau_nm", w.tau);
  AppendRows(text, "contact_wrenches", w.wrenches.size(), [&](std::size_t k, std::vector<double>& row) {
    for (const ContactWrench& wrench : w.wrenches[k]) {
      Append(row, wrench.force_W);
      Append(row, wrench.moment_W);
    }
  });
}

Failure Refused(const std::string& source, const std::string& why, const std::vector<Suggestion>& suggestions = {}) {
  return {FailureKind::kBadInput, FailureCode::kPlanFile, "LoadPlan", fmt::format("'{}' is refused: {}", source, why),
          suggestions};
}

Failure OtherSchema(const std::string& source, int schema) {
  return Refused(
      source, fmt::format("it has schema {}; this program reads schema {}", schema, MotionPlan::kSchema),
      {schema > MotionPlan::kSchema ? "read it with the newer program that wrote it" : "make the plan again"});
}

Json AdjustmentList(const std::vector<Adjustment>& adjustments) {
  Json list = Json::array();
  for (const Adjustment& a : adjustments) {
    list.push_back({{"what", a.what},
                    {"asked", a.asked},
                    {"given", a.given},
                    {"unit", a.unit},
                    {"why", FailureCodeName(a.why)},
                    {"part", a.part}});
  }
  return list;
}

}  // namespace

std::string AdjustmentsJson(const std::vector<Adjustment>& adjustments) { return AdjustmentList(adjustments).dump(); }

std::string PlanToJson(const MotionPlan& plan) {
  Json head = {{"format", kPlanFormat},
               {"schema", MotionPlan::kSchema},
               {"robot", plan.robot},
               {"robot_hash", plan.robot_hash},
               {"provenance", ProvenanceJson(plan.provenance)},
               {"parts", PartsJson(plan.parts)},
               {"goal", ToJson(plan.goal)},
               {"warnings", plan.warnings},
               {"terrain", TerrainJson(plan.terrain)},
               {"schedule", ScheduleJson(plan.schedule)},
               {"footholds", FootstepsJson(plan.footsteps)},
               {"swings", SwingsJson(plan.swings)},
               {"urdf", plan.urdf_text},
               {"robot_yaml", plan.yaml_text},
               {"start_s", plan.whole_body.start_s},
               {"step_s", plan.whole_body.step_s},
               {"omega_rad_s", plan.centroidal.omega_rad_s}};
  if (!plan.adjustments.empty()) head["adjustments"] = AdjustmentList(plan.adjustments);
  if (!plan.gates.empty()) head["gates"] = GatesJson(plan.gates);
  if (!plan.meshes.empty()) head["meshes"] = MeshesJson(plan.meshes);
  std::string text = head.dump();
  text.pop_back();  // the closing brace
  AppendTrajectories(text, plan);
  text += "\n}\n";
  return text;
}

std::string PlanHash(const MotionPlan& plan) { return HexHash(PlanToJson(plan)); }

Result<MotionPlan> PlanFromJson(const std::string& text, const std::string& source) {
  Json j;
  try {
    j = ParseJsonOnce(text);
  } catch (const Json::exception&) {
    return Refused(source, ReasonNoJson(text));
  } catch (const InvalidArgument& error) {
    return Refused(source, error.what());
  }
  try {
    if (!j.is_object() || !j.contains("format") || j.at("format") != kPlanFormat)
      return Refused(source, "it is not a motion plan");
    const JsonPart whole(j);
    const int schema = whole.At("schema").Whole(0, std::numeric_limits<int>::max());
    if (schema != MotionPlan::kSchema) return OtherSchema(source, schema);
    return ReadPlan(whole);
  } catch (const InvalidArgument& error) {
    return Refused(source, error.what());
  }
}

Result<std::string> SavePlan(const MotionPlan& plan, const std::string& path) {
  return WriteFileAtomically(path, PlanToJson(plan));
}

Result<MotionPlan> LoadPlan(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  return PlanFromJson(*text, path);
}

}  // namespace gaitwright
