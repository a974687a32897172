// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "tests/workflows/grade/made_class.h"
#include "workflows/exchange/csv_table.h"

namespace gaitwright {
namespace {

const std::string kZmp =
    "{name: zmp, kind: function, file: work.py, points: 10, reference: pendulum_zmp, cases: 10, limits: {time_s: 5}}\n";
const std::string kHull = "{name: hull, kind: answers, file: hull.csv, points: 4, reference: dcm, cases: 4}\n";

class MarkFunction : public MadeClass {
 protected:
  void SetUp() override {
    if (!CanRunCode()) GTEST_SKIP() << ReasonNotConfined();
  }
};

TEST_F(MarkFunction, TheRightFunctionGetsAllPoints) {
  const PartMark mark = MarkCode(kZmp, "def pendulum_zmp(c, a, h):\n    return c[:2] - a[:2] * h / 9.81\n");
  EXPECT_EQ(mark.points, 10.0);
  EXPECT_TRUE(mark.reasons.empty());
}

TEST_F(MarkFunction, ItMayImportItsOwnModulesAndNumPy) {
  HandIn("ada", "helper.py", "import numpy\nG = numpy.float64(9.81)\n");
  const PartMark mark =
      MarkCode(kZmp, "import helper\ndef pendulum_zmp(c, a, h):\n    return c[:2] - a[:2] * h / helper.G\n");
  EXPECT_EQ(mark.points, 10.0);
}

TEST_F(MarkFunction, AHalfRightOneGetsItsShare) {
  const PartMark mark = MarkCode(kZmp,
                                 "calls = [0]\ndef pendulum_zmp(c, a, h):\n    calls[0] += 1\n"
                                 "    return c[:2] - a[:2] * h / 9.81 + (calls[0] > 5)\n");
  EXPECT_EQ(mark.points, 5.0);
  EXPECT_EQ(mark.reasons[1], "5 of 10 cases are correct");
  EXPECT_EQ(mark.reasons[2], "case 5: the answer has an error of 1; at most 1e-06 is accepted");
}

TEST_F(MarkFunction, AnExceptionIsReportedWithItsPlace) {
  const PartMark mark = MarkCode(kZmp, "def pendulum_zmp(c, a, h):\n    return c.zmp()\n");
  ExpectNothing(mark, {"case 0: the submission says: AttributeError", "(work.py line 2)"});
  ExpectNothing(MarkCode(kZmp, "def pendulum_zmp(c, a, h)\n"), {"SyntaxError", "line 1"});
  ExpectNothing(MarkCode(kZmp, "def zmp(c, a, h): pass\n"), {"'work.py' has no 'pendulum_zmp'"});
  ExpectNothing(MarkCode(kZmp, "raise ValueError('in vain')\n"), {"ValueError: in vain"});
}

TEST_F(MarkFunction, InvalidAnswersAreWrongAndReported) {
  const auto gives = [&](const std::string& what) {
    return MarkCode(kZmp, "def pendulum_zmp(c, a, h):\n    return " + what + "\n");
  };
  ExpectNothing(gives("[float('nan'), 0]"), {"the answer[0] is nan; a finite number is needed"});
  ExpectNothing(gives("[0, 1e999]"), {"the answer[1] is inf"});
  ExpectNothing(gives("[1, 2, 3]"), {"the answer is 3 numbers; 2 numbers are needed"});
  ExpectNothing(gives("0.5"), {"the answer is a number; 2 numbers are needed"});
  ExpectNothing(gives("None"), {"the answer is None"});
  ExpectNothing(gives("[]"), {"the answer is 0 numbers"});
  ExpectNothing(gives("[[1, 2], [3]]"), {"row 1 of the answer has another length"});
  ExpectNothing(gives("[[[[[[1]]]]]]"), {"ValueError: the answer has more than three lists"});
  ExpectNothing(gives("{'points': 10}"), {"the answer[0] is points; a finite number is needed"});
  ExpectNothing(gives("[True, False]"), {"the answer[0] is True"});
}

TEST_F(MarkFunction, ThePackageIsThereOnlyWhereTheRubricSaysSo) {
  const std::string code = "import gaitwright\ndef dcm(c, v, h):\n    return [0, 0]\n";
  const auto part = [](const char* package) {
    return fmt::format("{{name: p, kind: function, file: work.py, points: 1, reference: dcm, cases: 1, package: {}}}\n",
                       package);
  };
  if (!CanRunCode(true)) GTEST_SKIP() << "the package is not built";
  EXPECT_NE(MarkCode(part("true"), code).reasons.front().find("share_right is 0"), std::string::npos);
  ExpectNothing(MarkCode(part("false"), code), {"No module named 'gaitwright'"});
}

class MarkAnswers : public MadeClass {
 protected:
  /// Right answers to the first `count` cases, from the inputs that students get.
  std::string Answers(int count) const {
    const CsvTable in = ParseCsvTable(InputsCsv(PartOf(kHull), 7), "inputs").value();
    std::string csv = "case,answer_0,answer_1\n";
    for (int row = 0; row < count; ++row) {
      const auto at = [&](const std::string& name) { return in.At(row, in.Find(name)); };
      const double omega = std::sqrt(9.81 / at("com_height_m"));
      csv += fmt::format("{},{},{}\n", row, at("com_m_0") + at("velocity_m_s_0") / omega,
                         at("com_m_1") + at("velocity_m_s_1") / omega);
    }
    return csv;
  }
  PartMark MarkCsv(const std::string& csv, std::uint64_t seed = 7) const {
    HandIn("ada", "hull.csv", csv);
    return Mark(kHull, "ada", seed);
  }
};

TEST_F(MarkAnswers, RightAnswersGetAllAndHalfOfThemHalf) {
  EXPECT_EQ(MarkCsv(Answers(4)).points, 4.0);
  const PartMark half = MarkCsv(Answers(2));
  EXPECT_EQ(half.points, 2.0);
  EXPECT_EQ(half.reasons.back(), "case 3: there is no answer");
}

TEST_F(MarkAnswers, AnswersOfAnotherSeedAreWrong) { EXPECT_EQ(MarkCsv(Answers(4), 8).points, 0.0); }

TEST_F(MarkAnswers, TablesThatAreNoneGetNothing) {
  ExpectNothing(MarkCsv("case,answer_0\n0,1\n"), {"no column 'answer_1'"});
  ExpectNothing(MarkCsv("number,answer_0\n0,1\n"), {"no column 'case'"});
  ExpectNothing(MarkCsv("case,answer_0,answer_1\n0,1,2\n0,1,2\n"), {"case 0 is in 'hull.csv' twice"});
  ExpectNothing(MarkCsv("case,answer_0,answer_1\n4,1,2\n"), {"is 4; accepted: 0 to 3"});
  ExpectNothing(MarkCsv("case,answer_0,answer_1\n0,nan,2\n"), {"'hull.csv'"});
  ExpectNothing(MarkCsv("case,answer_0,answer_1\n0,1,=1+1\n"), {"'hull.csv'"});
  ExpectNothing(MarkCsv(std::string("\x00\xff\x01", 3)), {"'hull.csv'"});
  ExpectNothing(MarkCsv(""), {"'hull.csv' is empty"});
  ExpectNothing(Mark(kHull, "nobody"), {"'hull.csv' was not handed in"});
}

}  // namespace
}  // namespace gaitwright
