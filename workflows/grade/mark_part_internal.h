// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/grade/mark_part.h"

namespace gaitwright {

/// A file of a submission, if it was submitted.
struct HandedIn {
  const RubricPart& part;
  const Student& student;
  const MarkingSetup& setup;
  std::string text;  ///< text of the part's file
};

PartMark MarkFunction(const HandedIn& in);
PartMark MarkAnswers(const HandedIn& in);
PartMark MarkPlan(const HandedIn& in);
PartMark MarkMotionFile(const HandedIn& in);
PartMark MarkParameters(const HandedIn& in);
PartMark MarkPlanner(const HandedIn& in);
PartMark MarkController(const HandedIn& in);

/// Largest size of a part's file in bytes.
std::size_t MostBytes(const RubricPart& part);

/// Starts the code of a submission. Failure as of StudentPython.
Result<StudentPython> StartCode(const HandedIn& in);

/// Reason for a failure of a submission's code: "the submission was stopped: ...", or its own message.
std::string ReasonOf(const Failure& failure);

}  // namespace gaitwright
