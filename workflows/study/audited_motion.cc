// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/audited_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planning/audit/audit.h"
#include "planning/plan/sample_plan.h"
#include "workflows/study/rigid_body_plan.h"
#include "workflows/study/rigid_body_robot.h"

namespace gaitwright {
namespace {

/// The stances of a foot of the problem between which it is in the air at a time.
std::optional<RigidSwing> SwingAt(const RigidBodyProblem& problem, int foot, double time_s) {
  std::optional<std::size_t> from;
  for (std::size_t i = 0; i < problem.stances.size(); ++i) {
    if (problem.stances[i].foot != foot) continue;
    if (problem.stances[i].start_s > time_s) return from ? std::optional(RigidSwing{*from, i}) : std::nullopt;
    from = i;
  }
  return std::nullopt;
}

/// One round after another.
class Refiner {
 public:
  Refiner(const Terrain& ground, RigidBodyOptions options, AuditedMotion& motion)
      : ground_(ground), options_(std::move(options)), motion_(motion) {}

  std::optional<Failure> Judge() {
    const Result<RobotModel> robot = RigidBodyRobot(motion_.problem, "rigid-body");
    if (!robot) return robot.failure();
    const Result<MotionPlan> plan = RigidBodyMotionPlan(*robot, ground_, motion_.problem, motion_.plan.motion);
    if (!plan) return plan.failure();
    const Result<AuditReport> report = Audit(*robot, *plan, {});
    if (!report) return report.failure();
    motion_.report = *report;
    FindStrays(*robot, *plan);
    return std::nullopt;
  }

  /// @return false where there is no other motion.
  bool PlanAnew() {
    RigidBodyProblem problem = motion_.problem;
    Result<RigidBodyPlan> plan = Failure{};
    // In turn: where swings that are held still stray, nodes that are too far apart may be why.
    constexpr int kMostHalvings = 3;
    held_last_ = !strays_.empty() && (!held_last_ || motion_.halvings == kMostHalvings);
    if (held_last_) {
      ++motion_.swings_held;
      Hold(problem);
      plan = PlanRigidBodyFrom(problem, options_, motion_.plan.numbers);
    } else {
      if (motion_.halvings == kMostHalvings) {
        motion_.refusal = "breaks half as far apart once more would not help";
        return false;
      }
      ++motion_.halvings;
      options_.spacing_s *= 0.5;
      options_.least_intervals *= 2;
    }
    if (!plan) plan = PlanRigidBody(problem, options_);
    if (!plan) {
      motion_.refusal = plan.failure().message;
      return false;
    }
    motion_.problem = std::move(problem);
    motion_.plan = std::move(*plan);
    return true;
  }

 private:
  /// Notes the swings that go out of reach.
  void FindStrays(const RobotModel& robot, const MotionPlan& plan) {
    strays_.clear();
    for (const SwingTrajectory& swing : plan.swings) {
      const double out_m = OutOfLimits(robot, plan, swing);
      if (!(out_m > 0.0)) continue;
      const int foot = std::stoi(robot.feet[static_cast<std::size_t>(swing.foot)].link.substr(5));
      std::optional<RigidSwing> stray = SwingAt(motion_.problem, foot, 0.5 * (swing.start_s + swing.end_s));
      if (!stray) continue;
      stray->lift_m = swing.lift_m;
      stray->cruise = swing.cruise;
      stray->detour_W = swing.detour_W;
      strays_.push_back(*stray);
    }
  }

  /// How far the slides of a foot are beyond their limits in a swing.
  static double OutOfLimits(const RobotModel& robot, const MotionPlan& plan, const SwingTrajectory& swing) {
    const WholeBodyTrajectory& rows = plan.whole_body;
    const std::vector<int>& joints = robot.legs[static_cast<std::size_t>(swing.foot)].joints;
    double out = 0.0;
    for (int k = 0; k < rows.size(); ++k) {
      const double time_s = rows.start_s + k * rows.step_s;
      if (time_s < swing.start_s || time_s > swing.end_s) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const Joint& joint = robot.joints[static_cast<std::size_t>(joints[i])];
        const double q = rows.q[static_cast<std::size_t>(k)][7 + joint.dof];
        out = std::max({out, q - joint.upper, joint.lower - q});
      }
    }
    return out;
  }

  void Hold(RigidBodyProblem& problem) const {
    for (const RigidSwing& stray : strays_) {
      const auto same = [&](const RigidSwing& swing) { return swing.from == stray.from && swing.to == stray.to; };
      std::erase_if(problem.swings, same);
      problem.swings.push_back(stray);
    }
  }

  const Terrain& ground_;
  RigidBodyOptions options_;
  AuditedMotion& motion_;
  std::vector<RigidSwing> strays_;
  bool held_last_ = false;
};

}  // namespace

Result<AuditedMotion> RefineByAudit(const Terrain& ground, const RigidBodyProblem& problem, RigidBodyOptions options,
                                    const RigidBodyPlan& plan, int most_rounds) {
  AuditedMotion motion{problem, plan, {}, {}, "", 0, 0};
  Refiner refiner(ground, std::move(options), motion);
  for (int round = 0;; ++round) {
    if (const auto failure = refiner.Judge()) return *failure;
    if (round == 0) motion.first = motion.report;
    if (motion.report.pass() || round == most_rounds) break;
    if (!refiner.PlanAnew()) break;
  }
  return motion;
}

}  // namespace gaitwright
