// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/writable.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// Runs as a user to whom permissions apply: the user of the tests or, if that is root, the user nobody.
class AsAUser {
 public:
  AsAUser() { Become(kNobody); }
  AsAUser(const AsAUser&) = delete;
  AsAUser& operator=(const AsAUser&) = delete;
  ~AsAUser() { Become(0); }

 private:
  static constexpr uid_t kNobody = 65534;
  static void Become(uid_t user) { EXPECT_TRUE(::getuid() != 0 || ::seteuid(user) == 0); }
};

class Writable : public testing::Test {
 protected:
  Writable() {
    for (const fs::path& folder : {ScratchFolder(), folder_, folder_ / "shut", folder_ / "open"}) {
      fs::create_directories(folder);
      fs::permissions(folder, static_cast<fs::perms>(0755));
    }
    fs::permissions(folder_ / "open", fs::perms::all);
    for (const char* file : {"file", "shut/file", "open/locked", "open/free"}) std::ofstream(InScratch(file)) << "text";
    fs::permissions(InScratch("open/locked"), static_cast<fs::perms>(0444));
    fs::permissions(InScratch("open/free"), static_cast<fs::perms>(0666));
    fs::permissions(InScratch("shut"), static_cast<fs::perms>(0555));
  }
  ~Writable() override {
    std::error_code ignored;
    fs::permissions(InScratch("shut"), static_cast<fs::perms>(0755), ignored);
    fs::remove_all(folder_, ignored);
  }

  std::string InScratch(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t Count() const {
    const fs::recursive_directory_iterator all(folder_);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

 private:
  fs::path folder_ = ScratchFolder() / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(Writable, NothingSpeaksAgainstNewFilesInFoldersThatMayHaveToBeMade) {
  const std::size_t before = Count();
  for (const char* file : {"file", "new", "a/b/new", "open/free", "open/new"})
    EXPECT_EQ(ReasonNotWritable(InScratch(file)), "");
  EXPECT_EQ(ReasonNotWritable("new"), "") << "in the present folder";
  EXPECT_EQ(ReasonNoNewFiles(InScratch("a/b")), "");
  EXPECT_EQ(ReasonNoNewFiles(""), "");
  EXPECT_EQ(Count(), before) << "nothing is made";
}

TEST_F(Writable, MissingFilesAndMissingFoldersAreDistinguished) {
  EXPECT_EQ(ReasonNotWritable(InScratch("open")), "it is a folder; give a file");
  EXPECT_EQ(ReasonNotWritable(InScratch("new/")), "it is the name of a folder; give a file");
  EXPECT_EQ(ReasonNotWritable(""), "it is the name of a folder; give a file");
  EXPECT_EQ(ReasonNotWritable("/dev/null"), "it exists and is not a regular file");
  const std::string no_folder = "'" + InScratch("file") + "' is a file, not a folder; give a folder";
  for (const char* file : {"file/new", "file/a/new"}) EXPECT_EQ(ReasonNotWritable(InScratch(file)), no_folder);
  EXPECT_EQ(ReasonNoNewFiles(InScratch("file")), no_folder);
  EXPECT_NE(ReasonNotWritable(InScratch(std::string(300, 'x'))), "") << "no file has so long a name";
}

TEST_F(Writable, PermissionsAreThoseOfTheUser) {
  const AsAUser user;
  EXPECT_EQ(ReasonNotWritable(InScratch("open/new")), "") << "else the rest proves nothing";
  EXPECT_EQ(ReasonNotWritable(InScratch("open/free")), "");
  EXPECT_EQ(ReasonNotWritable(InScratch("open/locked")), "Permission denied");
  const std::string shut = "Permission denied, in the folder '" + InScratch("shut") + "'";
  for (const char* file : {"shut/new", "shut/a/b/new"}) EXPECT_EQ(ReasonNotWritable(InScratch(file)), shut);
  EXPECT_EQ(ReasonNoNewFiles(InScratch("shut/plots")), shut);
  EXPECT_EQ(ReasonNotWritable(InScratch("shut/file")), ::getuid() == 0 ? "Permission denied" : shut)
      << "a file of its own in a folder that takes no temporary beside it";
}

}  // namespace
}  // namespace gaitwright
