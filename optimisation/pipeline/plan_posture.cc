// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/plan_posture.h"

#include <fmt/format.h>

#include <cmath>

#include "kinematics/base/version.h"
#include "kinematics/dynamics/dynamics.h"
#include "optimisation/pipeline/robot_body.h"
#include "optimisation/whole_body/body_path.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

constexpr double kTime = 1e-9;  // [s]

Gait GaitOf(const PostureMotion& motion, int num_feet) {
  Gait gait = StandingGait(num_feet);
  gait.name = motion.name;
  gait.description = "feet stay where they are";
  if (!motion.lift) return gait;
  const auto foot = static_cast<std::size_t>(motion.lift->foot);
  const double duration_s = motion.duration_s();
  gait.cycle_s = duration_s;
  gait.phase[foot] = motion.TimeOf(motion.lift->to_key) / duration_s;
  gait.duty_factor[foot] =
      1.0 - (motion.TimeOf(motion.lift->to_key) - motion.TimeOf(motion.lift->from_key)) / duration_s;
  return gait;
}

/// The part, the schedule, the footholds and the swing of a lift.
void AddContacts(const RobotModel& model, const PostureMotion& motion, MotionPlan& plan) {
  const int num_feet = static_cast<int>(model.feet.size());
  const double end_s = motion.duration_s();
  MotionPart part;
  part.gait = GaitOf(motion, num_feet);
  part.command.extent = WalkCommand::Extent::kDuration;
  part.command.duration_s = end_s;
  part.end_s = end_s;
  plan.parts = {part};
  plan.schedule.phases = {{0.0, end_s, AllFeet(num_feet)}};
  const std::vector<Pose> feet = StandingFeet(model);
  for (int f = 0; f < num_feet; ++f)
    plan.footsteps.footholds.push_back({f, feet[static_cast<std::size_t>(f)], Vector3::Zero(), 0, 0.0, end_s});
  if (!motion.lift) return;
  const FootLift& lift = *motion.lift;
  const double up_s = motion.TimeOf(lift.from_key), down_s = motion.TimeOf(lift.to_key);
  const FootSet others = AllFeet(num_feet) & ~FootBit(lift.foot);
  plan.schedule.phases = {{0.0, up_s, AllFeet(num_feet)}, {up_s, down_s, others}, {down_s, end_s, AllFeet(num_feet)}};
  Foothold& left = plan.footsteps.footholds[static_cast<std::size_t>(lift.foot)];
  Foothold again = left;
  left.liftoff_s = up_s;
  again.touchdown_s = down_s;
  plan.swings.push_back({lift.foot, up_s, down_s, left.X_WF, left.X_WF, lift.height_m});
  plan.swings.back().clearance_m = lift.height_m;
  plan.footsteps.footholds.push_back(again);
  SortFootholds(plan.footsteps);
}

/// The centre of mass by the keys; the ZMP is left out.
CentroidalTrajectory CentreOfMassOf(const RobotModel& model, const PostureMotion& motion, double height_m,
                                    double step_s) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  Vector3 standing = CentreOfMass(model, scratch);
  standing.z() = height_m;
  CentroidalTrajectory c;
  c.step_s = step_s;
  PostureSample sample;
  const long rows = std::lround(motion.duration_s() / step_s);
  double sum_m = 0.0;
  for (long k = 0; k <= rows; ++k) {
    SampleAt(motion, static_cast<double>(k) * step_s, sample);
    const auto& [x, y, z] = sample.shift;
    c.p_WC.push_back(standing + Vector3(x.value, y.value, z.value));
    c.v_WC.emplace_back(x.rate, y.rate, z.rate);
    c.a_WC.emplace_back(x.acceleration, y.acceleration, z.acceleration);
    sum_m += c.p_WC.back().z();
  }
  c.omega_rad_s = std::sqrt(kGravity * static_cast<double>(rows + 1) / sum_m);
  return c;
}

