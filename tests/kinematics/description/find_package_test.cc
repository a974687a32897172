// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/find_package.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "kinematics/base/file.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// Sets a variable of the environment as long as it lives.
class VariableSet {
 public:
  VariableSet(const char* name, const std::string& value) : name_(name) {
    if (const char* former = std::getenv(name)) former_ = former;
    ::setenv(name, value.c_str(), 1);
  }
  VariableSet(const VariableSet&) = delete;
  VariableSet& operator=(const VariableSet&) = delete;
  ~VariableSet() {
    if (former_) {
      ::setenv(name_, former_->c_str(), 1);
    } else {
      ::unsetenv(name_);
    }
  }

 private:
  const char* name_;
  std::optional<std::string> former_;
};

class FindsPackages : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::weakly_canonical(ScratchFile("find_package")).string();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  std::string Folder(const std::string& path) {
    fs::create_directories(folder_ + "/" + path);
    return folder_ + "/" + path;
  }
  /// A folder with a package.xml that names it.
  std::string Package(const std::string& path, const std::string& name) {
    const std::string text = "<package><name> " + name + "\n</name></package>";
    EXPECT_TRUE(WriteFileAtomically(Folder(path) + "/package.xml", text).ok());
    return folder_ + "/" + path;
  }
  static std::string Found(const std::string& name, const std::string& from, const PackageFolders& given = {}) {
    const Result<std::string> found = FindPackage(name, from, given);
    return found ? *found : FailureCodeName(found.failure().code);
  }

  std::string folder_;
};

TEST_F(FindsPackages, AboveAndBesideTheFile) {
  const std::string robot = Package("work/robots/folder", "bot_description"), urdf = Folder("work/robots/folder/urdf");
  EXPECT_EQ(Found("bot_description", urdf), robot);
  EXPECT_EQ(Found("folder", urdf), robot);
  const std::string beside = Folder("work/robots/parts");
  EXPECT_EQ(Found("parts", urdf), beside);
}

TEST_F(FindsPackages, GivenFoldersComeFirst) {
  const std::string urdf = Folder("a/bot/urdf"), other = Folder("other");
  EXPECT_EQ(Found("bot", urdf), folder_ + "/a/bot");
  EXPECT_EQ(Found("bot", urdf, {{"bot", other}}), other);
  const std::string relative = fs::relative(other).string();
  EXPECT_EQ(Found("bot", urdf, {{"bot", relative}}), other);
}

TEST_F(FindsPackages, InTheEnvironment) {
  const std::string here = Folder("here"), deep = Package("ros/stack/some_folder", "deep_bot");
  const std::string shared = Folder("prefix/share/shared_bot");
  const VariableSet ros("ROS_PACKAGE_PATH", folder_ + "/none:" + folder_ + "/ros");
  const VariableSet ament("AMENT_PREFIX_PATH", folder_ + "/prefix");
  EXPECT_EQ(Found("deep_bot", here), deep);
  EXPECT_EQ(Found("shared_bot", here), shared);
}

TEST_F(FindsPackages, InTheCurrentFolderLast) {
  const std::string here = Folder("far/away"), current = Folder("current/bot");
  const fs::path former = fs::current_path();
  fs::current_path(folder_ + "/current");
  EXPECT_EQ(Found("bot", here), current);
  fs::current_path(former);
}

TEST_F(FindsPackages, TheFirstFolderThatIsAccepted) {
  const std::string near = Folder("a/bot/x/bot"), far = folder_ + "/a/bot";
  const auto is_far = [&](const std::string& path) { return path == far; };
  EXPECT_EQ(FindPackage("bot", near, {}).value(), near);
  EXPECT_EQ(FindPackage("bot", near, {}, is_far).value(), far);
}

TEST_F(FindsPackages, SaysWhereItLookedAndWhatHelps) {
  const VariableSet ros("ROS_PACKAGE_PATH", "/opt/elsewhere");
  const Result<std::string> none = FindPackage("no_bot", folder_, {{"bot", "/x"}});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.failure().code, FailureCode::kNoPackage);
  for (const std::string& part :
       {std::string("'no_bot' is not found"), folder_, std::string("ROS_PACKAGE_PATH ('/opt/e"),
        std::string("AMENT_PREFIX_PATH"), std::string("package.xml")})
    EXPECT_NE(none.failure().message.find(part), std::string::npos) << none.failure().message;
  ASSERT_EQ(none.failure().suggestions.size(), 1U);
  for (const char* part : {"no_bot=DIR", "'bot'"})
    EXPECT_NE(none.failure().suggestions[0].text.find(part), std::string::npos) << part;
  for (const char* odd : {"", ".", "..", "a/b"}) EXPECT_EQ(Found(odd, folder_), "no_package") << odd;
}

}  // namespace
}  // namespace gaitwright
