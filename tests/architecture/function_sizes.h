// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright::architecture {

/// A function that is defined over several lines.
struct FunctionSize {
  std::string name;  ///< as written: `Result<T>::value`, `Fields`
  int line = 0;      ///< number of its first line, from 1
  int lines = 0;     ///< from its signature to its closing brace
  int parameters = 0;
};

/// The functions of a source text in clang-format's layout, in order. Lambdas are part of their function.
std::vector<FunctionSize> FunctionsOf(const std::string& text);

/// Every function of the file that has too many lines or parameters and is not in the table of exemptions.
/// @param file  path from the root of the tree, with '/'.
std::vector<std::string> FunctionBreaches(const std::string& file, const std::string& text);

}  // namespace gaitwright::architecture
