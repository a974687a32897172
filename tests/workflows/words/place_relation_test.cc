// SPDX-License-Identifier: BSD-3-Clause
// Relations to places: a robot walks and jumps to a place, and nowhere around it.
#include "workflows/words/place_relation.h"

#include <gtest/gtest.h>

#include "tests/workflows/words/told_tasks.h"

namespace gaitwright {
namespace {

std::variant<TaskPlan, words::Refusal> ReportedPlaces(const std::string& text) {
  TaskScope scope = ScopeOf(LoadNamedRobot("a1").value());
  scope.places = PlacesOf(tasks_in_words::WithMarkers());
  return words::Understand(text, scope);
}

TEST(PlaceRelation, ToAPlaceIsUnderstood) {
  for (const char* text : {"walk to the door", "jump to the red marker", "走到门", "走到门那里"}) {
    const auto result = ReportedPlaces(text);
    ASSERT_TRUE(std::holds_alternative<TaskPlan>(result)) << text;
    EXPECT_TRUE(std::get<TaskPlan>(result).tasks.front().Has("to")) << text;
  }
}

TEST(PlaceRelation, OtherRelationsAreRefusedWithTheirWords) {
  for (const auto& [text, part] :
       {std::pair("walk from the door", "from the door"), std::pair("walk through the door", "through the door"),
        std::pair("走到门后面", "门后面"), std::pair("jump off the red marker", "off the red marker")}) {
    const auto result = ReportedPlaces(text);
    ASSERT_TRUE(std::holds_alternative<words::Refusal>(result)) << text;
    const words::Refusal& refusal = std::get<words::Refusal>(result);
    EXPECT_EQ(refusal.code, FailureCode::kUnknown) << text;
    EXPECT_NE(refusal.part.find(part), std::string::npos) << text << ": " << refusal.part;
  }
}

}  // namespace
}  // namespace gaitwright
