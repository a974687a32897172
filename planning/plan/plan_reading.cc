// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/result.h"
#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/plan_reading_internal.h"
#include "planning/plan/plan_shape.h"
#include "planning/plan/plan_shape_internal.h"

namespace gaitwright {
namespace {

std::vector<Vector3> ToPoints(const JsonPart& list) {
  std::vector<Vector3> points;
  for (const JsonPart& point : list.List()) points.emplace_back(point.Vector(3));
  return points;
}

MeshHull ToMesh(const JsonPart& part) {
  part.Object(MeshShape());
  MeshHull mesh{part.At("file").Text(), ToPoints(part.At("vertices_m"))};
  if (mesh.vertices.empty()) part.At("vertices_m").Refuse("is empty; one vertex or more is needed");
  if (mesh.vertices.size() > kMostHullPoints) {
    part.At("vertices_m")
        .Refuse(fmt::format("has {} points; at most {} are accepted", mesh.vertices.size(), kMostHullPoints));
  }
  return mesh;
}

PlanarPose ToPlanarPose(const JsonPart& pose) {
  pose.Object(PlanarPoseShape());
  return {pose.At("x_m").Number(), pose.At("y_m").Number(), pose.At("yaw_rad").Number()};
}

WalkCommand ToCommand(const JsonPart& command) {
  command.Object(CommandShape());
  WalkCommand c;
  c.extent = static_cast<WalkCommand::Extent>(command.At("extent").Choice(PlanExtents()));
  c.speed_m_s = command.At("speed_m_s").Number();
  c.lateral_speed_m_s = command.At("lateral_speed_m_s").Number();
  c.yaw_rate_rad_s = command.At("yaw_rate_rad_s").Number();
  c.distance_m = command.At("distance_m").NumberFrom(0.0);
  if (command.Has("duration_s")) c.duration_s = command.At("duration_s").NumberFrom(0.0);
  c.goal_x_m = command.At("goal_x_m").Number();
  c.goal_y_m = command.At("goal_y_m").Number();
  c.goal_yaw_rad = command.At("goal_yaw_rad").Number();
  c.steps = command.At("steps").Whole(0, kMostSteps);
  c.step_length_m = command.At("step_length_m").Number();
  return c;
}

void CheckOutline(const JsonPart& part, const std::vector<Vector2>& outline) {
  constexpr double kRounding = 1e-6;
  const double share = ShareOfHull(outline);
  if (std::abs(share - 1.0) <= kRounding) return;
  if (std::abs(share + 1.0) <= kRounding) part.Refuse("runs clockwise; it must run counter-clockwise");
  part.Refuse(fmt::format("covers {:.4g} of its convex hull; it must be convex", std::abs(share)));
}

TerrainPatch ToPatch(const JsonPart& part) {
  part.Object(PlanPatchShape());
  TerrainPatch patch{
      part.At("name").Text(), part.At("pose").ToPose(), {}, part.At("friction").NumberIn(0.0, kMostFriction)};
  const double upright = patch.X_WT.linear()(2, 2);
  if (!(upright > 0.0))
    part.Refuse(fmt::format("faces down: the z of its normal is {:.3g}; it must be above 0", upright));
  for (const JsonPart& corner : part.At("outline_m").List()) patch.outline_T.emplace_back(corner.Vector(2));
  const std::size_t corners = patch.outline_T.size();
  if (corners == 1 || corners == 2) {
    part.At("outline_m")
        .Refuse(
            fmt::format("has {} corners; accepted: none (an infinite plane), or three or more (an outline)", corners));
  }
  if (corners > 2) CheckOutline(part.At("outline_m"), patch.outline_T);
  return patch;
}

HeightField ToHeightField(const JsonPart& part) {
  part.Object(PlanHeightFieldShape());
  HeightField field{part.At("name").Text(),
                    part.At("origin_m").Vector(2),
                    part.At("resolution_m").NumberFrom(0.0),
                    part.At("columns").Whole(2, kMostNodesAlong),
                    part.At("rows").Whole(2, kMostNodesAlong),
                    part.At("heights_m").Numbers(),
                    part.At("friction").NumberIn(0.0, kMostFriction)};
  if (field.resolution_m == 0.0) part.At("resolution_m").Refuse("is 0; it must be above 0");
  const std::size_t nodes = static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows);
  if (field.height_m.size() != nodes) {
    part.At("heights_m")
        .Refuse(fmt::format("has {} numbers; {} columns by {} rows need {}", field.height_m.size(), field.columns,
                            field.rows, nodes));
  }
  return field;
}

Obstacle ToObstacle(const JsonPart& part) {
  part.Object(PlanObstacleShape());
  Obstacle obstacle;
  obstacle.name = part.At("name").Text();
  obstacle.type = ObstacleTypes()[static_cast<std::size_t>(part.At("type").Choice(ObstacleTypeNames()))];
  obstacle.X_WO = part.At("pose").ToPose();
  const bool mesh = obstacle.type == ShapeType::kMesh;
  const std::string needed = mesh ? "vertices_m" : "size_m";
  part.Object({"name", "type", "pose", needed});
  if (mesh) {
    obstacle.vertices_O = ToPoints(part.At(needed));
    if (obstacle.vertices_O.size() < 4)
      part.At(needed).Refuse(fmt::format("has {} points; four or more are needed", obstacle.vertices_O.size()));
    return obstacle;
  }
  const VectorX size = part.At(needed).Vector(obstacle.type == ShapeType::kBox ? 3 : 2);
  if (!(size.minCoeff() > 0.0))
    part.At(needed).Refuse(fmt::format("has a size of {}; it must be above 0", size.minCoeff()));
  obstacle.size_m.head(size.size()) = size;
  return obstacle;
}

Terrain ToTerrain(const JsonPart& part) {
  part.Object(PlanTerrainShape());
  Terrain terrain;
  terrain.name = part.At("name").Text();
  for (const JsonPart& patch : part.At("patches").List()) terrain.patches.push_back(ToPatch(patch));
  for (const JsonPart& field : part.At("height_fields").List()) terrain.height_fields.push_back(ToHeightField(field));
  for (const JsonPart& obstacle : part.At("obstacles").List()) terrain.obstacles.push_back(ToObstacle(obstacle));
  if (part.Has("markers")) {
    for (const JsonPart& marker : part.At("markers").List()) {
      marker.Object(PlanMarkerShape());
      terrain.markers.push_back({marker.At("name").Text(), marker.At("place_m").Vector(2)});
    }
  }
  if (terrain.num_surfaces() == 0)
    part.Refuse("has neither patches nor height fields; a plan needs ground to stand on");
  return terrain;
}

Gait ToGait(const JsonPart& part, int feet) {
  part.Object(PlanGaitShape());
  const double cycle_s = part.At("cycle_s").Number();
  if (!(cycle_s > 0.0)) part.At("cycle_s").Refuse(fmt::format("is {}; it must be above 0", cycle_s));
  for (const JsonPart& phase : part.At("phase").List()) {
    if (phase.NumberIn(0.0, 1.0) == 1.0) phase.Refuse("is 1; a phase must be less than 1");
  }
  const std::vector<JsonPart> shares = part.At("duty_factor").List();
  const auto never = [](const JsonPart& share) { return share.NumberIn(0.0, 1.0) == 0.0; };
  const auto lifted = std::find_if(shares.begin(), shares.end(), never);
  if (lifted != shares.end() && !std::all_of(shares.begin(), shares.end(), never))
    lifted->Refuse("is 0; a foot that never stands is accepted only if no foot ever stands");
  // The feet of a gait are those of the legs; support links under the body are not part of it.
  const std::size_t legs = std::min(shares.size(), static_cast<std::size_t>(feet));
  const auto by_foot = [&](const char* key) {
    const VectorX numbers = part.At(key).Vector(legs);
    return std::vector<double>(numbers.begin(), numbers.end());
  };
  const auto turns = [&](const char* key) { return part.Has(key) ? part.At(key).NumberIn(-2.0, 2.0) : 0.0; };
  return {part.At("name").Text(), part.At("description").Text(), cycle_s, by_foot("phase"), by_foot("duty_factor"),
          turns("roll_turns"),    turns("pitch_turns")};
}

MotionPart ToPart(const JsonPart& part, int feet) {
  part.Object(PlanPartShape());
  MotionPart read{ToGait(part.At("gait"), feet), ToCommand(part.At("command")), ToPlanarPose(part.At("goal")),
                  part.At("start_s").Number(), part.At("end_s").Number()};
  if (!(read.end_s > read.start_s))
    part.Refuse(fmt::format("lasts from {} s to {} s; it must end after its start", read.start_s, read.end_s));
  return read;
}

PlanGate ToGate(const JsonPart& part, int feet) {
  part.Object(PlanGateShape());
  PlanGate gate{part.At("at_s").Number(), part.At("phase").Text(), part.At("joints_within").NumberIn(0.0, kWidestGate),
                part.At("contact").Natural(), part.At("longest_s").NumberIn(0.0, kLongestWait)};
  if ((gate.contact & ~AllFeet(feet)) != 0)
    part.At("contact").Refuse(fmt::format("names a foot beyond the robot's {} feet", feet));
  return gate;
}

Adjustment ToAdjustment(const JsonPart& part) {
  part.Object(AdjustmentsShape().of.front());
  const std::string why = part.At("why").Text();
  const auto code = FailureCodeOfName(why);
  if (!code) part.At("why").Refuse(fmt::format("is '{}', which is not a failure code", why));
  return {part.At("what").Text(), part.At("asked").Number(), part.At("given").Number(), part.At("unit").Text(), *code,
          part.At("part").Text()};
}

ContactSchedule ToSchedule(const JsonPart& list, int feet) {
  ContactSchedule schedule;
  for (const JsonPart& phase : list.List()) {
    const std::vector<JsonPart> parts = phase.List();
    if (parts.size() != 3)
      phase.Refuse(fmt::format("has {} values; three are needed: start, end and stance", parts.size()));
    schedule.phases.push_back({parts[0].Number(), parts[1].Number(), parts[2].Natural()});
  }
  CheckSchedule(schedule, feet);
  return schedule;
}

Foothold ToFoothold(const JsonPart& part, int feet, int surfaces) {
  part.Object(FootholdShape());
  if (part.At("liftoff_s").Number() < part.At("touchdown_s").Number()) part.Refuse("lifts off before it touches down");
  Foothold foothold{part.At("foot").Whole(0, feet - 1), part.At("pose").ToPose(),
                    part.At("roll_m").Vector(3),        part.At("patch").Whole(0, surfaces - 1),
                    part.At("touchdown_s").Number(),    part.At("liftoff_s").Number()};
  if (!part.Has("heel_off_s")) return foothold;
  foothold.heel_off_s = part.At("heel_off_s").Number();
  if (*foothold.heel_off_s < foothold.touchdown_s || *foothold.heel_off_s > foothold.liftoff_s) {
    part.Refuse(fmt::format("has 'heel_off_s' {}; accepted: from 'touchdown_s' {} to 'liftoff_s' {}",
                            *foothold.heel_off_s, foothold.touchdown_s, foothold.liftoff_s));
  }
  return foothold;
}

SwingTrajectory ToSwing(const JsonPart& part, int feet) {
  part.Object(SwingShape());
  const JsonPart clearance = part.At("clearance_m");
  SwingTrajectory swing{part.At("foot").Whole(0, feet - 1),
                        part.At("start_s").Number(),
                        part.At("end_s").Number(),
                        part.At("start_pose").ToPose(),
                        part.At("end_pose").ToPose(),
                        part.At("lift_m").Number(),
                        clearance.json().is_null() ? std::numeric_limits<double>::infinity() : clearance.Number()};
  if (!(swing.end_s > swing.start_s))
    part.Refuse(fmt::format("lasts from {} s to {} s; it must end after its start", swing.start_s, swing.end_s));
  if (part.Has("detour_m")) swing.detour_W = ToPoints(part.At("detour_m"));
  if (part.Has("cruise")) swing.cruise = part.At("cruise").Number();
  if (swing.cruise < 0.0 || swing.cruise >= 1.0)
    part.Refuse(fmt::format("has 'cruise' {}; accepted: 0 to less than 1", swing.cruise));
  return swing;
}

Provenance ToProvenance(const JsonPart& part) {
  part.Object(ProvenanceShape());
  Provenance provenance{part.At("program_version").Text(), part.At("made_by").Text(), {}, part.At("seed").Natural()};
  const JsonPart options = part.At("options");
  if (!options.json().is_object()) options.Object(std::vector<std::string>{});
  for (const auto& [key, value] : options.json().items()) provenance.options.emplace_back(key, options.At(key).Text());
  return provenance;
}

/// Rows of equal length. Their number must be `count` unless it is 0.
std::vector<VectorX> ToRows(const JsonPart& list, std::size_t count) {
  std::vector<VectorX> rows;
  for (const JsonPart& row : list.List()) {
    const std::vector<double> values = row.Numbers();
    rows.push_back(Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size())));
    if (rows.back().size() != rows.front().size())
      row.Refuse(fmt::format("has {} numbers, but the first row has {}", rows.back().size(), rows.front().size()));
  }
  if (rows.empty() || (count > 0 && rows.size() != count))
    list.Refuse(fmt::format("has {} rows; {} are needed", rows.size(), std::max<std::size_t>(count, 1)));
  return rows;
}

