// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/cpu_clock.h"
#include "optimisation/pipeline/choose_contacts_internal.h"
#include "optimisation/pipeline/press_soles_internal.h"
#include "optimisation/pipeline/solve_windows_internal.h"
#include "optimisation/whole_body/swing_room_internal.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

constexpr double kOfSwing = 0.5;       // of the shortest swing: time between control points of the pace
constexpr double kLeastPieceS = 0.05;  // [s] between these

/// Whether a foot stands on its patch as before when its foothold is shifted.
bool Stands(const RobotModel& model, const MotionPlan& plan, const Foothold& foothold, const Vector3& shift_W) {
  constexpr double kSame = 1e-9;  // [m^2]
  const Foot& foot = model.feet[static_cast<std::size_t>(foothold.foot)];
  Foothold shifted = foothold;
  shifted.X_WF.translation() += shift_W;
  const Polygon before = SupportOf(foot, foothold, plan.terrain), now = SupportOf(foot, shifted, plan.terrain);
  return !now.empty() && Area(now) >= Area(before) - kSame;
}

/// The largest share of the most a foothold may be shifted by for which it stands at all corners of its region.
double RoomOf(const RobotModel& model, const MotionPlan& plan, const Foothold& foothold,
              const ShiftedFoothold& choice) {
  for (double share = 1.0; share > 0.1; share *= 0.5) {
    bool stands = true;
    for (const double x : {choice.lower_m[0], choice.upper_m[0]}) {
      for (const double y : {choice.lower_m[1], choice.upper_m[1]})
        stands = stands && Stands(model, plan, foothold, share * (x * choice.along_W[0] + y * choice.along_W[1]));
    }
    if (stands) return share;
  }
  return 0.0;
}

/// How the goals of a foot move with a foothold, by knot.
std::vector<ShiftedFoothold::Share> SharesOf(const MotionPlan& plan, const FootCourse& course, std::size_t goal,
                                             std::size_t index, const std::vector<double>& knots_s) {
  std::vector<ShiftedFoothold::Share> shares;
  for (std::size_t k = 0; k < knots_s.size(); ++k) {
    const FootCourse::Place place = course.At(knots_s[k]);
    double share = place.foothold == index ? 1.0 : 0.0;
    if (place.swings) {
      const auto left = std::find(course.footholds().begin(), course.footholds().end(), place.foothold);
      const auto swing = std::find_if(plan.swings.begin(), plan.swings.end(), [&](const SwingTrajectory& s) {
        return s.foot == course.foot() && s.start_s <= knots_s[k] && knots_s[k] <= s.end_s;
      });
      const bool lands =
          left != course.footholds().end() && left + 1 != course.footholds().end() && *(left + 1) == index;
      if (swing == plan.swings.end() || (share == 0.0 && !lands)) continue;
      const double done =
          SmoothStep((knots_s[k] - swing->start_s) / (swing->end_s - swing->start_s), swing->cruise).value;
      share = lands ? done : 1.0 - done;
    }
    if (share > 0.0) shares.push_back({static_cast<int>(k), goal, share});
  }
  return shares;
}

/// A foothold that may be shifted, and its index in the plan.
struct FreeFoothold {
  std::size_t index;
  ShiftedFoothold choice;
};

std::vector<FreeFoothold> FreeFootholds(const RobotModel& model, const MotionPlan& plan,
                                        const std::vector<FootCourse>& courses, const std::vector<double>& knots_s,
                                        double most_m) {
  std::vector<FreeFoothold> free;
  for (std::size_t i = 0; i < courses.size(); ++i) {
    const std::vector<std::size_t>& footholds = courses[i].footholds();
    for (std::size_t f = 1; f + 1 < footholds.size(); ++f) {
      const Foothold& foothold = plan.footsteps.footholds[footholds[f]];
      if (foothold.patch < 0 || foothold.patch >= static_cast<int>(plan.terrain.patches.size())) continue;
      ShiftedFoothold choice;
      choice.name = model.feet[static_cast<std::size_t>(foothold.foot)].name;
      choice.along_W = {foothold.X_WF.linear().col(0), foothold.X_WF.linear().col(1)};
      choice.lower_m = {-most_m, -most_m};
      choice.upper_m = {most_m, most_m};
      const double room = RoomOf(model, plan, foothold, choice);
      if (room == 0.0) continue;
      for (double* bound : {&choice.lower_m[0], &choice.lower_m[1], &choice.upper_m[0], &choice.upper_m[1]})
        *bound *= room;
      choice.shares = SharesOf(plan, courses[i], i, footholds[f], knots_s);
      free.push_back({footholds[f], std::move(choice)});
    }
  }
  return free;
}

/// Control points of the pace: a few in each swing.
int PacePoints(const MotionPlan& plan) {
  constexpr int kLeast = 4;
  double piece_s = plan.duration_s();
  for (const SwingTrajectory& swing : plan.swings)
    piece_s = std::min(piece_s, kOfSwing * (swing.end_s - swing.start_s));
  piece_s = std::max(piece_s, kLeastPieceS);
  return std::max(kLeast, static_cast<int>(std::ceil(plan.duration_s() / piece_s)) + 3);
}

