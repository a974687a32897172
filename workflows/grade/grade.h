// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "workflows/grade/mark_part.h"

namespace gaitwright {

/// Inputs of grading.
struct GradeRequest {
  Rubric rubric;
  std::string rubric_file, folder;  ///< path of the rubric; folder of the students' folders
  std::string out_folder;
  std::string python;  ///< Python interpreter, see LookOver
  std::uint64_t seed = 0;
  bool unconfined = false;  ///< true: run code even if it cannot be confined
};

/// Callbacks for progress and for a request to stop.
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

/// Grades every submission. The marks are a pure function of the submissions, the rubric and the seed, except for code
/// that exceeds its time limits. `written`, if given, receives the pages of each student as soon as they are marked.
/// Failure, before anything runs: the rubric names something that does not exist; code cannot be confined on this
/// machine (`unconfined_only`) or with this Python, because it could read files in `folder` or beside the rubric
/// (`readable`); as of FindStudents and LookOver; or `interrupted`.
Result<ClassMarks> GradeClass(const GradeRequest& request, const GradeHooks& hooks,
                              const std::function<Result<std::string>(const std::vector<OutputFile>&)>& written);

/// The table of grades as CSV: student, a column for each part, total, of. All texts are quoted; a text that a
/// spreadsheet would read as a formula begins with an apostrophe.
std::string GradesCsv(const ClassMarks& marks);

/// The grades as JSON (docs/json-output.md), without "files".
std::string GradesJson(const ClassMarks& marks);

/// The name of a student's page: plain characters, unique. `number` is the student's number.
std::string PageNameOf(const std::string& student, std::size_t number);

/// The page of a student, with lost points and reasons, and the pages of played motions. Self-contained; content of a
/// submission appears only as text.
/// @return names within the folder of grades, and texts.
std::vector<OutputFile> StudentPages(const ClassMarks& marks, const StudentMarks& student, std::size_t number);

/// The page that lists all students.
std::string ClassPage(const ClassMarks& marks);

}  // namespace gaitwright
