// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/names_of_feet.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

std::string Named(const std::vector<std::string>& feet, const std::string& message) {
  RobotModel model;
  for (const std::string& name : feet) model.feet.emplace_back().name = name;
  Failure failure;
  failure.message = message;
  return WithNamesOfFeet(model, failure).message;
}

TEST(NamesOfFeet, StandForNumbers) {
  EXPECT_EQ(Named({"left", "right"}, "reach of foot 0 at 1 s, friction of foot 1; foot"),
            "reach of 'left' at 1 s, friction of 'right'; foot");
}

TEST(NamesOfFeet, OfFeetThereAreNot) { EXPECT_EQ(Named({"left"}, "a foot 10 cm ahead"), "a foot 10 cm ahead"); }

TEST(NamesOfFeet, MayHoldNumbersThemselves) {
  EXPECT_EQ(Named({"foot 1", "foot 0"}, "foot 0 and foot 1"), "'foot 1' and 'foot 0'");
}

TEST(NamesOfFeet, GoBeyondTen) { EXPECT_EQ(Named(std::vector<std::string>(11, ""), "foot 10"), "''"); }

}  // namespace
}  // namespace gaitwright
