// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace gaitwright {

/// A folder of this process alone, gone with it, so that tests may run side by side. A copy of the process that ends
/// by exit() leaves it.
inline const std::filesystem::path& ScratchFolder() {
  struct Own {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("gaitwright_test_" + std::to_string(::getpid()));
    Own() { std::filesystem::create_directories(path); }
    Own(const Own&) = delete;
    Own& operator=(const Own&) = delete;
    ~Own() {
      if (::getpid() != owner) return;
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
    const pid_t owner = ::getpid();
  };
  static const Own own;
  return own.path;
}

/// The path of a file or folder of that name in it, whether it is there or not.
inline std::string ScratchFile(const std::string& name) { return (ScratchFolder() / name).string(); }

}  // namespace gaitwright
