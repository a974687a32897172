// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/column_target.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "tests/playback/synthetic.h"
#include "workflows/exchange/export_csv.h"

namespace gaitwright {
namespace {

constexpr double kOneDegree = std::numbers::pi / 180.0;

/// A biped with one revolute joint.
RobotModel HalfTurningBiped() {
  RobotModel model = synthetic::Robot(2, FootType::kSole);
  model.joints[1].type = JointType::kRevolute;
  return model;
}

ColumnTarget TargetOf(const std::string& name, const ImportOptions& options = {}) {
  const auto targets = ColumnTargets(HalfTurningBiped(), options);
  const auto found = targets.find(name);
  EXPECT_NE(found, targets.end()) << name;
  return found == targets.end() ? ColumnTarget{ColumnKind::kTime, -1, 0.0} : found->second;
}

void ExpectTarget(const std::string& name, ColumnKind kind, int index, double scale) {
  const ColumnTarget target = TargetOf(name);
  EXPECT_EQ(target.kind, kind) << name;
  EXPECT_EQ(target.index, index) << name;
  EXPECT_DOUBLE_EQ(target.scale, scale) << name;
}

TEST(ColumnTargets, NamesSayKindIndexAndUnit) {
  ExpectTarget("time_s", ColumnKind::kTime, 0, 1.0);
  ExpectTarget("base_z_mm", ColumnKind::kBasePosition, 2, 1e-3);
  ExpectTarget("base_qw", ColumnKind::kQuaternion, 3, 1.0);
  ExpectTarget("base_pitch_deg", ColumnKind::kEuler, 1, kOneDegree);
  ExpectTarget("base_vy_m_s", ColumnKind::kBaseRate, 1, 1.0);
  ExpectTarget("base_wz_deg_s", ColumnKind::kBaseRate, 5, kOneDegree);
  ExpectTarget("base_alphax_rad_s2", ColumnKind::kBaseAcceleration, 3, 1.0);
  ExpectTarget("q_left_x_mm", ColumnKind::kPosition, 0, 1e-3);
  ExpectTarget("q_left_y_deg", ColumnKind::kPosition, 1, kOneDegree);
  ExpectTarget("v_right_z_m_s", ColumnKind::kVelocity, 5, 1.0);
  ExpectTarget("tau_left_x_n", ColumnKind::kTorque, 0, 1.0);
  ExpectTarget("tau_left_y_nm", ColumnKind::kTorque, 1, 1.0);
  ExpectTarget("contact_right", ColumnKind::kContact, 1, 1.0);
  ExpectTarget("force_right_z_n", ColumnKind::kForce, 5, 1.0);
}

TEST(ColumnTargets, AJointHasOnlyUnitsOfItsKind) {
  const auto targets = ColumnTargets(HalfTurningBiped(), {});
  for (const char* name : {"q_left_x_rad", "q_left_x_deg", "tau_left_x_nm", "q_left_y_m", "tau_left_y_n"})
    EXPECT_EQ(targets.count(name), 0U) << name;
}

TEST(ColumnTargets, OptionsSayTheUnitOfNamesThatDoNot) {
  ImportOptions options;
  options.angle_unit = "deg";
  options.length_unit = "mm";
  options.time_unit = "us";
  EXPECT_DOUBLE_EQ(TargetOf("left_x", options).scale, 1e-3);
  EXPECT_DOUBLE_EQ(TargetOf("left_y", options).scale, kOneDegree);
  EXPECT_DOUBLE_EQ(TargetOf("t", options).scale, 1e-6);
  EXPECT_DOUBLE_EQ(TargetOf("q_left_y_deg", options).scale, kOneDegree) << "this name says it itself";
  EXPECT_DOUBLE_EQ(TargetOf("tau_left_y_nm", options).scale, 1.0);
}

TEST(ColumnTargets, AJointsWholeNameComesBeforeAnotherOneWithAUnit) {
  RobotModel model = HalfTurningBiped();
  model.joints[4].name = "left_x_mm";
  const auto targets = ColumnTargets(model, {});
  EXPECT_EQ(targets.at("left_x_mm").index, 4);
  EXPECT_EQ(targets.at("q_left_x_mm").index, 0);
}

/// Exported columns are read in SI units, each value once.
TEST(ColumnTargets, ColumnsThatAreExportedAreReadWithTheirOwnMeaning) {
  const RobotModel model = HalfTurningBiped();
  const auto targets = ColumnTargets(model, {});
  std::set<std::pair<ColumnKind, int>> read;
  for (const std::string& column : MotionCsvColumns(model)) {
    const auto found = targets.find(column);
    ASSERT_NE(found, targets.end()) << column;
    EXPECT_EQ(found->second.scale, 1.0) << column;
    EXPECT_TRUE(read.emplace(found->second.kind, found->second.index).second) << column;
  }
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const ColumnTarget& target = targets.at(PositionColumn(model.joints[j]));
    EXPECT_EQ(target.kind, ColumnKind::kPosition);
    EXPECT_EQ(target.index, static_cast<int>(j));
  }
}

TEST(ColumnTargets, NamesThatBeginAsOursAreRecognised) {
  for (const char* ours : {"q_knee", "base_", "tau_hip_lbf", "contact_heel"}) EXPECT_TRUE(LooksLikeOurs(ours)) << ours;
  for (const char* other : {"knee", "", "Q_knee", "xq_knee", "base"}) EXPECT_FALSE(LooksLikeOurs(other)) << other;
}

}  // namespace
}  // namespace gaitwright
