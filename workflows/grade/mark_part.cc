// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/mark_part.h"

#include <fmt/format.h>

#include "workflows/grade/mark_part_internal.h"
#include "workflows/grade/motion_run.h"

namespace gaitwright {
namespace {

PartMark MarkByKind(const HandedIn& in) {
  switch (in.part.kind) {
    case RubricPartKind::kFunction:
      return MarkFunction(in);
    case RubricPartKind::kAnswers:
      return MarkAnswers(in);
    case RubricPartKind::kPlan:
      return MarkPlan(in);
    case RubricPartKind::kMotion:
      return MarkMotionFile(in);
    case RubricPartKind::kParameters:
      return MarkParameters(in);
    case RubricPartKind::kPlanner:
      return MarkPlanner(in);
    default:
      return MarkController(in);
  }
}

}  // namespace

std::size_t MostBytes(const RubricPart& part) { return static_cast<std::size_t>(part.limits.file_mb) << 20; }

Result<StudentPython> StartCode(const HandedIn& in) {
  StudentCode code{{{in.part.file, in.text}}, in.part.function, in.part.package};
  for (OutputFile& other : OtherPythonFiles(in.student, in.part.file, MostBytes(in.part)))
    code.files.push_back(std::move(other));
  return StudentPython::Start(in.setup.python, code, in.part.limits, in.setup.confined);
}

std::string ReasonOf(const Failure& failure) {
  return EndedIt(failure) ? "the submission was stopped: " + failure.message
                          : "the submission says: " + failure.message;
}

PartMark MarkPart(const RubricPart& part, const Student& student, const MarkingSetup& setup) {
  Result<std::string> text = ReadSubmission(student, part.file, MostBytes(part));
  if (!text) return NothingFor(part, text.failure().message);
  if (text->find_first_not_of(" \t\r\n") == std::string::npos)
    return NothingFor(part, fmt::format("'{}' is empty", part.file));
  try {
    return MarkByKind({part, student, setup, std::move(*text)});
  } catch (const InvalidArgument& error) {
    return NothingFor(part, ShownWords(error.what()));
  } catch (const BrokenCode& error) {
    return NothingFor(part, ShownWords(error.what()));
  }
}

}  // namespace gaitwright
