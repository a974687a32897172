// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "workflows/exchange/import_motion.h"

namespace gaitwright {

/// The text of a motion file of other software.
struct MotionText {
  std::string text;
  bool is_csv = false;         ///< columns of numbers
  bool is_npz = false;         ///< arrays of NumPy; otherwise YAML or JSON, unless is_csv
  bool has_footsteps = false;  ///< footsteps, for which a motion has to be planned
};

/// Reads the file of a request. Failure kBadInput for an unknown type, for a file of this program, and for --columns
/// with another file than a CSV.
Result<MotionText> ReadMotionText(const ImportRequest& request);

/// The motion in a text without footsteps. `request` gets the units of its file of column names.
Result<MotionTable> ReadMotionTable(const RobotModel& model, const MotionText& text, ImportRequest& request);

/// A motion on a uniform grid, with a base: checked, smoothed where its frames are far apart, and with the base derived
/// from the feet if the file has none. @throws InvalidArgument for a motion that is probably misinterpreted.
EvenMotion EvenMotionOf(const RobotModel& model, const Terrain& terrain, const ImportOptions& options,
                        MotionTable table, ImportNotes& notes);

Failure RefusedMotion(const std::string& file, const std::string& why);

}  // namespace gaitwright
