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

/// Of a swing: nearer to each other at its ends, where the foot is slow and the body goes on.
std::vector<double> SharesLookedAt() {
  constexpr int kEven = 16;
  std::vector<double> shares = {0.25 / kEven, 0.5 / kEven, 0.75 / kEven};
  for (int i = 1; i < kEven; ++i) shares.push_back(static_cast<double>(i) / kEven);
  for (const double before : {0.75, 0.5, 0.25}) shares.push_back(1.0 - before / kEven);
  return shares;
}

/// The places of a planned swing. One that goes over something is there over it wherever its footholds are: at its
/// crest, where it is farthest off the straight way, it does not move with them.
std::vector<SwingPlace> PlacesOf(const SwingTrajectory& swing) {
  const std::vector<double> shares = SharesLookedAt();
  const SwingCurve curve = CurveOf(swing);
  SwingCurve straight = curve;
  straight.lift_m = 0.0;
  straight.detour_W.clear();
  const Vector3 &start = swing.X_WF_start.translation(), &end = swing.X_WF_end.translation();
  const auto at = [&](const SwingCurve& of, double share) {
    return Vector3(Evaluate(of, swing.start_s + share * (swing.end_s - swing.start_s)).X_WF.translation());
  };
  double crest = 0.5, farthest_m = 0.0;
  for (const double share : shares) {
    const double off_m = (at(curve, share) - at(straight, share)).norm();
    if (off_m > farthest_m) crest = share;
    farthest_m = std::max(farthest_m, off_m);
  }
  std::vector<SwingPlace> places;
  for (const double share : shares) {
    const double gone = SmoothStep(share, swing.cruise).value;
    SwingPlace place{share, 1.0 - gone, gone};
    if (!swing.detour_W.empty()) {
      place.from = 1.0 - SmoothStep(share / crest).value;
      place.to = SmoothStep((share - crest) / (1.0 - crest)).value;
    }
    place.p_W = at(curve, share) - place.from * start - place.to * end;
    places.push_back(place);
  }
  return places;
}

/// A problem with where its plan stands.
struct Attempt {
  RigidBodyProblem problem;
  RigidBodyPlan plan;
  bool keeps_laws = true;
};

/// One round after another.
class Refiner {
 public:
  Refiner(const Terrain& ground, RigidBodyOptions options, AuditedMotion& motion)
      : ground_(ground), options_(std::move(options)), motion_(motion), attempt_{motion.problem, motion.plan} {}

  /// Has the attempt audited where it keeps its laws. @return why that cannot be.
  std::optional<Failure> Judge() {
    const Result<RobotModel> robot = RigidBodyRobot(attempt_.problem, "rigid-body");
    if (!robot) return robot.failure();
    const Result<MotionPlan> plan = RigidBodyMotionPlan(*robot, ground_, attempt_.problem, attempt_.plan.motion);
    if (!plan && !attempt_.keeps_laws) {  // not even swings: nothing to learn from it
      stray_m_ = 0.0;
      return std::nullopt;
    }
    if (!plan) return plan.failure();
    FindStrays(*robot, *plan);
    if (!attempt_.keeps_laws) return std::nullopt;
    const Result<AuditReport> report = Audit(*robot, *plan, {});
    if (!report) return report.failure();
    motion_.report = *report;
    motion_.problem = attempt_.problem;
    motion_.plan = attempt_.plan;
    return std::nullopt;
  }

  bool Passes() const { return attempt_.keeps_laws && motion_.report.pass(); }

