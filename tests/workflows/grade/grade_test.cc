// SPDX-License-Identifier: BSD-3-Clause
// A whole class: its table, its pages, and failures before marking.
#include "workflows/grade/grade.h"

#include <fmt/format.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cstddef>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/workflows/grade/made_class.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

const std::string kRubric =
    "title: \"<b>DCM</b>\"\nparts:\n- {name: dcm, kind: answers, file: dcm.csv, points: 4, reference: dcm, cases: 4}\n";
const std::string kCode =
    "title: t\nparts:\n- {name: dcm, kind: function, file: work.py, points: 4, reference: dcm, cases: 4}\n";
const std::string kRight = "def dcm(c, v, h):\n    return c[:2] + v[:2] * (h / 9.81) ** 0.5\n";

class GradeClassTest : public MadeClass {
 protected:
  GradeRequest RequestFor(const std::string& rubric) const {
    GradeRequest request;
    request.rubric = ReadRubric(rubric, "r.yaml").value();
    request.rubric_file = In("rubric.yaml").string();
    request.folder = In("class").string();
    request.out_folder = In("grades").string();
    request.seed = 7;
    return request;
  }
  /// The marks; pages are kept in `pages_`.
  Result<ClassMarks> Grade(const GradeRequest& request) {
    pages_.clear();
    return GradeClass(request, {}, [&](const std::vector<OutputFile>& files) -> Result<std::string> {
      pages_.insert(pages_.end(), files.begin(), files.end());
      return std::string();
    });
  }

  std::vector<OutputFile> pages_;
};

