// SPDX-License-Identifier: BSD-3-Clause
#include "examples/instruction.h"

#include <gtest/gtest.h>

namespace gaitwright::examples {
namespace {

TEST(InstructionExample, IsObeyedInBothLanguages) {
  for (const char* instruction : {"walk two steps, then wave with your left hand", "先走两步，再挥挥左手"}) {
    const Obeyed obeyed = Obey(instruction, "nao");
    ASSERT_EQ(obeyed.tasks.tasks.size(), 2U);
    EXPECT_EQ(obeyed.tasks.tasks[1].action, "wave");
    EXPECT_TRUE(obeyed.report.pass) << obeyed.report.reason;
  }
}

TEST(InstructionExample, WhatIsNotUnderstoodIsNamed) {
  try {
    Obey("walk two steps, then juggle", "nao");
    ADD_FAILURE();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("'juggle'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gaitwright::examples
