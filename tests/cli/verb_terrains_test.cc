// SPDX-License-Identifier: BSD-3-Clause
// Output and files of `gaitwright terrains`, and messages of --terrain.
#include <filesystem>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

using Terrains = Stranger;

std::string ValueOf(const Json& shown, const std::string& key) {
  for (const Json& parameter : shown.at("parameters")) {
    if (parameter.at("key") == key) return parameter.at("value");
  }
  return "";
}

TEST_F(Terrains, SizesAreThoseOfTheRobotUnlessGiven) {
  const Json a1 = Run({"terrains", "show", "stairs", "--json"}).json();
  const Json nao = Run({"terrains", "show", "stairs", "--robot", "nao", "--json"}).json();
  EXPECT_EQ(a1.at("robot"), "a1");
  EXPECT_EQ(nao.at("robot"), "nao");
  EXPECT_GT(std::stod(ValueOf(a1, "rise_m")), std::stod(ValueOf(nao, "rise_m")));
  const Json given = Run({"terrains", "show", "stairs:rise_m=0.07,count=2", "--json"}).json();
  EXPECT_EQ(given.at("name"), "stairs:rise_m=0.07,count=2");
  EXPECT_EQ(ValueOf(given, "rise_m"), "0.07");
  EXPECT_EQ(given.at("patches").size(), 4U);
  const Ran words = Run({"terrains", "show", "maze"});
  EXPECT_NE(words.out.find("passage_m"), std::string::npos);
  EXPECT_NE(words.out.find("wall 1: box"), std::string::npos);
  EXPECT_NE(Run({"terrains", "show", "rough"}).out.find("points"), std::string::npos);
}

TEST_F(Terrains, APictureOfEveryGroundIsWritten) {
  const Json listed = Run({"terrains", "--json"}).json();  // keeps the temporary alive in the loop
  EXPECT_GE(listed.at("terrains").size(), 13U);
  for (const Json& entry : listed.at("terrains")) {
    const std::string name = entry.at("name");
    SCOPED_TRACE(name);
    const Ran drawn = Run({"terrains", "show", name, "--picture", "out/" + name + ".svg", "--json"});
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    EXPECT_EQ(drawn.json().at("files").at("picture"), "out/" + name + ".svg");
    const std::string svg = Read("out/" + name + ".svg");
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    std::size_t walls = 0;
    for (std::size_t at = svg.find("<polygon class=\"w\""); at != std::string::npos;
         at = svg.find("<polygon class=\"w\"", at + 1))
      ++walls;
    const std::size_t hanging = name == "doorway" ? 1 : 0;  // the lintel
    EXPECT_EQ(walls + hanging, drawn.json().at("obstacles").size());
  }
  const std::string again = Read("out/rough.svg");
  Run({"terrains", "show", "rough", "--picture", "again.svg"});
  EXPECT_TRUE(Read("again.svg") == again) << "not the same bytes again";
}

TEST_F(Terrains, FilesAreShownAndPlannedOn) {
  Write("yard.yaml",
        "builtin: flat\nobstacles:\n  - {name: post, type: cylinder, size_m: [0.05, 1], position_m: [9, 0, 0.5]}\n"
        "markers:\n  - {name: red marker, place_m: [1.5, 0.5]}\n");
  const Ran shown = Run({"terrains", "show", "./yard.yaml", "--json"});
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(shown.json().at("name"), "yard.yaml");
  EXPECT_EQ(shown.json().at("obstacles").at(0).at("type"), "cylinder");
  EXPECT_EQ(shown.json().at("markers"), Json::parse(R"([{"name": "red marker", "position_m": [1.5, 0.5]}])"));
  const std::string text = Run({"terrains", "show", "./yard.yaml"}).out;
  EXPECT_NE(text.find("markers\n  red marker: at (1.500, 0.500) m"), std::string::npos) << text;
  const Ran planned = Run({"plan", "--terrain", In("yard.yaml").string(), "--distance", "0.3", "--out", "plan.json"});
  ASSERT_EQ(planned.status, 0) << planned.err;
  EXPECT_EQ(Read("plan.json").find(In("").string()), std::string::npos) << "plans hold no path";
  EXPECT_EQ(Json::parse(Read("plan.json")).at("terrain").at("name"), "yard.yaml");
}

