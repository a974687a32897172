// SPDX-License-Identifier: BSD-3-Clause
// The source tree follows its own rules.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "tests/architecture/function_sizes.h"
#include "tests/architecture/include_rules.h"
#include "tests/architecture/rules_table.h"
#include "tests/architecture/source_tree.h"
#include "tests/built_paths.h"

namespace gaitwright::architecture {
namespace {

const std::string kRoot = SourceFolder();

std::vector<SourceFile> RoomFiles() {
  return CppFiles(kRoot,
                  {"kinematics", "planning", "optimisation", "playback", "workflows", "cli", "examples", "python"});
}

std::string Joined(const std::vector<std::string>& lines) { return fmt::format("{}", fmt::join(lines, "\n")); }

TEST(Architecture, FindsTheRooms) {
  std::vector<std::string> seen;
  for (const SourceFile& file : RoomFiles()) seen.push_back(file.path.substr(0, file.path.find('/')));
  for (const char* room : {"kinematics", "planning", "optimisation", "playback", "cli"}) {
    EXPECT_NE(std::find(seen.begin(), seen.end(), room), seen.end()) << "no C++ file found below " << room;
  }
}

TEST(Architecture, RoomsIncludeOnlyWhatTheyMay) {
  std::vector<std::string> breaches;
  for (const SourceFile& file : RoomFiles()) {
    for (std::string& breach : IncludeBreaches(file.path, file.text)) breaches.push_back(std::move(breach));
  }
  EXPECT_TRUE(breaches.empty()) << Joined(breaches);
}

TEST(Architecture, TheHandbookHasTheOrderOfRooms) {
  std::map<std::string, std::vector<std::string>> folders;
  for (const Layer& layer : kLayers) {
    const std::string path(layer.folder);
    const std::size_t slash = path.find('/');
    if (slash != std::string::npos) folders[path.substr(0, slash)].push_back("`" + path.substr(slash + 1) + "`");
  }
  std::ifstream file(kRoot + "/docs/code-layout.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  ASSERT_GE(folders.size(), 5U);
  for (const auto& [room, names] : folders) {
    const std::size_t row = page.find("| `" + room + "` |");
    ASSERT_NE(row, std::string::npos) << room;
    const std::string line = page.substr(row, page.find('\n', row) - row);
    EXPECT_NE(line.find(fmt::format("| {}", fmt::join(names, ", "))), std::string::npos)
        << "docs/code-layout.md has no row of " << room << " with " << fmt::format("{}", fmt::join(names, ", "));
  }
}

TEST(Architecture, OwnIncludesExist) {
  std::vector<std::string> paths;
  const std::vector<SourceFile> files = RoomFiles();
  for (const SourceFile& file : files) paths.push_back(file.path);
  for (const SourceFile& file : files) {
    for (const Include& include : IncludesOf(file.text)) {
      if (include.angled) continue;
      EXPECT_TRUE(std::binary_search(paths.begin(), paths.end(), include.path))
          << file.path << ":" << include.line << ": no file '" << include.path << "'";
    }
  }
}

TEST(Architecture, EachFileKeepsTheHouseRules) {
  std::vector<std::string> breaches;
  std::vector<SourceFile> files = RoomFiles();
  for (SourceFile& file : CppFiles(kRoot, {"tests"})) files.push_back(std::move(file));
  for (SourceFile& file : ScriptFiles(kRoot)) files.push_back(std::move(file));
  for (const SourceFile& file : files) {
    for (std::string& breach : FileBreaches(file.path, file.text)) breaches.push_back(std::move(breach));
  }
  EXPECT_TRUE(breaches.empty()) << Joined(breaches);
}

TEST(Architecture, NamesOfFilesAreSnakeCase) {
  std::vector<SourceFile> files = RoomFiles();
  for (SourceFile& file : CppFiles(kRoot, {"tests"})) files.push_back(std::move(file));
  for (const SourceFile& file : files) {
    const bool assignment = file.path.starts_with("examples/course/");  // in folders such as 1-zmp
    const std::string path = assignment ? file.path.substr(file.path.rfind('/')) : file.path;
    const bool plain = std::all_of(path.begin(), path.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '/' || c == '.';
    });
    EXPECT_TRUE(plain) << file.path;
    const std::string ending = file.path.substr(file.path.rfind('.'));
    EXPECT_TRUE(ending == ".h" || ending == ".cc") << file.path;
  }
}

/// The name of the type whose definition begins at the left margin of a header's line; empty for any other line.
std::string DefinedType(const std::string& line) {
  for (const std::string start : {"struct ", "class ", "enum class "}) {
    if (!line.starts_with(start) || line.find('{') == std::string::npos) continue;
    return line.substr(start.size(), line.find_first_of(" :{", start.size()) - start.size());
  }
  return "";
}

// The linker silently merges two types of one name in one program.
TEST(Architecture, NamesOfTypesStandForOneThing) {
  std::map<std::string, std::string> defined_in;
  for (const SourceFile& file : RoomFiles()) {
    if (!file.path.ends_with(".h")) continue;
    std::istringstream text(file.text);
    for (std::string line; std::getline(text, line);) {
      const std::string type = DefinedType(line);
      if (type.empty()) continue;
      const auto [first, is_new] = defined_in.emplace(type, file.path);
      EXPECT_TRUE(is_new) << type << " is defined in " << first->second << " and in " << file.path;
    }
  }
  EXPECT_GT(defined_in.size(), 100U);
}

TEST(Architecture, AllowedLongFilesExist) {
  for (const std::string& allowed : FilesAllowedToBeLong()) {
    const std::vector<SourceFile> files = CppFiles(kRoot, {allowed.substr(0, allowed.find('/'))});
    EXPECT_TRUE(std::any_of(files.begin(), files.end(), [&](const SourceFile& file) { return file.path == allowed; }))
        << "rules_table.h allows '" << allowed << "' to be long, but there is no such file";
  }
}

TEST(Architecture, FunctionsAreShortAndHaveFewParameters) {
  std::vector<std::string> breaches;
  for (const SourceFile& file : RoomFiles()) {
    for (std::string& breach : FunctionBreaches(file.path, file.text)) breaches.push_back(std::move(breach));
  }
  EXPECT_TRUE(breaches.empty()) << Joined(breaches);
}

TEST(Architecture, FunctionsThatMayBeLargerAreLarger) {
  const std::vector<SourceFile> files = RoomFiles();
  const auto needed = [&](const Exempt& exempt, const auto& is_large) {
    for (const SourceFile& file : files) {
      if (file.path != exempt.file) continue;
      for (const FunctionSize& function : FunctionsOf(file.text)) {
        if (function.name == exempt.name && is_large(function)) return true;
      }
    }
    return false;
  };
  for (const Exempt& exempt : kLongFunctions) {
    EXPECT_TRUE(needed(exempt, [](const FunctionSize& f) { return f.lines > kLongestFunction; })) << exempt.name;
  }
  for (const Exempt& exempt : kManyParameters) {
    EXPECT_TRUE(needed(exempt, [](const FunctionSize& f) { return f.parameters > kMostParameters; })) << exempt.name;
  }
}

std::ptrdiff_t LinesIn(const std::vector<SourceFile>& files) {
  std::ptrdiff_t lines = 0;
  for (const SourceFile& file : files) lines += std::count(file.text.begin(), file.text.end(), '\n');
  return lines;
}

TEST(Architecture, EachRoomHasTests) {
  for (const TestShare& share : kTestShares) {
    const std::string room(share.room);
    const auto code = static_cast<double>(LinesIn(CppFiles(kRoot, {room})));
    const auto tests = static_cast<double>(LinesIn(CppFiles(kRoot, {"tests/" + room})));
    EXPECT_GE(tests, share.least * code) << room << ": " << tests / code;
  }
}

TEST(Architecture, LongSourcesHaveTheirOwnTest) {
  std::vector<std::string> untested;
  for (const SourceFile& file :
       CppFiles(kRoot, {"kinematics", "planning", "optimisation", "playback", "workflows", "cli"})) {
    if (!file.path.ends_with(".cc") || LinesIn({file}) <= kLongestUntested) continue;
    const std::string test = kRoot + "/tests/" + file.path.substr(0, file.path.size() - 3) + "_test.cc";
    if (!std::filesystem::exists(test)) untested.push_back(file.path);
  }
  EXPECT_LE(untested.size(), static_cast<std::size_t>(kMostUntested)) << Joined(untested);
}

/// Adds our headers that a file's text includes, directly or indirectly.
void AddReached(const std::map<std::string, std::string>& text_of, const std::string& text,
                std::set<std::string>& reached) {
  for (const Include& include : IncludesOf(text)) {
    const auto header = text_of.find(include.path);
    if (header == text_of.end() || !reached.insert(include.path).second) continue;
    AddReached(text_of, header->second, reached);
  }
}

// Users may write the code of every example and handbook page against the installed library.
TEST(Architecture, PublicHeadersAreFewAndAllThatUsersAreShown) {
  std::map<std::string, std::string> text_of;
  for (const SourceFile& file : RoomFiles()) {
    if (file.path.ends_with(".h")) text_of[file.path] = file.text;
  }
  std::set<std::string> installed;
  for (const Layer& umbrella : kUmbrellas) {
    ASSERT_TRUE(text_of.contains(std::string(umbrella.folder))) << umbrella.folder;
    installed.emplace(umbrella.folder);
    AddReached(text_of, text_of.at(std::string(umbrella.folder)), installed);
  }
  EXPECT_GT(installed.size(), 50U);
  EXPECT_LE(installed.size(), static_cast<std::size_t>(kMostPublicHeaders));
  for (const std::string& header : installed) EXPECT_FALSE(header.ends_with("_internal.h")) << header;
  std::vector<SourceFile> shown = CppFiles(kRoot, {"examples", "tests/consumer"});
  for (const auto& entry : std::filesystem::directory_iterator(kRoot + "/docs")) {
    if (entry.path().extension() != ".md") continue;
    std::ifstream stream(entry.path());
    shown.push_back({entry.path().filename().string(),
                     std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>())});
  }
  for (const SourceFile& file : shown) {
    for (const Include& include : IncludesOf(file.text)) {
      if (!text_of.contains(include.path) || include.path.starts_with("cli/")) continue;
      if (include.path.starts_with("examples/")) continue;
      EXPECT_TRUE(installed.contains(include.path)) << file.path << " includes '" << include.path << "'";
    }
  }
}

/// npm uses the registry that the user has configured.
TEST(Architecture, TheLockFileOfTheViewerNamesNoHost) {
  std::ifstream stream(kRoot + "/playback/viewer/web/package-lock.json");
  std::vector<std::string> named;
  int packages = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("\"integrity\"") != std::string::npos) ++packages;
    if (line.find("://") != std::string::npos || line.find("\"resolved\"") != std::string::npos) named.push_back(line);
  }
  EXPECT_GT(packages, 3) << "the lock file was not read";
  EXPECT_TRUE(named.empty()) << Joined(named);
}

}  // namespace
}  // namespace gaitwright::architecture
