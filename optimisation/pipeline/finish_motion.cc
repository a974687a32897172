// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/base/cpu_clock.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/trajectory/body_rows_internal.h"

namespace gaitwright {
namespace {

constexpr double kViolation = 1e-5;    // [m g, rad, m] that constraints at knots may be off by
constexpr double kGoodEnough = 1e-4;   // of a solve that was ended by its iterations
constexpr double kFinestRows = 1e-3;   // [s]
constexpr double kRolledAside = 1e-4;  // [m] that feet may be off where they roll to

FinishSettings SettingsOf(const FinishOptions& options) {
  FinishSettings settings;
  settings.knot_step_s = options.knot_step_s;
  settings.friction_use = options.friction_use;
  BodyWeights& w = settings.weights;
  for (double* weight : {&w.base_position, &w.base_rotation, &w.joint}) *weight *= options.near;
  w.effort = options.effort;
  return settings;
}

/// Solves over knots, refines them, and brings plan and rolls along.
class Finisher {
 public:
  Finisher(const RobotModel& model, const MotionPlan& plan, const FinishOptions& options)
      : model_(model),
        plan_(plan),
        options_(options),
        settings_(SettingsOf(options)),
        courses_(CoursesOf(model, plan)),
        knots_s_(KnotTimesOf(plan, options.knot_step_s)),
        finished_(plan) {
    rolls_ = RollsOf(model, plan.whole_body, courses_);
    SetCourses();
  }

  Result<MotionPlan> Run();
  const FinishReport& report() const { return report_; }

 private:
  void SetCourses();
  Result<bool> SolveOnce(const BodyProblem& problem, MatrixX& points);
  bool Refine(const PlanResidual& residual);
  void TakeOver(const BodyProblem& problem, const ChainSpline& spline, const MatrixX& points);
  double RolledAside(const BodyProblem& problem) const;
  MatrixX FirstPoints(const BodyProblem& problem, const ChainSpline& spline) const;

