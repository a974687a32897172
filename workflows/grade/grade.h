// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "workflows/grade/mark_part.h"

namespace gaitwright {

/// What is graded.
struct GradeRequest {
  Rubric rubric;
  std::string rubric_file, folder;  ///< where it is read from; where the students' folders are
  std::string out_folder;
  std::string python;  ///< LookOver
  std::uint64_t seed = 0;
  bool unconfined = false;  ///< runs code where it cannot be confined
};

/// How far it is, and whether to end.
struct GradeHooks {
  std::function<void(int done, int all, const std::string& student)> progress = {};
  std::function<bool()> stop = {};
};

/// The marks of a class.
struct ClassMarks {
  std::string title;
  std::uint64_t seed = 0;
  bool confined = true;
  std::vector<std::string> parts;  ///< names
  double of = 0.0;
  std::vector<StudentMarks> students;  ///< by name
};

/// Grades every submission. The marks are a pure function of the submissions, the rubric and the seed, except of code
/// that breaks its limits of time. `written`, where it is given, gets the pages of each student as soon as they are
/// marked.
/// Failure, before anything is run: the rubric asks for what there is not; code cannot be confined on this machine
/// (`unconfined_only`) or by this Python, since it could read what lies in `folder` or beside the rubric (`readable`);
/// as of FindStudents and LookOver; or `interrupted`.
Result<ClassMarks> GradeClass(const GradeRequest& request, const GradeHooks& hooks,
                              const std::function<Result<std::string>(const std::vector<OutputFile>&)>& written);

/// The table: student, a column for each part, total, of. Texts that a spreadsheet would take for a formula begin with
/// an apostrophe; all are in quotes.
std::string GradesCsv(const ClassMarks& marks);

/// As JSON (docs/json-output.md), without "files".
std::string GradesJson(const ClassMarks& marks);

/// The name of a student's page: of plain characters, and no other student's. `number` is that of the student.
std::string PageNameOf(const std::string& student, std::size_t number);

/// The page of a student, with what was lost and why, and those of motions that were played. Whole by themselves;
/// whatever comes from a submission is text in them.
/// @return names within the folder of the grades, and texts.
std::vector<OutputFile> StudentPages(const ClassMarks& marks, const StudentMarks& student, std::size_t number);

/// The page that lists all students.
std::string ClassPage(const ClassMarks& marks);

}  // namespace gaitwright
