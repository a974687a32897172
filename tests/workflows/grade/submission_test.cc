// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/submission.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/workflows/grade/made_class.h"

namespace gaitwright {
namespace {

/// A class whose files are read, but not marked.
class SubmissionTest : public MadeClass {
 protected:
  std::string Read(const std::string& file, std::size_t most_bytes = 100) const {
    const Result<std::string> text = ReadSubmission(StudentOf("ada"), file, most_bytes);
    EXPECT_TRUE(text.ok()) << text.failure().message;
    return text.ok() ? *text : "";
  }
  std::string Refusal(const std::string& file, std::size_t most_bytes = 100) const {
    const Result<std::string> text = ReadSubmission(StudentOf("ada"), file, most_bytes);
    EXPECT_FALSE(text.ok()) << file;
    if (text.ok()) return "";
    EXPECT_EQ(text.failure().kind, FailureKind::kBadInput);
    EXPECT_EQ(text.failure().code, FailureCode::kSubmission);
    return text.failure().message;
  }
  Result<std::vector<Student>> Students() const { return FindStudents(In("").string()); }
};

TEST_F(SubmissionTest, StudentsAreTheFoldersByName) {
  for (const char* name : {"zoe", "ada", ".hidden"}) HandIn(name, "work.py", "x = 1\n");
  std::ofstream(In("notes.txt")) << "no folder";
  std::filesystem::create_directory_symlink(In("ada"), In("link"));
  const Result<std::vector<Student>> students = Students();
  ASSERT_TRUE(students.ok()) << students.failure().message;
  ASSERT_EQ(students->size(), 2U);
  EXPECT_EQ(students->at(0).name, "ada");
  EXPECT_EQ(students->at(1).name, "zoe");
  EXPECT_TRUE(std::filesystem::equivalent(students->at(0).folder, In("ada")));
}

TEST_F(SubmissionTest, AClassWithoutFoldersOrWithANameThatIsNoTextIsRefused) {
  const Result<std::vector<Student>> empty = Students(), nowhere = FindStudents(In("nowhere").string());
  ASSERT_FALSE(empty.ok() || nowhere.ok());
  EXPECT_EQ(empty.failure().code, FailureCode::kSubmissions);
  EXPECT_EQ(nowhere.failure().code, FailureCode::kSubmissions);
  HandIn("a\tb", "work.py", "");
  const Result<std::vector<Student>> tab = Students();
  ASSERT_FALSE(tab.ok());
  EXPECT_NE(tab.failure().message.find("a\\x09b"), std::string::npos) << tab.failure().message;
}

TEST_F(SubmissionTest, BytesAreReadAsTheyAreButForTheMarkOfASpreadsheet) {
  HandIn("ada", "a.csv", "\xEF\xBB\xBFx,y\r\n");
  HandIn("ada", "b.csv", "x\xEF\xBB\xBF");
  HandIn("ada", "empty.csv", "");
  EXPECT_EQ(Read("a.csv"), "x,y\r\n");
  EXPECT_EQ(Read("b.csv"), "x\xEF\xBB\xBF") << "elsewhere it is text";
  EXPECT_EQ(Read("empty.csv"), "");
}

TEST_F(SubmissionTest, AFileMayBeAsLargeAsTheLimitAndNoLarger) {
  HandIn("ada", "work.py", std::string(100, 'x'));
  EXPECT_EQ(Read("work.py", 100).size(), 100U);
  EXPECT_EQ(Refusal("work.py", 99), "'work.py' has 100 bytes; at most 99 are accepted");
}

/// Opening a pipe without a writer would block.
TEST_F(SubmissionTest, OnlyAFileIsRead) {
  HandIn("ada", "real.py", "x = 1\n");
  std::filesystem::create_symlink(In("ada") / "real.py", In("ada") / "link.py");
  std::filesystem::create_directory(In("ada") / "folder.py");
  ASSERT_EQ(mkfifo((In("ada") / "pipe.py").c_str(), 0600), 0);
  EXPECT_EQ(Refusal("missing.py"), "'missing.py' was not handed in");
  EXPECT_EQ(Refusal("link.py"), "'link.py' is a link; a file is needed");
  EXPECT_EQ(Refusal("folder.py"), "'folder.py' is a folder; a file is needed");
  EXPECT_EQ(Refusal("pipe.py"), "'pipe.py' is a pipe; a file is needed");
}

TEST_F(SubmissionTest, AFolderThatIsALinkIsNotFollowed) {
  HandIn("bob", "work.py", "x = 1\n");
  std::filesystem::create_directory_symlink(In("bob"), In("ada"));
  EXPECT_EQ(Refusal("work.py"), "'work.py' was not handed in");
}

TEST_F(SubmissionTest, OtherPythonFilesAreThoseThatCanBeReadByName) {
  HandIn("ada", "work.py", "import b\n");
  HandIn("ada", "b.py", "y = 2\n");
  HandIn("ada", "a.py", "x = 1\n");
  HandIn("ada", "notes.txt", "text");
  HandIn("ada", "large.py", std::string(200, '#'));
  std::filesystem::create_symlink(In("ada") / "a.py", In("ada") / "link.py");
  const std::vector<OutputFile> others = OtherPythonFiles(StudentOf("ada"), "work.py", 100);
  ASSERT_EQ(others.size(), 2U);
  EXPECT_EQ(others[0].path, "a.py");
  EXPECT_EQ(others[0].text, "x = 1\n");
  EXPECT_EQ(others[1].path, "b.py");
  EXPECT_TRUE(OtherPythonFiles(StudentOf("nobody"), "work.py", 100).empty());
}

TEST_F(SubmissionTest, AtMostAHundredOtherFilesAreTaken) {
  for (int k = 0; k < 105; ++k) HandIn("ada", "m" + std::to_string(1000 + k) + ".py", "");
  const std::vector<OutputFile> others = OtherPythonFiles(StudentOf("ada"), "work.py", 100);
  ASSERT_EQ(others.size(), 100U);
  EXPECT_EQ(others.back().path, "m1099.py") << "the first ones by name";
}

}  // namespace
}  // namespace gaitwright
