// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace gaitwright::cli {

/// A file of a command line, and its name in messages: its flag, or words such as "the log".
struct NamedPath {
  std::string name, path;
  std::vector<std::string> endings = {};  ///< accepted endings of an output, such as ".csv"; empty: any
  bool ending_decides = false;            ///< the ending decides the format, so that no other ending is accepted
};

/// The ending of a path in lower case, such as ".svg".
std::string EndingOf(const std::string& path);

/// The files that a verb reads and writes. Empty paths are ignored.
struct Paths {
  std::vector<NamedPath> read, written;
  std::string plot_folder;  ///< gets SVG files

  /// Read adds an input file, Write adds an output file.
  void Read(std::string_view name, const std::string& path);
  void Write(std::string_view name, const std::string& path, std::initializer_list<std::string_view> endings = {});
  /// Adds an output file whose ending decides its format.
  void WriteByEnding(std::string_view name, const std::string& path, std::initializer_list<std::string_view> endings);
  /// Adds the file of `gait` if it names one.
  void AddGait(const std::string& gait);
  /// Adds the file of `sequence` if it names one.
  void AddSequence(const std::string& sequence);
  /// Adds the files of `terrain` if it names any.
  void AddTerrain(const std::string& terrain);
};

/// The path with a suffix before its ending: "a/log.json" with "-mujoco" is "a/log-mujoco.json". "" stays "".
std::string WithSuffix(const std::string& path, const std::string& suffix);

/// Checks the paths before the work begins, without creating anything: each output can be written, no output overwrites
/// an input, and no two outputs are the same file, also through `./` or links. An output with the ending of another
/// format is refused, since people and programs rely on endings. Other endings, such as ".bak" or ".3", are refused
/// only if the ending decides the format.
/// @throws InvalidArgument that names the flag, the path and the reason, or both files if two conflict.
void CheckPaths(const Paths& paths);

}  // namespace gaitwright::cli