/// Solves a problem until spheres roll as they were taken to, and takes over what comes of it.
std::optional<Failure> Solve(const RobotModel& model, const WholeBodyProblem& problem, const WholeBodyOptions& options,
                             MotionPlan& plan) {
  constexpr int kPasses = 6;
  constexpr double kSettled = 1e-5;  // [m]
  std::vector<Foothold>& footholds = plan.footsteps.footholds;
  std::vector<Vector3> expected_roll(footholds.size(), Vector3::Zero());
  for (int pass = 0; pass < kPasses; ++pass) {
    Result<WholeBodySolution> solution = SolveWholeBody(model, problem, expected_roll, options);
    if (!solution) return solution.failure();
    double change = 0.0;
    for (std::size_t i = 0; i < footholds.size(); ++i) {
      change = std::max(change, (solution->roll_at_touchdown_W[i] - expected_roll[i]).norm());
      footholds[i].roll_W = solution->roll_at_liftoff_W[i] - solution->roll_at_touchdown_W[i];
    }
    expected_roll = solution->roll_at_touchdown_W;
    plan.whole_body = std::move(solution->trajectory);
    plan.centroidal.p_WZ = std::move(solution->zmp_W);
    if (change < kSettled) break;
  }
  return std::nullopt;
}

Provenance ProvenanceOf(const PostureMotion& motion, MotionOptions options) {
  Provenance provenance{Version(), "PlanPosture", {{"posture.name", motion.name}}, 0};
  for (const auto& [key, text] : motion.options) provenance.options.emplace_back("posture." + key, text);
  for (const auto& [key, text] : TextsOf(options.Fields())) provenance.options.emplace_back(key, text);
  return provenance;
}

}  // namespace

Result<MotionPlan> PlanPosture(const RobotModel& model, const PostureMotion& motion, const MotionOptions& options) {
  MotionOptions checked = options;
  CheckOptions(checked.Fields());
  CheckPostureMotion(model, motion);
  const double step_s = options.pipeline.grid_step_s;
  const PostureMotion on_grid = Stretched(motion, 1.0, step_s);
  if (!(on_grid.duration_s() >= step_s))
    throw InvalidArgument(fmt::format("posture motion '{}' lasts {} s", motion.name, motion.duration_s()));
  MotionPlan plan;
  plan.robot = model.name;
  plan.robot_hash = model.hash;
  plan.urdf_text = model.urdf_text;
  plan.yaml_text = model.yaml_text;
  plan.meshes = model.meshes;
  plan.terrain = FlatTerrain();
  plan.provenance = ProvenanceOf(motion, options);
  AddContacts(model, on_grid, plan);
  const double asked = options.pipeline.com_height_m;
  plan.centroidal = CentreOfMassOf(model, on_grid, asked > 0.0 ? asked : StandingHeight(model), step_s);
  PostureSample sample;
  WholeBodyProblem problem{&plan.terrain, &plan.schedule, &plan.footsteps, &plan.centroidal, &plan.swings, {}};
  problem.turning = [&](double time_s) {
    SampleAt(on_grid, time_s, sample);
    return TurningOf(sample.turn[2], sample.turn[1], sample.turn[0]);
  };
  problem.posture = [&](double time_s, PostureTarget& posture) {
    SampleAt(on_grid, time_s, sample);
    posture = {sample.q, sample.v, sample.a};
  };
  if (auto failure = Solve(model, problem, options.whole_body, plan)) return *failure;
  return plan;
}

Result<MotionPlan> WithGesture(const RobotModel& model, const MotionPlan& plan, const PostureMotion& gesture,
                               double from_s, const WholeBodyOptions& options) {
  CheckPostureMotion(model, gesture);
  const WholeBodyTrajectory& w = plan.whole_body;
  if (!(from_s >= w.start_s - kTime && from_s + gesture.duration_s() <= w.end_s() + kTime)) {
    throw InvalidArgument(fmt::format("gesture '{}' lasts from {} to {} s; the plan lasts from {} to {} s",
                                      gesture.name, from_s, from_s + gesture.duration_s(), w.start_s, w.end_s()));
  }
  MotionPlan moved = plan;
  const Matrix3 R_standing = BaseRotation(StandingConfiguration(model));
  PostureSample sample;
  WholeBodyProblem problem{&moved.terrain, &moved.schedule, &moved.footsteps, &moved.centroidal, &moved.swings, {}};
  problem.turning = [&](double time_s) {
    const auto row = static_cast<std::size_t>(std::lround((time_s - w.start_s) / w.step_s));
    return BaseTurning{BaseRotation(w.q[row]) * R_standing.transpose(), w.v[row].segment<3>(3),
                       w.a[row].segment<3>(3)};
  };
  problem.posture = [&](double time_s, PostureTarget& posture) {
    SampleAt(gesture, time_s - from_s, sample);
    posture = {sample.q, sample.v, sample.a};
  };
  if (auto failure = Solve(model, problem, options, moved)) return *failure;
  return moved;
}

}  // namespace gaitwright
