// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "kinematics/model/robot_model.h"
#include "workflows/grade/marks.h"
#include "workflows/grade/student_python.h"
#include "workflows/grade/submission.h"

namespace gaitwright {

/// What submissions are marked with.
struct MarkingSetup {
  std::uint64_t seed = 0;
  PythonProgram python;  ///< of no account where no part runs code
  bool confined = true;
};

/// Marks one part of a student's submission: a pure function of what was handed in, the rubric and the seed, except
/// where it breaks its limits of time. Whatever was handed in, it ends, and the mark says why.
PartMark MarkPart(const RubricPart& part, const Student& student, const MarkingSetup& setup);

/// The inputs of a part of kind `answers`, as CSV text: a row for each case, a column for each number.
std::string InputsCsv(const RubricPart& part, std::uint64_t seed);

}  // namespace gaitwright
