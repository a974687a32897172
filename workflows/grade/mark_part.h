// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "kinematics/model/robot_model.h"
#include "workflows/grade/marks.h"
#include "workflows/grade/student_python.h"
#include "workflows/grade/submission.h"

namespace gaitwright {

/// Tools for marking submissions.
struct MarkingSetup {
  std::uint64_t seed = 0;
  PythonProgram python;  ///< unused if no part runs code
  bool confined = true;
};

/// Marks one part of a student's submission: a pure function of the submission, the rubric and the seed, except if time
/// limits are exceeded. It ends for every submission, and the mark gives the reason.
PartMark MarkPart(const RubricPart& part, const Student& student, const MarkingSetup& setup);

/// The inputs of a part of kind `answers`, as CSV text: one row for each case, one column for each number.
std::string InputsCsv(const RubricPart& part, std::uint64_t seed);

}  // namespace gaitwright