void CheckQuaternions(const JsonPart& list, const std::vector<VectorX>& q) {
  constexpr double kUnit = 1e-6;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const double length = q[k].segment<4>(3).norm();
    if (!(std::abs(length - 1.0) <= kUnit))
      list.List()[k].Refuse(fmt::format("has a quaternion of length {:.6g}; it must be 1", length));
  }
}

void ReadWholeBody(const JsonPart& whole, WholeBodyTrajectory& w) {
  w.start_s = whole.At("start_s").NumberIn(-kLongestTime, kLongestTime);
  w.step_s = whole.At("step_s").Number();
  if (!(w.step_s > 0.0)) whole.At("step_s").Refuse(fmt::format("is {}; it must be positive", w.step_s));
  whole.At("step_s").NumberIn(0.0, kLongestStep);
  w.q = ToRows(whole.At("q"), 0);
  w.v = ToRows(whole.At("v"), w.q.size());
  w.a = ToRows(whole.At("a"), w.q.size());
  w.tau = ToRows(whole.At("tau_nm"), w.q.size());
  const Eigen::Index nq = w.q[0].size();
  if (nq < 8 || w.v[0].size() != nq - 1 || w.a[0].size() != nq - 1 || w.tau[0].size() != nq - 7) {
    whole.Refuse(
        fmt::format("has rows of {}, {}, {} and {} numbers in 'q', 'v', 'a' and 'tau_nm'; for n joints, 7 + n, "
                    "6 + n, 6 + n and n are needed",
                    nq, w.v[0].size(), w.a[0].size(), w.tau[0].size()));
  }
  CheckQuaternions(whole.At("q"), w.q);
  for (const VectorX& row : ToRows(whole.At("contact_wrenches"), w.q.size())) {
    if (row.size() == 0 || row.size() % 6 != 0)
      whole.At("contact_wrenches").Refuse(fmt::format("has rows of {} numbers; each foot has six", row.size()));
    if (row.size() > 6 * kMostFeet)
      whole.At("contact_wrenches")
          .Refuse(fmt::format("has {} feet; at most {} are accepted", row.size() / 6, kMostFeet));
    std::vector<ContactWrench> wrenches;
    for (Eigen::Index f = 0; f < row.size(); f += 6) wrenches.push_back({row.segment<3>(f), row.segment<3>(f + 3)});
    w.wrenches.push_back(std::move(wrenches));
  }
}

