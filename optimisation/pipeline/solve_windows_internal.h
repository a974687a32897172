// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/numerics/elastic_interior.h"
#include "optimisation/numerics/elastic_rows_internal.h"
#include "optimisation/pipeline/press_soles_internal.h"
#include "optimisation/trajectory/body_problem_internal.h"

namespace gaitwright {

/// [m g, rad, m] that constraints may be off by in a solve that was ended by its iterations.
inline constexpr double kGoodEnough = 1e-4;

/// Options for solving a BodyProblem.
ElasticOptions ElasticOfKnots(int max_iterations);

/// Windows of a long BodyProblem.
struct WindowOptions {
  double length_s = 12.0;  ///< from seam to seam, about
  double overlap_s = 1.5;  ///< by which a window is solved beyond its last seam
};

/// A window: the knots from `first` to `last`. Its result holds up to the next window's first knot, the seam.
struct KnotWindow {
  int first = 0, last = 0;
  BodyLimitUse use;
  bool keeps_room = true;     ///< keeps the room that controllers would like to have
  bool spares_soles = false;  ///< soles use little of their friction; given up before the room
  VectorX multipliers = {};   ///< of its last solution, from which the next solve starts
};

/// Windows over all knots; one if the motion is at most one and a half times as long as a window. Seams are near
/// multiples of the length, at the knots at which most feet press and the motion is slowest.
std::vector<KnotWindow> WindowsOf(const BodyProblem& problem, const WindowOptions& options);

/// A motion of a BodyProblem that is being solved.
struct BodyMotion {
  MatrixX points;               ///< control points, by column
  std::vector<VectorX> forces;  ///< by knot
};

/// Solution of a window, as far as later solves need it.
struct SolvedWindow {
  VectorX x, multipliers;
  int iterations = 0;
  double violations = 0.0;  ///< sum
};

/// Solutions of a motion in several windows, in the order of the solves. A run that was interrupted finds them instead
/// of computing them again, and ends with the same motion, because solves are deterministic.
class SolveRecord {
 public:
  virtual ~SolveRecord() = default;
  /// Nothing if the solve was not kept.
  virtual std::optional<SolvedWindow> Find(std::size_t solve) = 0;
  virtual void Keep(std::size_t solve, const SolvedWindow& solved) = 0;
  /// The number of the next solve, from 0.
  std::size_t Next() { return next_++; }

 private:
  std::size_t next_ = 0;
};

/// What solving took.
struct WindowWork {
  int iterations = 0, variables = 0;
  double cpu_s = 0.0;
};

/// How feet press, by knot, in windows that cannot do with less. Both use all of their friction.
struct WindowSoles {
  PressingByKnot inside;    ///< with the margin to their edges that controllers would like
  PressingByKnot to_edges;  ///< up to their edges, in windows that keep no room
};

/// Solves a problem window by window: cost and memory are linear in its length, but for memory of one window. Each
/// window begins with position, rate and acceleration of the one before it at the seam, so that the joined spline is as
/// smooth as that of one solve.
class WindowSolver {
 public:
  /// @param record  may be null, and must outlive this.
  WindowSolver(const ElasticOptions& elastic, WindowSoles soles, SolveRecord* record = nullptr)
      : elastic_(elastic), soles_(std::move(soles)), record_(record) {}

  /// Solves all windows from the motion on. A window that has no solution is solved again without sparing soles, then
  /// without the room that controllers would like to have, unless it is far from a solution; then it is joined with the
  /// window before it. If that fails too, the motion stays as it was there, and the windows after it are solved all the
  /// same, so that `unmet_s` has all times without a solution. @param windows  are changed like this.
  /// @param progress  called after each window, with its number from 1 on and how many there are.
  /// @return nothing, or the failure of the first window that has no solution.
  std::optional<Failure> Solve(BodyProblem& problem, std::vector<KnotWindow>& windows, BodyMotion& motion,
                               const std::function<void(int done, int all)>& progress);

  const WindowWork& work() const { return work_; }
  /// After a failure: whether the violations that remain are too large to vanish with a little more friction, with all
  /// of the limits, or with links that may touch.
  bool is_far() const { return violations_ > kFarFromSolution * elastic_.infeasible; }
  /// After a failure: times of knots at which constraints stay violated, in order.
  const std::vector<double>& unmet_s() const { return unmet_s_; }

 private:
  std::optional<Failure> SolveOne(const BodyProblem& problem, const ChainSpline& spline, KnotWindow& window,
                                  BodyMotion& motion);
  Result<ConstrainedSolution> SolveRows(ElasticRows& rows, const ElasticStart& start, bool keeps,
                                        ConstrainedSolution& last);
  static void Press(const PressingByKnot& pressing, const KnotWindow& window, BodyProblem& problem);
  void UseSoles(BodyProblem& problem, KnotWindow& window) const;
  void UseAll(BodyProblem& problem, KnotWindow& window) const;

  static constexpr double kFarFromSolution = 3.0;  // times what is infeasible

  const ElasticOptions elastic_;
  const WindowSoles soles_;
  SolveRecord* const record_;
  WindowWork work_;
  double violations_ = 0.0;  // sum, of the last solve
  std::vector<double> unmet_s_, last_unmet_s_;
};

}  // namespace gaitwright
