// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/writable.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// Error if the user of this process has no permission `what` (W_OK, X_OK) for an existing path.
std::error_code Denied(const fs::path& path, int what) {
  if (::faccessat(AT_FDCWD, path.c_str(), what, AT_EACCESS) == 0) return {};
  return {errno, std::generic_category()};
}

}  // namespace

std::string ReasonNotWritable(const std::string& path) {
  const fs::path target(path);
  if (!target.has_filename()) return "it is the name of a folder; give a file";
  std::error_code error;
  if (fs::exists(target, error)) {
    if (fs::is_directory(target, error)) return "it is a folder; give a file";
    if (!fs::is_regular_file(target, error)) return "it exists and is not a regular file";
    error = Denied(target, W_OK);
  }
  return error ? error.message() : ReasonNoNewFiles(target.parent_path().string());
}

std::string ReasonNoNewFiles(const std::string& folder) {
  std::error_code error;
  fs::path at(folder);
  while (!at.empty() && !fs::exists(at, error) && !error) at = at.parent_path();
  if (at.empty()) at = ".";
  const bool is_folder = fs::is_directory(at, error);
  if (!is_folder && !error) return fmt::format("'{}' is a file, not a folder; give a folder", at.string());
  if (!error) error = Denied(at, W_OK | X_OK);
  return error ? fmt::format("{}, in the folder '{}'", error.message(), at.string()) : "";
}

}  // namespace gaitwright
