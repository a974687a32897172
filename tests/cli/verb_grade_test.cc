// SPDX-License-Identifier: BSD-3-Clause
// Output and files of `gaitwright grade`.
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

namespace fs = std::filesystem;

using Grade = Stranger;

constexpr char kAnswers[] =
    "title: Balance\nparts:\n- {name: dcm, kind: answers, file: dcm.csv, points: 4, reference: dcm, cases: 3}\n";
constexpr char kCode[] =
    "title: Balance\nparts:\n- {name: zmp, kind: function, file: work.py, points: 4, reference: pendulum_zmp, cases: "
    "3, "
    "limits: {time_s: 2}}\n";
constexpr char kRight[] = "def pendulum_zmp(c, a, h):\n    return c[:2] - a[:2] * h / 9.81\n";

/// Whether the machine cannot confine code. If so, the verb must have refused without writing anything.
bool Refused(const Ran& ran, const std::string& grades) {
  if (ran.err.find("cannot be run safely here") == std::string::npos) return false;
  EXPECT_EQ(ran.status, 1);
  EXPECT_FALSE(fs::exists(grades));
  return true;
}

TEST_F(Grade, MarksAndWritesTableAndPages) {
  Write("rubric.yaml", kAnswers);
  Write("class/ada/dcm.csv", "case,answer_0,answer_1\n0,1,2\n");
  fs::create_directories(In("class/bob"));
  const Ran ran = Run({"grade", "class", "--rubric", "rubric.yaml", "--seed", "7"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("ada"), std::string::npos);
  EXPECT_EQ(Read("grades/grades.csv"), "\"student\",\"dcm\",\"total\",\"of\"\n\"ada\",0,0,4\n\"bob\",0,0,4\n");
  for (const char* page : {"grades/index.html", "grades/001-ada.html", "grades/002-bob.html"})
    EXPECT_TRUE(fs::exists(In(page)));
}

TEST_F(Grade, JsonIsOneObject) {
  Write("rubric.yaml", kAnswers);
  Write("class/ada/dcm.csv", "case,answer_0,answer_1\n0,1,2\n");
  const Json json = Run({"grade", "class", "--rubric", "rubric.yaml", "--json", "--out-dir", "out"}).json();
  EXPECT_EQ(json.at("title"), "Balance");
  EXPECT_EQ(json.at("of"), 4.0);
  const Json& student = json.at("students").at(0);
  EXPECT_EQ(student.at("student"), "ada");
  EXPECT_EQ(student.at("parts").at(0).at("checks").at(0).at("measure"), "share_right");
  EXPECT_FALSE(student.at("parts").at(0).at("reasons").empty());
  EXPECT_EQ(json.at("files").at("grades"), "out/grades.csv");
}

TEST_F(Grade, InputsAreWrittenForASeed) {
  Write("rubric.yaml", kAnswers);
  EXPECT_EQ(Run({"grade", "--rubric", "rubric.yaml", "--seed", "7", "--write-inputs", "a"}).status, 0);
  EXPECT_EQ(Run({"grade", "--rubric", "rubric.yaml", "--seed", "8", "--write-inputs", "b"}).status, 0);
  const std::string inputs = Read("a/dcm_inputs.csv");
  EXPECT_TRUE(inputs.starts_with("case,com_m_0,com_m_1,com_m_2,velocity_m_s_0,")) << inputs;
  EXPECT_NE(inputs, Read("b/dcm_inputs.csv"));
  Write("code.yaml", kCode);
  ExpectRefused(Run({"grade", "--rubric", "code.yaml", "--write-inputs", "c"}), 1,
                {"--write-inputs", "no part of kind 'answers'"});
}

TEST_F(Grade, RefusalsNameTheOffender) {
  Write("rubric.yaml", "title: t\nparts:\n- {name: p, kind: answers, file: f, pionts: 3, reference: dcm}\n");
  Write("class/ada/f", "");
  ExpectRefused(Run({"grade", "class", "--rubric", "rubric.yaml"}), 1,
                {"'rubric.yaml', line 3", "'pionts'", "'points'"});
  ExpectRefused(Run({"grade", "class", "--rubric", "none.yaml"}), 1, {"none.yaml"});
  ExpectRefused(Run({"grade", "class"}), 1, {"--rubric"});
  Write("rubric.yaml", kAnswers);
  ExpectRefused(Run({"grade", "--rubric", "rubric.yaml"}), 1, {"DIR is missing"});
  ExpectRefused(Run({"grade", "nowhere", "--rubric", "rubric.yaml"}), 1, {"'nowhere'"});
  ExpectRefused(Run({"grade", "class", "--rubric", "rubric.yaml", "--set", "a=1"}), 1, {"--set"});
  EXPECT_FALSE(fs::exists(In("grades")));
}

TEST_F(Grade, CodeIsRunWhereItCanBeConfined) {
  Write("rubric.yaml", kCode);
  Write("class/ada/work.py", kRight);
  Write("class/eve/work.py", "import os\nos.kill(os.getppid(), 9)\n");
  const Ran ran = Run({"grade", "class", "--rubric", "rubric.yaml", "--seed", "7"});
  if (Refused(ran, In("grades").string())) return;
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(Read("grades/grades.csv"), "\"student\",\"zmp\",\"total\",\"of\"\n\"ada\",4,4,4\n\"eve\",0,0,4\n");
}

/// If the test runs as root, it runs the program as another user; skipped if that user cannot read the build.
TEST_F(Grade, ItNeedsNoRights) {
  if (geteuid() != 0) GTEST_SKIP() << "the other tests are without rights";
  Write("rubric.yaml", kCode);
  Write("class/ada/work.py", kRight);
  Write("class/eve/work.py",
        "import os\ndef pendulum_zmp(c, a, h):\n    os.chmod('" + In("class/eve/work.py").string() + "', 0)\n");
  for (const auto& entry : fs::recursive_directory_iterator(In("class"))) {
    ASSERT_EQ(::chown(entry.path().c_str(), 1234, 1234), 0);
  }
  ASSERT_EQ(::chown(In(".").c_str(), 1234, 1234), 0);
  const Ran ran = RunWords({"/usr/bin/setpriv", "--reuid=1234", "--regid=1234", "--clear-groups", ProgramPath(),
                            "grade", "class", "--rubric", "rubric.yaml", "--seed", "7", "--json"});
  if (ran.status == 127) GTEST_SKIP() << ran.err;
  if (Refused(ran, In("grades").string())) return;
  const Json json = ran.json();
  EXPECT_EQ(json.at("students").at(0).at("points"), 4.0) << ran.out;
  EXPECT_EQ(json.at("students").at(1).at("points"), 0.0);
  EXPECT_NE(json.dump().find("Operation not permitted"), std::string::npos) << ran.out;
}

TEST_F(Grade, WhenItIsInterruptedNothingIsHalfWritten) {
  Write("rubric.yaml", kCode);
  for (const char* name : {"ada", "bob", "eve"})
    Write(std::string("class/") + name + "/work.py", std::string("import time\ntime.sleep(0.5)\n") + kRight);
  const Ran ran = RunUntil({"grade", "class", "--rubric", "rubric.yaml"}, SIGINT,
                           [&] { return fs::exists(In("grades/001-ada.html")); });
  if (Refused(ran, In("grades").string())) return;
  EXPECT_EQ(ran.status, 130) << ran.err;
  EXPECT_NE(ran.err.find("stopped before it was complete"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(In("grades/grades.csv")));
  for (const auto& entry : fs::directory_iterator(In("grades"))) EXPECT_TRUE(entry.path().extension() == ".html");
}

}  // namespace
}  // namespace gaitwright::cli
