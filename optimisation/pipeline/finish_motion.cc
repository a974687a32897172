// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/spatial/rotation.h"
#include "optimisation/pipeline/apart_pairs_internal.h"
#include "optimisation/pipeline/choose_contacts_internal.h"
#include "optimisation/pipeline/cool_motors_internal.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/press_soles_internal.h"
#include "optimisation/pipeline/repeat_cycles_internal.h"
#include "optimisation/pipeline/solve_windows_internal.h"
#include "optimisation/trajectory/motor_rows_internal.h"
#include "planning/footsteps/ways_to_standing_internal.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/terrain_shapes.h"

namespace gaitwright {
namespace {

constexpr int kEarlyCheck = 20;           // iterations after which a solve ends if the violations
constexpr double kFar = 0.3;              // sum to more than this,
constexpr double kFarLargest = 5e-3;      // and one of them is larger than this
constexpr int kEarlyCheckOfHeels = 40;    // of plans with heel-off, which need more iterations
constexpr double kLeastFactor = 0.95;     // of limits that leave room: motors use more than these between knots
constexpr double kFinestRows = 1e-3;      // [s] of a row's step
constexpr double kFollowedShare = 0.5;    // see SoleMargin
constexpr double kRollOffset = 1e-4;      // [m] that feet may be off where they roll to
constexpr double kBesideStanding = 2e-4;  // [m] from places of the standing posture at the end

/// Whether the robot lands on legs that are free to give.
bool Lands(const MotionPlan& plan) {
  return LongestFlight(plan.schedule) > 0.0 &&
         std::ranges::none_of(plan.parts, [](const MotionPart& part) { return TurnsOver(part.gait); });
}

FinishSettings SettingsOf(const MotionPlan& plan, const TrajectoryOptions& options, double friction_use) {
  FinishSettings settings;
  constexpr double kLanding = 0.2;  // [rad]: legs bend by up to 0.1 rad more than planned
  if (Lands(plan)) settings.use.landing_margin = kLanding;
  settings.knot_step_s = options.knot_step_s;
  settings.friction_use = friction_use;
  BodyWeights& w = settings.weights;
  for (double* weight : {&w.base_position, &w.base_rotation, &w.joint}) *weight *= options.near;
  w.effort = options.effort;
  w.power = options.power;
  return settings;
}

std::vector<double> TimesOf(const std::vector<RepeatedCycles>& all) {
  std::vector<double> times_s;
  for (const RepeatedCycles& cycles : all) times_s.insert(times_s.end(), cycles.time_s.begin(), cycles.time_s.end());
  return times_s;
}

/// Solves over knots until the motion balances between them, and brings plan and rolls along.
class Finisher {
 public:
  /// @param follow  given for FollowMotion.
  Finisher(const RobotModel& model, const MotionPlan& plan, const TrajectoryOptions& options,
           const FinishSettings& settings, const FollowOptions* follow = nullptr)
      : model_(model),
        plan_(plan),
        options_(options),
        settings_(settings),
        follow_(follow),
        courses_(CoursesOf(model, plan)),
        cycles_(options.cycles == "periodic" ? CyclesToRepeat(plan, courses_) : std::vector<RepeatedCycles>{}),
        knots_s_(
            KnotTimesOf(plan, options.knot_step_s, follow == nullptr ? 0 : follow->least_per_swing, TimesOf(cycles_))),
        raises_heels_(
            std::ranges::any_of(plan.footsteps.footholds, [](const Foothold& f) { return f.heel_off_s.has_value(); })),
        finished_(plan) {
    rolls_ = RollsOf(model, plan.whole_body, courses_);
    landing_W_.assign(courses_.size(), Vector3::Zero());
    SetCourses();
    if (options.self_distance_m > 0.0) apart_.emplace(model, options.self_distance_m, ConvexSolidsOf(plan.terrain));
  }

  Result<MotionPlan> Run();
  const FollowReport& report() const { return report_; }

