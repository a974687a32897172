// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/approach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "kinematics/base/version.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/dof_units.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/zero_moment_point.h"
#include "planning/audit/audit.h"
#include "planning/audit/motor_effort.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/robot_of_plan.h"
#include "planning/tasks/free_path.h"

namespace gaitwright {
namespace {

constexpr char kApproachStage[] = "PlanApproach";

Failure Infeasible(FailureCode code, const std::string& message, const std::vector<Suggestion>& suggestions = {}) {
  return {FailureKind::kInfeasible, code, kApproachStage, message, suggestions};
}

/// A move of all joints from rest to rest.
struct Move {
  VectorX from, to;
  double duration_s = 0.0;
};

/// q with the joints at zero and the base hanging over the start of the plan, with the plan's heading.
VectorX HangingBase(const RobotModel& model, const MotionPlan& plan, const StartPosture& start) {
  VectorX q = VectorX::Zero(model.nq());
  q.head<2>() = plan.whole_body.q.front().head<2>();
  q[2] = model.standing_base_height_m + model.leg_length_m();
  const double yaw = YawOf(BaseRotation(plan.whole_body.q.front()));
  Quaternion R_WB(Eigen::AngleAxisd(yaw, Vector3::UnitZ()));
  if (start.R_WB) {
    const double measured = YawOf(start.R_WB->toRotationMatrix());
    R_WB = (Quaternion(Eigen::AngleAxisd(yaw - measured, Vector3::UnitZ())) * *start.R_WB).normalized();
  }
  q.segment<4>(3) = R_WB.coeffs();
  return q;
}

std::string PairText(const Overlap& pair) {
  return fmt::format("'{}' and '{}' collide, {:.1f} mm deep", pair.link_a, pair.link_b, 1e3 * pair.depth_m);
}

/// Postures of a collision-free motion, including both ends; a failure if none is found.
Result<std::vector<VectorX>> FreePath(const RobotModel& model, PathCheck& check, const VectorX& from,
                                      const VectorX& to) {
  const auto blocked = [&](const char* posture, const Overlap& pair) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kSelfCollision,
                   kApproachStage,
                   fmt::format("in the {} posture {}", posture, PairText(pair)),
                   {}};
  };
  if (const auto pair = check.MeetingAt(from)) return blocked("measured", *pair);
  if (const auto pair = check.MeetingAt(to)) return blocked("plan's first", *pair);
  const auto straight = check.FirstMeeting(from, to);
  if (!straight) return std::vector<VectorX>{from, to};
  const VectorX& standing = model.standing_joints;
  auto bent = check.FirstMeeting(from, standing);
  if (!bent) bent = check.FirstMeeting(standing, to);
  if (!bent) return std::vector<VectorX>{from, standing, to};
  return Infeasible(FailureCode::kSelfCollision,
                    fmt::format("no collision-free motion to the plan's first posture: on the direct motion, {}; on "
                                "the motion via the standing posture, {}",
                                PairText(*straight), PairText(*bent)),
                    {"move the joints by hand to near the standing posture and measure again"});
}

/// Shares of the limits that the approach may use.
struct Shares {
  Shares(const ApproachOptions& options, const AuditOptions& audit)
      : speed(std::min(options.speed_share, audit.derate_speed)),
        acceleration(std::min(options.limit_share, audit.derate_acceleration)),
        jerk(std::min(options.limit_share, audit.derate_jerk)),
        torque(std::min(options.limit_share, audit.derate_torque)) {}

  double speed, acceleration, jerk, torque;
};

/// Duration of a move within the limits of speed, acceleration and jerk.
double TimeOf(const RobotModel& model, const ApproachOptions& options, const Shares& shares, const VectorX& from,
              const VectorX& to) {
  constexpr double kSpeed = 1.875, kAcceleration = 5.7735026918962582, kJerk = 60.0;
  double time_s = options.least_s;
  for (int d = 0; d < model.num_dofs(); ++d) {
    const double distance = std::abs(to[d] - from[d]);
    const Motor& motor = model.MotorOf(d);
    const Actuator actuator = ActuatorOf(model, d);
    const double most = Slides(model, d) ? options.speed_m_s : options.speed_rad_s;
    time_s = std::max({time_s, kSpeed * distance / most,
                       kSpeed * std::abs(actuator.Speed(to - from)) / (shares.speed * actuator.velocity_limit),
                       std::sqrt(kAcceleration * distance / (shares.acceleration * motor.acceleration_limit)),
                       std::cbrt(kJerk * distance / (shares.jerk * motor.jerk_limit))});
  }
  return time_s;
}

