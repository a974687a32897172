// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/plan_json.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "kinematics/base/file.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;
constexpr char kFormat[] = "gaitwright-motion-plan";

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

const char* const kExtents[] = {"distance", "goal", "steps", "duration"};

Json CommandJson(const WalkCommand& c) {
  return {{"extent", kExtents[static_cast<int>(c.extent)]},
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

Json TerrainJson(const Terrain& terrain) {
  Json patches = Json::array();
  for (const TerrainPatch& patch : terrain.patches) {
    patches.push_back({{"name", patch.name},
                       {"pose", ToJson(patch.X_WT)},
                       {"outline_m", ToJson(patch.outline_T)},
                       {"friction", patch.friction}});
  }
  return {{"name", terrain.name}, {"patches", patches}};
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
                    {"detour_m", ToJson(s.detour_W)}});
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

/// Rows of numbers, one row a line; written by hand since most of a plan is these.
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
  for (Eigen::Index i = 0; i < v.size(); ++i) values.push_back(v[i]);
}

void AppendTrajectories(std::string& text, const MotionPlan& plan) {
  const CentroidalTrajectory& c = plan.centroidal;
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

// Reading. `at` throws with the key's name; the messages are turned into failures in PlanFromJson.

Vector2 ToVector2(const Json& j) { return {j.at(0).get<double>(), j.at(1).get<double>()}; }
Vector3 ToVector3(const Json& j) { return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()}; }

Pose ToPose(const Json& j) {
  Pose X = Pose::Identity();
  X.translation() = ToVector3(j);
  X.linear() = Quaternion(j.at(6).get<double>(), j.at(3).get<double>(), j.at(4).get<double>(), j.at(5).get<double>())
                   .normalized()
                   .toRotationMatrix();
  return X;
}

PlanarPose ToPlanarPose(const Json& j) {
  return {j.at("x_m").get<double>(), j.at("y_m").get<double>(), j.at("yaw_rad").get<double>()};
}

WalkCommand ToCommand(const Json& j) {
  WalkCommand c;
  const auto extent = j.at("extent").get<std::string>();
  for (int i = 0; i < 4; ++i) {
    if (extent == kExtents[i]) c.extent = static_cast<WalkCommand::Extent>(i);
  }
  c.speed_m_s = j.at("speed_m_s").get<double>();
  c.lateral_speed_m_s = j.at("lateral_speed_m_s").get<double>();
  c.yaw_rate_rad_s = j.at("yaw_rate_rad_s").get<double>();
  c.distance_m = j.at("distance_m").get<double>();
  c.duration_s = j.value("duration_s", 0.0);
  c.goal_x_m = j.at("goal_x_m").get<double>();
  c.goal_y_m = j.at("goal_y_m").get<double>();
  c.goal_yaw_rad = j.at("goal_yaw_rad").get<double>();
  c.steps = j.at("steps").get<int>();
  c.step_length_m = j.at("step_length_m").get<double>();
  return c;
}

Terrain ToTerrain(const Json& j) {
  Terrain terrain;
  terrain.name = j.at("name").get<std::string>();
  for (const Json& p : j.at("patches")) {
    TerrainPatch patch{p.at("name").get<std::string>(), ToPose(p.at("pose")), {}, p.at("friction").get<double>()};
    for (const Json& corner : p.at("outline_m")) patch.outline_T.push_back(ToVector2(corner));
    terrain.patches.push_back(patch);
  }
  return terrain;
}

void ReadContacts(const Json& j, MotionPlan& plan) {
  const Json& gait = j.at("gait");
  plan.gait = {gait.at("name").get<std::string>(), gait.at("description").get<std::string>(),
               gait.at("cycle_s").get<double>(), gait.at("phase").get<std::vector<double>>(),
               gait.at("duty_factor").get<std::vector<double>>()};
  for (const Json& p : j.at("schedule")) {
    plan.schedule.phases.push_back({p.at(0).get<double>(), p.at(1).get<double>(), p.at(2).get<FootSet>()});
  }
  for (const Json& f : j.at("footholds")) {
    plan.footsteps.footholds.push_back({f.at("foot").get<int>(), ToPose(f.at("pose")), ToVector3(f.at("roll_m")),
                                        f.at("patch").get<int>(), f.at("touchdown_s").get<double>(),
                                        f.at("liftoff_s").get<double>()});
  }
  for (const Json& s : j.at("swings")) {
    plan.swings.push_back({s.at("foot").get<int>(), s.at("start_s").get<double>(), s.at("end_s").get<double>(),
                           ToPose(s.at("start_pose")), ToPose(s.at("end_pose")), s.at("lift_m").get<double>(),
                           s.at("clearance_m").get<double>()});
    for (const Json& p : s.value("detour_m", Json::array())) plan.swings.back().detour_W.push_back(ToVector3(p));
  }
}

/// Rows of equal length. @throws InvalidArgument naming the key and row.
std::vector<VectorX> ToRows(const Json& j, const char* key, std::size_t count) {
  std::vector<VectorX> rows;
  for (const Json& row : j.at(key)) {
    const auto values = row.get<std::vector<double>>();
    rows.push_back(Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size())));
    if (rows.back().size() != rows.front().size()) {
      throw InvalidArgument(fmt::format("row {} of '{}' has {} numbers, the first has {}", rows.size() - 1, key,
                                        rows.back().size(), rows.front().size()));
    }
  }
  if (rows.empty() || (count > 0 && rows.size() != count)) {
    throw InvalidArgument(
        fmt::format("'{}' has {} rows, {} are needed", key, rows.size(), std::max<std::size_t>(count, 1)));
  }
  return rows;
}

