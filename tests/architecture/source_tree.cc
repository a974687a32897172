// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

namespace gaitwright::architecture {
namespace {

namespace fs = std::filesystem;

std::string Read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void Collect(const fs::path& root, const fs::path& folder, const std::function<bool(const fs::path&)>& wanted,
             std::vector<SourceFile>& files) {
  if (!fs::is_directory(root / folder)) return;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
    if (!entry.is_regular_file() || !wanted(entry.path())) continue;
    files.push_back({fs::relative(entry.path(), root).generic_string(), Read(entry.path())});
  }
}

std::vector<SourceFile> InOrder(std::vector<SourceFile> files) {
  std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

}  // namespace

std::vector<SourceFile> CppFiles(const std::string& root, const std::vector<std::string>& folders) {
  std::vector<SourceFile> files;
  const auto is_cpp = [](const fs::path& path) {
    return path.extension() == ".h" || path.extension() == ".cc" || path.extension() == ".cpp" ||
           path.extension() == ".hpp";
  };
  for (const std::string& folder : folders) Collect(root, folder, is_cpp, files);
  return InOrder(std::move(files));
}

std::vector<SourceFile> ScriptFiles(const std::string& root) {
  std::vector<SourceFile> files;
  const auto is_script = [](const fs::path& path) {
    return path.extension() == ".cmake" || path.extension() == ".sh" || path.filename() == "CMakeLists.txt";
  };
  for (const char* folder :
       {"cmake", "cli", "examples", "tests", "kinematics", "planning", "optimisation", "playback"}) {
    Collect(root, folder, is_script, files);
  }
  for (const char* name : {"CMakeLists.txt", "run", "test", ".ci/run"}) {
    files.push_back({name, Read(fs::path(root) / name)});
  }
  return InOrder(std::move(files));
}

}  // namespace gaitwright::architecture
