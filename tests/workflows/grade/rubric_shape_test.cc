// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/rubric_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "kinematics/base/result.h"
#include "workflows/grade/motion_measures.h"

namespace gaitwright {
namespace {

const std::vector<RubricPartKind> kPartKinds = {
    RubricPartKind::kFunction,   RubricPartKind::kAnswers, RubricPartKind::kPlan,      RubricPartKind::kMotion,
    RubricPartKind::kParameters, RubricPartKind::kPlanner, RubricPartKind::kController};

bool HasKey(const DataShape& shape, const std::string& key) {
  const std::vector<std::string> keys = shape.Keys();
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

bool NeedsKey(const DataShape& shape, const std::string& key) {
  const std::vector<std::string> keys = shape.NeededKeys();
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

TEST(RubricShape, EveryPartNeedsWhatMarksItAndHasEachKeyOnce) {
  ASSERT_EQ(kPartKinds.size(), PartKindNames().size());
  for (const RubricPartKind kind : kPartKinds) {
    const DataShape part = PartShape(kind);
    for (const char* key : {"name", "kind", "file", "points"}) EXPECT_TRUE(NeedsKey(part, key)) << key;
    EXPECT_EQ(part.At("kind").choices, std::vector<std::string>{PartKindNames()[static_cast<std::size_t>(kind)]});
    const std::vector<std::string> keys = part.Keys();
    EXPECT_EQ(std::set<std::string>(keys.begin(), keys.end()).size(), keys.size()) << "a key twice";
  }
}

TEST(RubricShape, PartsThatArePlayedNeedARobotAndChecksAndTheOthersAReference) {
  for (const RubricPartKind kind : kPartKinds) {
    const DataShape part = PartShape(kind);
    EXPECT_EQ(NeedsKey(part, "robot"), PlaysMotions(kind));
    EXPECT_EQ(NeedsKey(part, "checks"), PlaysMotions(kind));
    EXPECT_EQ(NeedsKey(part, "reference"), !PlaysMotions(kind));
    EXPECT_EQ(HasKey(part, "trials"), PlaysMotions(kind));
    EXPECT_EQ(HasKey(part, "function"), RunsCode(kind));
    EXPECT_EQ(HasKey(LimitsShape(kind), "motion_s"), PlaysMotions(kind));
  }
}

TEST(RubricShape, KeysOfOneKindAreOfNoOther) {
  EXPECT_TRUE(HasKey(PartShape(RubricPartKind::kPlanner), "swing_s"));
  EXPECT_FALSE(HasKey(PartShape(RubricPartKind::kMotion), "swing_s"));
  EXPECT_TRUE(HasKey(PartShape(RubricPartKind::kParameters), "options"));
  EXPECT_FALSE(HasKey(PartShape(RubricPartKind::kController), "options"));
  EXPECT_FALSE(HasKey(PartShape(RubricPartKind::kController), "controller")) << "it is what is handed in";
  EXPECT_TRUE(HasKey(PartShape(RubricPartKind::kPlan), "controller"));
  EXPECT_TRUE(HasKey(PartShape(RubricPartKind::kAnswers), "seed"));
  EXPECT_FALSE(HasKey(PartShape(RubricPartKind::kFunction), "seed")) << "a function is asked what it does not know";
}

TEST(RubricShape, ChecksAreOfMeasuresThatTheKindHas) {
  for (const RubricPartKind kind : kPartKinds) {
    EXPECT_EQ(CheckShape(kind).At("measure").choices, MeasuresOf(kind));
    EXPECT_FALSE(MeasuresOf(kind).empty());
  }
  EXPECT_EQ(MeasuresOf(RubricPartKind::kPlan), MotionMeasureNames());
  EXPECT_EQ(MeasuresOf(RubricPartKind::kAnswers), (std::vector<std::string>{"share_right", "largest_error"}));
}

TEST(RubricShape, ARubricIsAListOfPartsOfAnyKind) {
  const DataShape rubric = RubricShape();
  EXPECT_TRUE(NeedsKey(rubric, "title"));
  EXPECT_EQ(rubric.At("parts").least, 1U);
  const nlohmann::json schema = nlohmann::json::parse(SchemaOf(rubric, "rubric", "marks"));
  EXPECT_EQ(schema.at("title"), "rubric");
  for (const std::string& kind : PartKindNames())
    EXPECT_NE(schema.dump().find("\"" + kind + "\""), std::string::npos) << kind;
}

}  // namespace
}  // namespace gaitwright