void AddRow(const Move& move, double time_s, const VectorX& q_base, MotionPlan& plan) {
  const double u = time_s / move.duration_s, T = move.duration_s;
  const double s = u * u * u * (10.0 + u * (-15.0 + 6.0 * u)), ds = 30.0 * u * u * (1.0 + u * (-2.0 + u)) / T;
  const double dds = 60.0 * u * (1.0 + u * (-3.0 + 2.0 * u)) / (T * T);
  const VectorX change = move.to - move.from;
  const Eigen::Index n = change.size();
  VectorX q = q_base, v = VectorX::Zero(6 + n), a = v;
  q.tail(n) = move.from + s * change;
  v.tail(n) = ds * change;
  a.tail(n) = dds * change;
  plan.whole_body.q.push_back(q);
  plan.whole_body.v.push_back(v);
  plan.whole_body.a.push_back(a);
}

/// Fills in the rows of joints, torques and centre of mass for consecutive moves.
void FillRows(const RobotModel& model, const std::vector<Move>& moves, const VectorX& q_base, MotionPlan& plan) {
  WholeBodyTrajectory& w = plan.whole_body;
  CentroidalTrajectory& c = plan.centroidal;
  c = {};
  w.q.clear(), w.v.clear(), w.a.clear(), w.tau.clear(), w.wrenches.clear();
  c.step_s = w.step_s;
  for (const Move& move : moves) {
    const long rows = std::lround(move.duration_s / w.step_s);
    for (long k = w.q.empty() ? 0 : 1; k <= rows; ++k) AddRow(move, static_cast<double>(k) * w.step_s, q_base, plan);
  }
  DynamicsScratch scratch(model);
  VectorX needed;
  double height = 0.0;
  for (std::size_t k = 0; k < w.q.size(); ++k) {
    InverseDynamics(model, w.q[k], w.v[k], w.a[k], scratch, needed);
    w.tau.push_back(needed.tail(model.num_dofs()));
    w.wrenches.emplace_back(model.feet.size());
    c.p_WC.push_back(CentreOfMass(model, scratch));
    c.v_WC.push_back(CentroidalMomentum(model, scratch).head<3>() / model.total_mass_kg);
    c.a_WC.push_back(needed.head<3>() / model.total_mass_kg - kGravity * Vector3::UnitZ());
    c.p_WZ.push_back(ZeroMomentPoint(scratch.p_WB[0], needed.head<3>(), needed.segment<3>(3), 0.0));
    height += c.p_WC.back().z();
  }
  c.omega_rad_s = std::sqrt(kGravity * static_cast<double>(w.q.size()) / height);
}

/// A motor that needs more than its share of effort, and whether it needs that at rest too.
struct Overload {
  int motor = 0;
  double effort = 0.0, limit = 0.0;
  bool at_rest = false;
};

std::optional<Overload> FindOverload(const RobotModel& model, double share, const MotionPlan& plan) {
  const MotorEffort motors(model);
  const WholeBodyTrajectory& w = plan.whole_body;
  const VectorX still = VectorX::Zero(model.nv());
  DynamicsScratch scratch(model);
  VectorX holding;
  std::optional<Overload> worst;
  for (std::size_t k = 0; k < w.q.size(); ++k) {
    InverseDynamics(model, w.q[k], still, still, scratch, holding);
    const Eigen::Index n = model.num_dofs();
    for (int d = 0; d < model.num_dofs(); ++d) {
      const Actuator& actuator = motors.motors()[static_cast<std::size_t>(d)];
      const double limit = share * actuator.effort_limit;
      const double moving = std::abs(motors.Of(d, w.tau[k], w.v[k].tail(n), w.a[k].tail(n)));
      const double resting = std::abs(actuator.Effort(holding.tail(n)));
      if (resting > limit) return Overload{d, resting, limit, true};
      if (moving > limit && (!worst || moving / limit > worst->effort / worst->limit))
        worst = Overload{d, moving, limit, false};
    }
  }
  return worst;
}

