// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "workflows/grade/mark_part.h"

namespace gaitwright {

/// A class in a new folder that is deleted after the test.
class MadeClass : public testing::Test {
 protected:
  MadeClass();
  ~MadeClass() override;

  /// Submits a file.
  void HandIn(const std::string& student, const std::string& file, const std::string& text) const;
  std::filesystem::path In(const std::string& name) const { return folder_ / name; }
  Student StudentOf(const std::string& name) const { return {name, (folder_ / name).string()}; }

  /// The mark of the first part of a rubric.
  PartMark Mark(const std::string& part_yaml, const std::string& student, std::uint64_t seed = 7) const;
  /// The mark of the first part for code in the only submitted file, `work.py`.
  PartMark MarkCode(const std::string& part_yaml, const std::string& code, std::uint64_t seed = 7) const;

 private:
  std::filesystem::path folder_;
};

/// The first part of a rubric. @throws std::logic_error for a rubric that is refused.
RubricPart PartOf(const std::string& part_yaml);

/// Whether Python submissions can be run confined on this machine; with `package`, those that use the Python package.
/// Tests that need this are skipped if the kernel cannot confine processes or user nobody cannot read this build. If a
/// build with Python finds no suitable Python, the test fails.
bool CanRunCode(bool package = false);

/// Process numbers and names of the child processes of this process that have not been waited for, such as
/// "71 (python3)".
std::set<std::string> ChildProcesses();

/// Processes whose environment contains this word, as far as this user can read it.
int ProcessesWith(const std::string& word);

/// Expects no points, and a reason that contains each of `words`.
void ExpectNothing(const PartMark& mark, const std::vector<std::string>& words);

}  // namespace gaitwright
