// SPDX-License-Identifier: BSD-3-Clause
// `audit` before a plan runs on a robot: margins, start posture, approach, and the page to sign.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

class BeforeHardware : public Stranger {
 protected:
  BeforeHardware() { MakePlan("plan.json"); }

  /// A start posture: the standing posture of the robot, with one joint at another position.
  void Measure(const std::string& name, const std::string& joint, double by) const {
    const Json standing = Run({"robots", "show", "a1", "--json"}).json().at("standing");
    std::string text;
    for (const auto& [key, value] : standing.items())
      text += fmt::format("{}: {:.6f}\n", key, value.get<double>() + (key == joint ? by : 0.0));
    Write(name, text);
  }
  std::string Knee() const {
    const Json standing = Run({"robots", "show", "a1", "--json"}).json().at("standing");
    for (const auto& [key, value] : standing.items()) {
      if (key.find("calf") != std::string::npos) return key;
    }
    return "";
  }
  /// A result of a hundred trials: copies of one played trial, with given numbers of survivals and falls.
  Json Trials(int survived) const {
    const std::vector<std::string> one = {"trials", "plan.json", "-n", "1", "--out", "one.json"};
    EXPECT_EQ(Run(one).status, 0);
    Json result = Json::parse(Read("one.json"));
    std::filesystem::remove(In("one.json"));
    const auto& columns = result.at("trials").at("columns");
    Json& rows = result["trials"]["rows"];
    Json row = rows.at(0);
    const auto set = [&](const char* column, const Json& value) {
      row[static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin())] = value;
    };
    rows = Json::array();
    for (int i = 0; i < 100; ++i) {
      set("survived", i < survived);
      set("passed", i < survived);
      set("cause", i < survived ? "" : "a foot slid");
      set("log_hash", fmt::format("{:016x}", i));
      rows.push_back(row);
    }
    // Wilson's interval of 95 %.
    const double n = 100.0, z2 = 3.8414588, p = survived / n;
    const double middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
    const double half = std::sqrt(z2 * (p * (1.0 - p) / n + z2 / (4.0 * n * n))) / (1.0 + z2 / n);
    result["n"] = 100;
    result["survived"] = result["passed"] = survived;
    result["survival"] = p;
    result["survival_low"] = middle - half;
    result["survival_high"] = std::min(1.0, middle + half);
    result["causes"] = Json::object();
    if (survived < 100) result["causes"]["a foot slid"] = 100 - survived;
    return result;
  }
};