TEST_F(Terrains, AGroundIsWrittenForOtherPrograms) {
  for (const std::string file : {"ground.xml", "ground.obj", "ground.png", "LOUD.OBJ"}) {
    SCOPED_TRACE(file);
    const Ran ran = Run({"terrains", "show", "stairs", "--out", "out/" + file, "--json"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.json().at("files"), (Json{{"ground", "out/" + file}}));
    EXPECT_TRUE(ran.json().at("notes").is_array());
    EXPECT_EQ(ran.json().contains("terrain"), file != "ground.xml");
    if (file == "ground.xml") continue;
    const Ran again = Run({"terrains", "show", ran.json().at("terrain"), "--json"});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(again.json().at("patches").size() + again.json().at("height_fields").size(),
              file == "ground.png" ? 1U : ran.json().at("patches").size());
  }
  EXPECT_TRUE(Read("out/ground.obj") == Read("out/LOUD.OBJ"));
  const Ran words = Run({"terrains", "show", "rough", "--out", "rough.xml", "--picture", "rough.svg"});
  ASSERT_EQ(words.status, 0) << words.err;
  for (const char* file : {"rough.xml", "rough_field0.bin", "rough.svg"}) {
    EXPECT_NE(words.out.find(std::string("wrote ") + file), std::string::npos) << words.out;
    EXPECT_TRUE(std::filesystem::is_regular_file(In(file))) << file;
  }
  const std::string flat = Run({"terrains", "show", "flat", "--out", "flat.obj"}).out;
  EXPECT_NE(flat.find("note: the infinite surface 'ground' is cut"), std::string::npos) << flat;
  EXPECT_NE(flat.find("read it back with --terrain flat.obj\n"), std::string::npos) << flat;
  EXPECT_FALSE(Run({"terrains", "show", "flat", "--json"}).json().contains("notes"));
}

TEST_F(Terrains, TheEndingOfAGroundDecides) {
  for (const std::string wrong : {"ground", "ground.stl", "ground.bak", "ground.csv"})
    ExpectRefused(Run({"terrains", "show", "stairs", "--out", wrong}), 1, {"--out", wrong, ".xml or .obj or .png"});
  ExpectRefused(Run({"terrains", "show", "stairs", "--out", "no/"}), 1, {"no/"});
  EXPECT_EQ(Found(), std::vector<std::string>{});
}

TEST_F(Terrains, WrongOnesAreRefused) {
  ExpectRefused(Run({"terrains", "show", "stair"}), 1, {"'stair'", "'stairs'"});
  ExpectRefused(Run({"plan", "--terrain", "stairs:rise_m=300"}), 1, {"rise_m", "300", "accepted"});
  ExpectRefused(Run({"walk", "--terrain", "gap:width=1"}), 1, {"'width'", "'width_m'"});
  ExpectRefused(Run({"plan", "--terrain", "none.csv:resolution_m=0.1"}), 1, {"none.csv"});
  Write("bad.csv", "0,0\n0,nan\n");
  ExpectRefused(Run({"plan", "--terrain", "bad.csv:resolution_m=0.1"}), 1, {"bad.csv", "line 2, cell 2"});
  EXPECT_EQ(Found(), std::vector<std::string>{"bad.csv"});
}

TEST_F(Terrains, NothingIsWrittenOverTheGroundThatIsRead) {
  Write("ground.yaml", "builtin: flat\n");
  ExpectRefused(Run({"terrains", "show", "ground.yaml", "--picture", "ground.yaml"}), 1, {"ground.yaml", "overwrite"});
  ExpectRefused(Run({"plan", "--terrain", "ground.yaml", "--out", "./ground.yaml"}), 1, {"ground.yaml", "overwrite"});
  EXPECT_EQ(Read("ground.yaml"), "builtin: flat\n");
}

}  // namespace
}  // namespace gaitwright::cli
