// SPDX-License-Identifier: BSD-3-Clause
#include "cli/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "kinematics/base/result.h"

namespace gaitwright::cli {
namespace {

namespace fs = std::filesystem;

/// Paths in a folder that is deleted after the test.
class CliPaths : public testing::Test {
 protected:
  CliPaths() {
    std::string name = (fs::temp_directory_path() / "paths-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~CliPaths() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  std::string In(const std::string& name) const { return (folder_ / name).string(); }
  std::string Made(const std::string& name) const {
    std::ofstream(In(name)) << "text";
    return In(name);
  }
  static std::string Refusal(const Paths& paths) {
    try {
      CheckPaths(paths);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  }
  static std::string RefusalOfOutput(const std::string& path, std::initializer_list<std::string_view> endings = {}) {
    Paths paths;
    paths.Write("--out", path, endings);
    return Refusal(paths);
  }

  fs::path folder_;
};

TEST_F(CliPaths, EndingsAreInSmallLetters) {
  EXPECT_EQ(EndingOf("a/b.CSV"), ".csv");
  EXPECT_EQ(EndingOf("a.b/c"), "");
  EXPECT_EQ(EndingOf("plan.tar.gz"), ".gz");
  EXPECT_EQ(EndingOf(""), "");
}

TEST_F(CliPaths, NewFilesAndNoFilesAreAccepted) {
  EXPECT_EQ(Refusal({}), "");
  EXPECT_EQ(RefusalOfOutput(In("new.csv"), {".csv"}), "");
  EXPECT_EQ(RefusalOfOutput(""), "") << "an empty path is no file";
  EXPECT_FALSE(fs::exists(In("new.csv"))) << "a check makes nothing";
}

TEST_F(CliPaths, AnEndingThatDecidesIsOneOfThoseAccepted) {
  const auto refusal = [&](const std::string& name) {
    Paths paths;
    paths.WriteByEnding("--out", name.empty() ? "" : In(name), {".obj", ".png"});
    return Refusal(paths);
  };
  for (const char* good : {"a.obj", "a.PNG", ""}) EXPECT_EQ(refusal(good), "") << good;
  for (const char* wrong : {"a", "a.bak", "a.xml"})
    EXPECT_NE(refusal(wrong).find("accepted: .obj or .png"), std::string::npos) << wrong;
  EXPECT_EQ(RefusalOfOutput(In("a.bak"), {".obj"}), "") << "elsewhere a foreign ending says nothing";
}

TEST_F(CliPaths, NothingIsWrittenOverAnInput) {
  const std::string input = Made("plan.json");
  fs::create_symlink(input, In("link.json"));
  for (const std::string& output : {input, (folder_ / "." / "plan.json").string(), In("link.json")}) {
    Paths paths;
    paths.Read("the plan", input);
    paths.Write("--out", output);
    const std::string refusal = Refusal(paths);
    EXPECT_NE(refusal.find("--out '" + output + "' would overwrite an input, the plan"), std::string::npos) << refusal;
  }
}

TEST_F(CliPaths, TwoOutputsAreNotOneFile) {
  Paths paths;
  paths.Write("--plan", In("a.json"));
  paths.Write("--log", (folder_ / "." / "a.json").string());
  EXPECT_NE(Refusal(paths).find("are the same file"), std::string::npos) << Refusal(paths);
  paths.written[1].path = In("b.json");
  EXPECT_EQ(Refusal(paths), "");
}

/// The ending of another format misleads people and programs; unknown endings do not.
TEST_F(CliPaths, AnEndingOfAnotherFormatIsRefused) {
  EXPECT_EQ(RefusalOfOutput(In("a.json"), {".csv", ".npz"}),
            "--out '" + In("a.json") + "' ends in '.json'; accepted: .csv or .npz");
  EXPECT_NE(RefusalOfOutput(In("a.PNG"), {".csv"}), "") << "in capitals too";
  for (const char* name : {"a.csv", "a.CSV", "a.bak", "a.3", "a"}) EXPECT_EQ(RefusalOfOutput(In(name), {".csv"}), "");
  EXPECT_EQ(RefusalOfOutput(In("a.yml"), {".yaml"}), "") << "two spellings of one";
  EXPECT_EQ(RefusalOfOutput(In("a.json")), "") << "any ending where none is asked for";
}

TEST_F(CliPaths, AFolderIsNoFileAndAFileNoFolder) {
  EXPECT_NE(RefusalOfOutput(folder_.string()).find("cannot be written"), std::string::npos);
  EXPECT_NE(RefusalOfOutput(Made("file") + "/a.json").find("cannot be written"), std::string::npos);
}

TEST_F(CliPaths, PlotsDoNotLieAmongDrawingsThatAreRead) {
  Paths paths;
  paths.Read("--picture", Made("seen.svg"));
  paths.plot_folder = folder_.string();
  EXPECT_NE(Refusal(paths).find("could overwrite an input, --picture"), std::string::npos) << Refusal(paths);
  paths.plot_folder = In("plots");
  EXPECT_EQ(Refusal(paths), "");
  paths.read[0].path = Made("seen.png");
  paths.plot_folder = folder_.string();
  EXPECT_EQ(Refusal(paths), "") << "plots are called otherwise";
}

TEST_F(CliPaths, NamesThatAreFilesAreReadAndBuiltInOnesAreNot) {
  Paths paths;
  paths.AddTerrain("stairs:rise_m=0.05");
  paths.AddSequence("trot: distance=1; stand: duration=1");
  EXPECT_TRUE(paths.read.empty());
  paths.AddTerrain(Made("yard.yaml"));
  paths.AddGait(In("my.yaml") + ":amble");
  ASSERT_EQ(paths.read.size(), 2U);
  EXPECT_EQ(paths.read[0].path, In("yard.yaml"));
  EXPECT_EQ(paths.read[1].name, "--gait");
  EXPECT_EQ(paths.read[1].path, In("my.yaml"));
}

}  // namespace
}  // namespace gaitwright::cli
