// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/centroidal_problems.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <numeric>

#include "kinematics/base/data_path.h"
#include "kinematics/base/file.h"
#include "kinematics/spatial/symmetric_matrix.h"
#include "planning/plan/json_part_internal.h"

namespace gaitwright {
namespace {

constexpr int kMostFeet = 64;
// Bounds of the numbers of a problem set, each in its unit; the first is the lower bound of numbers that must be
// positive.
constexpr double kSmallestPositive = 1e-6, kLargestNumber = 1e6;

Matrix3 ToInertia(const JsonPart& part) {
  const auto at = [&](const char* key) { return part.At(key).NumberIn(-kLargestNumber, kLargestNumber); };
  Matrix3 inertia = SymmetricMatrix(at("xx"), at("xy"), at("xz"), at("yy"), at("yz"), at("zz"));
  const Vector3 moments = Eigen::SelfAdjointEigenSolver<Matrix3>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(moments[0] > 0.0) || moments[0] + moments[1] < (1.0 - 1e-6) * moments[2])
    part.Refuse(
        fmt::format("has principal moments of {:.4g}, {:.4g} and {:.4g} kg m^2, which violate the triangle inequality",
                    moments[0], moments[1], moments[2]));
  return inertia;
}

CentroidalSchedule ToSchedule(const JsonPart& part, std::size_t feet) {
  CentroidalSchedule schedule{part.At("name").Text(), {}};
  for (const JsonPart& foot : part.At("phase_durations_s").List()) {
    schedule.phase_durations_s.push_back(foot.Numbers());
    if (foot.List().empty()) foot.Refuse("is empty; a foot has one duration or more");
    for (const JsonPart& duration : foot.List()) duration.NumberIn(kSmallestPositive, kLargestNumber);
  }
  if (schedule.phase_durations_s.size() != feet)
    throw InvalidArgument(fmt::format("schedule '{}' is not for {} feet", schedule.name, feet));
  return schedule;
}

CentroidalRobot ToRobot(const JsonPart& part, double force_max_n, const JsonPart& schedules) {
  CentroidalRobot robot;
  robot.mass_kg = part.At("mass_kg").NumberIn(kSmallestPositive, kLargestNumber);
  robot.inertia_B = ToInertia(part.At("inertia_kg_m2"));
  const VectorX half = part.At("reach_box_half_m").Vector(3);
  if (!(half.minCoeff() > 0.0)) part.At("reach_box_half_m").Refuse("has a side that is not above 0");
  for (const JsonPart& place : part.At("nominal_stance_m").List()) {
    RigidFoot foot;
    foot.p_CF_nominal_B = place.Vector(3);
    foot.workspace_B = BoxAbout(foot.p_CF_nominal_B, half);
    foot.force_max_n = force_max_n;
    robot.feet.push_back(foot);
  }
  if (robot.feet.empty() || robot.feet.size() > kMostFeet)
    part.At("nominal_stance_m").Refuse(fmt::format("has {} feet; 1 to {} are accepted", robot.feet.size(), kMostFeet));
  for (const JsonPart& schedule : schedules.At(part.At("schedules").Text()).List())
    robot.schedules.push_back(ToSchedule(schedule, robot.feet.size()));
  return robot;
}

Terrain ToGround(const std::string& name, const JsonPart& patches, double friction) {
  Terrain ground;
  ground.name = name;
  for (const JsonPart& patch : patches.List()) {
    std::vector<Vector3> corners;
    for (const JsonPart& corner : patch.List()) corners.emplace_back(corner.Vector(3));
    ground.patches.push_back(PatchThrough(fmt::format("{}-{}", name, ground.patches.size()), corners, friction));
  }
  return ground;
}

/// The members of an object, by name.
std::vector<std::pair<std::string, JsonPart>> Members(const JsonPart& part) {
  if (!part.json().is_object()) part.Refuse("is not an object");
  std::vector<std::pair<std::string, JsonPart>> members;
  for (const auto& [name, value] : part.json().items()) members.emplace_back(name, part.At(name));
  return members;
}

CentroidalProblemSet ToSet(const JsonPart& whole) {
  CentroidalProblemSet set;
  set.friction = whole.At("friction").NumberIn(0.001, 100.0);
  set.distance_m = whole.At("distance_m").NumberIn(-1e3, 1e3);
  set.duration_s = whole.At("duration_s").NumberIn(1e-3, 1e3);
  const double force_max_n = whole.At("normal_force_max_n").NumberIn(kSmallestPositive, 1e9);
  for (const auto& [name, robot] : Members(whole.At("robots")))
    set.robots.emplace_back(name, ToRobot(robot, force_max_n, whole.At("schedules")));
  for (const auto& [name, patches] : Members(whole.At("grounds")))
    set.grounds.push_back(ToGround(name, patches, set.friction));
  return set;
}

}  // namespace

Result<CentroidalProblemSet> LoadCentroidalProblems(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  try {
    const JsonPart::Json json = ParseJsonOnce(*text);
    return ToSet(JsonPart(json));
  } catch (const std::exception& e) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kBadProblemSet,
                   "LoadCentroidalProblems",
                   fmt::format("'{}' is not a set of problems: {}", path, e.what()),
                   {"see tests/benchmarks/centroidal_problems.json"}};
  }
}

std::string CentroidalProblemsPath() { return DataPath("benchmarks/centroidal_problems.json"); }

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
