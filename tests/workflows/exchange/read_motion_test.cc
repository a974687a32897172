// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/named_robot.h"
#include "tests/scratch_folder.h"
#include "workflows/exchange/read_motion_internal.h"

namespace gaitwright {
namespace {

Result<MotionText> TextOf(const std::string& name, const std::string& text) {
  std::ofstream(ScratchFile(name)) << text;
  ImportRequest request;
  request.file = ScratchFile(name);
  return ReadMotionText(request);
}

TEST(ReadMotion, TellsFormatsByEndingAndContent) {
  EXPECT_EQ(TextOf("a.csv", "time_s,x\n0,1\n")->form, MotionForm::kCsv);
  EXPECT_EQ(TextOf("a.txt", "0,1\n")->form, MotionForm::kCsv);
  EXPECT_EQ(TextOf("b.txt", "{\"FrameDuration\": 0.1, \"Frames\": []}")->form, MotionForm::kTree)
      << "JSON in a text file";
  EXPECT_EQ(TextOf("a.yaml", "footsteps: []\n")->form, MotionForm::kFootsteps);
  EXPECT_EQ(TextOf("a.json", "{\"joint_names\": [], \"points\": []}")->form, MotionForm::kTree);
  EXPECT_EQ(TextOf("a.mcap", "\x89MCAP0\r\n")->form, MotionForm::kRecording);
}

TEST(ReadMotion, KeepsTheBytesOfArrays) {
  const std::string bytes("PK\x03\x04\0\0\xff", 7);
  const auto read = TextOf("a.npz", bytes);
  ASSERT_TRUE(read.ok()) << read.failure().message;
  EXPECT_EQ(read->form, MotionForm::kNpz);
  EXPECT_EQ(read->text, bytes);
  ImportRequest request;
  request.file = ScratchFile("a.npz");
  const auto table = ReadMotionTable(NamedRobot("a1"), *read, request);
  ASSERT_FALSE(table.ok());
  EXPECT_NE(table.failure().message.find("it is not a ZIP archive"), std::string::npos) << table.failure().message;
}

TEST(ReadMotion, RefusesOtherFiles) {
  EXPECT_NE(TextOf("a.fbx", "Kaydara").failure().message.find("a file of type '.fbx' is not a known motion"),
            std::string::npos);
  EXPECT_NE(
      TextOf("plan.json", "{\"format\": \"gaitwright-motion-plan\"}").failure().message.find("accept it directly"),
      std::string::npos);
  ImportRequest request;
  request.file = ScratchFolder().string();
  EXPECT_NE(ReadMotionText(request).failure().message.find("is a folder"), std::string::npos);
}

TEST(ReadMotion, ReadsFramesWhereNoColumnHasAName) {
  ImportRequest request;
  request.file = "motion.csv";
  const std::string row = "0,0,1,0,0,0,1" + std::string(",0,0,0,0,0,0,0,0,0,0,0,0") + "\n";
  const auto table = ReadMotionTable(NamedRobot("a1"), {row + row, MotionForm::kCsv}, request);
  ASSERT_TRUE(table.ok()) << table.failure().message;
  EXPECT_EQ(table->format, MotionFormat::kFramesCsv);
  EXPECT_EQ(table->rows(), 2);
}

/// A table of the standing A1 without names: times, base, a column of a battery, and the joints in another order.
std::string LoggedTable(const RobotModel& model) {
  std::string text;
  for (int k = 0; k < 6; ++k) {
    text += fmt::format("{} 0 0 {} 0 0 0 1 12.1", 0.01 * k, model.standing_base_height_m);
    for (Eigen::Index d = model.num_dofs(); d-- > 0;) text += fmt::format(" {}", model.standing_joints[d]);
    text += "\n";
  }
  std::replace(text.begin(), text.end(), ' ', ',');
  return text;
}

Result<MotionTable> LoggedMotion(const std::string& names) {
  std::ofstream(ScratchFile("names.yaml")) << names;
  ImportRequest request;
  request.file = "log.csv";
  request.columns_file = ScratchFile("names.yaml");
  return ReadMotionTable(NamedRobot("a1"), {LoggedTable(NamedRobot("a1")), MotionForm::kCsv}, request);
}

TEST(ReadMotion, NamesOfColumnsMayBeInAFile) {
  const RobotModel& model = NamedRobot("a1");
  std::string names = "names: [clock, base_x_m, base_y_m, base_z_m, base_qx, base_qy, base_qz, base_qw, battery";
  std::string numbers =
      "columns: {1: time_s, 2: base_x_m, 3: base_y_m, 4: base_z_m, 5: base_qx, 6: base_qy, "
      "7: base_qz, 8: base_qw";
  for (int d = model.num_dofs(); d-- > 0;) {
    const std::string& joint = model.dof_names[static_cast<std::size_t>(d)];
    names += fmt::format(", q_{}_rad", joint);
    numbers += fmt::format(", {}: q_{}_rad", 9 + model.num_dofs() - d, joint);
  }
  names += "]\ncolumns: {clock: time_s}\nignore: [battery]\n";
  for (const std::string& file : {names, numbers + "}\nignore: [9]\n"}) {
    const auto table = LoggedMotion(file);
    ASSERT_TRUE(table.ok()) << table.failure().message;
    EXPECT_EQ(table->format, MotionFormat::kCsv);
    EXPECT_NEAR(table->time_s[5], 0.05, 1e-12);
    EXPECT_LT((table->q[0] - model.standing_joints).norm(), 1e-9);
  }
  const std::string few = LoggedMotion("names: [time_s, base_x_m]\n").failure().message;
  EXPECT_NE(few.find("has 2 names, but 'log.csv' has 21 columns"), std::string::npos) << few;
  names.replace(names.find("base_x_m"), 8, "base_y_m");
  EXPECT_NE(LoggedMotion(names).failure().message.find("twice"), std::string::npos);
  ImportRequest request;
  request.file = "motion.csv";
  request.columns_file = ScratchFile("names.yaml");
  EXPECT_NE(ReadMotionTable(model, {"time_s,x\n0,1\n", MotionForm::kCsv}, request)
                .failure()
                .message.find("has 'names', but 'motion.csv' has a line of names"),
            std::string::npos);
}

}  // namespace
}  // namespace gaitwright
