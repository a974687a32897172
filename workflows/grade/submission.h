// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"

namespace gaitwright {

/// A student: the name of a folder, and where it is.
struct Student {
  std::string name, folder;
};

/// The students of a class: one for each folder in `folder`, sorted by name; links and names that begin with a dot are
/// passed over. Failure: no such folder, none in it, more than 10,000, or a name that is no plain text.
Result<std::vector<Student>> FindStudents(const std::string& folder);

/// The bytes of a file that was handed in. Links are not followed and nothing is waited for. Failure `submission`, in
/// words for the student: there is no such file; it is a link, a folder, a pipe or a device; it is too large.
Result<std::string> ReadSubmission(const Student& student, const std::string& file, std::size_t most_bytes);

/// The other files in Python of a student, which that file may import; what ReadSubmission refuses is left out, and so
/// are those beyond 100.
std::vector<OutputFile> OtherPythonFiles(const Student& student, const std::string& file, std::size_t most_bytes);

}  // namespace gaitwright
