// SPDX-License-Identifier: BSD-3-Clause
// Reading messages of pages; their effects on a robot are tested elsewhere.
#include "workflows/live/live_requests.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

std::string RefusalOfMessage(const std::string& message) {
  static const RobotModel model = synthetic::Robot(4, FootType::kSphere);
  try {
    ReadLiveRequest(model, message);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

void ExpectParts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
}

TEST(LiveMessages, OnesThatAreInRangeAreRead) {
  for (const char* message :
       {R"({"do": "pace", "gait": "trot", "speed_m_s": 0.5})", R"({"do": "pace", "gait": "stand"})",
        R"({"do": "heading", "heading_deg": -270})", R"({"do": "pull", "body": 0, "at_m": [0,0,0], "by_m": [0.1,0,0]})",
        R"({"do": "push", "force_n": [1,2,3], "for_s": 0.5})", R"({"do": "let_go"})", R"({"do": "reset"})",
        R"({"do": "stand_up"})", R"({"do": "ground", "friction": 0.5, "slope_deg": 5, "slope_direction_deg": 0})",
        R"({"do": "options", "options": {"stabilised.dcm_gain": 2}})",
        R"({"do": "nudge", "dof": 3, "by": 0.1, "for_s": 1})", R"({"do": "clock", "paused": true, "steps": 5})",
        R"({"do": "clock"})"})
    EXPECT_EQ(RefusalOfMessage(message), "") << message;
}

TEST(LiveMessages, WhatIsNoRequestIsRefusedInWords) {
  ExpectParts(RefusalOfMessage("{"), {"not JSON"});
  ExpectParts(RefusalOfMessage("[]"), {"'do'"});
  ExpectParts(RefusalOfMessage("{}"), {"'do'"});
  ExpectParts(RefusalOfMessage(R"({"do": "dance"})"), {"'dance'", "'pace'", "'reset'"});
  ExpectParts(RefusalOfMessage(R"({"do": "reset", "now": true})"), {"now"});
  ExpectParts(RefusalOfMessage(R"({"do": "pace"})"), {"gait"});
  ExpectParts(RefusalOfMessage(R"({"do": "reset", "do": "push"})"), {"do"});
  EXPECT_EQ(RefusalOfMessage(std::string(kLongestLiveMessage + 1, ' ')),
            "the message has 65537 bytes; at most 65536 are read");
}

TEST(LiveMessages, ValuesOutOfRangeAreRefused) {
  for (const char* message :
       {R"({"do": "pace", "gait": "trot", "speed_m_s": 21})", R"({"do": "heading", "heading_deg": 1e9})",
        R"({"do": "pull", "body": 99, "at_m": [0,0,0], "by_m": [0,0,0]})",
        R"({"do": "pull", "body": 0, "at_m": [0,0,1e4], "by_m": [0,0,0]})",
        R"({"do": "pull", "body": 0, "at_m": [0,0], "by_m": [0,0,0]})",
        R"({"do": "push", "force_n": [1,2,3], "for_s": 11})", R"({"do": "push", "force_n": [1,2], "for_s": 1})",
        R"({"do": "nudge", "dof": -1, "by": 0.1, "for_s": 1})", R"({"do": "nudge", "dof": 12, "by": 0.1, "for_s": 1})",
        R"({"do": "clock", "steps": 10001})", R"({"do": "clock", "paused": 1})",
        R"({"do": "options", "options": {"stabilised.dcm_gain": 1e9}})",
        R"({"do": "options", "options": {"stabilised.dcm_gian": 2}})", R"({"do": "options", "options": [1]})",
        R"({"do": "pace", "gait": "gallopp"})"})
    EXPECT_NE(RefusalOfMessage(message), "") << message;
}

TEST(LiveMessages, PagesDoNotNameFiles) {
  ExpectParts(RefusalOfMessage(R"({"do": "pace", "gait": "/etc/gaits.yaml"})"), {"is a file"});
}

std::string PoseMessage(const VectorX& q) {
  std::string list;
  for (const double number : q) list += (list.empty() ? "" : ",") + std::to_string(number);
  return R"({"do": "pose", "q": [)" + list + "]}";
}

TEST(LiveMessages, APoseIsWithinTheLimitsOfItsJoints) {
  const RobotModel model = synthetic::Robot(4, FootType::kSphere);
  VectorX q = VectorX::Zero(model.nq());
  q[6] = 2.0;  // not of unit length; it is normalised
  EXPECT_EQ(RefusalOfMessage(PoseMessage(q)), "");
  q[7] = 1.00005;
  EXPECT_EQ(RefusalOfMessage(PoseMessage(q)), "") << "rounding";
  q[7] = 1.01;
  ExpectParts(RefusalOfMessage(PoseMessage(q)), {model.dof_names[0], "-1 to 1"});
  q[7] = 0.0;
  q[6] = 0.0;
  ExpectParts(RefusalOfMessage(PoseMessage(q)), {"quaternion"});
  EXPECT_NE(RefusalOfMessage(PoseMessage(VectorX::Zero(model.nq() - 1))), "");
}

TEST(LiveMessages, OptionsOfPagesAreNumbersWithRangesAndEachOnce) {
  PlayRequest play;
  std::set<std::string> keys;
  for (const OptionField& field : LiveOptions(play)) {
    EXPECT_TRUE(std::holds_alternative<double*>(field.target)) << field.key;
    EXPECT_TRUE(keys.insert(field.key).second) << field.key;
    EXPECT_TRUE(field.key.starts_with("stabilised.") || field.key.starts_with("recovering.") ||
                field.key.starts_with("gains."))
        << field.key;
  }
  EXPECT_TRUE(keys.contains("stabilised.dcm_gain"));
  PlayRequest plain;
  plain.controller = "joint-pd";
  EXPECT_LT(LiveOptions(plain).size(), keys.size()) << "only those that act";
}

}  // namespace
}  // namespace gaitwright
