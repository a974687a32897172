// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/robot_yaml_shape.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_yaml.h"
#include "kinematics/model/robot_yaml_shape_internal.h"

namespace gaitwright {
namespace {

bool IsYamlAccepted(const std::string& text) {
  try {
    ParseRobotYaml(text);
  } catch (const InvalidArgument&) {
    return false;
  }
  return true;
}

/// A value that a shape accepts, and one that it refuses; "" if all numbers and texts are accepted.
struct SampleValues {
  std::string accepted, refused;
};

SampleValues SamplesOf(const DataShape& shape) {
  if (shape.kind != DataShape::Kind::kNumber) return {};
  const double inside = shape.over_lowest ? std::min(1.0, shape.highest) : 0.5 * (shape.lowest + shape.highest);
  return {std::to_string(inside), std::to_string(2.0 * shape.highest)};
}

// The reader and the schema have the same keys and ranges.
TEST(RobotYamlShape, TheReaderAcceptsEachNumberWithinItsRangeAndNoneBeyond) {
  int checked = 0;
  const auto check = [&](const DataShape& part, const std::string& before, const std::string& after) {
    for (const ShapeMember& member : part.members) {
      const SampleValues values = SamplesOf(member.shape);
      if (values.accepted.empty()) continue;
      EXPECT_FALSE(IsYamlAccepted(before + member.key + ": " + values.refused + after)) << member.key;
      ++checked;
      // Some keys need other keys; other tests cover them.
      const std::set<std::string> paired = {"standing_base_height_m", "thermal_s"};
      if (paired.contains(member.key)) continue;
      EXPECT_TRUE(IsYamlAccepted(before + member.key + ": " + values.accepted + after)) << member.key;
    }
  };
  check(LimitsYamlShape(), "limits: {j: {", "}}");
  check(GainsYamlShape(), "gains: {j: {", "}}");
  check(RobotYamlShape(), "", "");
  EXPECT_GE(checked, 14);
}

TEST(RobotYamlShape, KeysOfBothKindsOfJointsComeInPairs) {
  const auto count = [](const DataShape& shape, const std::vector<std::string>& endings) {
    int found = 0;
    for (const ShapeMember& member : shape.members) {
      for (const std::string& ending : endings) found += member.key.ends_with(ending) ? 1 : 0;
    }
    return found;
  };
  EXPECT_EQ(count(LimitsYamlShape(), {"_rad", "_rad_s", "_nm"}), count(LimitsYamlShape(), {"_m", "_m_s", "_n"}));
  EXPECT_EQ(count(GainsYamlShape(), {"_nm_rad", "_nm_s_rad"}), count(GainsYamlShape(), {"_n_m", "_n_s_m"}));
  EXPECT_EQ(count(MotorYamlShape(), {"_rad_s", "_rad_s2", "_rad_s3"}),
            count(MotorYamlShape(), {"_m_s", "_m_s2", "_m_s3"}));
}

TEST(RobotYamlShape, EachKeyStandsOnceAndOnlyNamesAreNeeded) {
  for (const DataShape& shape : {RobotYamlShape(), FootYamlShape(), LegYamlShape(), LimitsYamlShape(), GainsYamlShape(),
                                 MotorYamlShape(), TransmissionYamlShape(), TransmissionMotorYamlShape()}) {
    const std::vector<std::string> keys = shape.Keys();
    EXPECT_EQ(std::set<std::string>(keys.begin(), keys.end()).size(), keys.size());
  }
  EXPECT_TRUE(RobotYamlShape().NeededKeys().empty()) << "all of a robot.yaml is optional";
  EXPECT_EQ(FootYamlShape().NeededKeys(), std::vector<std::string>{"link"});
  EXPECT_EQ(TransmissionYamlShape().NeededKeys(), (std::vector<std::string>{"name", "joints", "motors"}));
  EXPECT_EQ(TransmissionMotorYamlShape().NeededKeys(), (std::vector<std::string>{"name", "ratios"}));
}

TEST(RobotYamlShape, ItsSchemaHasTheKeysAndForbidsOthers) {
  const nlohmann::json schema = nlohmann::json::parse(SchemaOf(RobotYamlShape(), "robot", "A robot."));
  for (const std::string& key : RobotYamlShape().Keys()) EXPECT_TRUE(schema.at("properties").contains(key)) << key;
  EXPECT_EQ(schema.at("properties").size(), RobotYamlShape().Keys().size());
  EXPECT_EQ(schema.at("additionalProperties"), false);
}

}  // namespace
}  // namespace gaitwright
