// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace gaitwright::cli {

/// A file of a command line and what it is there: its flag, or words such as "the log".
struct NamedPath {
  std::string name, path;
  std::vector<std::string> endings = {};  ///< of a file that is written: those of its format, ".csv"; none: any
  bool ending_decides = false;            ///< which format is written, so that no other ending is accepted
};

/// The ending of a path in small letters, as ".svg".
std::string EndingOf(const std::string& path);

/// The files that a verb reads and writes. Paths that are empty are none.
struct Paths {
  std::vector<NamedPath> read, written;
  std::string plot_folder;  ///< gets SVG files

  /// Adds a file that is read, and a file that is written.
  void Read(std::string_view name, const std::string& path);
  void Write(std::string_view name, const std::string& path, std::initializer_list<std::string_view> endings = {});
  /// Adds a file whose format is that of its ending.
  void WriteByEnding(std::string_view name, const std::string& path, std::initializer_list<std::string_view> endings);
  /// Adds the file of `gait` when it names one.
  void AddGait(const std::string& gait);
  /// Adds the file of `sequence` when it names one.
  void AddSequence(const std::string& sequence);
  /// Adds the files of `terrain` when it names any.
  void AddTerrain(const std::string& terrain);
};

/// The path with a suffix before its ending: "a/log.json" with "-mujoco" is "a/log-mujoco.json". "" stays "".
std::string WithSuffix(const std::string& path, const std::string& suffix);

/// Sees to it that what is written can be, as far as that is seen without making anything, and that nothing is written
/// over what is read, nor twice to one file; by `./` or links too. A name with the ending of another format is refused,
/// since people and programs go by it; other endings, such as ".bak" or ".3", say nothing, but are refused where the
/// ending decides. Call it before the work is done.
/// @throws InvalidArgument naming what is wrong: the flag, the path and why, or both of two.
void CheckPaths(const Paths& paths);

}  // namespace gaitwright::cli
