// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/answer_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "kinematics/base/file.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

const std::string kInputs =
    "case,height_m,com_m_0,com_m_1,points_m_0_0,points_m_0_1,points_m_1_0,points_m_1_1\n"
    "0,0.5,1,2,3,4,5,6\n"
    "1,0.25,7,8,9,10,11,12\n";

CsvTable Inputs() { return *ParseCsvTable(kInputs, "inputs.csv"); }

TEST(AnswerTable, ACaseHasItsInputsByName) {
  const CsvTable inputs = Inputs();
  const AnswerCase second(inputs, 1);
  EXPECT_EQ(second.Number("height_m"), 0.25);
  EXPECT_EQ(second.Vector("com_m"), Vector2(7.0, 8.0));
  const MatrixX points = second.Matrix("points_m");
  ASSERT_EQ(points.rows(), 2);
  ASSERT_EQ(points.cols(), 2);
  EXPECT_EQ(points(0, 1), 10.0);
  EXPECT_EQ(points(1, 0), 11.0);
}

TEST(AnswerTable, AnInputThatIsNotThereIsNamedWithTheNearest) {
  const CsvTable inputs = Inputs();
  const AnswerCase first(inputs, 0);
  const auto why = [](const auto& ask) -> std::string {
    try {
      ask();
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "it was not refused";
  };
  EXPECT_EQ(why([&] { first.Number("heigth_m"); }), "inputs.csv has no column 'heigth_m'; the nearest is 'height_m'");
  EXPECT_NE(why([&] { first.Vector("con_m"); }).find("'con_m_0'; the nearest is 'com_m_0'"), std::string::npos);
  EXPECT_NE(why([&] { first.Matrix("point_m"); }).find("no column 'point_m_0_0'"), std::string::npos);
}

TEST(AnswerTable, AnswersAreARowACaseAndShorterOnesAreFilledUp) {
  const auto answer = [](const AnswerCase& asked) {
    std::vector<double> numbers = {asked.Number("height_m")};
    if (asked.Number("case") > 0.5) numbers.push_back(0.1);
    return numbers;
  };
  EXPECT_EQ(AnswersCsv(Inputs(), answer), "case,answer_0,answer_1\n0,0.5,0\n1,0.25,0.1\n");
}

TEST(AnswerTable, WritesAllPartsOrNone) {
  const std::string folder = ScratchFile("answer_table");
  ASSERT_TRUE(WriteFileAtomically(folder + "/height_inputs.csv", kInputs).ok());
  const AnsweredPart height{"height", [](const AnswerCase& asked) { return std::vector{asked.Number("height_m")}; }};
  const auto written = WriteAnswers(folder, folder + "/mine", {height});
  ASSERT_TRUE(written.ok()) << written.failure().message;
  EXPECT_EQ(*ReadFile(written->front()), "case,answer_0\n0,0.5\n1,0.25\n");

  const AnsweredPart broken{"height", [](const AnswerCase&) { return std::vector{std::nan("")}; }};
  const auto refused = WriteAnswers(folder, folder + "/none", {height, broken});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().code, FailureCode::kAnswers);
  EXPECT_EQ(refused.failure().message,
            "the answer to case 0 of " + folder + "/height_inputs.csv is nan; it must be finite");
  EXPECT_FALSE(std::filesystem::exists(folder + "/none/height.csv"));

  const auto absent = WriteAnswers(folder, folder, {{"margin", height.answer}});
  ASSERT_FALSE(absent.ok());
  EXPECT_NE(absent.failure().message.find("margin_inputs.csv"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
