// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright::architecture {

/// One #include line of a file.
struct Include {
  std::string path;  ///< between the quotes or angle brackets
  bool angled = false;
  int line = 0;  ///< from 1
};

/// The #include lines of a source text, in order; those in line comments are skipped.
std::vector<Include> IncludesOf(const std::string& text);

/// Every violation of the rules by one file, as sentences that name the file, the line and the rule; empty without
/// violations. The rules apply to the rooms, the program and the examples: the order of rooms and of the folders inside
/// them, no access of `playback` to the planners, one owner for each third party, and only std, Eigen and our own
/// headers in public headers.
/// @param file  path from the root of the tree, with '/'.
std::vector<std::string> IncludeBreaches(const std::string& file, const std::string& text);

/// Every violation of the rules for single files: the licence line, `#pragma once` in a header, the length, and no
/// printing from libraries.
std::vector<std::string> FileBreaches(const std::string& file, const std::string& text);

/// Files that may be longer than 400 lines; the table gives the reason for each.
std::vector<std::string> FilesAllowedToBeLong();

}  // namespace gaitwright::architecture
