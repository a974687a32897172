// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/import_motion.h"

namespace gaitwright {

/// Forms of motion files.
enum class MotionForm {
  kCsv,        ///< columns of numbers
  kNpz,        ///< arrays of NumPy
  kRecording,  ///< messages of ROS 2
  kBvh,        ///< a skeleton and its motion
  kTree,       ///< YAML or JSON with a trajectory or frames
  kFootsteps,  ///< YAML with footsteps, for which a motion has to be planned
};

/// The contents of a motion of other software.
struct MotionText {
  std::string text;
  MotionForm form = MotionForm::kTree;
  std::vector<std::string> further = {};  ///< contents of the other files of a recording

  std::string Hash() const;
};

/// Reads the file of a request, or the folder of a recording. Failure kBadInput for an unknown type, for a file of this
/// program, and for --columns with another file than a CSV.
Result<MotionText> ReadMotionText(const ImportRequest& request);

/// The endings of the files that are read, in lower case.
const std::vector<std::string>& MotionEndings();

/// The motion in a text without footsteps. `request` gets the units of its file of column names.
Result<MotionTable> ReadMotionTable(const RobotModel& model, const MotionText& text, ImportRequest& request);

/// A motion on a uniform grid, with a base: checked, smoothed where its frames are far apart, and with the base derived
/// from the feet if the file has none. @throws InvalidArgument for a motion that is probably misinterpreted.
EvenMotion EvenMotionOf(const RobotModel& model, const Terrain& terrain, const ImportOptions& options,
                        MotionTable table, ImportNotes& notes);

/// The failure of a file that cannot be read as a motion: kBadInput `import`, with the file's name before the reason.
Failure RefusedMotion(const std::string& file, const std::string& why);

}  // namespace gaitwright