 private:
  void SetCourses();
  ElasticOptions Elastic() const;
  bool HasApart() const { return apart_ && apart_->lists(); }
  int MostSolves() const {
    constexpr int kToPart = 4;  // links that touch
    return options_.max_solves + (HasApart() ? kToPart : 0);
  }
  std::optional<Failure> SolveApart(BodyProblem& problem, WindowSolver& solver);
  std::optional<Failure> SolveOnce(BodyProblem& problem, WindowSolver& solver);
  void TakeOver(const SolvedTrajectory& solved);
  double RollOffset(const BodyProblem& problem) const;
  bool LandsAsStanding();
  bool TightenLimits(const SolvedTrajectory& solved);
  double LeastFactor() const;
  bool Tighten(const SolvedTrajectory& solved, double start_s, double end_s, BodyLimitUse& use);

  const RobotModel& model_;
  const MotionPlan& plan_;
  const TrajectoryOptions& options_;
  const FinishSettings settings_;
  const FollowOptions* const follow_;  // null: finishes a plan
  std::vector<FootCourse> courses_;
  const std::vector<RepeatedCycles> cycles_;
  const std::vector<double> knots_s_;
  const bool raises_heels_;
  MotionPlan finished_;              // of the last solve; at first the plan
  FootRolls rolls_;                  // of that
  BodyMotion motion_;                // of the last solve
  std::vector<KnotWindow> windows_;  // in which problems are solved
  std::vector<Vector3> landing_W_;   // by course: how far its last landing was moved
  std::optional<ApartPairs> apart_;  // none: links may touch
  FollowReport report_;
};

/// The courses pass where feet touch down less what they have rolled then by the plan; the last landings are moved.
void Finisher::SetCourses() {
  for (std::size_t i = 0; i < courses_.size(); ++i) {
    std::vector<Vector3> at_touchdown_W = RolledAtTouchdowns(plan_, courses_[i], rolls_.roll_W[i]);
    at_touchdown_W.back() -= landing_W_[i];
    courses_[i].SetRolls(at_touchdown_W);
  }
}

/// Moves the last landings of feet that roll by how far these are from their places of the standing posture at the end.
/// @return whether they are there.
bool Finisher::LandsAsStanding() {
  std::vector<Pose> standing = StandingFeet(model_), landed_W;
  standing.resize(courses_.size());
  for (const FootCourse& course : courses_)
    landed_W.push_back(plan_.footsteps.footholds[course.footholds().back()].X_WF);
  const OffsetsToStanding offsets =
      FindOffsetsToStanding(model_, finished_.whole_body.q.back(), MeanHeading(standing, landed_W));
  if (offsets.largest_m() <= kBesideStanding) return true;
  for (std::size_t i = 0; i < courses_.size(); ++i) {
    const auto foot = static_cast<std::size_t>(courses_[i].foot());
    if (model_.feet[foot].radius > 0.0 && courses_[i].footholds().size() > 1) landing_W_[i] += offsets.offset_W[foot];
  }
  SetCourses();
  return false;
}

ElasticOptions Finisher::Elastic() const {
  ElasticOptions elastic = ElasticOfKnots(options_.max_iterations);
  if (follow_ != nullptr) return elastic;
  elastic.early_check = raises_heels_ ? kEarlyCheckOfHeels : kEarlyCheck;
  elastic.infeasible = kFar;
  elastic.infeasible_largest = kFarLargest;
  return elastic;
}

/// A plan that has no solution with its links apart is finished without: its audit names them.
std::optional<Failure> Finisher::SolveApart(BodyProblem& problem, WindowSolver& solver) {
  const BodyMotion before = motion_;
  const std::vector<KnotWindow> windows = windows_;
  std::optional<Failure> failure = SolveOnce(problem, solver);
  if (!failure || follow_ != nullptr || !HasApart() || solver.is_far()) return failure;
  ApartPairs::Clear(problem);
  apart_.reset();
  motion_ = before;
  windows_ = windows;
  return SolveOnce(problem, solver);
}

std::optional<Failure> Finisher::SolveOnce(BodyProblem& problem, WindowSolver& solver) {
  const auto progress = [&](int done, int all) {
    if (follow_ != nullptr && follow_->progress) follow_->progress({report_.solves, done, all});
  };
  std::optional<Failure> failure = solver.Solve(problem, windows_, motion_, progress);
  report_.solve_cpu_s = solver.work().cpu_s;
  report_.iterations = solver.work().iterations;
  report_.variables = solver.work().variables;
  report_.unmet_s = solver.unmet_s();
  report_.windows = static_cast<int>(windows_.size());
  report_.keeps_room =
      std::all_of(windows_.begin(), windows_.end(), [](const KnotWindow& window) { return window.keeps_room; });
  return failure;
}

/// On rows that meet the knots, where a step of at least kFinestRows does.
void Finisher::TakeOver(const SolvedTrajectory& solved) {
  double step_s = plan_.whole_body.step_s;
  const auto on_rows = [&] {
    return std::all_of(knots_s_.begin(), knots_s_.end(), [&](double time_s) {
      const double row = (time_s - plan_.whole_body.start_s) / step_s;
      return std::abs(row - std::round(row)) < 1e-6;
    });
  };
  while (!on_rows() && 0.5 * step_s >= kFinestRows) step_s *= 0.5;
  SetRows(model_, solved, step_s, finished_);
  rolls_ = RollsOf(model_, finished_.whole_body, courses_);
}

/// How far feet that roll are from where they roll to.
double Finisher::RollOffset(const BodyProblem& problem) const {
  BodyProblem rolled = problem;
  SetRolledGoals(model_, finished_.whole_body, rolls_, courses_, rolled);
  double offset = 0.0;
  for (std::size_t k = 0; k < problem.knots.size(); ++k) {
    for (std::size_t i = 0; i < courses_.size(); ++i) {
      const FootGoal &before = problem.knots[k].feet[i], &now = rolled.knots[k].feet[i];
      const double radius = model_.feet[static_cast<std::size_t>(now.foot)].radius;
      if (radius == 0.0) continue;
      const Vector3 turned = RotationLog(now.R_roll * before.R_roll.transpose());
      offset = std::max(offset, (before.p_W + radius * turned.cross(before.normal_W) - now.p_W).norm());
    }
  }
  return offset;
}

/// Lowers the limits of motors for knots by as much as the motors exceed them between knots, by window.
/// @return whether any is lowered.
bool Finisher::TightenLimits(const SolvedTrajectory& solved) {
  report_.effort_use = 0.0;
  bool tightens = false;
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    const auto knot_s = [&](int knot) { return knots_s_[static_cast<std::size_t>(knot)]; };
    const double end_s = i + 1 < windows_.size() ? knot_s(windows_[i + 1].first) : knots_s_.back();
    tightens |= Tighten(solved, knot_s(windows_[i].first), end_s, windows_[i].use);
  }
  return tightens;
}

/// Of a motor's limits at knots.
double Finisher::LeastFactor() const {
  double least = 1.0;
  for (const KnotWindow& window : windows_) {
    for (const std::vector<double>* factors : {&window.use.effort_of, &window.use.speed_of}) {
      for (const double factor : *factors) least = std::min(least, factor);
    }
  }
  return least;
}

bool Finisher::Tighten(const SolvedTrajectory& solved, double start_s, double end_s, BodyLimitUse& use) {
  constexpr double kRoom = 2e-3, kLeast = 0.93, kLeastSpeed = 0.9;  // of a limit
  constexpr double kStep = 1e-3;                                    // [s]
  const MotorRows motors(model_, {.effort = 1.0, .speed = 1.0});
  MotorRows::Largest largest;
  KnotModel knot(model_);
  VectorJet jet;
  ChartedState state;
  std::vector<KnotContact> contacts;
  VectorX forces_W, needed;
  const auto n = model_.num_dofs();
  for (double time_s = start_s; time_s < end_s; time_s += kStep) {
    solved.Sample(time_s, jet);
    StateOf(solved.problem().chart, jet, state);
    solved.ForcesAt(time_s, contacts, forces_W);
    forces_W *= model_.weight_n();
    knot.Evaluate(state.q, state.v, state.a, contacts, forces_W, needed);
    motors.Raise(needed.tail(n), state.v.tail(n), state.a.tail(n), largest);
  }
  if (largest.effort.size() > 0) report_.effort_use = std::max(report_.effort_use, largest.effort.maxCoeff());
  bool tightens = false;
  const auto tighten = [&](const VectorX& shares, double least, std::vector<double>& factors) {
    factors.resize(static_cast<std::size_t>(shares.size()), 1.0);
    for (std::size_t motor = 0; motor < factors.size(); ++motor) {
      const double share = shares[static_cast<Eigen::Index>(motor)];
      if (share <= 1.0 || factors[motor] <= least) continue;
      factors[motor] = std::max(least, factors[motor] / share - kRoom);
      tightens = true;
    }
  };
  tighten(largest.effort, kLeast, use.effort_of);
  tighten(largest.curve, kLeastSpeed, use.speed_of);
  return tightens;
}

Result<MotionPlan> Finisher::Run() {
  BodyProblem problem = ProblemOf(model_, plan_, courses_, knots_s_, settings_);
  problem.knots.front().pins_place = follow_ == nullptr;
  if (problem.chart.yaw_first()) {
    TieCycles(cycles_, problem);
    for (const RepeatedCycles& cycles : cycles_) report_.cycles += cycles.count();
  }
  PressingByKnot to_edges = PressingOf(problem);
  KeepFromEdges(follow_ == nullptr ? SoleMargin{} : SoleMargin{follow_->sole_margin_m, kFollowedShare}, problem);
  if (follow_ != nullptr && follow_->prepare) follow_->prepare(problem);
  motion_ = {FirstPoints(problem), FirstForces(model_, finished_, problem)};
  windows_ = {{0, static_cast<int>(knots_s_.size()) - 1, problem.use}};
  if (follow_ != nullptr) windows_ = WindowsOf(problem, follow_->windows);
  PressingByKnot inside = PressingOf(problem);
  if (follow_ == nullptr && MayLowerSoleFriction(model_, plan_, settings_.friction_use)) {
    windows_.front().spares_soles = true;
    LowerSoleFriction(problem);
  }
  constexpr double kCoarse = 4e-3;  // [s]
  if (apart_) apart_->Watch(plan_.whole_body, problem, kCoarse);
  WindowSolver solver(Elastic(), {std::move(inside), std::move(to_edges)},
                      follow_ != nullptr ? follow_->record : nullptr);
  PlanResidual residual;
  for (report_.solves = 1;; ++report_.solves) {
    SetRolledGoals(model_, finished_.whole_body, rolls_, courses_, problem);
    if (std::optional<Failure> failure = SolveApart(problem, solver)) return *failure;
    const SolvedTrajectory solved(problem, motion_.points, motion_.forces);
    TakeOver(solved);
    residual = ResidualOf(model_, finished_);
    const bool balanced = residual.largest() <= options_.residual && RollOffset(problem) <= kRollOffset;
    const bool last = report_.solves >= MostSolves(),
               tightens = TightenLimits(solved) || (!last && CoolMotors(model_, finished_, problem.weights));
    const bool in_place = !settings_.end_as_standing || last || LandsAsStanding();
    const bool settled = balanced && in_place && !tightens;
    const bool looks = settled || HasApart() || report_.solves >= options_.max_solves;
    const bool touches = looks && apart_ && apart_->Watch(finished_.whole_body, problem);
    if ((settled && !touches) || last) break;
    for (std::size_t k = 0; k < problem.knots.size(); ++k) problem.knots[k].residual_W = solved.ResidualsAtKnots()[k];
  }
  SetFootholds(rolls_, courses_, finished_);
  SetCentroidal(model_, finished_);
  report_.keeps_room = report_.keeps_room && LeastFactor() >= kLeastFactor;
  if (apart_) report_.apart = apart_->Listed();
  report_.knots = static_cast<int>(knots_s_.size());
  report_.residual_force = residual.force;
  report_.residual_moment = residual.moment;
  report_.residual_at_s = residual.at_s;
  report_.summary = fmt::format(
      "whole body over {} knots: {} iterations, unbalanced {:.1e} m g and {:.1e} m g l at most between knots",
      report_.knots, report_.iterations, residual.force, residual.moment);
  if (report_.cycles > 0) report_.summary += fmt::format("; {} cycles repeat exactly", report_.cycles);
  if (!report_.apart.empty()) report_.summary += fmt::format("; kept apart: {}", fmt::join(report_.apart, ", "));
  return std::move(finished_);
}

}  // namespace

