// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Largest file that is read [byte].
inline constexpr std::size_t kLargestFile = std::size_t{512} << 20;

/// The bytes of a file or a pipe. Failure: the file does not exist, is a folder, a device such as /dev/zero or a
/// socket, or has more than `most` bytes.
Result<std::string> ReadBytes(const std::string& path, std::size_t most = kLargestFile);

/// The text of a file in UTF-8, without a byte-order mark and without zero bytes at its end. Failure: as in ReadBytes,
/// or a byte that is not text; the message names the file and the line.
Result<std::string> ReadFile(const std::string& path, std::size_t most = kLargestFile);

/// Whether two paths name the same file. Relative and absolute paths, '.', '..' and symbolic links are resolved. The
/// file need not exist.
bool IsSameFile(const std::string& a, const std::string& b);

/// Writes the text to a temporary file beside `path` and renames it, so that a partly written file never appears at
/// `path`. Creates parent folders. @return the path.
Result<std::string> WriteFileAtomically(const std::string& path, const std::string& text);

/// A file to write.
struct OutputFile {
  std::string path, text;
};

/// Writes all files or none: each to a temporary file beside its path, then all are renamed. Creates parent folders.
/// After a failure, all files and folders are unchanged. Signals to end the program are delayed until the end.
/// @return the paths in the same order. Failure: a file cannot be written (with the system's reason), or is given
/// twice.
Result<std::vector<std::string>> WriteFilesTogether(const std::vector<OutputFile>& files);

}  // namespace gaitwright
