// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"

namespace gaitwright {

/// A student: folder name and path.
struct Student {
  std::string name, folder;
};

/// The students of a class: one for each folder in `folder`, sorted by name; links and names that begin with a dot are
/// ignored. Failure: the folder does not exist, contains no folder or more than 10,000, or a name is not plain text.
Result<std::vector<Student>> FindStudents(const std::string& folder);

/// Reads the bytes of a submitted file. Links are not followed, and reading never blocks. Failure `submission`, with a
/// message for the student: the file does not exist; it is a link, a folder, a pipe or a device; it is too large.
Result<std::string> ReadSubmission(const Student& student, const std::string& file, std::size_t most_bytes);

/// The student's other Python files, which this file may import; files that ReadSubmission refuses are left out, and so
/// are files beyond 100.
std::vector<OutputFile> OtherPythonFiles(const Student& student, const std::string& file, std::size_t most_bytes);

}  // namespace gaitwright
