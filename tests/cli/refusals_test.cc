// SPDX-License-Identifier: BSD-3-Clause
// Wrong input: status 1, one sentence that names the offender, and nothing written.
#include "tests/built_paths.h"
#include "tests/cli/stranger.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright::cli {
namespace {

class Refusals : public Stranger {
 protected:
  /// A walk that would write to `no`, with more arguments.
  Ran Walk(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"walk", "--out-dir", "no", "--plot-dir", "no/plots"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Run(arguments);
  }

  void ExpectNothingWritten() const { EXPECT_EQ(Found(), std::vector<std::string>{}); }

  /// A copy of a built-in robot in the folder `mine`, with `yaml` beside it.
  void CopyRobot(const std::string& yaml) const {
    std::filesystem::create_directories(In("mine"));
    std::filesystem::copy_file(SourceFolder() + "/robots/a1/robot.urdf", In("mine/robot.urdf"),
                               std::filesystem::copy_options::overwrite_existing);
    Write("mine/robot.yaml", yaml);
  }
};

TEST_F(Refusals, RobotThatIsNotThere) {
  ExpectRefused(Walk({"--robot", "b2"}), 1,
                {"'b2'", "'a1', 'g1', 'go1', 'h1', 'h1_2', 'humanoid', 'laikago', 'mini_cheetah', 'nao'"});
  ExpectRefused(Run({"robots", "show", "b2"}), 1,
                {"'b2'", "'a1', 'g1', 'go1', 'h1', 'h1_2', 'humanoid', 'laikago', 'mini_cheetah', 'nao'"});
  ExpectRefused(Walk({"--urdf", "none.urdf"}), 1, {"none.urdf"});
  ExpectRefused(Walk({"--robot", "a1", "--urdf", "none.urdf"}), 1, {"--robot", "--urdf"});
  ExpectNothingWritten();
}

TEST_F(Refusals, SequencesThatSayTooMuchOrTheWrongThing) {
  ExpectRefused(Walk({"--sequence", "trot; walk", "--speed", "0.3"}), 1, {"--sequence", "--speed"});
  ExpectRefused(Walk({"--sequence", "trot; walk", "--gait", "trot"}), 1, {"--sequence", "--gait"});
  ExpectRefused(Walk({"--sequence", "trot; walk:sped=1"}), 1, {"part 2, 'walk'", "'sped'", "'speed'"});
  ExpectRefused(Walk({"--sequence", "none.yaml"}), 1, {"none.yaml"});
  ExpectNothingWritten();
}

TEST_F(Refusals, UrdfWithALoop) {
  Write("loop.urdf",
        "<robot name='r'><link name='a'/><link name='b'/><link name='c'/>"
        "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>"
        "<joint name='k' type='fixed'><parent link='a'/><child link='c'/></joint>"
        "<joint name='l' type='fixed'><parent link='b'/><child link='c'/></joint></robot>");
  ExpectRefused(Walk({"--urdf", "loop.urdf"}), 1, {"'c'", "'k'", "'l'", "loop"});
  EXPECT_EQ(Found(), std::vector<std::string>{"loop.urdf"});
}

TEST_F(Refusals, RobotYaml) {
  CopyRobot("standing_base_height_m: .nan\n");
  ExpectRefused(Walk({"--urdf", "mine/robot.urdf"}), 1, {"robot.yaml, line 1", "'standing_base_height_m'", "finite"});
  CopyRobot("description: mine\nstanding_base_hight_m: 0.3\n");
  ExpectRefused(Walk({"--urdf", "mine/robot.urdf"}), 1,
                {"robot.yaml, line 2", "'standing_base_hight_m'", "'standing_base_height_m'"});
  EXPECT_EQ(Found(), std::vector<std::string>{"mine"});
}

TEST_F(Refusals, Command) {
  ExpectRefused(Walk({"--speed", "-0.2", "--goal", "1,0,0"}), 1, {"-0.2 m/s", "negative"});
  ExpectRefused(Walk({"--speed", "nan"}), 1, {"--speed", "'nan'", "finite number"});
  ExpectRefused(Walk({"--speed", "fast"}), 1, {"--speed", "'fast'"});
  ExpectRefused(Walk({"--distance", "-1"}), 1, {"-1 m", "negative"});
  ExpectRefused(Walk({"--distance", "1e6"}), 1, {"at most 600 s"});
  ExpectRefused(Walk({"--steps", "1000000"}), 1, {"at most 600 s"});
  ExpectRefused(Walk({"--speed", "1e-9"}), 1, {"at most 600 s"});
  ExpectRefused(Walk({"--distance", "0"}), 1, {"it must be more than 0"});
  ExpectRefused(Walk({"--goal", "0,0,0"}), 1, {"it ends where it starts"});
  ExpectRefused(Walk({"--distance", "1e999"}), 1, {"--distance", "1e999"});
  ExpectRefused(Walk({"--distance", "1", "--steps", "4"}), 1, {"--distance", "--goal", "--steps", "one of them"});
  ExpectRefused(Walk({"--duration", "3", "--steps", "4"}), 1, {"--duration", "--steps", "one of them"});
  ExpectRefused(Walk({"--duration", "0"}), 1, {"0 s", "more than 0"});
  ExpectRefused(Walk({"--duration", "1e4"}), 1, {"at most 600 s"});
  ExpectRefused(Walk({"--steps", "4", "--speed", "0.2", "--step-length", "0.1"}), 1, {"--step-length", "--speed"});
  ExpectRefused(Walk({"--yaw-rate", "0.3", "--distance", "0"}), 1, {"--distance", "it must be more than 0"});
  ExpectRefused(Walk({"--steps", "0"}), 1, {"--steps", "1 or more"});
  ExpectRefused(Walk({"--steps", "2.5"}), 1, {"--steps", "'2.5'", "whole number"});
  ExpectRefused(Walk({"--step-length", "0.1"}), 1, {"--step-length", "--steps"});
  ExpectRefused(Walk({"--goal", "1,0"}), 1, {"--goal", "3 numbers", "has 2"});
  ExpectRefused(Walk({"--goal", "1,0,nan"}), 1, {"--goal", "'nan'"});
  ExpectRefused(Walk({"--goal", "1,0,4"}), 1, {"4 rad", "pi"});
  ExpectRefused(Walk({"--gait", "trott"}), 1, {"'trott'", "'trot'", "'crawl'"});
  ExpectRefused(Walk({"--gait", "none.yaml"}), 1, {"none.yaml"});
  ExpectRefused(Walk({"--terrain", "flatt"}), 1, {"'flatt'", "'flat'"});
  ExpectRefused(Run({"terrains", "show", "flatt"}), 1, {"'flatt'", "'flat'"});
  for (const char* flag : {"--robot", "--urdf", "--gait", "--goal", "--push"}) {
    ExpectRefused(Walk({flag, ""}), 1, {flag, "empty"});
  }
  ExpectRefused(Run({"robots", "show", ""}), 1, {"ROBOT", "empty"});
  ExpectRefused(Walk({"--seed", "-1"}), 1, {"--seed", "-1", "0 or more"});
  const std::string huge = "99999999999999999999";  // too large for 64 bits
  for (const std::string& seed : {std::string("2147483648"), std::string("99999999999"), huge})
    ExpectRefused(Walk({"--seed", seed}), 1, {"--seed: " + seed + " is too large; accepted: 0 to 2147483647"});
  ExpectRefused(Walk({"--seed", "-" + huge}), 1, {"--seed: -" + huge + " is too small; accepted: 0 or more"});
  ExpectRefused(Walk({"--steps", huge}), 1, {"--steps: " + huge + " is too large; accepted: 1 to 2147483647"});
  ExpectNothingWritten();
}

TEST_F(Refusals, Options) {
  ExpectRefused(Walk({"--set", "swing.heigth_m=0.1"}), 1, {"'swing.heigth_m'", "'swing.height_m'"});
  ExpectRefused(Walk({"--set", "swing.height_m=9"}), 1, {"'swing.height_m' is 9 m", "0 to 1"});
  ExpectRefused(Walk({"--set", "swing.height_m=nan"}), 1, {"'swing.height_m'", "nan"});
  ExpectRefused(Walk({"--set", "swing.height_m"}), 1, {"--set", "key=value"});
  ExpectRefused(Walk({"--set", "swing.height_m=0.1", "--set", "swing.height_m=0.1"}), 1,
                {"--set: 'swing.height_m' is given twice"});
  ExpectRefused(Walk({"--set", "com-method=preview"}), 1, {"'com-method'; --list-options=all prints all option keys"});
  ExpectRefused(Run({"gaits", "--set", "a=1"}), 1, {"--set"});
  ExpectNothingWritten();
}

TEST_F(Refusals, Playback) {
  ExpectRefused(Walk({"--push", "1,2"}), 1, {"--push", "3 numbers", "has 2"});
  ExpectRefused(Walk({"--push", "1,2,x"}), 1, {"--push", "'x'"});
  ExpectRefused(Walk({"--push-at", "1"}), 1, {"--push-at", "without --push"});
  ExpectRefused(Walk({"--push", "0,9,0", "--push-for", "0"}), 1, {"--push-for must be above 0"});
  ExpectRefused(Walk({"--push", "0,9,0", "--push-at", "100"}), 1, {"100 s", "ends"});
  ExpectRefused(Walk({"--friction", "-1"}), 1, {"--friction", "-1", "0 to 10"});
  ExpectRefused(Walk({"--mass-scale", "0"}), 1, {"--mass-scale", "0.1 to 10"});
  ExpectRefused(Walk({"--controller", "pid"}), 1, {"'pid'", "'stabilised', 'joint-pd', 'recovering'"});
  ExpectRefused(Walk({"--log-rate-hz", "300"}), 1, {"300 Hz", "333.333"});
  ExpectRefused(Walk({"--log-rate-hz", "0"}), 1, {"--log-rate-hz", "1 to 100000"});
  ExpectRefused(Walk({"--log-rate-hz", "2000"}), 1, {"2000 Hz", "1000"});
  ExpectNothingWritten();
}

TEST_F(Refusals, PlanFile) {
  ExpectRefused(Run({"audit", "none.json"}), 1, {"none.json"});
  ExpectRefused(Run({"play", "none.json", "--log", "log.json", "--report", "r.html"}), 1, {"none.json"});
  ExpectNothingWritten();
  Json plan = MakePlan("plan.json");
  const std::string text = Read("plan.json");
  Write("short.json", text.substr(0, text.size() / 2));
  plan["schema"] = plan.at("schema").get<int>() + 1;
  Write("newer.json", plan.dump());
  plan["schema"] = 1;
  Write("older.json", plan.dump());
  Write("other.json", "{\"a\": 1}");
  for (const char* verb : {"audit", "play"}) {
    ExpectRefused(Run({verb, "short.json"}), 1, {"short.json", "cut short"});
    ExpectRefused(Run({verb, "newer.json"}), 1, {"newer.json", "schema", "newer program"});
    ExpectRefused(Run({verb, "older.json"}), 1, {"older.json", "schema", "make the plan again"});
    ExpectRefused(Run({verb, "other.json"}), 1, {"other.json", "not a motion plan"});
    ExpectRefused(Run({verb, "."}), 1, {"folder"});
  }
  plan = Json::parse(text);
  plan["step_s"] = 1e9;
  Write("endless.json", plan.dump());
  ExpectRefused(Run({"play", "endless.json"}), 1, {"'step_s' is 1000000000", "accepted: 0 to 10"});
}

TEST_F(Refusals, Usage) {
  ExpectRefused(Run({}), 1, {"a verb is needed", "'walk'"});
  ExpectRefused(Run({"wlk"}), 1, {"'wlk'", "nearest is 'walk'", "'audit'"});
  ExpectRefused(Walk({"--distnace", "1"}), 1, {"walk", "'--distnace'", "'--distance'"});
  ExpectRefused(Run({"play", "plan.json", "--out", "x"}), 1,
                {"play has no flag '--out' (try: gaitwright play --help)"});
  ExpectRefused(Walk({"more"}), 1, {"walk", "'more'"});
  ExpectRefused(Walk({"--speed"}), 1, {"walk: --speed needs a value"});
  ExpectRefused(Walk({"--speed", "0.1", "--speed", "0.2"}), 1, {"walk: --speed is given more than once"});
  ExpectRefused(Run({"play"}), 1, {"play", "PLAN"});
  ExpectRefused(Run({"robots", "shwo", "a1"}), 1, {"'robots shwo'", "'show'"});
  ExpectRefused(Run({"--jsn", "walk"}), 1, {"'--jsn'"});
  ExpectNothingWritten();
}

TEST_F(Refusals, PlacesThatCannotBeWritten) {
  Write("file", "text");
  ExpectRefused(Run({"plan", "--distance", "0.3", "--out-dir", "file"}), 1, {"'file'", "file/plan.json"});
  ExpectRefused(Run({"plan", "--distance", "0.3", "--out-dir", "a", "--out", "b"}), 1, {"--out", "--out-dir"});
  ExpectRefused(Run({"plan", "--distance", "0.3", "--out", "."}), 1, {"'.'"});
  EXPECT_EQ(Found(), std::vector<std::string>{"file"});
}

TEST_F(Refusals, AnOutputThatCannotBeWrittenTakesTheOthersWithIt) {
  const std::vector<std::string> walk = {"walk", "--distance", "0.3", "--out-dir", "w", "--plot-dir"};
  const auto to = [&](const std::string& folder) {
    std::vector<std::string> arguments = walk;
    arguments.push_back(folder);
    return arguments;
  };
  ExpectRefused(Run(to("/proc/none")), 1, {"/proc/none"});
  ExpectNothingWritten();
  Write("w/plan.json", "an earlier one");
  Write("p/gait.svg/file", "in the way");
  ExpectRefused(Run(to("p")), 1, {"'p/gait.svg'"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"p", "w"}));
  EXPECT_EQ(Read("w/plan.json"), "an earlier one");
  EXPECT_FALSE(std::filesystem::exists(In("w/log.json")));
  MakePlan("plan.json");
  ExpectRefused(Run({"play", "plan.json", "--log", "a", "--report", "./a"}), 1, {"'a'", "are the same file"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"p", "plan.json", "w"}));
}

