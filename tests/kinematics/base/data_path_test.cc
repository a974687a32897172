// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/data_path.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/built_paths.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

TEST(DataPath, IsOfTheSourceTreeInABuildTree) {
  const fs::path source = fs::canonical(SourceFolder());
  EXPECT_EQ(DataPath("robots"), (source / "robots").string());
  EXPECT_EQ(DataPath("gaits.yaml"), (source / "planning/gait/gaits.yaml").string());
  EXPECT_EQ(DataPath("benchmarks/centroidal_problems.json"),
            (source / "tests/benchmarks/centroidal_problems.json").string());
}

TEST(DataPath, IsThatOfTheVariableEvenWhereNothingIsThere) {
  setenv("GAITWRIGHT_DATA_PATH_TEST", "/no/such/folder", 1);
  EXPECT_EQ(DataPath("robots", "GAITWRIGHT_DATA_PATH_TEST"), "/no/such/folder");
  unsetenv("GAITWRIGHT_DATA_PATH_TEST");
  EXPECT_EQ(DataPath("robots", "GAITWRIGHT_DATA_PATH_TEST"), DataPath("robots"));
}

TEST(DataPath, NamesTheInstalledPlaceOfWhatDoesNotExist) {
  const std::string path = DataPath("no_such_data");
  EXPECT_TRUE(path.ends_with("/share/gaitwright/no_such_data")) << path;
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace gaitwright