void ReadCentroidal(const JsonPart& whole, const WholeBodyTrajectory& w, CentroidalTrajectory& c) {
  constexpr Eigen::Index kColumns = 11;
  c.start_s = w.start_s;
  c.step_s = w.step_s;
  c.omega_rad_s = whole.At("omega_rad_s").Number();
  for (const VectorX& row : ToRows(whole.At("centroidal"), w.q.size())) {
    if (row.size() != kColumns)
      whole.At("centroidal").Refuse(fmt::format("has rows of {} numbers; {} are needed", row.size(), kColumns));
    c.p_WC.push_back(row.segment<3>(0));
    c.v_WC.push_back(row.segment<3>(3));
    c.a_WC.push_back(row.segment<3>(6));
    c.p_WZ.push_back(row.segment<2>(9));
  }
}

}  // namespace

const std::vector<std::string>& PlanExtents() {
  static const std::vector<std::string> extents = {"distance", "goal", "steps", "duration"};
  return extents;
}

MotionPlan ReadPlan(const JsonPart& whole) {
  whole.Object(PlanShape());
  MotionPlan plan;
  plan.robot = whole.At("robot").Text();
  plan.robot_hash = whole.At("robot_hash").Text();
  plan.urdf_text = whole.At("urdf").Text();
  plan.yaml_text = whole.At("robot_yaml").Text();
  if (whole.Has("meshes")) {
    for (const JsonPart& mesh : whole.At("meshes").List()) plan.meshes.push_back(ToMesh(mesh));
  }
  plan.provenance = ToProvenance(whole.At("provenance"));
  plan.goal = ToPlanarPose(whole.At("goal"));
  plan.terrain = ToTerrain(whole.At("terrain"));
  for (const JsonPart& warning : whole.At("warnings").List()) plan.warnings.push_back(warning.Text());
  ReadWholeBody(whole, plan.whole_body);
  ReadCentroidal(whole, plan.whole_body, plan.centroidal);
  const int feet = static_cast<int>(plan.whole_body.wrenches.front().size());
  const int surfaces = plan.terrain.num_surfaces();
  for (const JsonPart& part : whole.At("parts").List()) plan.parts.push_back(ToPart(part, feet));
  if (plan.parts.empty()) whole.At("parts").Refuse("is empty; a plan has one part or more");
  if (whole.Has("adjustments")) {
    for (const JsonPart& part : whole.At("adjustments").List()) plan.adjustments.push_back(ToAdjustment(part));
  }
  plan.schedule = ToSchedule(whole.At("schedule"), feet);
  for (const JsonPart& part : whole.At("footholds").List())
    plan.footsteps.footholds.push_back(ToFoothold(part, feet, surfaces));
  SortFootholds(plan.footsteps);
  for (const JsonPart& part : whole.At("swings").List()) plan.swings.push_back(ToSwing(part, feet));
  if (whole.Has("gates")) {
    for (const JsonPart& part : whole.At("gates").List()) plan.gates.push_back(ToGate(part, feet));
  }
  return plan;
}

}  // namespace gaitwright
