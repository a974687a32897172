// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/playback/synthetic.h"
#include "tests/playback/xml_check.h"
#include "workflows/render/drawing_tables_internal.h"

namespace gaitwright {
namespace {

int RowsWith(const std::string& svg, const std::string& part) {
  int count = 0;
  for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + part.size())) ++count;
  return count;
}

DrawnTable TablesOf(const RobotModel& model, double width_px) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  return DrawnTables(model, scratch, Vector2(10.0, 20.0), width_px);
}

TEST(DrawingTables, HaveEachFootAndEachJointByItsNumber) {
  const RobotModel model = synthetic::Robot(4, FootType::kSphere);
  const DrawnTable table = TablesOf(model, 900.0);
  EXPECT_EQ(XmlFault(table.svg), "");
  EXPECT_EQ(RowsWith(table.svg, "number-of-table"), 12);
  for (const std::string& name : model.dof_names)
    EXPECT_EQ(RowsWith(table.svg, ">" + name + " (prismatic)<"), 1) << name;
  EXPECT_EQ(RowsWith(table.svg, ": ball, radius 20.0 mm"), 4);
  EXPECT_EQ(RowsWith(table.svg, ">+z<"), 4) << "an axis along z of each leg";
}

TEST(DrawingTables, ASoleHasItsCornersAndItsSize) {
  const DrawnTable table = TablesOf(synthetic::Robot(2, FootType::kSole), 900.0);
  EXPECT_EQ(RowsWith(table.svg, "sole of 4 corners, 160 x 80 mm"), 2);
}

/// Joints are listed in as many columns as fit, so a narrow table is higher.
TEST(DrawingTables, ANarrowTableIsHigherAndAllStaysInIt) {
  const RobotModel model = synthetic::Robot(4, FootType::kSphere);
  const DrawnTable wide = TablesOf(model, 1200.0), narrow = TablesOf(model, 320.0);
  EXPECT_GT(narrow.height_px, wide.height_px);
  for (const auto& [table, width] : {std::pair(&wide, 1200.0), std::pair(&narrow, 320.0)}) {
    for (std::size_t at = table->svg.find("<text"); at != std::string::npos; at = table->svg.find("<text", at + 1)) {
      const double x = std::strtod(table->svg.c_str() + table->svg.find("x=\"", at) + 3, nullptr);
      const double y = std::strtod(table->svg.c_str() + table->svg.find(" y=\"", at) + 4, nullptr);
      EXPECT_GE(x, 10.0);
      EXPECT_LT(x, 10.0 + width);
      EXPECT_GT(y, 20.0);
      EXPECT_LE(y, 20.0 + table->height_px);
    }
  }
}

TEST(DrawingTables, ANameThatIsTooLongIsCutBetweenItsLetters) {
  RobotModel model = synthetic::Robot(2, FootType::kSole);
  model.joints[0].name = std::string(60, 'w');
  model.joints[1].name = "\xC3\xA9" +
                         std::string("\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9") +
                         std::string(60, 'w');
  const std::string svg = TablesOf(model, 900.0).svg;
  EXPECT_EQ(RowsWith(svg, model.joints[0].name), 0);
  EXPECT_EQ(RowsWith(svg, "...</text>"), 2);
  EXPECT_EQ(RowsWith(svg, "\xC3..."), 0) << "no half of a letter";
}

}  // namespace
}  // namespace gaitwright
