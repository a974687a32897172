// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "kinematics/base/result.h"
#include "kinematics/description/find_package.h"

namespace gaitwright {

/// A xacro file with the user's arguments.
struct XacroRequest {
  std::string path;
  std::map<std::string, std::string> arguments;  ///< values of `$(arg NAME)`
  PackageFolders packages;                       ///< folders for `$(find NAME)`, which are tried first
  bool strict = false;                           ///< files in another encoding than UTF-8 are refused, not converted
};

/// External inputs of an expansion.
struct XacroSources {
  /// The text of an included file or YAML file. The path is absolute, or relative as that of the first text is.
  std::function<Result<std::string>(const std::string& path)> read;
  /// The folder of a package that a file in `folder` names.
  std::function<Result<std::string>(const std::string& package, const std::string& folder)> find_package;
  /// The value of an environment variable.
  std::function<std::optional<std::string>(const std::string& name)> environment;
};

/// Whether a text is to be expanded before it can be read as a URDF: outside of comments it has an element of the
/// namespace `xacro`, an expression `${...}`, or a substitution such as `$(find ...)`. The declaration of the namespace
/// alone does not count, since expanded files may keep it.
bool IsXacro(const std::string& text);

/// Expands a xacro file to plain XML: macros, blocks, properties, expressions as Python has them, conditions, included
/// files and YAML files, as in version 2 of xacro. The result has no element of xacro, no comment, and not its
/// namespace; all other elements are kept. Elements without the prefix `xacro:`, as files before ROS Jade have them,
/// are known where the root declares the namespace.
///
/// Differences from xacro: attributes of the root are evaluated last, so that they may use arguments that the file
/// declares; whole numbers have 64 bits; one file at a time is included, no pattern; what `message()`, `warning()`
/// and `error()` of xacro say is dropped.
///
/// Failure: FILE:LINE: with the element and the reason, where a file is not XML, a name is not defined, an expression
/// is wrong, a macro is called without a parameter, a file or package is not found, an argument is given that the file
/// does not use, or the result is beyond its bounds: 64 MiB, 1,000,000 elements, 90 elements and 100 macros in one
/// another, 5,000,000 steps. Hints tell which macros were being called.
Result<std::string> ExpandXacro(const XacroRequest& request);

/// Expands a text as the file `path`, with everything else from `sources`.
Result<std::string> ExpandXacroText(const std::string& text, const std::string& path,
                                    const std::map<std::string, std::string>& arguments, const XacroSources& sources);

}  // namespace gaitwright
