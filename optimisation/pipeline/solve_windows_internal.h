// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/numerics/elastic_interior.h"
#include "optimisation/trajectory/body_problem_internal.h"

namespace gaitwright {

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
};

/// Windows over all knots; one if the motion is at most one and a half times as long as a window. Seams are near
/// multiples of the length, at the knots at which most feet press and the motion is slowest.
std::vector<KnotWindow> WindowsOf(const BodyProblem& problem, const WindowOptions& options);

/// A motion of a BodyProblem that is being solved.
struct BodyMotion {
  MatrixX points;               ///< control points, by column
  std::vector<VectorX> forces;  ///< by knot
};

/// What solving took.
struct WindowWork {
  int iterations = 0, variables = 0;
  double cpu_s = 0.0;
};

/// Solves a problem window by window: cost and memory are linear in its length, but for memory of one window. Each
/// window begins with position, rate and acceleration of the one before it at the seam, so that the joined spline is as
/// smooth as that of one solve.
class WindowSolver {
 public:
  /// @param to_edges  by knot: soles that press up to their edges with all their friction, for windows that cannot
  /// spare soles or keep room.
  WindowSolver(const ElasticOptions& elastic, std::vector<std::vector<PressingFoot>> to_edges)
      : elastic_(elastic), to_edges_(std::move(to_edges)) {}

  /// Solves all windows from the motion on. A window that has no solution is solved again without sparing soles, then
  /// without the room that controllers would like to have, then joined with the window before it. @param windows  are
  /// changed like this.
  /// @param progress  called after each window, with its number from 1 on and how many there are.
  /// @return nothing, or the failure of a window.
  std::optional<Failure> Solve(BodyProblem& problem, std::vector<KnotWindow>& windows, BodyMotion& motion,
                               const std::function<void(int done, int all)>& progress);

  const WindowWork& work() const { return work_; }
  /// After a failure: times of knots at which constraints stay violated, in order.
  const std::vector<double>& unmet_s() const { return unmet_s_; }

 private:
  std::optional<Failure> SolveOne(const BodyProblem& problem, const ChainSpline& spline, const KnotWindow& window,
                                  BodyMotion& motion);
  void UseSoles(BodyProblem& problem, KnotWindow& window) const;
  void UseAll(BodyProblem& problem, KnotWindow& window) const;

  const ElasticOptions elastic_;
  const std::vector<std::vector<PressingFoot>> to_edges_;
  WindowWork work_;
  std::vector<double> unmet_s_;
};

}  // namespace gaitwright