MotionPlan EmptyPlan(const RobotModel& model, double step_s, ApproachOptions options, AuditOptions reserve) {
  MotionPlan plan;
  SetRobot(model, plan);
  plan.provenance = {Version(), kApproachStage, {{"approach.base", "hanging"}}, 0};
  OptionTexts& shaped = plan.provenance.options;
  for (const auto& [key, text] : TextsOf(options.Fields())) shaped.emplace_back("approach." + key, text);
  for (const auto& [key, text] : TextsOf(reserve.Fields()))
    if (key.starts_with("derate_")) shaped.emplace_back("audit." + key, text);
  plan.terrain = FlatTerrain();
  plan.whole_body.step_s = step_s;
  plan.warnings = {fmt::format(
      "robot '{}' hangs: its base is assumed to be held in the air, and its feet to touch nothing", model.name)};
  return plan;
}

void Close(const RobotModel& model, const VectorX& q_base, MotionPlan& plan) {
  const double end_s = plan.whole_body.end_s();
  MotionPart part;
  part.gait = HangingGait(static_cast<int>(model.feet.size()));
  part.command.extent = WalkCommand::Extent::kDuration;
  part.command.duration_s = end_s;
  part.goal = BaseInPlan(q_base);
  part.end_s = end_s;
  plan.parts = {part};
  plan.goal = part.goal;
  plan.schedule.phases = {{0.0, end_s, 0}};
}

/// Failure if an approach of this duration is too long.
std::optional<Failure> TooLong(double time_s, double step_s) {
  const std::vector<Suggestion> suggestions = {
      "move the joints by hand closer to the plan's first posture and measure again",
      "allow more speed: --set approach.speed_rad_s= and approach.speed_share="};
  if (!(time_s <= kLongestApproach)) {
    return Infeasible(
        FailureCode::kTooLong,
        fmt::format("the motion to the plan's first posture takes {:.4g} s; at most {:.0f} s are accepted", time_s,
                    kLongestApproach),
        suggestions);
  }
  if (time_s / step_s <= kMostApproachRows) return std::nullopt;
  return Infeasible(FailureCode::kTooLong,
                    fmt::format("the motion to the plan's first posture takes {:.4g} s, or {:.4g} rows at the plan's "
                                "time step of {:.4g} s; at most {:.0f} rows are accepted",
                                time_s, time_s / step_s, step_s, kMostApproachRows),
                    suggestions);
}

double TimeOf(const std::vector<Move>& moves) {
  double time_s = 0.0;
  for (const Move& move : moves) time_s += move.duration_s;
  return time_s;
}

/// Slows the moves down until no motor is overloaded. Failure that names the motor if it is overloaded at any speed.
std::optional<Failure> SlowDown(const RobotModel& model, double torque_share, std::vector<Move>& moves,
                                const VectorX& q_base, MotionPlan& plan) {
  constexpr int kMostTries = 20;
  constexpr double kSlower = 1.3;
  for (int tries = 0;; ++tries) {
    if (auto failure = TooLong(TimeOf(moves), plan.whole_body.step_s)) return failure;
    FillRows(model, moves, q_base, plan);
    const auto over = FindOverload(model, torque_share, plan);
    if (!over) return std::nullopt;
    if (over->at_rest || tries == kMostTries) {
      const Actuator motor = ActuatorOf(model, over->motor);
      return Infeasible(
          FailureCode::kTorque,
          fmt::format("{} '{}' needs {:.4g} {} {} on the motion to the plan's first posture, with the "
                      "base held in the air; at most {:.4g} {} is accepted, its share of the limit",
                      motor.shared() ? "motor" : "joint", motor.name, over->effort, motor.effort_unit(),
                      over->at_rest ? "only to hold" : "even at low speed", over->limit, motor.effort_unit()));
    }
    for (Move& move : moves)
      move.duration_s = std::ceil(kSlower * move.duration_s / plan.whole_body.step_s) * plan.whole_body.step_s;
  }
}

