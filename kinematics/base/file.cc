// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace gaitwright {
namespace {

Failure FileFailure(const std::string& code, const std::string& message) {
  return {FailureKind::kBadInput, code, "File", message, {}};
}

}  // namespace

Result<std::string> ReadFile(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    return FileFailure("no_such_file", fmt::format("no such file: '{}'", path));
  if (std::filesystem::is_directory(path, error)) {
    return FileFailure("not_a_file", fmt::format("'{}' is a folder, not a file", path));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return FileFailure("unreadable_file", fmt::format("cannot read '{}'", path));
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

Result<std::string> WriteFileAtomically(const std::string& path, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target(path);
  if (target.has_parent_path()) fs::create_directories(target.parent_path(), error);
  if (error) {
    return FileFailure("unwritable_file", fmt::format("cannot make the folder '{}' for '{}': {}",
                                                      target.parent_path().string(), path, error.message()));
  }
  const fs::path temporary = path + fmt::format(".{}.part", ::getpid());
  {
    std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) {
      fs::remove(temporary, error);
      return FileFailure("unwritable_file", fmt::format("cannot write '{}'", path));
    }
  }
  fs::rename(temporary, target, error);
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return FileFailure("unwritable_file", fmt::format("cannot write '{}': {}", path, error.message()));
  }
  return path;
}

}  // namespace gaitwright
