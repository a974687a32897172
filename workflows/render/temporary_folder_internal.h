// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace gaitwright {

/// A new folder below the system's temporary one, deleted with this object.
class TemporaryFolder {
 public:
  explicit TemporaryFolder() : path_((std::filesystem::temp_directory_path() / "gaitwright-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) path_.clear();
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// Whether it was created.
  bool there() const { return !path_.empty(); }
  const std::string& path() const { return path_; }
  std::string In(const std::string& name) const { return (std::filesystem::path(path_) / name).string(); }

 private:
  std::string path_;
};

}  // namespace gaitwright