TEST_F(BeforeHardware, MarginsAreGivenOnlyWhenAskedFor) {
  EXPECT_FALSE(Run({"audit", "plan.json", "--json"}).json().contains("margins"));
  const Ran ran = Run({"audit", "plan.json", "--margins", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  EXPECT_EQ(json.at("verdict"), "pass");
  int torques = 0;
  for (const Json& m : json.at("margins")) {
    if (m.at("law") != "joint_torque") continue;
    ++torques;
    EXPECT_GT(m.at("share"), 0.0);
    EXPECT_LT(m.at("value"), m.at("limit"));
  }
  EXPECT_EQ(torques, 12);
  EXPECT_NE(Run({"audit", "plan.json", "--margins"}).out.find("joint_velocity"), std::string::npos);
}

TEST_F(BeforeHardware, AFailSaysForHowLong) {
  EXPECT_EQ(Run({"audit", "plan.json", "--json"}).json().at("broken"), Json::array());
  const Ran ran = Run({"audit", "plan.json", "--derate", "torque=0.1", "--json"});
  ASSERT_EQ(ran.status, 3) << ran.err;
  const Json json = ran.json();
  ASSERT_EQ(json.at("broken").size(), 1U);
  const Json broken = json.at("broken").at(0);
  EXPECT_EQ(broken.at("law"), json.at("violations").at(0).at("law"));
  EXPECT_GT(broken.at("share"), 0.05);
  EXPECT_LE(broken.at("share"), 1.0);
  EXPECT_LE(broken.at("worst_s").size(), 3U);
  EXPECT_NE(Run({"audit", "plan.json", "--derate", "torque=0.1"}).out.find(" of the time, longest from "),
            std::string::npos);
}

TEST_F(BeforeHardware, EveryLimitMayBeDerated) {
  EXPECT_EQ(Run({"audit", "plan.json", "--derate", "acceleration=0.5,jerk=0.5,continuous=0.5", "--quiet"}).out,
            "pass\n")
      << "the robot gives none of them";
  ExpectRefused(Run({"audit", "plan.json", "--derate", "jerks=0.5"}), 1, {"'jerks'", "'jerk'"});
}

TEST_F(BeforeHardware, AJumpIsNamedAndAnApproachIsPlanned) {
  const std::string knee = Knee();
  Measure("near.yaml", "", 0.0);
  Measure("off.yaml", knee, -0.3);
  const Ran near = Run({"audit", "plan.json", "--start-posture", "near.yaml", "--set", "start_tolerance_rad=0.2"});
  EXPECT_EQ(near.status, 0) << near.out;
  const Ran jump = Run({"audit", "plan.json", "--start-posture", "off.yaml", "--approach", "way.json", "--json"});
  EXPECT_EQ(jump.status, 3) << jump.err;
  const Json json = jump.json();
  EXPECT_EQ(json.at("violations").at(0).at("law"), "start_posture");
  EXPECT_EQ(json.at("violations").at(0).at("where"), knee);
  EXPECT_EQ(json.at("approach").at("base"), "hanging");
  EXPECT_GE(json.at("approach").at("duration_s"), 1.0);
  EXPECT_EQ(json.at("approach").at("farthest"), knee);
  const Ran approach = Run({"audit", "way.json", "--start-posture", "off.yaml", "--json"});
  EXPECT_EQ(approach.status, 0) << approach.out;
  EXPECT_EQ(approach.json().at("verdict"), "pass");
}

TEST_F(BeforeHardware, ATiltedBaseIsNotCorrectedByAnApproach) {
  Measure("near.yaml", "", 0.0);
  Write("tilted.yaml", Read("near.yaml") + "base_quaternion_xyzw: [0.1494381, 0, 0, 0.9887711]\n");
  const std::vector<std::string> audit = {"audit",       "plan.json", "--start-posture",
                                          "tilted.yaml", "--set",     "start_tolerance_rad=0.2",
                                          "--approach",  "way.json"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = audit;
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  };
  const std::string none = "no approach is needed, and 'way.json' is not written";
  EXPECT_NE(with({}).out.find(none), std::string::npos) << with({}).out;
  EXPECT_TRUE(with({"--json"}).json().at("approach").is_null());
  const Ran page = with({"--preflight"});
  EXPECT_EQ(page.status, 3) << page.err;
  EXPECT_NE(page.out.find(none), std::string::npos) << page.out;
  EXPECT_NE(page.out.find("the measured base is tilted by 0.3"), std::string::npos) << page.out;
  EXPECT_EQ(page.out.find("run it"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(In("way.json")));
}

TEST_F(BeforeHardware, AHangingRobotIsReportedWhereverItsApproachIsChecked) {
  Measure("off.yaml", Knee(), -0.3);
  EXPECT_EQ(Run({"audit", "plan.json", "--start-posture", "off.yaml", "--approach", "way.json", "--quiet"}).status, 3);
  const std::string warning = "robot 'a1' hangs: its base is assumed to be held in the air";
  const Ran audit = Run({"audit", "way.json"});
  EXPECT_EQ(audit.status, 0) << audit.err;
  EXPECT_NE(audit.out.find("\nwarning: " + warning), std::string::npos) << audit.out;
  const std::size_t note = audit.out.find("\nnote: from 0 to ");
  ASSERT_NE(note, std::string::npos) << audit.out;
  EXPECT_NE(audit.out.find("the base is held externally", note), std::string::npos) << audit.out;
  EXPECT_EQ(Run({"audit", "way.json", "--quiet"}).out, "pass\n");
  const Json warnings = Run({"audit", "way.json", "--json"}).json().at("warnings");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(warnings.at(0).get<std::string>().starts_with(warning)) << warnings;
  for (const char* verb : {"play", "trials"})
    ExpectRefused(Run({verb, "way.json"}), 1, {"held externally", "play the plan that follows it"});
  for (const char* verb : {"audit", "play"})
    EXPECT_EQ(Run({verb, "plan.json", "--json"}).json().at("warnings"), Json::array()) << verb;
}

TEST_F(BeforeHardware, WrongFilesAreRefusedAndNothingIsWritten) {
  Measure("off.yaml", Knee(), -9.0);
  ExpectRefused(Run({"audit", "plan.json", "--start-posture", "off.yaml"}), 1, {"'off.yaml'", Knee(), "limits of"});
  ExpectRefused(Run({"audit", "plan.json", "--start-posture", "none.yaml"}), 1, {"none.yaml"});
  ExpectRefused(Run({"audit", "plan.json", "--approach", "way.json"}), 1, {"--approach", "--start-posture"});
  ExpectRefused(Run({"audit", "plan.json", "--report", "page.html"}), 1, {"--report", "--preflight"});
  ExpectRefused(Run({"audit", "plan.json", "--trials-result", "t.json"}), 1, {"--trials-result", "--preflight"});
  ExpectRefused(Run({"audit", "plan.json", "--preflight", "--report", "plan.json"}), 1,
                {"--report", "would overwrite"});
  ExpectRefused(Run({"audit", "plan.json", "--preflight", "--trials-result", "plan.json", "--report", "page.html"}), 1,
                {"plan.json", "is a gaitwright-motion-plan", "'gaitwright trials'"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"off.yaml", "plan.json"}));
}

TEST_F(BeforeHardware, ThePageIsAGoOrANoGo) {
  const Ran alone = Run({"audit", "plan.json", "--preflight", "--report", "page.html"});
  EXPECT_EQ(alone.status, 0) << alone.err;
  EXPECT_NE(alone.out.find("PREFLIGHT: GO"), std::string::npos);
  EXPECT_NE(alone.out.find("no trials"), std::string::npos);
  EXPECT_NE(Read("page.html").find("signature"), std::string::npos);
  Write("good.json", Trials(100).dump());
  Write("bad.json", Trials(50).dump());
  EXPECT_EQ(Run({"audit", "plan.json", "--preflight", "--trials-result", "good.json", "--quiet"}).out, "go\n");
  const Ran bad = Run({"audit", "plan.json", "--preflight", "--trials-result", "bad.json", "--json"});
  EXPECT_EQ(bad.status, 3) << bad.err;
  EXPECT_EQ(bad.json().at("verdict"), "no-go");
  EXPECT_EQ(bad.json().at("trials").at("survived"), 50);
  const std::vector<std::string> lenient = {
      "audit",  "plan.json", "--preflight", "--trials-result", "bad.json", "--set", "preflight.least_survival=0.4",
      "--quiet"};
  EXPECT_EQ(Run(lenient).out, "go\n");
  Json other = Trials(100);
  other["plan_hash"] = "0123";
  Write("other.json", other.dump());
  ExpectRefused(Run({"audit", "plan.json", "--preflight", "--trials-result", "other.json"}), 1,
                {"another plan", "'0123'"});
}

TEST_F(BeforeHardware, TrialsOfAPlanWhoseGroundWasChangedSinceAreRefused) {
  const Ran trials = Run({"trials", "plan.json", "-n", "2", "--friction", "0.7", "--out", "two.json", "--quiet"});
  EXPECT_EQ(trials.status, 0) << trials.err;
  const Ran same = Run({"audit", "plan.json", "--preflight", "--trials-result", "two.json"});
  EXPECT_NE(same.out.find("play.friction 0.7 (default 0)"), std::string::npos) << same.out << same.err;
  EXPECT_NE(same.out.find("mass_scale"), std::string::npos) << "disturbances";
  Json plan = Json::parse(Read("plan.json"));
  plan["terrain"]["patches"][0]["friction"] = 0.4;
  Write("icy.json", plan.dump());
  ExpectRefused(Run({"audit", "icy.json", "--preflight", "--trials-result", "two.json"}), 1,
                {"another plan", "plan_hash"});
}

using Verdicts = Stranger;

/// Doubles the torque of the first motor.
void DoubleFirstTorque(Json& plan) {
  for (Json& row : plan.at("tau_nm")) row.at(0) = 2.0 * row.at(0).get<double>() + 1.0;
}

TEST_F(Verdicts, ABrokenPlanFailsItsAudit) {
  Json plan = MakePlan("plan.json");
  DoubleFirstTorque(plan);
  Write("broken.json", plan.dump());
  const Ran ran = Run({"audit", "broken.json", "--json"});
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_EQ(ran.err, "");
  const Json json = ran.json();
  EXPECT_EQ(json.at("verdict"), "fail");
  ASSERT_FALSE(json.at("violations").empty());
  bool dynamics = false;
  for (const Json& violation : json.at("violations")) {
    EXPECT_TRUE(violation.at("at_s").is_number());
    EXPECT_GT(violation.at("value"), violation.at("limit"));
    EXPECT_FALSE(violation.at("where").get<std::string>().empty());
    EXPECT_FALSE(violation.at("unit").get<std::string>().empty());
    dynamics = dynamics || violation.at("law") == "dynamics";
  }
  EXPECT_TRUE(dynamics) << json.dump();
  EXPECT_EQ(Run({"audit", "broken.json", "--quiet"}).out, "fail\n");
  EXPECT_NE(Run({"audit", "broken.json"}).out.find("dynamics"), std::string::npos);
}

TEST_F(Verdicts, DeratedLimitsFail) {
  MakePlan("plan.json");
  const Ran ran = Run({"audit", "plan.json", "--derate", "torque=0.1,speed=0.9", "--json"});
  EXPECT_EQ(ran.status, 3);
  EXPECT_EQ(ran.json().at("violations").at(0).at("law"), "joint_torque");
  ExpectRefused(Run({"audit", "plan.json", "--derate", "torqe=0.1"}), 1, {"'torqe'", "'torque'"});
  ExpectRefused(Run({"audit", "plan.json", "--derate", "torque"}), 1, {"--derate", "key=value"});
  for (const char* twice : {"torque=0.2,torque=1", "torque=1,speed=1,torque=0.2"})
    ExpectRefused(Run({"audit", "plan.json", "--derate", twice}), 1, {"--derate: 'torque' is given twice"});
}

}  // namespace
}  // namespace gaitwright::cli