void ReadTrajectories(const Json& j, MotionPlan& plan) {
  WholeBodyTrajectory& w = plan.whole_body;
  CentroidalTrajectory& c = plan.centroidal;
  w.start_s = c.start_s = j.at("start_s").get<double>();
  w.step_s = c.step_s = j.at("step_s").get<double>();
  if (!(w.step_s > 0.0)) throw InvalidArgument(fmt::format("'step_s' is {}; it must be positive", w.step_s));
  c.omega_rad_s = j.at("omega_rad_s").get<double>();
  w.q = ToRows(j, "q", 0);
  w.v = ToRows(j, "v", w.q.size());
  w.a = ToRows(j, "a", w.q.size());
  w.tau = ToRows(j, "tau_nm", w.q.size());
  if (w.q[0].size() < 8 || w.v[0].size() != w.q[0].size() - 1 || w.a[0].size() != w.v[0].size() ||
      w.tau[0].size() != w.v[0].size() - 6) {
    throw InvalidArgument("the columns of 'q', 'v', 'a' and 'tau_nm' do not belong together");
  }
  for (const VectorX& row : ToRows(j, "contact_wrenches", w.q.size())) {
    if (row.size() % 6 != 0) throw InvalidArgument("'contact_wrenches' needs six numbers a foot");
    std::vector<ContactWrench> wrenches;
    for (Eigen::Index f = 0; f < row.size(); f += 6) wrenches.push_back({row.segment<3>(f), row.segment<3>(f + 3)});
    w.wrenches.push_back(std::move(wrenches));
  }
  for (const VectorX& row : ToRows(j, "centroidal", w.q.size())) {
    if (row.size() != 11) throw InvalidArgument("'centroidal' needs eleven numbers a row");
    c.p_WC.push_back(row.segment<3>(0));
    c.v_WC.push_back(row.segment<3>(3));
    c.a_WC.push_back(row.segment<3>(6));
    c.p_WZ.push_back(row.segment<2>(9));
  }
}

MotionPlan ReadPlan(const Json& j) {
  MotionPlan plan;
  plan.robot = j.at("robot").get<std::string>();
  plan.robot_hash = j.at("robot_hash").get<std::string>();
  plan.urdf_text = j.at("urdf").get<std::string>();
  plan.yaml_text = j.at("robot_yaml").get<std::string>();
  const Json& provenance = j.at("provenance");
  plan.provenance.program_version = provenance.at("program_version").get<std::string>();
  plan.provenance.made_by = provenance.at("made_by").get<std::string>();
  plan.provenance.seed = provenance.at("seed").get<std::uint64_t>();
  for (const auto& [key, value] : provenance.at("options").items())
    plan.provenance.options.emplace_back(key, value.get<std::string>());
  plan.command = ToCommand(j.at("command"));
  plan.goal = ToPlanarPose(j.at("goal"));
  plan.terrain = ToTerrain(j.at("terrain"));
  plan.warnings = j.at("warnings").get<std::vector<std::string>>();
  ReadContacts(j, plan);
  ReadTrajectories(j, plan);
  return plan;
}

Failure Refused(const std::string& source, const std::string& why, const std::vector<std::string>& hints = {}) {
  return {FailureKind::kBadInput, "plan_file", "LoadPlan", fmt::format("'{}' is refused: {}", source, why), hints};
}

Failure OtherSchema(const std::string& source, int schema) {
  return Refused(
      source, fmt::format("it has schema {}; this program reads schema {}", schema, MotionPlan::kSchema),
      {schema > MotionPlan::kSchema ? "read it with the newer program that wrote it" : "make the plan anew"});
}

}  // namespace

std::string PlanToJson(const MotionPlan& plan) {
  Json head = {{"format", kFormat},
               {"schema", MotionPlan::kSchema},
               {"robot", plan.robot},
               {"robot_hash", plan.robot_hash},
               {"provenance", ProvenanceJson(plan.provenance)},
               {"command", CommandJson(plan.command)},
               {"goal", ToJson(plan.goal)},
               {"warnings", plan.warnings},
               {"terrain", TerrainJson(plan.terrain)},
               {"gait",
                {{"name", plan.gait.name},
                 {"description", plan.gait.description},
                 {"cycle_s", plan.gait.cycle_s},
                 {"phase", plan.gait.phase},
                 {"duty_factor", plan.gait.duty_factor}}},
               {"schedule", ScheduleJson(plan.schedule)},
               {"footholds", FootstepsJson(plan.footsteps)},
               {"swings", SwingsJson(plan.swings)},
               {"urdf", plan.urdf_text},
               {"robot_yaml", plan.yaml_text},
               {"start_s", plan.whole_body.start_s},
               {"step_s", plan.whole_body.step_s},
               {"omega_rad_s", plan.centroidal.omega_rad_s}};
  std::string text = head.dump();
  text.pop_back();  // the closing brace
  AppendTrajectories(text, plan);
  text += "\n}\n";
  return text;
}

Result<MotionPlan> PlanFromJson(const std::string& text, const std::string& source) {
  try {
    const Json j = Json::parse(text);
    if (!j.is_object() || !j.contains("format") || j.at("format") != kFormat)
      return Refused(source, "it is no motion plan");
    const int schema = j.at("schema").get<int>();
    if (schema != MotionPlan::kSchema) return OtherSchema(source, schema);
    MotionPlan plan = ReadPlan(j);
    CheckSchedule(plan.schedule, static_cast<int>(plan.whole_body.wrenches.front().size()));
    return plan;
  } catch (const Json::parse_error& error) {
    return Refused(source, fmt::format("its JSON is cut short or broken at byte {}", error.byte));
  } catch (const Json::exception& error) {
    return Refused(source, fmt::format("a part is missing or of the wrong kind: {}", error.what()));
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