TEST_F(GradeClassTest, EachStudentHasARowAndAPage) {
  HandIn("class/bob", "dcm.csv", "case,answer_0,answer_1\n0,1,2\n");
  HandIn("class/ada", "other.csv", "");
  HandIn("class/.hidden", "dcm.csv", "");
  fs::create_directory_symlink(In("class") / "bob", In("class") / "zoe");
  const Result<ClassMarks> marks = Grade(RequestFor(kRubric));
  ASSERT_TRUE(marks.ok()) << marks.failure().message;
  EXPECT_EQ(GradesCsv(*marks), "\"student\",\"dcm\",\"total\",\"of\"\n\"ada\",0,0,4\n\"bob\",0,0,4\n");
  ASSERT_EQ(pages_.size(), 2U);
  EXPECT_EQ(pages_[0].path, "001-ada.html");
  EXPECT_NE(pages_[0].text.find("dcm.csv&#39; was not handed in"), std::string::npos) << pages_[0].text;
  EXPECT_NE(ClassPage(*marks).find("<a href=\"002-bob.html\">bob</a>"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(GradesJson(*marks))["students"][1]["page"], "002-bob.html");
}

TEST_F(GradeClassTest, ATableOfASpreadsheetIsReadLikeAnyOther) {
  const std::string table = "case,answer_0,answer_1\n0,1,2\n";
  HandIn("class/bob", "dcm.csv", "\xEF\xBB\xBF" + table);
  Grade(RequestFor(kRubric)).value();
  const std::string marked = pages_[0].text;
  HandIn("class/bob", "dcm.csv", table);
  Grade(RequestFor(kRubric)).value();
  EXPECT_EQ(pages_[0].text, marked);
}

TEST_F(GradeClassTest, TheSameSeedGivesTheSameBytes) {
  HandIn("class/bob", "dcm.csv", "case,answer_0,answer_1\n0,1,2\n");
  const std::string one = GradesJson(Grade(RequestFor(kRubric)).value());
  const std::string page = pages_[0].text;
  EXPECT_EQ(GradesJson(Grade(RequestFor(kRubric)).value()), one);
  EXPECT_EQ(pages_[0].text, page);
}

TEST_F(GradeClassTest, AFolderWhoseNameCannotBeShownIsNamedByItsBytes) {
  HandIn("class/bob", "dcm.csv", "case,answer_0,answer_1\n0,1,2\n");
  HandIn("class/a\nb\xff", "dcm.csv", "");
  const Result<ClassMarks> marks = Grade(RequestFor(kRubric));
  ASSERT_FALSE(marks.ok());
  EXPECT_NE(marks.failure().message.find("the folder 'a\\x0ab\\xff' in "), std::string::npos)
      << marks.failure().message;
}

TEST_F(GradeClassTest, NamesAreNoFormulasAndNoMarkup) {
  for (const char* name : {"=cmd|' -C calc'!A0", "+1", "-1", "@SUM(A1)", "<script>alert(1)<\\script>", "a\"b,c"})
    HandIn(std::string("class/") + name, "dcm.csv", "<script>,=1+1\n1,2\n");
  const Result<ClassMarks> marks = Grade(RequestFor(kRubric));
  ASSERT_TRUE(marks.ok());
  const std::string csv = GradesCsv(*marks);
  for (const char* cell : {"\"'=cmd|", "\"'+1\"", "\"'-1\"", "\"'@SUM(A1)\"", "\"a\"\"b,c\""})
    EXPECT_NE(csv.find(cell), std::string::npos) << cell << " in " << csv;
  pages_.push_back({"index", ClassPage(*marks)});
  for (const OutputFile& page : pages_) {
    EXPECT_EQ(page.text.find("<script"), std::string::npos) << page.path;
    EXPECT_EQ(page.text.find("<b>DCM"), std::string::npos) << page.path;
    EXPECT_NE(page.text.find("default-src 'none'"), std::string::npos) << page.path;
    EXPECT_EQ(page.path.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-."),
              std::string::npos);
  }
}

/// Other tests of code are skipped if it cannot be confined; this test checks that nothing runs in that case.
TEST_F(GradeClassTest, CodeIsRunConfinedOrNotAtAll) {
  HandIn("class/ada", "work.py", kRight);
  const Result<ClassMarks> marks = Grade(RequestFor(kCode));
  if (CanRunCode()) {
    ASSERT_TRUE(marks.ok()) << marks.failure().message;
    EXPECT_TRUE(marks->confined);
    EXPECT_EQ(marks->students[0].points(), 4.0);
    return;
  }
  ASSERT_FALSE(marks.ok());
  EXPECT_TRUE(marks.failure().code == FailureCode::kUnconfinedOnly || marks.failure().code == FailureCode::kPython)
      << marks.failure().message;
  EXPECT_TRUE(pages_.empty());
}

TEST_F(GradeClassTest, WordsOfASubmissionAreTextInItsPage) {
  if (!CanRunCode()) GTEST_SKIP() << ReasonNotConfined();
  HandIn("class/eve", "work.py", "raise ValueError('<img src=x onerror=alert(1)>\\n\\x1b[2J' + str(object()))\n");
  ASSERT_TRUE(Grade(RequestFor(kCode)).ok());
  const std::string& page = pages_[0].text;
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find('\x1b'), std::string::npos);
  EXPECT_NE(page.find("&lt;img src=x"), std::string::npos);
  EXPECT_NE(page.find("object at 0x...&gt;"), std::string::npos) << page;
}

TEST_F(GradeClassTest, WhatTheRubricAsksForIsThereBeforeAnythingIsMarked) {
  HandIn("class/ada", "t.yaml", "");
  const std::string head =
      "title: t\nparts:\n- {name: p, file: t.yaml, points: 1, robot: a1, checks: [{measure: pass, points: 1}], ";
  const auto refused = [&](const std::string& rest) { return Grade(RequestFor(head + rest)).failure().message; };
  EXPECT_NE(refused("kind: parameters, terrain: stars}\n").find("part 'p' of the rubric"), std::string::npos);
  EXPECT_NE(refused("kind: parameters, terrain: {name: stairs, rise_m: [0.1, 99]}}\n").find("rise_m"),
            std::string::npos);
  EXPECT_NE(refused("kind: parameters, command: {distance_m: 1, duration_s: 2}}\n").find("each set the distance"),
            std::string::npos);
  EXPECT_NE(refused("kind: plan, command: {steps: 4}}\n").find("does not set a goal"), std::string::npos);
  EXPECT_TRUE(pages_.empty());
}

