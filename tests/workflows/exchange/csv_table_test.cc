// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/csv_table.h"

#include <gtest/gtest.h>

#include <clocale>

#include "kinematics/base/file.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

using Cells = std::vector<double>;
using Names = std::vector<std::string>;

CsvTable Parsed(const std::string& text) {
  const Result<CsvTable> table = ParseCsvTable(text, "motion.csv");
  EXPECT_TRUE(table.ok()) << table.failure().message;
  return table.ok() ? *table : CsvTable{};
}

std::string ReasonCsvTableRefused(const std::string& text) {
  const Result<CsvTable> table = ParseCsvTable(text, "motion.csv");
  EXPECT_FALSE(table.ok()) << text;
  if (table.ok()) return "";
  EXPECT_EQ(table.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(table.failure().code, FailureCode::kCsv);
  return table.failure().message;
}

TEST(CsvTable, ReadsNamesAndNumbers) {
  const CsvTable table = Parsed("time_s,x\n0,1.5\n0.5,-2e-3\n");
  EXPECT_EQ(table.columns, (Names{"time_s", "x"}));
  EXPECT_EQ(table.values, (Cells{0.0, 1.5, 0.5, -2e-3}));
  EXPECT_EQ(table.lines, (std::vector<int>{2, 3}));
  EXPECT_EQ(table.Find("x"), 1);
  EXPECT_EQ(table.Find("y"), -1);
  EXPECT_EQ(table.Column(1), (Cells{1.5, -2e-3}));
  EXPECT_EQ(table.Place(1, 1), "line 3, column 2 'x'");
}

TEST(CsvTable, DelimitersAndBlanksDoNotMatter) {
  const CsvTable expected = Parsed("a,b,c\n1,2,3\n4,5,6\n");
  for (const char* text : {"a;b;c\n1;2;3\n4;5;6\n", "a\tb\tc\n1\t2\t3\n4\t5\t6", "a, b , c\n 1 , 2,3\n4 ,5 , 6 \n",
                           "\"a\",\"b\",\"c\"\n\"1\",2,\"3\"\n4,\"5\" ,6\n", "a,b,c\r\n1,2,3\r\n4,5,6\r\n"}) {
    const CsvTable table = Parsed(text);
    EXPECT_EQ(table.columns, expected.columns) << text;
    EXPECT_EQ(table.values, expected.values) << text;
  }
}

TEST(CsvTable, CommentsAndEmptyLinesArePassedOver) {
  const CsvTable table = Parsed("# made by hand\n\na,b\n# half way\n1,2\n\n   \n3,4\n\n");
  EXPECT_EQ(table.values, (Cells{1, 2, 3, 4}));
  EXPECT_EQ(table.lines, (std::vector<int>{5, 8}));
}

TEST(CsvTable, NamesMayStandInTheCommentBeforeTheNumbers) {
  const CsvTable table = Parsed("# of the walk\n# time, x\n0, 1\n1, 2\n");
  EXPECT_EQ(table.columns, (Names{"time", "x"}));
  EXPECT_EQ(table.values, (Cells{0, 1, 1, 2}));
}

TEST(CsvTable, DelimiterAtTheEndOfEveryLineIsPassedOver) {
  const CsvTable table = Parsed("time, x, \n0, 1, \n1, 2, \n");
  EXPECT_EQ(table.columns, (Names{"time", "x"}));
  EXPECT_EQ(table.values, (Cells{0, 1, 1, 2}));
  EXPECT_EQ(table.At(1, 1), 2.0);
}

TEST(CsvTable, QuotesHoldDelimitersAndQuotes) {
  EXPECT_EQ(Parsed("\"a,b\",\"c\"\"d\"\n1,2\n").columns, (Names{"a,b", "c\"d"}));
}

TEST(CsvTable, TruthIsANumber) { EXPECT_EQ(Parsed("a,b\nTrue,false\n").values, (Cells{1.0, 0.0})); }

TEST(CsvTable, NumbersDoNotDependOnTheMachinesLanguage) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  const CsvTable table = Parsed("a;b\n1.25;+3\n");
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(table.values, (Cells{1.25, 3.0}));
}

TEST(CsvTable, ByteOrderMarkIsNoPartOfAName) {
  const std::string path = ScratchFile("bom.csv");
  ASSERT_TRUE(WriteFileAtomically(path, "\xEF\xBB\xBFtime_s,x\n0,1\n").ok());
  const Result<CsvTable> table = ReadCsvTable(path);
  ASSERT_TRUE(table.ok()) << table.failure().message;
  EXPECT_EQ(table->columns.front(), "time_s");
}

