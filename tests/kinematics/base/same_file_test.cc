// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "kinematics/base/file.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

TEST(SameFile, HoweverItIsWritten) {
  EXPECT_TRUE(IsSameFile("a", "./a"));
  EXPECT_TRUE(IsSameFile("a/../b", "b"));
  EXPECT_TRUE(IsSameFile("a", (fs::current_path() / "a").string()));
  EXPECT_TRUE(IsSameFile("folder", "folder/."));
  EXPECT_TRUE(IsSameFile("folder", "folder/"));
  EXPECT_TRUE(IsSameFile("/", "/."));
  EXPECT_FALSE(IsSameFile("a", "b"));
  EXPECT_FALSE(IsSameFile("a/c", "b/c"));
}

TEST(SameFile, ThroughLinks) {
  const fs::path folder = ScratchFolder() / "same";
  fs::create_directories(folder / "real");
  fs::create_symlink("real", folder / "link");
  std::ofstream(folder / "real/file") << "text";
  fs::create_symlink("real/file", folder / "to_file");
  const auto in = [&](const char* name) { return (folder / name).string(); };
  EXPECT_TRUE(IsSameFile(in("real/file"), in("link/file")));
  EXPECT_TRUE(IsSameFile(in("real/file"), in("to_file")));
  EXPECT_TRUE(IsSameFile(in("real/not_yet"), in("link/not_yet")));
  EXPECT_FALSE(IsSameFile(in("real/file"), in("file")));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace gaitwright
