// SPDX-License-Identifier: BSD-3-Clause
// The rules detect violations: each is tested with a text that violates it, and a similar one that does not.
#include "tests/architecture/include_rules.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/architecture/rules_table.h"

namespace gaitwright::architecture {
namespace {

std::string Breach(const std::string& file, const std::string& include) {
  const std::vector<std::string> breaches = IncludeBreaches(file, "#include " + include + "\n");
  return breaches.empty() ? "" : breaches.front();
}

TEST(IncludesOf, ReadsQuotesAngleBracketsAndSpaces) {
  const std::vector<Include> includes =
      IncludesOf("// #include <no>\n#include <a>\n  #  include \"b/c.h\"  // d\nint x;\n");
  ASSERT_EQ(includes.size(), 2u);
  EXPECT_EQ(includes[0].path, "a");
  EXPECT_TRUE(includes[0].angled);
  EXPECT_EQ(includes[0].line, 2);
  EXPECT_EQ(includes[1].path, "b/c.h");
  EXPECT_FALSE(includes[1].angled);
  EXPECT_EQ(includes[1].line, 3);
}

TEST(IncludeBreaches, TheArrowBetweenRoomsPointsDown) {
  EXPECT_EQ(Breach("planning/gait/a.cc", "\"kinematics/ik/b.h\""), "");
  EXPECT_EQ(Breach("kinematics/ik/a.cc", "\"planning/plan/b.h\""),
            "kinematics/ik/a.cc:1: kinematics/ik may not include 'planning/plan/b.h': planning/plan is not below it");
  EXPECT_NE(Breach("optimisation/swing/a.h", "\"playback/log/b.h\""), "");
  EXPECT_NE(Breach("planning/tasks/a.h", "\"optimisation/numerics/b.h\""), "");
  EXPECT_EQ(Breach("workflows/walk/a.cc", "\"playback/score/b.h\""), "");
  EXPECT_EQ(Breach("cli/a.cc", "\"workflows/walk/b.h\""), "");
  EXPECT_NE(Breach("workflows/walk/a.cc", "\"cli/b.h\""), "");
  EXPECT_NE(Breach("cli/a.cc", "\"examples/b.h\""), "");
}

TEST(IncludeBreaches, TheArrowInsideARoomPointsDown) {
  EXPECT_EQ(Breach("kinematics/dynamics/a.h", "\"kinematics/model/b.h\""), "");
  EXPECT_NE(Breach("kinematics/model/a.h", "\"kinematics/dynamics/b.h\""), "");
  EXPECT_EQ(Breach("kinematics/model/a.h", "\"kinematics/model/b.h\""), "");
  EXPECT_NE(Breach("playback/report/a.h", "\"playback/viewer/b.h\""), "");
}

/// Two folders of one room, the lower first, for every such pair in the table.
TEST(IncludeBreaches, EveryPairOfFoldersInARoomHasOneDirection) {
  int pairs = 0;
  for (const Layer& low : kLayers) {
    for (const Layer& high : kLayers) {
      const std::string a(low.folder), b(high.folder);
      if (a.substr(0, a.find('/')) != b.substr(0, b.find('/')) || low.rank >= high.rank) continue;
      ++pairs;
      EXPECT_NE(Breach(a + "/x.cc", "\"" + b + "/y.h\""), "") << a << " must not include " << b;
      if (b == "planning/audit" && a != "planning/plan") continue;
      EXPECT_EQ(Breach(b + "/x.cc", "\"" + a + "/y.h\""), "") << b << " may include " << a;
    }
  }
  EXPECT_GT(pairs, 80);
}

TEST(IncludeBreaches, TheJudgeCannotSeeTheMaker) {
  EXPECT_EQ(Breach("playback/control/a.h", "\"planning/plan/b.h\""), "");
  EXPECT_EQ(Breach("playback/control/a.h", "\"kinematics/ik/b.h\""), "");
  EXPECT_EQ(Breach("playback/control/a.cc", "\"planning/gait/b.h\""),
            "playback/control/a.cc:1: playback sees only playback, kinematics, planning/plan, not 'planning/gait/b.h'");
  EXPECT_NE(Breach("playback/score/a.cc", "\"optimisation/numerics/b.h\""), "");
  EXPECT_EQ(Breach("planning/audit/a.cc", "\"planning/plan/b.h\""), "");
  EXPECT_NE(Breach("planning/audit/a.cc", "\"planning/footsteps/b.h\""), "");
  EXPECT_EQ(Breach("planning/tasks/a.cc", "\"planning/footsteps/b.h\""), "");
}

TEST(IncludeBreaches, EachThirdPartyHasOneOwner) {
  const std::vector<std::pair<std::string, std::string>> owned = {
      {"<urdf_parser/urdf_parser.h>", "kinematics/model"},
      {"<tinyxml2.h>", "kinematics/model"},
      {"<fcl/fcl.h>", "kinematics/collision"},
      {"<ccd/ccd.h>", "kinematics/collision"},
      {"<ompl/base/Planner.h>", "planning/paths"},
      {"<ceres/ceres.h>", "optimisation/numerics"},
      {"<btBulletDynamicsCommon.h>", "playback/bullet"},
      {"<BulletDynamics/Featherstone/btMultiBody.h>", "playback/bullet"},
      {"<LinearMath/btVector3.h>", "playback/bullet"},
      {"<CLI/CLI.hpp>", "cli"},
      {"<pybind11/pybind11.h>", "python"}};
  for (const auto& [include, owner] : owned) {
    EXPECT_EQ(Breach(owner + "/a.cc", include), "") << include << " in " << owner;
    EXPECT_NE(Breach("workflows/walk/a.cc", include), "") << include;
    EXPECT_NE(Breach("kinematics/base/a.cc", include), "") << include;
    EXPECT_NE(Breach("playback/score/a.cc", include), "") << include;
  }
}

TEST(IncludeBreaches, PublicHeadersNameStdEigenAndUs) {
  EXPECT_EQ(Breach("optimisation/numerics/a.h", "<vector>"), "");
  EXPECT_EQ(Breach("optimisation/numerics/a.h", "<Eigen/Core>"), "");
  for (const char* include :
       {"<ceres/ceres.h>", "<fmt/format.h>", "<nlohmann/json.hpp>", "<yaml-cpp/yaml.h>", "<unistd.h>"}) {
    EXPECT_NE(Breach("optimisation/numerics/a.h", include), "") << include;
    EXPECT_EQ(Breach("optimisation/numerics/a.cc", include), "") << include;
    EXPECT_EQ(Breach("optimisation/numerics/a_internal.h", include), "") << include;
  }
}

TEST(IncludeBreaches, HeadersOfTheProgramDoNotNameCli11) {
  EXPECT_EQ(Breach("cli/command_line.cc", "<CLI/CLI.hpp>"), "");
  EXPECT_NE(Breach("cli/command_line.h", "<CLI/CLI.hpp>"), "");
}

TEST(IncludeBreaches, StrangersAndRelativePathsAreRefused) {
  EXPECT_NE(Breach("kinematics/base/a.cc", "<boost/any.hpp>"), "");
  EXPECT_NE(Breach("kinematics/base/a.cc", "\"result.h\""), "");
  EXPECT_NE(Breach("kinematics/base/a.cc", "\"../model/b.h\""), "");
  EXPECT_NE(Breach("kinematics/ik/a.cc", "<kinematics/base/b.h>"), "");
  EXPECT_NE(Breach("kinematics/ik/a.cc", "\"tests/base/b.h\""), "");
  EXPECT_NE(Breach("kinematics/ik/a.cc", "\"kinematics/b.h\""), "");
  EXPECT_EQ(IncludeBreaches("kinematics/secret/a.h", "").size(), 1u) << "a folder that the table does not know";
}

TEST(FileBreaches, LicenceGuardLengthAndPrinting) {
  const std::string licence = "// SPDX-License-Identifier: BSD-3-Clause\n";
  EXPECT_TRUE(FileBreaches("kinematics/base/a.h", licence + "#pragma once\n").empty());
  EXPECT_EQ(FileBreaches("kinematics/base/a.h", "#pragma once\n").size(), 1u);
  EXPECT_EQ(FileBreaches("kinematics/base/a.h", licence).size(), 1u);
  const std::string longest(static_cast<std::size_t>(kLongestFile - 1), '\n');
  EXPECT_TRUE(FileBreaches("cli/a.cc", licence + longest).empty());
  EXPECT_EQ(FileBreaches("cli/a.cc", licence + longest + "\n").size(), 1u);
  EXPECT_EQ(FileBreaches("planning/gait/a.cc", licence + "std::cout << 1;\n").size(), 1u);
  EXPECT_EQ(FileBreaches("planning/gait/a.cc", licence + "fmt::print(\"\");\n").size(), 1u);
  EXPECT_TRUE(FileBreaches("cli/a.cc", licence + "fmt::print(\"\");\n").empty());
}

}  // namespace
}  // namespace gaitwright::architecture