TEST_F(Refusals, OutputsOverInputs) {
  MakePlan("plan.json");
  const std::string plan = Read("plan.json");
  std::filesystem::create_symlink("plan.json", In("link.json"));
  std::filesystem::create_symlink(".", In("here"));
  for (const std::string out : {"plan.json", "./plan.json", "here/plan.json", "link.json"}) {
    ExpectRefused(Run({"play", "plan.json", "--log", out}), 1, {"--log", "'" + out + "'", "'plan.json'", "overwrite"});
    ExpectRefused(Run({"play", out, "--report", "plan.json"}), 1,
                  {"--report", "'plan.json'", "'" + out + "'", "overwrite"});
  }
  ExpectRefused(Run({"play", In("plan.json").string(), "--log", "plan.json"}), 1, {"--log", "overwrite"});
  ExpectRefused(Run({"play", "plan.json", "--log", "a", "--report", "here/a"}), 1,
                {"--log", "--report", "are the same file"});
  ExpectRefused(Run({"play", "plan.json", "--log", "a", "--report", In("a").string()}), 1, {"are the same file"});
  Write("p/gait.svg", plan);
  ExpectRefused(Run({"play", "p/gait.svg", "--plot-dir", "./p"}), 1, {"--plot-dir", "'p/gait.svg'"});
  EXPECT_EQ(Read("plan.json"), plan);
  EXPECT_EQ(Read("p/gait.svg"), plan);
  EXPECT_EQ(Found(), (std::vector<std::string>{"here", "link.json", "p", "plan.json"}));
}

