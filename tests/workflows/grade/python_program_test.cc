// SPDX-License-Identifier: BSD-3-Clause
// Python interpreters for submissions.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/scratch_folder.h"
#include "workflows/grade/student_python.h"

namespace gaitwright {
namespace {

/// A program that is a shell script.
std::string ShellProgram(const std::string& name, const std::string& script) {
  std::string path = ScratchFile(name);
  std::ofstream(path) << "#!/bin/sh\n" << script << "\n";
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

void ExpectNoPython(const std::string& program, const std::string& part) {
  const Result<PythonProgram> found = LookOver(program);
  ASSERT_FALSE(found.ok()) << program;
  EXPECT_EQ(found.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(found.failure().code, FailureCode::kPython);
  EXPECT_NE(found.failure().message.find(part), std::string::npos) << found.failure().message;
}

TEST(PythonProgram, WhatIsNotAPythonIsRefused) {
  ExpectNoPython("no-such-python", "there is no Python 'no-such-python'");
  ExpectNoPython(ShellProgram("talks", "echo hello >&2"), "is not Python 3: it printed 'hello");
  ExpectNoPython(ShellProgram("fails", "exit 3"), "");
}

TEST(PythonProgram, OneThatIsTooOldIsRefusedWithItsVersion) {
  const std::string output =
      "echo '{\"version\": [3, 8, 2], \"path\": \"/x\", \"readable\": [], \"package\": \"\", \"numpy\": false}' >&2";
  ExpectNoPython(ShellProgram("old", output), "is Python 3.8.2; 3.9 or newer is needed");
}

TEST(PythonProgram, WhatItTellsOfItselfIsTaken) {
  const std::string output =
      "echo 'a warning' >&2; echo '{\"version\": [3, 12, 1], \"path\": \"/opt/py\", \"readable\": [\"/opt/lib\"], "
      "\"package\": \"\", \"numpy\": true}' >&2";
  const Result<PythonProgram> found = LookOver(ShellProgram("new", output));
  ASSERT_TRUE(found.ok()) << found.failure().message;
  EXPECT_EQ(found->version, "3.12.1");
  EXPECT_EQ(found->path, "/opt/py");
  EXPECT_TRUE(found->has_numpy);
  EXPECT_EQ(found->package, "");
  ASSERT_FALSE(found->readable.empty());
  EXPECT_EQ(found->readable.front(), "/opt/lib");
  EXPECT_NE(std::find(found->readable.begin(), found->readable.end(), "/usr/lib"), found->readable.end());
}

TEST(PythonProgram, WithoutThePackageNothingHasToBeReadable) { EXPECT_EQ(UnreadableForNobody({}), ""); }

}  // namespace
}  // namespace gaitwright
