// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "workflows/grade/mark_part.h"

namespace gaitwright {

/// A class in a folder of its own, that goes with the test.
class MadeClass : public testing::Test {
 protected:
  MadeClass();
  ~MadeClass() override;

  /// Hands a file in.
  void HandIn(const std::string& student, const std::string& file, const std::string& text) const;
  std::filesystem::path In(const std::string& name) const { return folder_ / name; }
  Student StudentOf(const std::string& name) const { return {name, (folder_ / name).string()}; }

  /// The mark of one part, of a rubric that has it as its first.
  PartMark Mark(const std::string& part_yaml, const std::string& student, std::uint64_t seed = 7) const;
  /// The same of code in a file `work.py`, handed in by itself.
  PartMark MarkCode(const std::string& part_yaml, const std::string& code, std::uint64_t seed = 7) const;

 private:
  std::filesystem::path folder_;
};

/// The part that a rubric has first. @throws std::logic_error for a rubric that is refused.
RubricPart PartOf(const std::string& part_yaml);

/// Whether Python submissions can be run confined here, with `package` those that may use the Python package too. Tests
/// that need it are skipped where the kernel cannot confine, or nobody may read this build; that a build with Python
/// has no Python that serves is a failure of the test that asks.
bool CanRunCode(bool package = false);

/// Processes whose environment has that word, as far as one may see it.
int ProcessesWith(const std::string& word);

/// Expects no points, and a reason that says each of `words`.
void ExpectNothing(const PartMark& mark, const std::vector<std::string>& words);

}  // namespace gaitwright