TEST_F(Refusals, OutputsOverTheRobotOrTheGait) {
  CopyRobot("description: mine\n");
  const std::string urdf = Read("mine/robot.urdf");
  Write("gaits.yaml", "");
  const auto plan = [&](const std::string& out) {
    return Run({"plan", "--urdf", "mine/robot.urdf", "--gait", "gaits.yaml:slow", "--out", out});
  };
  ExpectRefused(plan("./mine/robot.urdf"), 1, {"'./mine/robot.urdf'", "--urdf", "overwrite"});
  ExpectRefused(plan("mine/robot.yaml"), 1, {"'mine/robot.yaml'", "robot.yaml", "overwrite"});
  ExpectRefused(plan("mine/../gaits.yaml"), 1, {"--gait", "'gaits.yaml'", "overwrite"});
  std::filesystem::rename(In("mine/robot.urdf"), In("mine/log.json"));
  ExpectRefused(Run({"walk", "--urdf", "mine/log.json", "--out-dir", "mine"}), 1,
                {"the log of --out-dir 'mine/log.json'", "--urdf"});
  EXPECT_EQ(Read("mine/log.json"), urdf);
  EXPECT_EQ(Read("mine/robot.yaml"), "description: mine\n");
  EXPECT_EQ(Found(), (std::vector<std::string>{"gaits.yaml", "mine"}));
}

