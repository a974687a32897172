// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Largest file that is read [byte].
inline constexpr std::size_t kLargestFile = std::size_t{512} << 20;

/// The bytes of a file, or of a pipe. Failure: no such file, a folder, a device such as /dev/zero, a socket, or more
/// than `most` bytes.
Result<std::string> ReadBytes(const std::string& path, std::size_t most = kLargestFile);

/// The whole text of a file in UTF-8, without a byte-order mark and without zero bytes at its end. Fails as ReadBytes
/// does; a failure names the file, and the line of a byte that is not text.
Result<std::string> ReadFile(const std::string& path, std::size_t most = kLargestFile);

/// Whether two paths lead to the same file, however they are written: relative or absolute, with '.' and '..', through
/// symbolic links. Neither need exist.
bool IsSameFile(const std::string& a, const std::string& b);

/// Writes the text to a temporary file beside `path` and renames it, so that no half-written file is ever seen.
/// Parent folders are made. @return the path written.
Result<std::string> WriteFileAtomically(const std::string& path, const std::string& text);

/// A file to write.
struct OutputFile {
  std::string path, text;
};

/// Writes all of the files or none: each to a temporary beside its path, then all are renamed. After a failure, all
/// files and folders are unchanged; existing files keep their old text. Parent folders are made. Signals that ask the
/// program to end wait until that is done.
/// @return the paths in their order; a failure that names the file that cannot be written and the system's reason, or
/// that is named twice.
Result<std::vector<std::string>> WriteFilesTogether(const std::vector<OutputFile>& files);

}  // namespace gaitwright
