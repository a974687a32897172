// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/name_of_description.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

TEST(NameOfDescription, IsOfTheFileElseOfTheFolderElseOfTheText) {
  const std::string text = "<robot name='strider'/>";
  EXPECT_EQ(NameOfDescription("robots/walker.urdf", text), "walker");
  EXPECT_EQ(NameOfDescription("walker.urdf.xacro", text), "walker");
  EXPECT_EQ(NameOfDescription("walker/robot.urdf", text), "walker");
  EXPECT_EQ(NameOfDescription("walker/robot.urdf.xacro", text), "walker");
  for (const std::string folder : {"urdf", "xacro", "mjcf", "robots"})
    EXPECT_EQ(NameOfDescription("walker/" + folder + "/robot.urdf", text), "strider") << folder;
}

TEST(NameOfDescription, ATextWithoutAFitNameLeavesTheFolders) {
  for (const std::string text : {"<robot/>", "<robot name=''/>", "<robot name='../up'/>", "no text"})
    EXPECT_EQ(NameOfDescription("walker/urdf/robot.urdf", text), "urdf") << text;
  EXPECT_EQ(NameOfDescription("robot.urdf", "<robot name='strider'/>"), "robot");
}

}  // namespace
}  // namespace gaitwright