TEST_F(Refusals, FoldersThatAreFiles) {
  Write("file", "text");
  for (const char* folder : {"file", "./file", "file/plots"}) {
    ExpectRefused(Run({"walk", "--distance", "1", "--plot-dir", folder}), 1, {"--plot-dir", folder, "not a folder"});
    ExpectRefused(Run({"walk", "--distance", "1", "--out-dir", folder}), 1, {folder, "plan.json", "not a folder"});
  }
  EXPECT_EQ(Read("file"), "text");
  EXPECT_EQ(Found(), std::vector<std::string>{"file"});
}

/// Outputs are checked before inputs are read: the input motion does not exist.
TEST_F(Refusals, OutputsThatCannotBeWrittenAreSeenBeforeTheWork) {
  Write("file", "text");
  const std::vector<std::pair<std::string, std::string>> wrong = {{"file/x", "'file' is a file, not a folder"},
                                                                  {".", "it is a folder"},
                                                                  {"new/", "the name of a folder"},
                                                                  {"/dev/null", "not a regular file"}};
  const std::vector<std::vector<std::string>> verbs = {
      {"play", "none.json", "--log"},      {"play", "none.json", "--report"},
      {"trials", "none.json", "--out"},    {"view", "none.json", "--out"},
      {"trials", "none.json", "--report"}, {"render", "none.json", "--figure"},
      {"export", "none.json", "--out"},    {"compare", "none.json", "none.json", "--report"}};
  for (const auto& [path, why] : wrong) {
    for (std::vector<std::string> arguments : verbs) {
      const std::string flag = arguments.back();
      arguments.push_back(path);
      ExpectRefused(Run(arguments), 1, {flag + " '" + path + "' cannot be written: ", why});
    }
    for (const std::string flag : {"--out", "--report", "--map", "--best"}) {
      ExpectRefused(Run({"sweep", "--robot", "none", "--over", "speed=0.1,0.2", flag, path}), 1,
                    {flag + " '" + path + "' cannot be written: ", why});
    }
  }
  ExpectRefused(Run({"walk", "--robot", "none", "--out-dir", "file"}), 1, {"the plan of --out-dir 'file/plan.json'"});
  std::filesystem::create_directories(In("t.json.so-far"));
  ExpectRefused(Run({"trials", "none.json", "--out", "t.json"}), 1, {"the run so far 't.json.so-far'", "a folder"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"file", "t.json.so-far"}));
}

