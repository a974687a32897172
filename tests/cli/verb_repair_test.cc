// SPDX-License-Identifier: BSD-3-Clause
// The verb `repair`: output, files and refusals.
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

class Repair : public Stranger {
 protected:
  void SetUp() override {
    Stranger::SetUp();
    MakePlan("plan.json");
    EXPECT_EQ(Run({"export", "plan.json", "--format", "csv", "--out", "motion.csv", "--quiet"}).status, 0);
  }
};

TEST_F(Repair, KeepsASoundMotionAndPlaysIt) {
  const Ran ran = Run({"repair", "motion.csv", "--out", "new/repaired.json", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  EXPECT_EQ(json.at("robot"), "a1");
  EXPECT_EQ(json.at("verdict"), "pass");
  EXPECT_EQ(json.at("kept"), true);
  EXPECT_LT(json.at("distance").at("joint_largest_rad"), 0.01);
  EXPECT_EQ(json.at("files").at("plan"), "new/repaired.json");
  EXPECT_EQ(Run({"audit", "new/repaired.json", "--quiet"}).out, "pass\n");
}

TEST_F(Repair, LiftsAMotionThatFloatsAndOnlyChecksIfAsked) {
  const Ran checked = Run({"repair", "motion.csv", "--set", "lift_m=0.02", "--check"});
  EXPECT_EQ(checked.status, 3) << checked.err;
  EXPECT_NE(checked.out.find("lifted: the base was moved down by 20.0 mm"), std::string::npos) << checked.out;
  EXPECT_EQ(checked.out.find("after:"), std::string::npos);
  const Ran ran = Run({"repair", "motion.csv", "--set", "lift_m=0.02", "--no-play", "--out", "down.json"});
  EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("after: audit: pass"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace gaitwright::cli
