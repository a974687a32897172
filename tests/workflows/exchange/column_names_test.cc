// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>

#include "tests/scratch_folder.h"
#include "workflows/exchange/motion_columns.h"

namespace gaitwright {
namespace {

Result<ColumnNames> NamesIn(const std::string& yaml, ImportOptions& options) {
  std::ofstream(ScratchFile("columns.yaml")) << yaml;
  return ReadColumnNames(ScratchFile("columns.yaml"), options);
}

std::string ReasonNoNames(const std::string& yaml) {
  ImportOptions options;
  const auto names = NamesIn(yaml, options);
  return names.ok() ? "" : names.failure().message;
}

TEST(ColumnNames, AreReadInTheirOrder) {
  ImportOptions options;
  const auto names = NamesIn("names: [t, 'hip pos', t2]\ncolumns: {t: time_s}\nscale: {t: 2}\nignore: [t2]\n", options);
  ASSERT_TRUE(names.ok()) << names.failure().message;
  EXPECT_EQ(names->in_order, (std::vector<std::string>{"t", "hip pos", "t2"}));
  EXPECT_EQ(names->ours.at("t"), "time_s");
  EXPECT_EQ(names->scale.at("t"), 2.0);
  EXPECT_EQ(names->ignored, std::vector<std::string>{"t2"});
}

TEST(ColumnNames, UnitsGoIntoTheOptions) {
  ImportOptions options;
  ASSERT_TRUE(NamesIn("angle_unit: deg\ntime_unit: ms\n", options).ok());
  EXPECT_EQ(options.angle_unit, "deg");
  EXPECT_EQ(options.time_unit, "ms");
  const auto other = NamesIn("time_unit: us\n", options);
  ASSERT_FALSE(other.ok());
  EXPECT_NE(other.failure().message.find("line 1: 'time_unit' is 'us' here but 'ms' on the command line"),
            std::string::npos)
      << other.failure().message;
}

TEST(ColumnNames, RefusesWithTheLine) {
  EXPECT_NE(ReasonNoNames("columns: {}\nnames: t\n").find("line 2: "), std::string::npos);
  EXPECT_NE(ReasonNoNames("columns: {t: ''}\n").find("column 't' is not mapped"), std::string::npos);
  EXPECT_NE(ReasonNoNames("scale: {t: 0}\n").find("scale of 't' is 0"), std::string::npos);
  EXPECT_NE(ReasonNoNames("nam: [t]\n").find("'names'"), std::string::npos) << "the nearest key";
}

}  // namespace
}  // namespace gaitwright