TEST_F(GradeClassTest, GradesDoNotLieAmongTheSubmissions) {
  HandIn("class/ada", "dcm.csv", "");
  GradeRequest request = RequestFor(kRubric);
  request.out_folder = In("class/grades").string();
  EXPECT_EQ(Grade(request).failure().code, FailureCode::kOutDir);
}

/// Messages do not contain the name of the temporary folder, which differs in each run.
TEST_F(GradeClassTest, WordsOfASubmissionAreTheSameAgain) {
  if (!CanRunCode()) GTEST_SKIP() << ReasonNotConfined();
  HandIn("class/eve", "work.py", "import os\nopen(os.environ['HOME'] + '/none')\n");
  ASSERT_TRUE(Grade(RequestFor(kCode)).ok());
  const std::string page = pages_[0].text;
  EXPECT_NE(page.find("&#39;work/none&#39;"), std::string::npos) << page;
  ASSERT_TRUE(Grade(RequestFor(kCode)).ok());
  EXPECT_EQ(pages_[0].text, page);
}

TEST_F(GradeClassTest, AClassWithoutStudentsIsRefused) {
  EXPECT_EQ(Grade(RequestFor(kRubric)).failure().code, FailureCode::kSubmissions);
  fs::create_directories(In("class"));
  EXPECT_NE(Grade(RequestFor(kRubric)).failure().message.find("no folder of a student"), std::string::npos);
}

TEST_F(GradeClassTest, NothingThatIsHiddenLiesWhereCodeReads) {
  if (!CanRunCode()) GTEST_SKIP() << ReasonNotConfined();
  HandIn("class/ada", "work.py", "");
  GradeRequest request = RequestFor(kCode);
  request.rubric_file = "/usr/lib/rubric.yaml";
  EXPECT_EQ(Grade(request).failure().code, FailureCode::kReadable);
  EXPECT_NE(Grade(request).failure().message.find("'/usr/lib/rubric.yaml' is inside '/usr/lib'"), std::string::npos);
}

TEST_F(GradeClassTest, AnInvalidPythonIsReported) {
  if (!CanRunCode()) GTEST_SKIP() << ReasonNotConfined();
  HandIn("class/ada", "work.py", "");
  GradeRequest request = RequestFor(kCode);
  request.python = "/usr/bin/true";
  EXPECT_EQ(Grade(request).failure().code, FailureCode::kPython);
  request.python = "no-such-python";
  EXPECT_NE(Grade(request).failure().message.find("no Python 'no-such-python'"), std::string::npos);
}

TEST_F(GradeClassTest, ItEndsWhenAskedTo) {
  HandIn("class/ada", "dcm.csv", "");
  const Result<ClassMarks> marks =
      GradeClass(RequestFor(kRubric), {{}, [] { return true; }},
                 [](const std::vector<OutputFile>&) -> Result<std::string> { return std::string(); });
  EXPECT_EQ(marks.failure().code, FailureCode::kInterrupted);
}

/// From now on this process has no Landlock, as with an older kernel.
void TakeLandlockAway() {
  sock_filter lines[] = {{BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
                         {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, SYS_landlock_create_ruleset},
                         {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | ENOSYS},
                         {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW}};
  const sock_fprog program{4, lines};
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

TEST_F(GradeClassTest, WhereNothingConfinesCodeItIsRefusedUnlessAskedFor) {
  const Result<PythonProgram> python = LookOver("");
  if (!python || !python->has_numpy) GTEST_SKIP() << "there is no Python with NumPy";
  HandIn("class/ada", "work.py", kRight);
  const auto without = [&] {
    TakeLandlockAway();
    GradeRequest request = RequestFor(kCode);
    const Result<ClassMarks> refused = Grade(request);
    const bool reported = !refused && refused.failure().code == FailureCode::kUnconfinedOnly &&
                          refused.failure().message.find("Landlock") != std::string::npos;
    request.unconfined = true;
    const Result<ClassMarks> marks = Grade(request);
    const bool graded = marks && !marks->confined && marks->students[0].points() == 4.0 &&
                        pages_[0].text.find("run unconfined") != std::string::npos;
    std::_Exit(reported && graded ? 0 : reported ? 1 : 2);
  };
  EXPECT_EXIT(without(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace gaitwright
