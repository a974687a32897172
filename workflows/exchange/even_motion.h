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
  std::vector<VectorX> tau;                   ///< as in the file, NaN if missing; or empty
  std::vector<FootSet> contact;               ///< as in the file, or empty
  std::vector<std::vector<Vector3>> force_W;  ///< as in the file, or empty

  int size() const { return static_cast<int>(q.size()); }
  /// Time of a row after the first row [s].
  double TimeOf(int row) const { return row * step_s; }
};

/// Resamples a table onto a uniform grid. The base follows cubic splines through its positions and the components of
/// its quaternion; joints follow cubic splines through their positions. If the file's joint velocities are used, joints
/// follow quintics through the file's positions and velocities, with accelerations from the derivative of a spline
/// through the velocities. If the grid is the file's own, the file's base velocities and accelerations are used if they
/// are consistent with the motion. Torques and forces are interpolated linearly; contacts hold from their row on,
/// rounded to the grid. A rest of less than one step after the last row of the grid is left out, because a curve to
/// rest there would jump. `derived` describes the method; `warnings` reports gaps and noise that would degrade
/// accelerations.
/// @param table  checked, with base and quaternions. @throws InvalidArgument for options out of range, and for more
///               than kMostGridRows rows.
EvenMotion Resample(const RobotModel& model, const MotionTable& table, const ImportOptions& options,
                    std::vector<DerivedPart>& derived, std::vector<std::string>& warnings);

/// The step of the grid for a table [s]: the step of the table if it is uniform (its last step may be shorter).
double GridStepOf(const std::vector<double>& time_s, const ImportOptions& options);

}  // namespace gaitwright