TEST_F(Refusals, JsonHasTheErrorObject) {
  const std::vector<std::vector<std::string>> wrong = {{"walk", "--json", "--robot", "b2"},
                                                       {"walk", "--json", "--frobnicate"},
                                                       {"wlk", "--json"},
                                                       {"play", "--json"},
                                                       {"--json"},
                                                       {"audit", "none.json", "--json"},
                                                       {"walk", "--json", "--robot", "\xff"},
                                                       {"plan", "--json", "--steps", "four"}};
  for (const auto& arguments : wrong) {
    const Ran ran = Run(arguments);
    EXPECT_EQ(ran.status, 1);
    const Json error = ran.json().at("error");
    EXPECT_FALSE(error.at("code").get<std::string>().empty());
    EXPECT_FALSE(error.at("stage").get<std::string>().empty());
    EXPECT_TRUE(error.at("hints").is_array());
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    if (arguments.back() != "\xff") {
      EXPECT_NE(ran.err.find(error.at("message").get<std::string>()), std::string::npos) << ran.err;
    }
  }
  ExpectNothingWritten();
}

TEST_F(Refusals, ABipedWhoseFeetHaveNoShapeGetsADraftThatAsksForThem) {
  std::string urdf = "<robot name='bare'>" + SmallLink("trunk", "<box size='0.1 0.3 0.3'/>");
  for (const std::string leg : {"L", "R"}) {
    const std::string side = leg == "L" ? "0 0.1 0" : "0 -0.1 0";
    urdf += SmallLink(leg + "_yaw") + SmallLink(leg + "_roll") + SmallLink(leg + "_thigh") + SmallLink(leg + "_shank") +
            SmallLink(leg + "_ankle") + SmallLink(leg + "_foot");
    urdf += Replaced(PitchJoint(leg + "_j1", "trunk", leg + "_yaw", side), "0 1 0", "0 0 1");
    urdf += Replaced(PitchJoint(leg + "_j2", leg + "_yaw", leg + "_roll", "0 0 0"), "0 1 0", "1 0 0");
    urdf += PitchJoint(leg + "_j3", leg + "_roll", leg + "_thigh", "0 0 0");
    urdf += Replaced(PitchJoint(leg + "_j4", leg + "_thigh", leg + "_shank", "0 0 -0.3"), "lower='-2' upper='1'",
                     "lower='0' upper='2'");
    urdf += PitchJoint(leg + "_j5", leg + "_shank", leg + "_ankle", "0 0 -0.3");
    urdf += Replaced(PitchJoint(leg + "_j6", leg + "_ankle", leg + "_foot", "0 0 0"), "0 1 0", "1 0 0");
  }
  Write("bare.urdf", urdf + "</robot>");
  const Ran ran = Run({"walk", "--urdf", "bare.urdf", "--json"});
  EXPECT_EQ(ran.status, 2) << ran.out;
  EXPECT_EQ(ran.json().at("error").at("code"), "no_support") << ran.out;
  EXPECT_NE(Read("robot.draft.yaml").find("sole_m"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright::cli
