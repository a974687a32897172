// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/exchanged.h"

namespace gaitwright::cli {
namespace {

TEST_F(Exchange, ExportWritesEachFormatOfAPlanAndALog) {
  for (const char* format : {"csv", "joint-trajectory-yaml", "joint-trajectory-json", "npz", "frames-csv",
                             "frames-json", "frames-npz", "mcap"}) {
    SCOPED_TRACE(format);
    for (const char* name : {"one", "two"}) {
      const Ran ran = Run({"export", "out/plan.json", "--format", format, "--rate-hz", "250", "--out", name, "--json"});
      ASSERT_EQ(ran.status, 0) << ran.err;
      EXPECT_EQ(ran.json().at("format"), format);
      EXPECT_EQ(ran.json().at("from"), "plan");
      EXPECT_EQ(ran.json().at("files"), (Json{{"motion", name}}));
    }
    EXPECT_TRUE(Read("one") == Read("two")) << "the same bytes";
    EXPECT_GT(Read("one").size(), 10000U);
  }
  const Ran log = Run({"export", "out/log.json", "--robot", "a1", "--out", "log.csv", "--json"});
  ASSERT_EQ(log.status, 0) << log.err;
  EXPECT_EQ(log.json().at("rate_hz"), 200.0);
  EXPECT_EQ(LinesIn(Read("log.csv")), log.json().at("rows").get<std::size_t>() + 1);
  EXPECT_EQ(Run({"export", "out/log.json", "--plan", "out/plan.json", "--format", "svg", "--quiet"}).out, "plots\n");
  for (const char* plot : {"zmp_com_x.svg", "joint_torques.svg"})
    EXPECT_TRUE(std::filesystem::is_regular_file(In("plots") / plot)) << plot;
}

TEST_F(Exchange, ImportReadsBackAllFormatsOfFrames) {
  const std::vector<std::pair<std::string, std::string>> formats = {{"frames-csv", "a.csv"},
                                                                    {"frames-json", "a.json"},
                                                                    {"frames-npz", "a.npz"},
                                                                    {"npz", "b.npz"},
                                                                    {"mcap", "a.mcap"}};
  for (const auto& format : formats) {
    SCOPED_TRACE(format.first);
    const Ran out = Run({"export", "slow.json", "--format", format.first, "--rate-hz", "50", "--out", format.second});
    ASSERT_EQ(out.status, 0) << out.err;
    EXPECT_EQ(out.out.find("joints are in the order of the robot's description") != std::string::npos,
              format.first.starts_with("frames"));
    const Ran in = Run({"import", format.second, "--rate-hz", "50", "--out", "again.json", "--json"});
    ASSERT_TRUE(in.status == 0 || in.status == 3) << in.err;
    EXPECT_EQ(in.json().at("format"), format.first == "mcap" ? "ros-bag" : format.first);
    const Ran same = Run({"compare", "slow.json", "again.json", "--json"});
    ASSERT_EQ(same.status, 0) << same.err;
    for (const char* const axis : {"x of the base", "y of the base", "z of the base"})
      EXPECT_LT(same.json().at("base").at(axis).at("rms").get<double>(), 1e-3);
  }
}

TEST_F(Exchange, ExportWritesOneCycleOfAPeriodicWalk) {
  ASSERT_EQ(Run({"plan", "--robot", "a1", "--gait", "trot", "--speed", "0.8", "--distance", "1.6", "--set",
                 "trajectory.cycles=periodic", "--out", "trot.json"})
                .status,
            0);
  const Ran ran = Run({"export", "trot.json", "--cycle", "--format", "frames-json", "--rate-hz", "60", "--out",
                       "cycle.json", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json cycle = Json::parse(Read("cycle.json"));
  EXPECT_EQ(cycle.at("LoopMode"), "Wrap");
  const Json first = cycle.at("Frames").front(), last = cycle.at("Frames").back();
  EXPECT_EQ(cycle.at("Frames").size(), ran.json().at("rows"));
  for (std::size_t i = 7; i < first.size(); ++i) EXPECT_NEAR(first[i].get<double>(), last[i].get<double>(), 2e-6) << i;
  EXPECT_GT(last[0].get<double>(), first[0].get<double>() + 0.1);
  ExpectRefused(Run({"export", "out/log.json", "--robot", "a1", "--cycle"}), 1, {"--cycle is for plans"});
  ExpectRefused(Run({"export", "trot.json", "--cycle", "--format", "mjcf"}), 1, {"has no cycle"});
}

TEST_F(Exchange, ExportRefusesWhatItCannotDo) {
  ExpectRefused(Run({"export", "out/log.json"}), 1, {"a log of robot 'a1'", "--plan FILE", "--robot a1"});
  ExpectRefused(Run({"export", "out/log.json", "--robot", "nao"}), 1, {"the log is of robot 'a1'", "'nao'"});
  ExpectRefused(Run({"export", "out/log.json", "--plan", "slow.json"}), 1, {"the log was played from plan"});
  ExpectRefused(Run({"export", "out/log.json", "--robot", "a1", "--rate-hz", "1000"}), 1,
                {"1000 Hz", "200 Hz", "--log-rate-hz"});
  ExpectRefused(Run({"export", "out/plan.json", "--format", "cvs"}), 1, {"'cvs'", "nearest is 'csv'", "'npz'"});
  ExpectRefused(Run({"export", "out/plan.json", "--rate-hz", "1e6"}), 1, {"10000"});
  ExpectRefused(Run({"export", "out/plan.json", "--rate-hz", "-5"}), 1, {"-5", "0.1"});
  ExpectRefused(Run({"export", "out/plan.json", "--robot", "a1"}), 1, {"contains its robot"});
  ExpectRefused(Run({"export", "out/plan.json", "--out", "out/plan.json"}), 1, {"would overwrite"});
  ExpectRefused(Run({"export", "none.json"}), 1, {"none.json"});
  Write("text.txt", "nothing");
  ExpectRefused(Run({"export", "text.txt"}), 1, {"text.txt", "neither a plan nor a log"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"out", "slow.json", "text.txt"})) << "nothing was written";
}

using ExportedModel = Stranger;

TEST_F(ExportedModel, ExportWritesAModelForMujoco) {
  ASSERT_EQ(Run({"plan", "--distance", "0.3", "--terrain", "rough", "--out", "a.json"}).status, 0);
  const Ran ran = Run({"export", "a.json", "--format", "mjcf", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.json().at("files"), (Json{{"model", "model.xml"}}));
  EXPECT_EQ(Found(), (std::vector<std::string>{"a.json", "model.xml", "model_field0.bin"}));
  EXPECT_EQ(Run({"export", "a.json", "--format", "mjcf", "--rate-hz", "100"}).status, 1);
}

}  // namespace
}  // namespace gaitwright::cli
