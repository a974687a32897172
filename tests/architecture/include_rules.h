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

/// The #include lines of a source text, in order; those in line comments are passed over.
std::vector<Include> IncludesOf(const std::string& text);

/// Every breach of the rules by one file, as sentences that name the file, the line and the rule; empty when it is
/// clean. The rules hold for the rooms, the program and the examples: the order of rooms and of the folders inside
/// them, the judge that cannot see the maker, one owner for each third party, and public headers of std, Eigen and
/// ourselves only.
/// @param file  path from the root of the tree, with '/'.
std::vector<std::string> IncludeBreaches(const std::string& file, const std::string& text);

/// Every breach of what holds for each file by itself: the licence line, `#pragma once` in a header, the length, and no
/// printing from libraries.
std::vector<std::string> FileBreaches(const std::string& file, const std::string& text);

/// Files that may be longer than 400 lines, each with its reason in the table.
std::vector<std::string> FilesAllowedToBeLong();

}  // namespace gaitwright::architecture
