// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/data_path.h"

#include <dlfcn.h>
#include <link.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

constexpr int kMostFoldersAbove = 4;  // from PREFIX/lib/python3.11/dist-packages/gaitwright to PREFIX

/// The shared library that contains this code, or the program; empty if it cannot be found.
fs::path OwnFile() {
  static const char here = 0;
  Dl_info info;
  void* found = nullptr;
  std::error_code error;
  if (dladdr1(&here, &info, &found, RTLD_DL_LINKMAP) != 0 && found != nullptr) {
    const std::string library = static_cast<const link_map*>(found)->l_name;  // empty for the program
    if (!library.empty()) return fs::canonical(library, error);
  }
  return fs::canonical("/proc/self/exe", error);
}

/// The folders that may contain the data, the preferred one first.
std::vector<fs::path> DataFolders() {
  std::vector<fs::path> folders;
  fs::path folder = OwnFile().parent_path();
  for (int above = 0; above <= kMostFoldersAbove && folder.has_relative_path(); ++above) {
    folders.push_back(folder / "share/gaitwright");
    folder = folder.parent_path();
  }
  for (const char* fixed :
       {GAITWRIGHT_INSTALLED_DATA, "/usr/local/share/gaitwright", "/usr/share/gaitwright", GAITWRIGHT_BUILD_DATA}) {
    folders.emplace_back(fixed);
  }
  return folders;
}

}  // namespace

std::string DataPath(const std::string& name, const char* variable) {
  const char* chosen = variable == nullptr ? nullptr : std::getenv(variable);
  if (chosen != nullptr) return chosen;
  for (const fs::path& folder : DataFolders()) {
    std::error_code error;
    const fs::path path = fs::canonical(folder / name, error);
    if (!error) return path.string();
  }
  return (fs::path(GAITWRIGHT_INSTALLED_DATA) / name).string();
}

}  // namespace gaitwright
