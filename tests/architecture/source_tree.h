// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright::architecture {

/// A file of the tree.
struct SourceFile {
  std::string path;  ///< from the root, with '/'
  std::string text;
};

/// The C++ files below the given top folders, in the order of their paths; a folder that does not exist has none.
std::vector<SourceFile> CppFiles(const std::string& root, const std::vector<std::string>& folders);

/// The scripts and CMake files of the tree, in the order of their paths.
std::vector<SourceFile> ScriptFiles(const std::string& root);

}  // namespace gaitwright::architecture
