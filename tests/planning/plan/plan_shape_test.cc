// SPDX-License-Identifier: BSD-3-Clause
// The structure of a plan file agrees with what is written and what is read.
#include "planning/plan/plan_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "planning/plan/plan_json.h"
#include "planning/plan/plan_shape_internal.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

/// A good plan with two rows and all optional parts.
const Json& ShortPlanJson() {
  static const Json json = [] {
    MotionPlan plan = GoodPlanOf("a1").plan;
    plan.adjustments = {{"speed", 0.4, 0.3, "m/s", FailureCode::kLimits, ""}};
    plan.meshes = {{"x.stl", {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.0, 0.0, 0.1}}}};
    PlanGate gate;
    gate.at_s = plan.schedule.start_s() + 0.1;
    gate.phase = "stand";
    plan.gates = {gate};
    plan.terrain.markers = {{"door", {1.0, 2.0}}};
    Json whole = Json::parse(PlanToJson(plan));
    for (const char* rows : {"centroidal", "q", "v", "a", "tau_nm", "contact_wrenches"}) {
      const Json first = whole[rows][0], second = whole[rows][1];
      whole[rows] = {first, second};
    }
    return whole;
  }();
  return json;
}

/// Paths at which a value does not match its structure.
void CollectMisfits(const DataShape& shape, const Json& value, const std::string& path,
                    std::set<std::string>& misfits) {
  if (value.is_null() && shape.or_null) return;
  switch (shape.kind) {
    case DataShape::Kind::kObject: {
      if (!value.is_object()) return static_cast<void>(misfits.insert(path + " is no object"));
      for (const std::string& key : shape.NeededKeys())
        if (!value.contains(key)) misfits.insert(path + " lacks " + key);
      for (const auto& [key, member] : value.items()) {
        const std::vector<std::string> keys = shape.Keys();
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
          misfits.insert(path + " has " + key);
        } else {
          CollectMisfits(shape.At(key), member, path + "." + key, misfits);
        }
      }
      return;
    }
    case DataShape::Kind::kList:
      if (!value.is_array() || value.size() < shape.least || value.size() > shape.most)
        return static_cast<void>(misfits.insert(path + " is no such list"));
      for (const Json& member : value) CollectMisfits(shape.of.at(0), member, path + "[]", misfits);
      return;
    case DataShape::Kind::kNumber:
    case DataShape::Kind::kWhole:
      if (!value.is_number() || value.get<double>() < shape.lowest || value.get<double>() > shape.highest)
        misfits.insert(path + " is no such number");
      return;
    case DataShape::Kind::kText:
      if (!value.is_string()) misfits.insert(path + " is no text");
      return;
    default:
      return;
  }
}

std::string RefusalOfJson(const Json& json) {
  const Result<MotionPlan> plan = PlanFromJson(json.dump(), "x.json");
  return plan.ok() ? "" : plan.failure().message;
}

TEST(PlanShapeOfFile, IsThatOfWhatIsWritten) {
  std::set<std::string> misfits;
  CollectMisfits(PlanShape(), ShortPlanJson(), "plan", misfits);
  EXPECT_TRUE(misfits.empty()) << *misfits.begin();
  EXPECT_EQ(RefusalOfJson(ShortPlanJson()), "");
}

/// Objects of each kind in the short plan, with the structure of each.
struct ObjectOfPlan {
  const char* pointer;
  DataShape shape;
};

std::vector<ObjectOfPlan> ObjectsOfPlan() {
  return {{"", PlanShape()},
          {"/provenance", ProvenanceShape()},
          {"/parts/0", PlanPartShape()},
          {"/parts/0/command", CommandShape()},
          {"/parts/0/goal", PlanarPoseShape()},
          {"/parts/0/gait", PlanGaitShape()},
          {"/goal", PlanarPoseShape()},
          {"/terrain", PlanTerrainShape()},
          {"/terrain/patches/0", PlanPatchShape()},
          {"/terrain/markers/0", PlanMarkerShape()},
          {"/footholds/0", FootholdShape()},
          {"/swings/0", SwingShape()},
          {"/meshes/0", MeshShape()},
          {"/gates/0", PlanGateShape()}};
}

TEST(PlanReadingByShape, EachNeededKeyIsNeededAndNamed) {
  int tried = 0;
  for (const ObjectOfPlan& object : ObjectsOfPlan()) {
    for (const std::string& key : object.shape.NeededKeys()) {
      Json without = ShortPlanJson();
      without.at(Json::json_pointer(object.pointer)).erase(key);
      const std::string refusal = RefusalOfJson(without);
      EXPECT_NE(refusal, "") << object.pointer << " without " << key;
      const bool named = refusal.find("'" + key + "'") != std::string::npos || key == "format" || key == "schema";
      EXPECT_TRUE(named) << object.pointer << " without " << key << ": " << refusal;
      ++tried;
    }
  }
  EXPECT_GT(tried, 80);
}

TEST(PlanReadingByShape, AnUnknownKeyIsRefusedInEachObjectWithItsPlace) {
  for (const ObjectOfPlan& object : ObjectsOfPlan()) {
    Json more = ShortPlanJson();
    more.at(Json::json_pointer(object.pointer))["colour"] = 1;
    EXPECT_NE(RefusalOfJson(more).find("'colour'"), std::string::npos) << object.pointer << RefusalOfJson(more);
  }
}

TEST(PlanReadingByShape, EachNumberIsReadAsOneAndWithinItsEnds) {
  int bounded = 0;
  for (const ObjectOfPlan& object : ObjectsOfPlan()) {
    for (const ShapeMember& member : object.shape.members) {
      const bool number = member.shape.kind == DataShape::Kind::kNumber || member.shape.kind == DataShape::Kind::kWhole;
      const Json::json_pointer at(std::string(object.pointer) + "/" + member.key);
      if (!number || !ShortPlanJson().contains(at) || member.key == "schema") continue;
      Json changed = ShortPlanJson();
      changed.at(at) = "many";
      EXPECT_NE(RefusalOfJson(changed).find(member.key), std::string::npos) << at;
      if (!(member.shape.lowest >= -1e6)) continue;
      changed.at(at) = member.shape.lowest - 1.0;
      EXPECT_NE(RefusalOfJson(changed).find(member.key), std::string::npos) << at << " of " << changed.at(at);
      ++bounded;
    }
  }
  EXPECT_GT(bounded, 8);
}

}  // namespace
}  // namespace gaitwright
