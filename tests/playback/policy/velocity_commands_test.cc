// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "playback/policy/velocity_commands_internal.h"

namespace gaitwright {
namespace {

constexpr char kCsv[] = "time_s,speed_m_s,yaw_rate_rad_s\n0,0.5,0\n2.5, -0.25 ,0.3\n";
constexpr char kYaml[] = "- {time_s: 0, speed_m_s: 0.5}\n- {time_s: 2.5, speed_m_s: -0.25, yaw_rate_rad_s: 0.3}\n";

std::string CommandsMessage(const std::string& text, const std::string& name) {
  const Result<VelocityCommands> commands = ReadCommands(text, name);
  return commands ? "" : commands.failure().message;
}

TEST(VelocityCommandsTest, CsvAndYamlSayTheSame) {
  const VelocityCommands csv = ReadCommands(kCsv, "c.csv").value(), yaml = ReadCommands(kYaml, "c.yaml").value();
  EXPECT_EQ(csv, yaml);
  ASSERT_EQ(csv.rows.size(), 2U);
  EXPECT_EQ(csv.rows[1].AsVector(), Vector3(-0.25, 0.0, 0.3));
}

TEST(VelocityCommandsTest, EachHoldsUntilTheNext) {
  const VelocityCommands commands = ReadCommands(kCsv, "c.csv").value();
  EXPECT_EQ(commands.At(0.0).speed_m_s, 0.5);
  EXPECT_EQ(commands.At(2.4999).speed_m_s, 0.5);
  EXPECT_EQ(commands.At(2.5).speed_m_s, -0.25);
  EXPECT_EQ(commands.At(100.0).speed_m_s, -0.25);
}

TEST(VelocityCommandsTest, RefusesWithTheLine) {
  EXPECT_EQ(CommandsMessage("time_s,speed\n0,1\n", "c.csv"),
            "'c.csv': line 1: unknown column 'speed'; the nearest is 'speed_m_s'");
  EXPECT_NE(CommandsMessage("time_s,speed_m_s\n0,fast\n", "c.csv").find("line 2: speed_m_s is 'fast'"),
            std::string::npos);
  EXPECT_NE(CommandsMessage("time_s,speed_m_s\n0\n", "c.csv").find("line 2: there are 1 cells"), std::string::npos);
  EXPECT_NE(CommandsMessage("speed_m_s\n0\n", "c.csv").find("no column 'time_s'"), std::string::npos);
  EXPECT_NE(CommandsMessage("time_s\n", "c.csv").find("contains no commands"), std::string::npos);
  EXPECT_NE(CommandsMessage("time_s\n1\n", "c.csv").find("must be at 0 s"), std::string::npos);
  EXPECT_NE(CommandsMessage("time_s\n0\n2\n2\n", "c.csv").find("times must increase"), std::string::npos);
  EXPECT_NE(CommandsMessage("- {time_s: 0, sped_m_s: 1}\n", "c.yaml").find("'speed_m_s'"), std::string::npos);
  EXPECT_NE(CommandsMessage("- {time_s: 0, speed_m_s: 1000}\n", "c.yaml"), "");
}

}  // namespace
}  // namespace gaitwright
