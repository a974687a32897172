// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "optimisation/pipeline/plan_motion.h"
#include "optimisation/trajectory/chosen_rows_internal.h"
#include "optimisation/whole_body/finish_problem_internal.h"

namespace gaitwright {

/// What ChooseContacts did.
struct ChosenContacts {
  int iterations = 0;
  double solve_cpu_s = 0.0;
  double shortest = 1.0, longest = 1.0;  ///< new duration of a phase over the old one: least and largest
  double largest_shift_m = 0.0;          ///< of a foothold
  int swings = 0;                        ///< with new paths
  std::string summary;                   ///< one line; empty if nothing is to be chosen
};

/// Chooses contact times (options.timing), footholds (options.footholds) and paths of swings (options.swings) of a plan
/// together with the motion of its whole body and the contact forces: one solve of a BodyProblem with the pace of its
/// time and shifts of footholds as unknowns, in which swing feet may leave their paths. Footholds of the start and the
/// end, and those on height fields, stay. The total duration stays; times of contact are rounded to the plan's rows.
/// Swings of motions that turn over stay.
/// @return a plan whose contacts are chosen and whose motion is near a solution, for FinishMotion; the plan itself if
/// nothing is to be chosen or nothing was found.
MotionPlan ChooseContacts(const RobotModel& model, const MotionPlan& plan, const TrajectoryOptions& options,
                          const FinishSettings& settings, ChosenContacts& chosen);

/// New time over a problem's time at a pace, and the reverse.
class PacedTimes {
 public:
  /// @param row_s  the new duration is a multiple of this; an error of less than half of it is spread evenly.
  PacedTimes(const PaceSpline& pace, double start_s, double end_s, double row_s);

  double New(double problem_s) const;
  double Old(double new_s) const;
  /// New(), rounded to a row.
  double NewRow(double problem_s) const;
  int rows() const { return rows_; }

 private:
  double start_s_, step_s_, row_s_;
  int rows_ = 0;
  std::vector<double> new_s_;  // at even steps of the problem's time
};

}  // namespace gaitwright