/// A plan whose times follow a map and whose footholds are shifted, with the motion of a solution.
class ChosenPlan {
 public:
  /// @param retimes  whether times are chosen; otherwise they stay as they are.
  ChosenPlan(const MotionPlan& plan, const BodyProblem& problem, const PacedTimes& times, bool retimes)
      : plan_(plan), problem_(problem), times_(times), retimes_(retimes) {}

  MotionPlan Made(const PaceSpline& pace, const MatrixX& points, const std::vector<Vector3>& shift_W) {
    MotionPlan made = plan_;
    SetTimes(made);
    for (std::size_t i = 0; i < shift_W.size(); ++i) made.footsteps.footholds[i].X_WF.translation() += shift_W[i];
    SetSwings(shift_W, made);
    SetRows(pace, points, made.whole_body);
    return made;
  }

 private:
  double New(double time_s) const { return retimes_ ? times_.NewRow(time_s) : time_s; }

  void SetTimes(MotionPlan& made) const {
    for (MotionPart& part : made.parts) {
      part.start_s = New(part.start_s);
      part.end_s = New(part.end_s);
    }
    for (ContactPhase& phase : made.schedule.phases) {
      phase.start_s = New(phase.start_s);
      phase.end_s = New(phase.end_s);
    }
    for (Foothold& foothold : made.footsteps.footholds) {
      foothold.touchdown_s = New(foothold.touchdown_s);
      foothold.liftoff_s = New(foothold.liftoff_s);
      if (foothold.heel_off_s) foothold.heel_off_s = New(*foothold.heel_off_s);
    }
    for (PlanGate& gate : made.gates) gate.at_s = New(gate.at_s);
  }

  void SetSwings(const std::vector<Vector3>& shift_W, MotionPlan& made) const {
    constexpr double kSame = 1e-9;  // [s]
    for (SwingTrajectory& swing : made.swings) {
      for (std::size_t i = 0; i < shift_W.size(); ++i) {
        const Foothold& before = plan_.footsteps.footholds[i];
        if (before.foot != swing.foot) continue;
        if (std::abs(before.liftoff_s - swing.start_s) < kSame) swing.X_WF_start.translation() += shift_W[i];
        if (std::abs(before.touchdown_s - swing.end_s) < kSame) swing.X_WF_end.translation() += shift_W[i];
      }
      swing.start_s = New(swing.start_s);
      swing.end_s = New(swing.end_s);
    }
  }

  void SetRows(const PaceSpline& pace, const MatrixX& points, WholeBodyTrajectory& motion) const {
    const ChainSpline spline = problem_.spline();
    const WholeBodyTrajectory old = motion;
    motion.q.clear();
    motion.v.clear();
    motion.a.clear();
    motion.tau.clear();
    motion.wrenches.clear();
    VectorJet jet;
    ChartedState state;
    WholeBodySample sample;
    for (int row = 0; row <= times_.rows(); ++row) {
      const double old_s = times_.Old(old.start_s + row * old.step_s);
      spline.Sample(points, old_s, jet);
      SetPace(pace.At(old_s), jet);
      StateOf(problem_.chart, jet, state);
      SampleWholeBody(old, old_s, sample);
      motion.q.push_back(state.q);
      motion.v.push_back(state.v);
      motion.a.push_back(state.a);
      if (!old.tau.empty()) motion.tau.push_back(sample.tau);
      if (!old.wrenches.empty()) motion.wrenches.push_back(sample.wrenches);
    }
  }

  const MotionPlan& plan_;
  const BodyProblem& problem_;
  const PacedTimes& times_;
  const bool retimes_;
};

/// Sets what was chosen. @return whether each phase still has a time.
bool Measure(const MotionPlan& plan, const MotionPlan& made, const std::vector<Vector3>& shifts_W,
             ChosenContacts& chosen) {
  chosen.shortest = std::numeric_limits<double>::infinity();
  chosen.longest = 0.0;
  for (std::size_t i = 0; i < plan.schedule.phases.size(); ++i) {
    const ContactPhase &before = plan.schedule.phases[i], &now = made.schedule.phases[i];
    if (now.end_s <= now.start_s) return false;
    const double ratio = (now.end_s - now.start_s) / (before.end_s - before.start_s);
    chosen.shortest = std::min(chosen.shortest, ratio);
    chosen.longest = std::max(chosen.longest, ratio);
  }
  for (const Vector3& shift_W : shifts_W) chosen.largest_shift_m = std::max(chosen.largest_shift_m, shift_W.norm());
  return true;
}

}  // namespace

