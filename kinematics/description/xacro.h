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
  PackageFolders packages;                       ///< folders for `$(find NAME)`, searched first
  bool strict = false;                           ///< refuses files in an encoding other than UTF-8
};

/// External inputs of an expansion.
struct XacroSources {
  /// Reads an included file or YAML file. The path is absolute, or relative like the path of the first text.
  std::function<Result<std::string>(const std::string& path)> read;
  /// Finds the folder of a package that is named by a file in `folder`.
  std::function<Result<std::string>(const std::string& package, const std::string& folder)> find_package;
  /// The value of an environment variable.
  std::function<std::optional<std::string>(const std::string& name)> environment;
};

/// Whether a text must be expanded before it can be read as a URDF. It then contains, outside comments, an element of
/// the namespace `xacro`, an expression `${...}`, or a substitution such as `$(find ...)`. The declaration of the
/// namespace alone does not count, because expanded files may keep it.
bool IsXacro(const std::string& text);

/// Expands a xacro file to plain XML: macros, blocks, properties, Python expressions, conditions, included files and
/// YAML files, as in version 2 of xacro. The result has no elements of xacro, no comments, and no namespace of xacro;
/// all other elements are kept. Elements without the prefix `xacro:`, as in files before ROS Jade, are recognised if
/// the root declares the namespace.
///
/// Differences from xacro: attributes of the root are evaluated last, so they may use arguments that the file declares.
/// Whole numbers have 64 bits. Include patterns are not supported. The texts of xacro's `message()`, `warning()` and
/// `error()` are ignored.
///
/// Failure: FILE:LINE: with the element and the reason, if a file is not XML, a name is not defined, an expression is
/// wrong, a macro is called without a parameter, a file or package is not found, an argument is given that the file
/// does not use, or the result exceeds a limit: 64 MiB, 1,000,000 elements, 90 nested elements, 100 nested macros,
/// 5,000,000 steps. Hints list the macros that were being called.
Result<std::string> ExpandXacro(const XacroRequest& request);

/// Expands a text as the file `path`, with everything else from `sources`.
Result<std::string> ExpandXacroText(const std::string& text, const std::string& path,
                                    const std::map<std::string, std::string>& arguments, const XacroSources& sources);

}  // namespace gaitwright
