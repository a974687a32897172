// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_table.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

ImportOptions With(const std::string& key, const std::string& text) {
  ImportOptions options;
  OptionFields fields = options.Fields();
  SetOption(fields, key, text);
  return options;
}

TEST(MotionTable, UnitsOfTimeAreSeconds) {
  EXPECT_EQ(ImportOptions().time_unit_s(), 1.0) << "seconds are assumed";
  EXPECT_EQ(With("time_unit", "s").time_unit_s(), 1.0);
  EXPECT_EQ(With("time_unit", "ms").time_unit_s(), 1e-3);
  EXPECT_EQ(With("time_unit", "us").time_unit_s(), 1e-6);
  EXPECT_EQ(With("time_unit", "ns").time_unit_s(), 1e-9);
}

TEST(MotionTable, GridsOfPlansHaveALeastStep) {
  EXPECT_NO_THROW(CheckImportOptions(With("grid_step_s", "0"))) << "that of the file";
  EXPECT_NO_THROW(CheckImportOptions(With("grid_step_s", "0.0005")));
  EXPECT_THROW(CheckImportOptions(With("grid_step_s", "0.0004")), InvalidArgument);
}

TEST(MotionTable, TopicsAreAnyText) {
  EXPECT_EQ(ImportOptions().topics, "detect");
  EXPECT_EQ(With("topics", "/joint_states,/odom").topics, "/joint_states,/odom");
  EXPECT_NO_THROW(CheckImportOptions(With("topics", "/joint_states")));
  EXPECT_THROW(With("missing_joints", "maybe"), InvalidArgument) << "others have a list of words";
}

TEST(MotionTable, HasARowForEachTime) {
  MotionTable table;
  EXPECT_EQ(table.rows(), 0);
  table.time_s = {0.0, 0.1, 0.2};
  EXPECT_EQ(table.rows(), 3);
}

}  // namespace
}  // namespace gaitwright
