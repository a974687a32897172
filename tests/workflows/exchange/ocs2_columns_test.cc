// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/ocs2_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/playback/played.h"

namespace gaitwright {
namespace {

CsvTable TableWithColumns(std::vector<std::string> columns) {
  CsvTable table;
  table.source = "motion.csv";
  table.columns = std::move(columns);
  return table;
}

const std::vector<std::string> kFewColumns = {"time", "base_positionInWorld_x", "jointAngle_LF_HAA"};

/// The block quadruped with joint names of OCS2, on legs in another order than their positions.
RobotModel NamedAsAnymal() {
  RobotModel model = synthetic::Robot(4, FootType::kSphere);
  const std::vector<std::string> legs = {"RH", "LH", "RF", "LF"}, joints = {"HAA", "HFE", "KFE"};
  for (std::size_t l = 0; l < 4; ++l) {
    for (std::size_t j = 0; j < 3; ++j) model.joints[3 * l + j].name = legs[l] + "_" + joints[j];
  }
  return model;
}

TEST(Ocs2Columns, AMotionIsRecognisedByTwoOfItsColumns) {
  EXPECT_TRUE(IsOcs2Motion(TableWithColumns(kFewColumns)));
  EXPECT_FALSE(IsOcs2Motion(TableWithColumns({"time", "jointAngle_LF_HAA"})));
  EXPECT_FALSE(IsOcs2Motion(TableWithColumns({"time", "base_positionInWorld_x"})));
  EXPECT_FALSE(IsOcs2Motion(TableWithColumns({"time", "base_positionInWorld_x", "my_jointAngle_"})));
}

TEST(Ocs2Columns, LegsAreFoundByWhereTheirFeetStand) {
  std::vector<DerivedPart> derived;
  const Result<ColumnNames> names =
      Ocs2ColumnNames(synthetic::Robot(4, FootType::kSphere), TableWithColumns(kFewColumns), derived);
  ASSERT_TRUE(names.ok()) << names.failure().message;
  EXPECT_EQ(names->ours.at("time"), "time_s");
  EXPECT_EQ(names->ours.at("base_quaternion_w"), "base_qw");
  EXPECT_EQ(names->ours.at("jointAngle_LF_HAA"), "q_front_left_x_m");
  EXPECT_EQ(names->ours.at("jointAngle_RF_KFE"), "q_front_right_z_m");
  EXPECT_EQ(names->ours.at("jointVelocity_LH_HFE"), "v_rear_left_y_m_s");
  EXPECT_EQ(names->ours.at("contactflag_RH"), "contact_rear_right");
  EXPECT_EQ(names->ours.at("contactForcesInWorld_RH_z"), "force_rear_right_z_n");
  EXPECT_TRUE(names->may_lack);
  ASSERT_EQ(derived.size(), 1U) << "that legs were found by place is said";
  EXPECT_TRUE(synthetic::Says(derived[0].how, "LF_HAA is front_left_x")) << derived[0].how;
}

/// Each of their columns maps to a different column of this program.
TEST(Ocs2Columns, NoTwoColumnsMeanOneThing) {
  std::vector<DerivedPart> derived;
  const Result<ColumnNames> names =
      Ocs2ColumnNames(synthetic::Robot(4, FootType::kSphere), TableWithColumns(kFewColumns), derived);
  ASSERT_TRUE(names.ok());
  std::set<std::string> ours;
  for (const auto& [theirs, our] : names->ours) {
    EXPECT_TRUE(ours.insert(our).second) << our;
    EXPECT_EQ(std::count(names->ignored.begin(), names->ignored.end(), theirs), 0) << theirs;
  }
  EXPECT_EQ(ours.size(), 1U + 3U + 4U + 4U * (3U + 3U + 1U + 3U));
}

TEST(Ocs2Columns, NamesOfJointsComeBeforeWhereTheyStand) {
  std::vector<DerivedPart> derived;
  const Result<ColumnNames> names = Ocs2ColumnNames(NamedAsAnymal(), TableWithColumns(kFewColumns), derived);
  ASSERT_TRUE(names.ok()) << names.failure().message;
  EXPECT_EQ(names->ours.at("jointAngle_LF_HAA"), "q_LF_HAA_m");
  EXPECT_EQ(names->ours.at("contactflag_LF"), "contact_rear_right") << "where that leg stands";
  EXPECT_TRUE(derived.empty()) << "nothing had to be worked out";
}

TEST(Ocs2Columns, ARobotWithOtherLegsIsRefused) {
  RobotModel crowded = synthetic::Robot(4, FootType::kSphere);
  crowded.joints[0].X_PJ.translation().x() = -0.2;  // three legs behind
  crowded.joints[0].X_PJ.translation().y() = 0.3;
  for (const RobotModel& model : {synthetic::Robot(2, FootType::kSphere), crowded}) {
    std::vector<DerivedPart> derived;
    const Result<ColumnNames> names = Ocs2ColumnNames(model, TableWithColumns(kFewColumns), derived);
    ASSERT_FALSE(names.ok()) << model.name;
    EXPECT_EQ(names.failure().kind, FailureKind::kBadInput);
    EXPECT_EQ(names.failure().code, FailureCode::kOcs2);
    EXPECT_TRUE(synthetic::Says(names.failure().message, "'" + model.name + "'")) << names.failure().message;
    EXPECT_TRUE(derived.empty());
  }
}

TEST(Ocs2Columns, AColumnOfALegThatTheyHaveNotIsRefusedByName) {
  for (const std::string wrong : {"jointAngle_LF_HIP", "jointVelocity_XF_HAA", "contactflag_lf"}) {
    std::vector<std::string> columns = kFewColumns;
    columns.push_back(wrong);
    std::vector<DerivedPart> derived;
    const Result<ColumnNames> names =
        Ocs2ColumnNames(synthetic::Robot(4, FootType::kSphere), TableWithColumns(columns), derived);
    ASSERT_FALSE(names.ok()) << wrong;
    EXPECT_EQ(names.failure().code, FailureCode::kOcs2);
    EXPECT_TRUE(synthetic::Says(names.failure().message, "'" + wrong + "'")) << names.failure().message;
  }
}

}  // namespace
}  // namespace gaitwright
