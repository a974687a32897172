// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/plan_posture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/version.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/ik/whole_body_ik.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/pipeline/robot_body.h"
#include "optimisation/whole_body/body_path.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/robot_of_plan.h"

namespace gaitwright {
namespace {

constexpr double kTime = 1e-9;  // [s]

/// The gait of standing still on all feet of legs, with a given name; lifted feet leave the ground for a while.
Gait GaitOf(const RobotModel& model, const PostureMotion& motion, const std::string& name, double start_s,
            double end_s) {
  Gait gait = StandingGait(static_cast<int>(model.legs.size()));
  gait.name = name;
  gait.description = "feet stay where they are";
  for (const FootLift& lift : motion.lifts) {
    const double up_s = motion.TimeOf(lift.from_key), down_s = motion.TimeOf(lift.to_key);
    if (up_s < start_s - kTime || down_s > end_s + kTime) continue;
    const auto foot = static_cast<std::size_t>(lift.foot);
    gait.cycle_s = end_s - start_s;
    gait.phase[foot] = (down_s - start_s) / gait.cycle_s;
    gait.duty_factor[foot] = 1.0 - (down_s - up_s) / gait.cycle_s;
  }
  return gait;
}

void AddParts(const RobotModel& model, const PostureMotion& motion, MotionPlan& plan) {
  std::vector<PostureSection> sections = motion.sections;
  if (sections.empty()) sections = {{motion.name, motion.keys.size() - 1}};
  double start_s = 0.0;
  for (const PostureSection& section : sections) {
    MotionPart part;
    part.start_s = start_s;
    part.end_s = start_s = motion.TimeOf(section.last_key);
    if (part.end_s - part.start_s < kTime) continue;
    part.gait = GaitOf(model, motion, section.name, part.start_s, part.end_s);
    part.command.extent = WalkCommand::Extent::kDuration;
    part.command.duration_s = part.end_s - part.start_s;
    plan.parts.push_back(part);
  }
}

/// Positions of the feet at the first key. Spherical feet have rolled with their legs since standing.
Result<std::vector<Pose>> FeetAtStart(const RobotModel& model, const PostureMotion& motion, double com_height_m) {
  DynamicsScratch scratch(model);
  VectorX q = StandingConfiguration(model);
  ForwardKinematics(model, q, scratch);
  const PostureKey& key = motion.keys.front();
  BodyTarget target;
  target.p_WC << CentreOfMass(model, scratch).head<2>(), com_height_m;
  target.p_WC += key.shift;
  target.R_WB = Eigen::AngleAxisd(key.turn_rad.z(), Vector3::UnitZ()) *
                Eigen::AngleAxisd(key.turn_rad.y(), Vector3::UnitY()) *
                Eigen::AngleAxisd(key.turn_rad.x(), Vector3::UnitX()) * BaseRotation(q);
  target.posture = {key.joints, VectorX::Zero(model.num_dofs()), VectorX::Zero(model.num_dofs())};
  for (std::size_t f = 0; f < model.legs.size(); ++f) {
    FootTarget foot;
    const Pose X_WF = FramePose(scratch, model.feet[f].body, model.feet[f].X_BF);
    foot.p_WF = X_WF.translation();
    foot.R_WF = foot.R_anchor = X_WF.linear();
    target.feet.push_back(foot);
  }
  WholeBodyIk ik(model);
  const Result<int> solved = ik.SolvePosition(target, q);
  if (!solved) return solved.failure();
  std::vector<Pose> feet = StandingFeet(model);
  for (std::size_t f = 0; f < model.legs.size(); ++f) {
    const Vector3 moved = ik.FootPose(static_cast<int>(f)).translation() - target.feet[f].p_WF;
    if (model.feet[f].radius > 0.0) feet[f].translation().head<2>() += moved.head<2>();
  }
  return feet;
}

/// Adds the schedule, the footholds and the swings of lifted feet.
void AddContacts(const RobotModel& model, const PostureMotion& motion, const std::vector<Pose>& feet,
                 MotionPlan& plan) {
  const double end_s = motion.duration_s();
  std::vector<std::vector<ContactInterval>> stays(model.feet.size());
  for (std::size_t f = 0; f < model.legs.size(); ++f) {
    double since_s = 0.0;
    for (const FootLift& lift : motion.lifts) {
      if (lift.foot != static_cast<int>(f)) continue;
      const double up_s = motion.TimeOf(lift.from_key), down_s = motion.TimeOf(lift.to_key);
      stays[f].push_back({since_s, up_s});
      plan.swings.push_back({lift.foot, up_s, down_s, feet[f], feet[f], lift.height_m});
      plan.swings.back().clearance_m = lift.height_m;
      since_s = down_s;
    }
    stays[f].push_back({since_s, end_s});
  }
  for (const RestStay& stay : motion.rests)
    stays[static_cast<std::size_t>(stay.rest)].push_back({motion.TimeOf(stay.from_key), motion.TimeOf(stay.to_key)});
  plan.schedule = ScheduleFromIntervals(stays, 0.0, end_s);
  for (std::size_t f = 0; f < stays.size(); ++f) {
    for (const ContactInterval& stay : stays[f])
      plan.footsteps.footholds.push_back({static_cast<int>(f), feet[f], Vector3::Zero(), 0, stay.start_s, stay.end_s});
  }
  SortFootholds(plan.footsteps);
}

/// Motion of the centre of mass from the keys; the ZMP is left out.
CentroidalTrajectory CentreOfMassOf(const RobotModel& model, const PostureMotion& motion, double height_m,
                                    double step_s) {
  Vector3 standing = StandingCentreOfMass(model);
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

/// Solves a problem repeatedly until the rolling of spherical feet has converged, and stores the result.
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

/// Puts the footholds of support links where the body's motion puts the links.
void PlaceRests(const RobotModel& model, MotionPlan& plan) {
  DynamicsScratch scratch(model);
  const WholeBodyTrajectory& w = plan.whole_body;
  for (Foothold& foothold : plan.footsteps.footholds) {
    if (foothold.foot < static_cast<int>(model.legs.size())) continue;
    ForwardKinematics(model, w.q[static_cast<std::size_t>(std::lround(foothold.touchdown_s / w.step_s))], scratch);
    const Pose X_WF = ContactFrame(model, scratch, foothold.foot);
    foothold.X_WF.linear() = YawRotation(YawOf(X_WF.linear()));
    foothold.X_WF.translation() << X_WF.translation().head<2>(), 0.0;
  }
}

/// Sets the base's final pose of each part: the body may move over fixed feet.
void SetGoals(MotionPlan& plan) {
  constexpr double kSame = 1e-3;  // [m]
  const WholeBodyTrajectory& w = plan.whole_body;
  PlanarPose from = BaseInPlan(w.q.front());
  for (MotionPart& part : plan.parts) {
    part.goal = BaseInPlan(w.q[static_cast<std::size_t>(std::lround(part.end_s / w.step_s))]);
    const Pose X_AB = PoseOf(from).inverse() * PoseOf(part.goal);
    if (X_AB.translation().norm() > kSame) {
      part.command.extent = WalkCommand::Extent::kGoal;
      part.command.duration_s = 0.0;
      part.command.goal_x_m = X_AB.translation().x();
      part.command.goal_y_m = X_AB.translation().y();
      part.command.goal_yaw_rad = YawOf(X_AB.linear());
    }
    from = part.goal;
  }
  plan.goal = from;
}

/// Adds a gate at the end of each section that waits: all feet of legs must carry force.
void AddGates(const RobotModel& model, const PostureMotion& motion, MotionPlan& plan) {
  for (const PostureSection& section : motion.sections) {
    if (!section.waits) continue;
    PlanGate gate;
    gate.at_s = motion.TimeOf(section.last_key);
    gate.phase = section.name;
    gate.contact = AllFeet(static_cast<int>(model.legs.size()));
    plan.gates.push_back(gate);
  }
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
    throw InvalidArgument(fmt::format("posture motion '{}' lasts {} s; at least one time step, {} s, is needed",
                                      motion.name, motion.duration_s(), step_s));
  MotionPlan plan;
  SetRobot(model, plan);
  plan.terrain = FlatTerrain();
  plan.provenance = ProvenanceOf(motion, options);
  AddParts(model, on_grid, plan);
  const double asked = options.pipeline.com_height_m, height_m = asked > 0.0 ? asked : StandingCentreOfMass(model).z();
  const Result<std::vector<Pose>> feet = FeetAtStart(model, on_grid, height_m);
  if (!feet) return feet.failure();
  AddContacts(model, on_grid, *feet, plan);
  plan.centroidal = CentreOfMassOf(model, on_grid, height_m, step_s);
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
  PlaceRests(model, plan);
  SetGoals(plan);
  AddGates(model, on_grid, plan);
  return plan;
}

Result<MotionPlan> WithGesture(const RobotModel& model, const MotionPlan& plan, const PostureMotion& gesture,
                               double from_s, const WholeBodyOptions& options) {
  CheckPostureMotion(model, gesture);
  const WholeBodyTrajectory& w = plan.whole_body;
  if (!(from_s >= w.start_s - kTime && from_s + gesture.duration_s() <= w.end_s() + kTime)) {
    throw InvalidArgument(fmt::format("gesture '{}' lasts from {} to {} s; it must lie within the plan, {} to {} s",
                                      gesture.name, from_s, from_s + gesture.duration_s(), w.start_s, w.end_s()));
  }
  MotionPlan moved = plan;
  const Matrix3 R_standing = BaseRotation(StandingConfiguration(model));
  PostureSample sample;
  WholeBodyProblem problem{&moved.terrain, &moved.schedule, &moved.footsteps, &moved.centroidal, &moved.swings, {}};
  problem.turning = [&](double time_s) {
    const auto row = static_cast<std::size_t>(std::lround((time_s - w.start_s) / w.step_s));
    return BaseTurning{BaseRotation(w.q[row]) * R_standing.transpose(), w.v[row].segment<3>(3), w.a[row].segment<3>(3)};
  };
  problem.posture = [&](double time_s, PostureTarget& posture) {
    SampleAt(gesture, time_s - from_s, sample);
    posture = {sample.q, sample.v, sample.a};
  };
  if (auto failure = Solve(model, problem, options, moved)) return *failure;
  return moved;
}

}  // namespace gaitwright