std::string ReasonNotFinished(const RobotModel& model, const MotionPlan& plan) {
  if (plan.whole_body.size() < 2) return "the plan has no motion";
  if (plan.whole_body.q.front().size() != model.nq()) return "the plan is of another robot";
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    const std::string& name = model.feet[static_cast<std::size_t>(foot)].name;
    const bool of_leg = foot < static_cast<int>(model.legs.size());
    const auto holds = std::count_if(plan.footsteps.footholds.begin(), plan.footsteps.footholds.end(),
                                     [&](const Foothold& foothold) { return foothold.foot == foot; });
    const auto swings = std::count_if(plan.swings.begin(), plan.swings.end(),
                                      [&](const SwingTrajectory& swing) { return swing.foot == foot; });
    if (of_leg && (holds == 0 || swings + 1 != holds))
      return fmt::format("foot '{}' needs footholds, and a swing between any two of them", name);
    if (!of_leg && holds > 0) return fmt::format("the robot lies on '{}'", name);
  }
  return "";
}

Result<MotionPlan> FinishMotion(const RobotModel& model, const MotionPlan& plan, const TrajectoryOptions& options,
                                double friction_use, FinishReport* report, bool end_as_standing) {
  TrajectoryOptions checked = options;
  CheckOptions(checked.Fields());
  if (const std::string reason = ReasonNotFinished(model, plan); !reason.empty())
    throw InvalidArgument("FinishMotion: " + reason);
  const bool chooses = options.timing != "fixed" || options.footholds != "fixed" || options.swings == "free";
  if (options.cycles == "periodic" && chooses) {
    throw InvalidArgument(
        "trajectory.cycles=periodic needs trajectory.timing=fixed and trajectory.footholds=fixed, and excludes "
        "trajectory.swings=free");
  }
  FinishSettings settings = SettingsOf(plan, options, friction_use);
  settings.end_as_standing = end_as_standing;
  ChosenContacts chosen;
  const MotionPlan with_chosen = ChooseContacts(model, plan, options, settings, chosen);
  Finisher finisher(model, with_chosen, options, settings);
  Result<MotionPlan> finished = finisher.Run();
  if (report != nullptr) {
    *report = finisher.report();
    report->iterations += chosen.iterations;
    report->solve_cpu_s += chosen.solve_cpu_s;
    if (!chosen.summary.empty()) report->summary += "; " + chosen.summary;
  }
  return finished;
}

Result<MotionPlan> FollowMotion(const RobotModel& model, const MotionPlan& plan, const TrajectoryOptions& options,
                                const FollowOptions& follow, FollowReport* report) {
  TrajectoryOptions checked = options;
  CheckOptions(checked.FollowFields());
  if (const std::string reason = ReasonNotFinished(model, plan); !reason.empty())
    throw InvalidArgument("FollowMotion: " + reason);
  FinishSettings settings;
  settings.knot_step_s = options.knot_step_s;
  settings.friction_use = follow.friction_use;
  settings.weights = follow.weights;
  settings.use.effort = follow.effort_use;
  Finisher finisher(model, plan, options, settings, &follow);
  Result<MotionPlan> followed = finisher.Run();
  if (report != nullptr) *report = finisher.report();
  return followed;
}

}  // namespace gaitwright
