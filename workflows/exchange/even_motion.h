// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// A motion on a uniform grid that begins at zero, with exact derivatives of smooth curves through its rows.
struct EvenMotion {
  double step_s = 0.0;
  std::vector<VectorX> q, v, a;               ///< in the model's order, sizes 7 + n and 6 + n
  std::vector<VectorX> tau;                   ///< as given, NaN if missing; or empty
  std::vector<FootSet> contact;               ///< as given, or empty
  std::vector<std::vector<Vector3>> force_W;  ///< as given, or empty

  int size() const { return static_cast<int>(q.size()); }
  /// Time of a row since the first [s].
  double TimeOf(int row) const { return row * step_s; }
};

/// Brings a table onto a uniform grid. The base goes along cubic splines through its positions and the parts of its
/// quaternion, joints likewise; or, where their velocities are given and taken, along the quintic that has the file's
/// positions and velocities, and for accelerations the derivative of a spline through the velocities. If the grid is
/// the file's own, the file's base velocities and accelerations are used if they are consistent with the motion.
/// Torques and forces are linear in between; contacts hold from the row on that has them, to the grid. The rest after
/// the grid's last row, less than one step, is left out, because a curve to rest there would jump. The method is
/// described in `derived`; noise that would degrade accelerations, and gaps, in `warnings`.
/// @param table  checked, with base and quaternions.  @throws InvalidArgument for options out of their range, and more
/// than kMostGridRows rows.
EvenMotion Resample(const RobotModel& model, const MotionTable& table, const ImportOptions& options,
                    std::vector<DerivedPart>& derived, std::vector<std::string>& warnings);

/// The step of the grid that a table gets [s]: its own step if uniform; the last step may be shorter.
double GridStepOf(const std::vector<double>& time_s, const ImportOptions& options);

}  // namespace gaitwright
