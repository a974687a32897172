// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/centroidal_problems.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>

#include "kinematics/base/file.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Vector3 ToVector3(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Matrix3 ToInertia(const Json& json) {
  const auto at = [&](const char* key) { return json.at(key).get<double>(); };
  Matrix3 inertia;
  inertia << at("xx"), at("xy"), at("xz"), at("xy"), at("yy"), at("yz"), at("xz"), at("yz"), at("zz");
  return inertia;
}

CentroidalRobot ToRobot(const Json& json, double force_max_n, const Json& schedules) {
  CentroidalRobot robot;
  robot.mass_kg = json.at("mass_kg");
  robot.inertia_B = ToInertia(json.at("inertia_kg_m2"));
  for (const Json& place : json.at("nominal_stance_m")) {
    RigidFoot foot;
    foot.p_CF_nominal_B = ToVector3(place);
    foot.workspace_B = BoxAbout(foot.p_CF_nominal_B, ToVector3(json.at("reach_box_half_m")));
    foot.force_max_n = force_max_n;
    robot.feet.push_back(foot);
  }
  for (const Json& schedule : schedules.at(json.at("schedules").get<std::string>())) {
    robot.schedules.push_back({schedule.at("name"), schedule.at("phase_durations_s")});
    if (robot.schedules.back().phase_durations_s.size() != robot.feet.size())
      throw InvalidArgument(
          fmt::format("schedule '{}' is not one of {} feet", robot.schedules.back().name, robot.feet.size()));
  }
  return robot;
}

Terrain ToGround(const std::string& name, const Json& patches, double friction) {
  Terrain ground;
  ground.name = name;
  for (const Json& patch : patches) {
    std::vector<Vector3> corners;
    for (const Json& corner : patch) corners.push_back(ToVector3(corner));
    ground.patches.push_back(PatchThrough(fmt::format("{}-{}", name, ground.patches.size()), corners, friction));
  }
  return ground;
}

CentroidalProblemSet ToSet(const Json& json) {
  CentroidalProblemSet set;
  set.friction = json.at("friction");
  set.distance_m = json.at("distance_m");
  set.duration_s = json.at("duration_s");
  const double force_max_n = json.at("normal_force_max_n");
  for (const auto& [name, robot] : json.at("robots").items())
    set.robots.emplace_back(name, ToRobot(robot, force_max_n, json.at("schedules")));
  for (const auto& [name, patches] : json.at("grounds").items())
    set.grounds.push_back(ToGround(name, patches, set.friction));
  return set;
}

}  // namespace

Result<CentroidalProblemSet> LoadCentroidalProblems(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  try {
    return ToSet(Json::parse(*text));
  } catch (const std::exception& e) {
    return Failure{FailureKind::kBadInput,
                   "bad_problem_set",
                   "LoadCentroidalProblems",
                   fmt::format("'{}' is no set of problems: {}", path, e.what()),
                   {"see tests/benchmarks/centroidal_problems.json"}};
  }
}

std::string CentroidalProblemsPath() {
  std::error_code error;
  return std::filesystem::exists(GAITWRIGHT_SOURCE_BENCHMARKS, error)
             ? GAITWRIGHT_SOURCE_BENCHMARKS "/centroidal_problems.json"
             : GAITWRIGHT_INSTALLED_BENCHMARKS "/centroidal_problems.json";
}

RigidBodyProblem CentroidalProblem(const CentroidalRobot& robot, const CentroidalSchedule& schedule,
                                   const Terrain& ground, const CentroidalTask& task) {
  RigidBodyProblem problem;
  problem.mass_kg = robot.mass_kg;
  problem.inertia_B = robot.inertia_B;
  problem.feet = robot.feet;
  problem.duration_s = task.duration_s;
  const auto over = [&](double x_m) -> Vector3 {
    return {x_m, 0.0, GroundAt(ground, {x_m, 0.0}).height_m - robot.feet.front().p_CF_nominal_B.z()};
  };
  problem.start.p_WC = over(0.0);
  problem.goal.p_WC = over(task.distance_m) + task.higher_m * Vector3::UnitZ();
  for (std::size_t foot = 0; foot < robot.feet.size(); ++foot) {
    const std::vector<double>& durations = schedule.phase_durations_s[foot];
    const double stretch = task.duration_s / std::accumulate(durations.begin(), durations.end(), 0.0);
    double t = 0.0;
    for (std::size_t i = 0; i < durations.size(); ++i) {
      RigidStance stance;
      stance.foot = static_cast<int>(foot);
      stance.start_s = t;
      t = i + 1 == durations.size() ? task.duration_s : t + stretch * durations[i];
      stance.end_s = t;
      if (i % 2 == 1) continue;
      stance.held = i == 0;
      stance.friction = task.friction;
      stance.X_WF.translation() = problem.start.p_WC + robot.feet[foot].p_CF_nominal_B;
      problem.stances.push_back(stance);
    }
  }
  return problem;
}

Terrain WithFriction(Terrain ground, double friction) {
  for (TerrainPatch& patch : ground.patches) patch.friction = friction;
  return ground;
}

}  // namespace gaitwright