PacedTimes::PacedTimes(const PaceSpline& pace, double start_s, double end_s, double row_s)
    : start_s_(start_s), row_s_(row_s) {
  constexpr double kStep = 5e-4;  // [s]
  const int steps = std::max(1, static_cast<int>(std::ceil((end_s - start_s) / kStep)));
  step_s_ = (end_s - start_s) / steps;
  new_s_.push_back(start_s);
  for (int i = 0; i < steps; ++i) {
    const double at = start_s + i * step_s_;
    const double sum =
        1.0 / pace.At(at).rate + 4.0 / pace.At(at + 0.5 * step_s_).rate + 1.0 / pace.At(at + step_s_).rate;
    new_s_.push_back(new_s_.back() + sum * step_s_ / 6.0);
  }
  const double length_s = new_s_.back() - start_s;
  rows_ = std::max(1, static_cast<int>(std::lround(length_s / row_s)));
  for (double& time_s : new_s_) time_s = start_s + (time_s - start_s) * rows_ * row_s / length_s;
}

double PacedTimes::New(double problem_s) const {
  const double at = std::clamp((problem_s - start_s_) / step_s_, 0.0, static_cast<double>(new_s_.size() - 1));
  const auto step = std::min(static_cast<std::size_t>(at), new_s_.size() - 2);
  return std::lerp(new_s_[step], new_s_[step + 1], at - static_cast<double>(step));
}

double PacedTimes::Old(double new_s) const {
  const auto above =
      std::clamp(std::upper_bound(new_s_.begin(), new_s_.end(), new_s), new_s_.begin() + 1, new_s_.end() - 1);
  const double share = std::clamp((new_s - *(above - 1)) / (*above - *(above - 1)), 0.0, 1.0);
  return start_s_ + (static_cast<double>(above - 1 - new_s_.begin()) + share) * step_s_;
}

double PacedTimes::NewRow(double problem_s) const {
  return start_s_ + row_s_ * std::round((New(problem_s) - start_s_) / row_s_);
}

MotionPlan ChooseContacts(const RobotModel& model, const MotionPlan& plan, const TrajectoryOptions& options,
                          const FinishSettings& settings, ChosenContacts& chosen) {
  const bool times = options.timing == "optimised", places = options.footholds == "free";
  const bool turns_over = std::ranges::any_of(plan.parts, [](const MotionPart& part) { return TurnsOver(part.gait); });
  const bool paths = options.swings == "free" && !turns_over;
  if (!times && !places && !paths) return plan;
  const SwingFreedom freedom{options.most_shift_m, options.clearance_m, places ? options.most_shift_m : 0.0};
  std::vector<FootCourse> courses = CoursesOf(model, plan);
  const FootRolls rolls = RollsOf(model, plan.whole_body, courses);
  for (std::size_t i = 0; i < courses.size(); ++i)
    courses[i].SetRolls(RolledAtTouchdowns(plan, courses[i], rolls.roll_W[i]));
  const std::vector<double> knots_s = KnotTimesOf(plan, options.knot_step_s);
  BodyProblem problem = ProblemOf(model, plan, courses, knots_s, settings);
  SetRolledGoals(model, plan.whole_body, rolls, courses, problem);
  if (paths) FreeSwings(model, plan, courses, freedom, problem);
  KeepFromEdges({}, problem);
  problem.limits_jerk = !times;
  BodyChoices choices;
  std::vector<FreeFoothold> free;
  if (places) free = FreeFootholds(model, plan, courses, knots_s, options.most_shift_m);
  for (const FreeFoothold& foothold : free) choices.footholds.push_back(foothold.choice);
  if (times) choices.pace_points = PacePoints(plan);
  choices.fastest = 1.0 + options.most_change;
  choices.slowest = 1.0 / choices.fastest;
  const CpuClock clock;
  ConstrainedSolution last;
  const VectorX start = Unknowns(FirstPoints(problem), FirstForces(model, plan, problem));
  ChosenRows rows(problem, choices, start);
  const Result<ConstrainedSolution> solved =
      SolveElasticRows(rows, {rows.StartOf(start)}, ElasticOfKnots(options.max_iterations), &last);
  chosen.iterations = last.iterations;
  chosen.solve_cpu_s = clock.elapsed_s();
  chosen.summary = "contacts stay as planned: no better ones were found";
  if (!solved && last.violation > kGoodEnough) return plan;
  const PaceSpline pace = rows.PaceOf(last.x);
  const PacedTimes map(pace, plan.whole_body.start_s, plan.whole_body.end_s(), plan.whole_body.step_s);
  std::vector<Vector3> shifts_W(plan.footsteps.footholds.size(), Vector3::Zero());
  for (std::size_t i = 0; i < free.size(); ++i) shifts_W[free[i].index] = rows.ShiftsOf(last.x)[i];
  MotionPlan made =
      ChosenPlan(plan, problem, map, times).Made(pace, rows.inner().PointsOf(rows.InnerOf(last.x)), shifts_W);
  if (!Measure(plan, made, shifts_W, chosen)) return plan;
  if (paths) chosen.swings = FitSwings(model, freedom, made);
  chosen.summary = fmt::format(
      "contacts chosen in {} iterations: phases take {:.2f} to {:.2f} of their time, footholds "
      "move by up to {:.0f} mm, {} swings have new paths",
      chosen.iterations, chosen.shortest, chosen.longest, 1e3 * chosen.largest_shift_m, chosen.swings);
  return made;
}

}  // namespace gaitwright
