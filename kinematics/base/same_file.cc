// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <system_error>

#include "kinematics/base/file.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// The path with its links resolved as far as it exists; the unchanged path if this fails.
fs::path Resolved(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return fs::path(path).lexically_normal();
  const fs::path canonical = fs::weakly_canonical(absolute, error);
  const fs::path resolved = (error ? absolute : canonical).lexically_normal();
  return resolved.has_filename() ? resolved : resolved.parent_path();  // a folder without its last slash
}

}  // namespace

bool IsSameFile(const std::string& a, const std::string& b) { return Resolved(a) == Resolved(b); }

}  // namespace gaitwright