TEST(CsvTable, SaysWhereItIsWrong) {
  EXPECT_EQ(ReasonCsvTableRefused(""), "'motion.csv': is empty; its first line must name the columns");
  EXPECT_EQ(ReasonCsvTableRefused("a,b\n"), "'motion.csv': has no row of numbers below the column names");
  EXPECT_EQ(ReasonCsvTableRefused("a,b\n1,2\n3\n"), "'motion.csv': line 3 has 1 cells, but line 1 names 2 columns");
  EXPECT_EQ(ReasonCsvTableRefused("a,b\n1,2,3\n"), "'motion.csv': line 2 has 3 cells, but line 1 names 2 columns");
  EXPECT_EQ(ReasonCsvTableRefused("a,b\n1,nan\n"),
            "'motion.csv': line 2, column 2 'b' contains 'nan', which is not a finite number");
  EXPECT_EQ(ReasonCsvTableRefused("a,b\n1,-inf\n"),
            "'motion.csv': line 2, column 2 'b' contains '-inf', which is not a finite number");
  EXPECT_EQ(ReasonCsvTableRefused("a,b\n1,1e999\n"),
            "'motion.csv': line 2, column 2 'b' contains '1e999', which is not a finite number");
  EXPECT_EQ(ReasonCsvTableRefused("a,b\n1,\n"),
            "'motion.csv': line 2, column 2 'b' is empty; each cell must hold a number");
  EXPECT_EQ(ReasonCsvTableRefused("a,b\n,1\n"),
            "'motion.csv': line 2, column 1 'a' is empty; each cell must hold a number");
  EXPECT_EQ(
      ReasonCsvTableRefused("a;b\n1;2,5\n"),
      "'motion.csv': line 2, column 2 'b' contains '2,5', which is not a finite number; write decimals with a point");
  EXPECT_EQ(ReasonCsvTableRefused("a,b\n1,0x10\n"),
            "'motion.csv': line 2, column 2 'b' contains '0x10', which is not a finite number");
}

TEST(CsvTable, SaysWhatIsWrongWithItsNames) {
  EXPECT_EQ(ReasonCsvTableRefused("a,b,a\n1,2,3\n"), "'motion.csv': line 1: columns 1 and 3 are both named 'a'");
  EXPECT_EQ(ReasonCsvTableRefused("a,,b\n1,2,3\n"), "'motion.csv': line 1: column 2 has no name");
  EXPECT_EQ(ReasonCsvTableRefused("1,2,3\n4,5,6\n"),
            "'motion.csv': line 1 contains only numbers; the first line must name the columns");
  EXPECT_EQ(ReasonCsvTableRefused("\"a,b\n1,2\n"),
            "'motion.csv': line 1: a quote (\") is not closed; a cell must end on its line");
  EXPECT_EQ(ReasonCsvTableRefused("\"a\"x,b\n1,2\n"), "'motion.csv': line 1, cell 1: text after a closing quote");
}

TEST(CsvTable, HasALimitOfColumns) {
  std::string names = "c0", row = "0";
  for (int i = 1; i <= kMostCsvColumns; ++i) names += ",c" + std::to_string(i), row += ",0";
  EXPECT_EQ(ReasonCsvTableRefused(names + "\n" + row + "\n"), "'motion.csv': line 1: more than 1000 columns");
}

TEST(CsvTable, HasALimitOfRows) {
  std::string text = "a\n";
  for (int i = 0; i <= kMostCsvRows; ++i) text += "0\n";
  EXPECT_EQ(ReasonCsvTableRefused(text), "'motion.csv': line 1000002: more than 1000000 rows");
}

TEST(CsvTable, FileThatIsNotThereIsNamed) {
  const Result<CsvTable> table = ReadCsvTable("/nowhere/motion.csv");
  ASSERT_FALSE(table.ok());
  EXPECT_NE(table.failure().message.find("/nowhere/motion.csv"), std::string::npos);
}

// Byte 40 is inside the 13th character of three bytes.
TEST(CsvTable, ALongCellIsShownUpToACharactersEnd) {
  std::string cell = "ab", shown = "ab";
  for (int i = 0; i < 20; ++i) cell += "\u932f";
  for (int i = 0; i < 12; ++i) shown += "\u932f";
  const std::string why = ReasonCsvTableRefused("time_s,x\n0," + cell + "\n");
  EXPECT_NE(why.find("'" + shown + "...'"), std::string::npos) << why;
}

}  // namespace
}  // namespace gaitwright