  const RobotModel& model_;
  const MotionPlan& plan_;
  const FinishOptions& options_;
  const FinishSettings settings_;
  std::vector<FootCourse> courses_;
  std::vector<double> knots_s_;
  MotionPlan finished_;          // of the last solve; at first the plan
  FootRolls rolls_;              // of that
  std::vector<VectorX> forces_;  // of the last solve, at its knots
  FinishReport report_;
};

/// The courses pass where feet touch down less what they have rolled then by the plan.
void Finisher::SetCourses() {
  const WholeBodyTrajectory& motion = plan_.whole_body;
  for (std::size_t i = 0; i < courses_.size(); ++i) {
    std::vector<Vector3> at_touchdown_W;
    for (const std::size_t index : courses_[i].footholds()) {
      const double time_s = plan_.footsteps.footholds[index].touchdown_s;
      const double row = std::clamp((time_s - motion.start_s) / motion.step_s, 0.0, motion.size() - 1.0);
      at_touchdown_W.push_back(rolls_.roll_W[i][static_cast<std::size_t>(std::lround(row))]);
    }
    courses_[i].SetRolls(at_touchdown_W);
  }
}

/// The spline through the motion so far.
MatrixX Finisher::FirstPoints(const BodyProblem& problem, const ChainSpline& spline) const {
  const BodyProblem near = ProblemOf(model_, finished_, courses_, problem.time_s, settings_);
  MatrixX values(model_.nv(), spline.knots());
  for (int k = 0; k < spline.knots(); ++k) values.col(k) = near.knots[static_cast<std::size_t>(k)].reference.x;
  return spline.Through(values, VectorX::Zero(model_.nv()), VectorX::Zero(model_.nv()));
}

Result<bool> Finisher::SolveOnce(const BodyProblem& problem, MatrixX& points) {
  ElasticOptions elastic;
  elastic.tolerance = kViolation;
  elastic.cost_tolerance = 2e-3;
  elastic.max_iterations = options_.max_iterations;
  VectorX start(points.size());
  start = Eigen::Map<const VectorX>(points.data(), points.size());
  Eigen::Index size = start.size();
  for (const VectorX& forces : forces_) size += forces.size();
  start.conservativeResize(size);
  Eigen::Index at = points.size();
  for (const VectorX& forces : forces_) {
    start.segment(at, forces.size()) = forces;
    at += forces.size();
  }
  BodyRows rows(problem, start);
  ConstrainedSolution last;
  const CpuClock clock;
  const Result<ConstrainedSolution> solved = SolveElasticRows(rows, start, elastic, &last);
  report_.solve_cpu_s += clock.elapsed_s();
  report_.iterations += last.iterations;
  report_.variables = static_cast<int>(size);
  if (!solved && last.violation > kGoodEnough) {
    Failure failure = solved.failure();
    failure.stage = "FinishMotion";
    failure.message = fmt::format("the whole body cannot follow this plan: {}", failure.message);
    return failure;
  }
  points = rows.PointsOf(last.x);
  forces_ = rows.ForcesOf(last.x);
  return true;
}

void Finisher::TakeOver(const BodyProblem& problem, const ChainSpline& spline, const MatrixX& points) {
  double step_s = plan_.whole_body.step_s;
  const auto on_rows = [&] {
    return std::all_of(knots_s_.begin(), knots_s_.end(), [&](double time_s) {
      const double row = (time_s - plan_.whole_body.start_s) / step_s;
      return std::abs(row - std::round(row)) < 1e-6;
    });
  };
  while (!on_rows() && 0.5 * step_s >= kFinestRows) step_s *= 0.5;
  SetRows(model_, {problem, spline, points, forces_}, step_s, finished_);
  rolls_ = RollsOf(model_, finished_.whole_body, courses_);
}

/// How far feet that roll are from where they roll to.
double Finisher::RolledAside(const BodyProblem& problem) const {
  BodyProblem rolled = problem;
  SetRolledGoals(model_, finished_.whole_body, rolls_, courses_, rolled);
  double aside = 0.0;
  for (std::size_t k = 0; k < problem.knots.size(); ++k) {
    for (std::size_t i = 0; i < courses_.size(); ++i) {
      const FootGoal &before = problem.knots[k].feet[i], &now = rolled.knots[k].feet[i];
      const double radius = model_.feet[static_cast<std::size_t>(now.foot)].radius;
      if (radius == 0.0) continue;
      const Vector3 turned = RotationLog(now.R_roll * before.R_roll.transpose());
      aside = std::max(aside, (before.p_W + radius * turned.cross(before.normal_W) - now.p_W).norm());
    }
  }
  return aside;
}

/// Halves the intervals between knots that leave too much; on rows of a finer grid where knots are on the plan's rows.
/// @return whether there were any.
bool Finisher::Refine(const PlanResidual& residual) {
  const double start_s = knots_s_.front();
  double finest_s = plan_.whole_body.step_s;
  while (0.5 * finest_s >= kFinestRows) finest_s *= 0.5;
  const auto to_row = [&](double time_s) { return start_s + finest_s * std::round((time_s - start_s) / finest_s); };
  const bool on_rows = std::all_of(knots_s_.begin(), knots_s_.end(),
                                   [&](double time_s) { return std::abs(to_row(time_s) - time_s) < 1e-9; });
  std::vector<double> finer;
  bool refined = false;
  for (std::size_t k = 0; k + 1 < knots_s_.size(); ++k) {
    finer.push_back(knots_s_[k]);
    const double length = knots_s_[k + 1] - knots_s_[k];
    if (residual.by_interval[k] <= options_.residual || length < 1.9 * finest_s) continue;
    const double middle_s = knots_s_[k] + 0.5 * length;
    finer.push_back(on_rows ? to_row(middle_s) : middle_s);
    refined = true;
  }
  finer.push_back(knots_s_.back());
  knots_s_ = std::move(finer);
  return refined;
}

Result<MotionPlan> Finisher::Run() {
  constexpr int kMostRolls = 3;  // solves, after each of which feet roll otherwise
  PlanResidual residual;
  for (;; ++report_.refinements) {
    BodyProblem problem = ProblemOf(model_, plan_, courses_, knots_s_, settings_);
    const ChainSpline spline(knots_s_);
    MatrixX points = FirstPoints(problem, spline);
    forces_ = FirstForces(model_, finished_, problem);
    for (int solve = 0; solve < kMostRolls; ++solve) {
      SetRolledGoals(model_, finished_.whole_body, rolls_, courses_, problem);
      if (Result<bool> solved = SolveOnce(problem, points); !solved) return solved.failure();
      TakeOver(problem, spline, points);
      if (RolledAside(problem) <= kRolledAside) break;
    }
    residual = ResidualOf(model_, finished_, knots_s_);
    const double most = *std::max_element(residual.by_interval.begin(), residual.by_interval.end());
    if (most <= options_.residual || report_.refinements == options_.max_refinements || !Refine(residual)) break;
  }
  SetFootholds(rolls_, courses_, finished_);
  SetCentroidal(model_, finished_);
  report_.knots = static_cast<int>(knots_s_.size());
  report_.residual_force = residual.force;
  report_.residual_moment = residual.moment;
  report_.residual_at_s = residual.at_s;
  report_.summary = fmt::format(
      "whole body over {} knots: {} iterations, unbalanced {:.1e} m g and {:.1e} m g l at most between knots",
      report_.knots, report_.iterations, residual.force, residual.moment);
  return finished_;
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

Result<MotionPlan> FinishMotion(const RobotModel& model, const MotionPlan& plan, const FinishOptions& options,
                                FinishReport* report) {
  FinishOptions checked = options;
  CheckOptions(checked.Fields());
  if (const std::string reason = ReasonNotFinished(model, plan); !reason.empty())
    throw InvalidArgument("FinishMotion: " + reason);
  Finisher finisher(model, plan, options);
  Result<MotionPlan> finished = finisher.Run();
  if (report != nullptr) *report = finisher.report();
  return finished;
}

}  // namespace gaitwright