/// Failure if the plan or the start posture does not fit the robot.
std::optional<Failure> Misfit(const RobotModel& model, const MotionPlan& plan, const StartPosture& from) {
  const auto bad = [](const std::string& message) {
    return Failure{FailureKind::kBadInput, FailureCode::kMisfit, kApproachStage, message, {}};
  };
  if (plan.whole_body.q.empty() || plan.whole_body.q.front().size() != model.nq() || !(plan.whole_body.step_s > 0.0) ||
      from.joints.size() != model.num_dofs())
    return bad(fmt::format("the plan or the start posture does not belong to robot '{}'", model.name));
  for (int d = 0; d < model.num_dofs(); ++d) {
    if (std::abs(from.joints[d]) <= kFarthestMeasured) continue;
    return bad(fmt::format("joint '{}' is measured at {}; accepted: -{} to {}",
                           model.dof_names[static_cast<std::size_t>(d)], from.joints[d], kFarthestMeasured,
                           kFarthestMeasured));
  }
  return std::nullopt;
}

/// Failure of the audit check that the motion violates. The start posture of the plan is not checked.
std::optional<Failure> WhatForbids(const RobotModel& model, const MotionPlan& motion, AuditOptions reserve) {
  reserve.start.reset();
  reserve.margins = false;
  const Result<AuditReport> audit = Audit(model, motion, reserve);
  if (!audit) return audit.failure();
  if (audit->pass()) return std::nullopt;
  const Violation& worst = audit->violations.front();
  Failure failure = Infeasible(
      FailureCodeOf(worst.law),
      fmt::format("the motion to the plan's first posture fails the check '{}': {}, {} at {:.2f} s (limit {:.4g})",
                  LawName(worst.law), worst.where, AuditFigure(worst.value, worst.unit), worst.at_s, worst.limit));
  failure.violation = worst;
  return failure;
}

}  // namespace

bool NeedsApproach(const RobotModel& model, const MotionPlan& plan, const StartPosture& from,
                   const AuditOptions& audit) {
  if (Misfit(model, plan, from)) return true;
  const VectorX off = (plan.whole_body.q.front().tail(model.num_dofs()) - from.joints).cwiseAbs();
  for (int d = 0; d < model.num_dofs(); ++d) {
    if (off[d] > (Slides(model, d) ? audit.start_tolerance_m : audit.start_tolerance_rad)) return true;
  }
  return false;
}

Result<Approach> PlanApproach(const RobotModel& model, const MotionPlan& plan, const StartPosture& from,
                              const ApproachOptions& given, const AuditOptions& kept) {
  ApproachOptions options = given;
  AuditOptions reserve = kept;
  CheckOptions(options.Fields());
  CheckOptions(reserve.Fields());
  if (auto failure = Misfit(model, plan, from)) return *failure;
  const Shares shares(options, reserve);
  const VectorX to = plan.whole_body.q.front().tail(model.num_dofs());
  const double step = plan.whole_body.step_s;
  if (auto failure = TooLong(TimeOf(model, options, shares, from.joints, to), step)) return *failure;
  const VectorX q_base = HangingBase(model, plan, from);
  PathCheck check(model, q_base);
  const Result<std::vector<VectorX>> path = FreePath(model, check, from.joints, to);
  if (!path) return path.failure();
  Approach approach;
  approach.via_standing = path->size() > 2;
  approach.plan = EmptyPlan(model, plan.whole_body.step_s, options, reserve);
  std::vector<Move> moves;
  for (std::size_t i = 0; i + 1 < path->size(); ++i) {
    const double time_s = TimeOf(model, options, shares, (*path)[i], (*path)[i + 1]);
    moves.push_back({(*path)[i], (*path)[i + 1], std::max(2.0, std::ceil(time_s / step - 1e-9)) * step});
  }
  if (const auto failure = SlowDown(model, shares.torque, moves, q_base, approach.plan)) return *failure;
  Close(model, q_base, approach.plan);
  int farthest = 0;
  approach.farthest_by = (to - from.joints).cwiseAbs().maxCoeff(&farthest);
  approach.farthest = model.dof_names[static_cast<std::size_t>(farthest)];
  if (const auto failure = WhatForbids(model, approach.plan, reserve)) return *failure;
  return approach;
}

}  // namespace gaitwright
