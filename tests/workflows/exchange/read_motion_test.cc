// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

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
  EXPECT_EQ(table->format, "frames-csv");
  EXPECT_EQ(table->rows(), 2);
}

}  // namespace
}  // namespace gaitwright
