// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/playback/xml_check.h"
#include "workflows/grade/grade.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

int TimesIn(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

PartMark MarkedPart(const std::string& name, double points) {
  PartMark part;
  part.part = name;
  part.title = "Part <" + name + ">";
  part.points = points;
  part.of = 5.0;
  part.checks = {{"share_right", 0.25, points, 5.0}};
  return part;
}

/// Two students; the names of the second one look like formulas or markup.
ClassMarks MarkedClass() {
  ClassMarks marks;
  marks.title = "Walking & more";
  marks.seed = 7;
  marks.parts = {"zmp", "trot"};
  marks.of = 10.0;
  marks.students = {{"ada", {MarkedPart("zmp", 5.0), MarkedPart("trot", 2.5)}},
                    {"=1+2\"<b>", {MarkedPart("zmp", 0.0), MarkedPart("trot", 1.0)}}};
  PartMark& wrong = marks.students[1].parts[0];
  wrong.checks[0].value.reset();
  wrong.reasons = {"your code said '<script>'"};
  wrong.pages = {{"run 1", "<html>first</html>"}, {"run 2", "<html>second</html>"}};
  return marks;
}

TEST(GradePages, TheTableHasARowForEachStudentAndQuotesWhatIsNoNumber) {
  EXPECT_EQ(GradesCsv(MarkedClass()),
            "\"student\",\"zmp\",\"trot\",\"total\",\"of\"\n"
            "\"ada\",5,2.5,7.5,10\n"
            "\"'=1+2\"\"<b>\",0,1,1,10\n");
}

TEST(GradePages, OnlyWhatBeginsAsAFormulaGetsAnApostrophe) {
  ClassMarks marks = MarkedClass();
  for (const std::string name : {"+a", "-a", "@a", "=a"}) {
    marks.students[0].student = name;
    EXPECT_EQ(TimesIn(GradesCsv(marks), "\"'" + name + "\""), 1) << name;
  }
  marks.students[0].student = "a=b";
  EXPECT_EQ(TimesIn(GradesCsv(marks), "\"a=b\""), 1);
}

TEST(GradePages, JsonHasTheMarksAndNullWithoutAMeasurement) {
  const Json json = Json::parse(GradesJson(MarkedClass()));
  EXPECT_EQ(json.at("seed"), 7);
  EXPECT_EQ(json.at("of"), 10.0);
  EXPECT_EQ(json.at("confined"), true);
  ASSERT_EQ(json.at("students").size(), 2U);
  EXPECT_EQ(json.at("students")[0].at("points"), 7.5);
  const Json wrong = json.at("students")[1].at("parts")[0];
  EXPECT_TRUE(wrong.at("checks")[0].at("value").is_null());
  EXPECT_EQ(wrong.at("reasons")[0], "your code said '<script>'");
  EXPECT_EQ(json.at("students")[1].at("page"), PageNameOf("=1+2\"<b>", 1));
}

TEST(GradePages, NamesOfPagesArePlainAndDifferForEachStudent) {
  EXPECT_EQ(PageNameOf("ada", 0), "001-ada.html");
  EXPECT_EQ(PageNameOf("../../etc/passwd", 11), "012-______etc_passwd.html");
  EXPECT_NE(PageNameOf("a b", 0), PageNameOf("a_b", 1));
  EXPECT_LT(PageNameOf(std::string(500, 'x'), 0).size(), 100U);
  std::set<std::string> names;
  for (std::size_t k = 0; k < 1200; ++k) names.insert(PageNameOf("ada", k));
  EXPECT_EQ(names.size(), 1200U);
}

TEST(GradePages, APageShowsASubmissionAsTextOnly) {
  const ClassMarks marks = MarkedClass();
  const std::vector<OutputFile> files = StudentPages(marks, marks.students[1], 1);
  const std::string& page = files.front().text;
  EXPECT_EQ(XmlFault(page.substr(page.find("<html"))), "");
  EXPECT_EQ(TimesIn(page, "<script>"), 0);
  EXPECT_EQ(TimesIn(page, "&lt;script&gt;"), 1);
  EXPECT_EQ(TimesIn(page, "<b>1 of 10</b>"), 1) << "the total, and no other mark in bold";
  EXPECT_EQ(TimesIn(page, "default-src 'none'"), 1);
  EXPECT_EQ(TimesIn(page, "none</td>"), 1) << "the check without a value";
}

/// Each page of a motion is written once and linked by its name.
TEST(GradePages, PagesOfMotionsAreBesideThePageThatLinksThem) {
  const ClassMarks marks = MarkedClass();
  const std::vector<OutputFile> files = StudentPages(marks, marks.students[1], 1);
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].path, PageNameOf(marks.students[1].student, 1));
  EXPECT_EQ(files[1].text, "<html>first</html>");
  EXPECT_NE(files[1].path, files[2].path);
  for (std::size_t i = 1; i < files.size(); ++i)
    EXPECT_EQ(TimesIn(files[0].text, "href=\"" + files[i].path + "\""), 1) << files[i].path;
  EXPECT_EQ(StudentPages(marks, marks.students[0], 0).size(), 1U);
}

TEST(GradePages, TheClassHasALinkToEachStudent) {
  const ClassMarks marks = MarkedClass();
  const std::string page = ClassPage(marks);
  EXPECT_EQ(XmlFault(page.substr(page.find("<html"))), "");
  for (std::size_t i = 0; i < marks.students.size(); ++i)
    EXPECT_EQ(TimesIn(page, "href=\"" + PageNameOf(marks.students[i].student, i) + "\""), 1);
  EXPECT_EQ(TimesIn(page, "Walking &amp; more"), 2) << "title and heading";
}

TEST(GradePages, MarksOfCodeThatWasNotConfinedAreMarkedAsSuch) {
  ClassMarks marks = MarkedClass();
  EXPECT_EQ(TimesIn(ClassPage(marks), "reason fail"), 0);
  marks.confined = false;
  EXPECT_EQ(TimesIn(ClassPage(marks), "reason fail"), 1);
  EXPECT_EQ(TimesIn(StudentPages(marks, marks.students[0], 0).front().text, "reason fail"), 1);
  EXPECT_EQ(Json::parse(GradesJson(marks)).at("confined"), false);
}

}  // namespace
}  // namespace gaitwright
