// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/cpu_clock.h"
#include "optimisation/pipeline/solve_windows_internal.h"
#include "optimisation/trajectory/chosen_rows_internal.h"

namespace gaitwright {
namespace {

constexpr double kLongest = 3.5;  // of a window that was joined with those before it, in their usual length

std::size_t Of(int knot) { return static_cast<std::size_t>(knot); }

int KnotAfter(const std::vector<double>& time_s, double at_s) {
  constexpr double kRounding = 1e-9;  // [s]
  return static_cast<int>(std::lower_bound(time_s.begin(), time_s.end(), at_s - kRounding) - time_s.begin());
}

/// The knot between two times at which most feet press, and there the motion is slowest.
int QuietestKnot(const BodyProblem& problem, double from_s, double to_s) {
  const int first = KnotAfter(problem.time_s, from_s), behind = KnotAfter(problem.time_s, to_s);
  int best = first;
  const auto speed = [&](int k) { return problem.knots[Of(k)].reference.rate.squaredNorm(); };
  const auto feet = [&](int k) { return problem.knots[Of(k)].pressing.size(); };
  for (int k = first; k < behind; ++k) {
    if (feet(k) > feet(best) || (feet(k) == feet(best) && speed(k) < speed(best))) best = k;
  }
  return best;
}

}  // namespace

ElasticOptions ElasticOfKnots(int max_iterations) {
  constexpr double kViolation = 1e-5;  // [m g, rad, m] that constraints at knots may be off by
  constexpr double kGive = 1e-6;       // see ElasticOptions
  constexpr double kPenalty = 100.0;   // the same: above the multipliers of most motions
  ElasticOptions elastic{.tolerance = kViolation, .cost_tolerance = 2e-3, .penalty = kPenalty, .give = kGive};
  elastic.max_iterations = max_iterations;
  return elastic;
}

std::vector<KnotWindow> WindowsOf(const BodyProblem& problem, const WindowOptions& options) {
  constexpr double kOne = 1.5, kSearched = 0.2;  // of a window's length: for one window; to either side of a seam
  const double start_s = problem.time_s.front(), length_s = problem.time_s.back() - start_s;
  const int last = static_cast<int>(problem.time_s.size()) - 1;
  if (length_s <= kOne * options.length_s) return {{0, last, problem.use}};
  const int count = static_cast<int>(std::ceil(length_s / options.length_s));
  std::vector<KnotWindow> windows{{0, last, problem.use}};
  for (int i = 1; i < count; ++i) {
    const double near_s = start_s + length_s * i / count, range_s = kSearched * options.length_s;
    const int seam = QuietestKnot(problem, near_s - range_s, near_s + range_s);
    windows.back().last = std::min(last, KnotAfter(problem.time_s, problem.time_s[Of(seam)] + options.overlap_s));
    windows.push_back({seam, last, problem.use});
  }
  return windows;
}

/// Where the window begins, forces were found before.
void WindowSolver::Press(const PressingByKnot& pressing, const KnotWindow& window, BodyProblem& problem) {
  for (int k = window.first == 0 ? 0 : window.first + 1; k <= window.last; ++k)
    problem.knots[Of(k)].pressing = pressing[Of(k)];
}

/// Lets soles use all of their friction.
void WindowSolver::UseSoles(BodyProblem& problem, KnotWindow& window) const {
  window.spares_soles = false;
  Press(soles_.inside, window, problem);
}

/// Gives up the room that controllers would like to have.
void WindowSolver::UseAll(BodyProblem& problem, KnotWindow& window) const {
  window.keeps_room = false;
  window.use = kFullUse;
  window.spares_soles = false;
  Press(soles_.to_edges, window, problem);
}

/// Solves rows, or finds the solution in the record. @param keeps  whether the record keeps it.
Result<ConstrainedSolution> WindowSolver::SolveRows(ElasticRows& rows, const ElasticStart& start, bool keeps,
                                                    ConstrainedSolution& last) {
  keeps = keeps && record_ != nullptr;
  const std::size_t number = keeps ? record_->Next() : 0;
  if (std::optional<SolvedWindow> kept = keeps ? record_->Find(number) : std::nullopt) {
    last.x = std::move(kept->x);
    last.multipliers = std::move(kept->multipliers);
    last.iterations = kept->iterations;
    last.violations = kept->violations;
    return last;
  }
  const CpuClock clock;
  Result<ConstrainedSolution> solved = SolveElasticRows(rows, start, elastic_, &last);
  work_.cpu_s += clock.elapsed_s();
  const bool usable = solved || last.violation <= kGoodEnough;
  if (keeps && usable) record_->Keep(number, {last.x, last.multipliers, last.iterations, last.violations});
  return solved;
}

std::optional<Failure> WindowSolver::SolveOne(const BodyProblem& problem, const ChainSpline& spline, KnotWindow& window,
                                              BodyMotion& motion) {
  const int knots = window.last - window.first + 1;
  const bool whole = knots == static_cast<int>(problem.time_s.size());
  BodyProblem part = whole ? problem : WindowOf(problem, spline, motion.points, window.first, window.last);
  part.use = window.use;
  const MatrixX points = motion.points.middleCols(window.first, knots + 2);
  std::vector<VectorX> forces(motion.forces.begin() + window.first, motion.forces.begin() + window.last + 1);
  if (part.knots.front().is_given) forces.front().resize(0);
  const VectorX inner_start = Unknowns(points, forces);
  const BodyChoices none;
  std::optional<BodyRows> free;
  std::optional<ChosenRows> tied;  // with the states of cycles that repeat
  const bool repeats = std::ranges::any_of(part.knots, [](const BodyKnot& knot) { return knot.tie.has_value(); });
  if (repeats) {
    tied.emplace(part, none, inner_start);
  } else {
    free.emplace(part, inner_start);
  }
  const VectorX start = repeats ? tied->StartOf(inner_start) : inner_start;
  ElasticRows& rows = repeats ? static_cast<ElasticRows&>(*tied) : *free;
  const BodyRows& inner = repeats ? tied->inner() : *free;
  ConstrainedSolution last;
  const Result<ConstrainedSolution> solved = SolveRows(rows, {start, window.multipliers}, !whole, last);
  work_.iterations += last.iterations;
  violations_ = last.violations;
  work_.variables = std::max(work_.variables, static_cast<int>(start.size()));
  if (!solved && last.violation > kGoodEnough) {
    Failure failure = solved.failure();
    failure.stage = "FinishMotion";
    rows.Evaluate(last.x);
    last_unmet_s_ = inner.TimesUnmet(kGoodEnough);
    failure.message = fmt::format("the whole body cannot follow this plan: {}", failure.message);
    return failure;
  }
  window.multipliers = std::move(last.multipliers);
  // At the seam the points stay exactly as they were.
  const int given = part.knots.front().is_given ? 3 : 0;
  motion.points.middleCols(window.first + given, knots + 2 - given) =
      inner.PointsOf(last.x).rightCols(knots + 2 - given);
  std::vector<VectorX> found = inner.ForcesOf(last.x);
  for (int k = given > 0 ? 1 : 0; k < knots; ++k) motion.forces[Of(window.first + k)] = std::move(found[Of(k)]);
  return std::nullopt;
}

std::optional<Failure> WindowSolver::Solve(BodyProblem& problem, std::vector<KnotWindow>& windows, BodyMotion& motion,
                                           const std::function<void(int done, int all)>& progress) {
  const ChainSpline spline = problem.spline();
  const int usual = windows.front().last - windows.front().first;
  std::optional<Failure> first;
  std::size_t after_failed = 0;  // the window before it has no solution
  unmet_s_.clear();
  for (std::size_t i = 0; i < windows.size();) {
    std::optional<Failure> failure = SolveOne(problem, spline, windows[i], motion);
    if (failure && windows[i].spares_soles && !is_far()) {
      UseSoles(problem, windows[i]);
      failure = SolveOne(problem, spline, windows[i], motion);
    }
    if (failure && windows[i].keeps_room && !is_far()) {
      UseAll(problem, windows[i]);
      failure = SolveOne(problem, spline, windows[i], motion);
    }
    if (!failure) {
      ++i;
      if (progress) progress(static_cast<int>(i), static_cast<int>(windows.size()));
      continue;
    }
    if (i == after_failed || windows[i].last - windows[i - 1].first > kLongest * usual) {
      unmet_s_.insert(unmet_s_.end(), last_unmet_s_.begin(), last_unmet_s_.end());
      if (!first) first = std::move(failure);
      after_failed = ++i;
      continue;
    }
    // Joined with the window before it, which is solved once more, from its own seam on.
    windows[i - 1].last = windows[i].last;
    windows[i - 1].multipliers.resize(0);
    windows.erase(windows.begin() + static_cast<std::ptrdiff_t>(i));
    --i;
    if (windows[i].keeps_room) UseAll(problem, windows[i]);
  }
  std::sort(unmet_s_.begin(), unmet_s_.end());  // windows overlap
  return first;
}

}  // namespace gaitwright