  /// @return false where there is nothing else to try.
  bool PlanAnew() {
    // Nodes that are too far apart are mended first, since that costs least, and again where swings that are held stray
    // no less than before. Footholds of an attempt that does not keep its laws are nearer to where they should be, and
    // swings between these are held next.
    constexpr int kMostHalvings = 2, kMostUnmet = 3;
    constexpr double kProgress = 0.7;
    unmet_ = attempt_.keeps_laws ? 0 : unmet_ + 1;
    const bool stuck =
        unmet_ == 0 && motion_.swings_held > 0 && !halved_last_ && stray_m_ > kProgress * former_stray_m_;
    const bool halve = stray_m_ <= 0.0 || unmet_ > kMostUnmet || stuck || motion_.halvings == 0;
    halved_last_ = halve && motion_.halvings < kMostHalvings;
    former_stray_m_ = stray_m_;
    if (halved_last_) {
      if (!attempt_.keeps_laws) attempt_ = {motion_.problem, motion_.plan};
      ++motion_.halvings;
      options_.spacing_s *= 0.5;
      options_.least_intervals *= 2;
      Solve(false);
      return true;
    }
    if (stray_m_ <= 0.0 || unmet_ > kMostUnmet) {
      if (motion_.refusal.empty()) motion_.refusal = "breaks half as far apart once more would not help";
      return false;
    }
    constexpr double kMargin = 4e-3;  // [m] so that swings planned anew between other footholds stay within too
    options_.reach_margin_m = std::max(options_.reach_margin_m, kMargin);
    ++motion_.swings_held;
    attempt_.problem.swings = swings_;
    Solve(true);
    return true;
  }

 private:
  /// From the numbers of the attempt where that is asked for, else or where that fails anew; the one that is violated
  /// less stays.
  void Solve(bool from_numbers) {
    RigidBodyPlan last, anew;
    Result<RigidBodyPlan> plan = Failure{};
    if (from_numbers) plan = PlanRigidBodyFrom(attempt_.problem, options_, attempt_.plan.numbers, &last);
    if (!plan) plan = PlanRigidBody(attempt_.problem, options_, &anew);
    attempt_.keeps_laws = plan.ok();
    motion_.refusal = plan.ok() ? "" : plan.failure().message;
    if (plan.ok()) {
      attempt_.plan = std::move(*plan);
    } else {
      const bool is_last = from_numbers && last.summary.violations < anew.summary.violations;
      attempt_.plan = std::move(is_last ? last : anew);
    }
  }

  /// Takes note of the swings, and how far the worst of them is out of reach. All are held where one is, for what
  /// brings that one back takes others out.
  void FindStrays(const RobotModel& robot, const MotionPlan& plan) {
    swings_.clear();
    stray_m_ = 0.0;
    for (const SwingTrajectory& swing : plan.swings) {
      const int foot = std::stoi(robot.feet[static_cast<std::size_t>(swing.foot)].link.substr(5));
      std::optional<RigidSwing> held = SwingAt(attempt_.problem, foot, 0.5 * (swing.start_s + swing.end_s));
      if (!held) continue;
      held->places = PlacesOf(swing);
      swings_.push_back(*held);
      stray_m_ = std::max(stray_m_, OutOfLimits(robot, plan, swing));
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

  const Terrain& ground_;
  RigidBodyOptions options_;
  AuditedMotion& motion_;
  Attempt attempt_;
  std::vector<RigidSwing> swings_;  // of the attempt
  double stray_m_ = 0.0, former_stray_m_ = 0.0;
  bool halved_last_ = false;
  int unmet_ = 0;  // attempts in a row that do not keep their laws
};

}  // namespace

Result<AuditedMotion> RefineByAudit(const Terrain& ground, const RigidBodyProblem& problem, RigidBodyOptions options,
                                    const RigidBodyPlan& plan, int most_rounds) {
  AuditedMotion motion{problem, plan, {}, {}, "", 0, 0};
  Refiner refiner(ground, std::move(options), motion);
  for (int round = 0;; ++round) {
    if (const auto failure = refiner.Judge()) return *failure;
    if (round == 0) motion.first = motion.report;
    if (refiner.Passes() || round == most_rounds) break;
    if (!refiner.PlanAnew()) break;
  }
  return motion;
}

}  // namespace gaitwright
