// SPDX-License-Identifier: BSD-3-Clause
#include "tests/kinematics/base/synced_files.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <filesystem>
#include <mutex>
#include <string>
#include <system_error>
#include <utility>

namespace {
std::mutex mutex;
std::vector<std::string> synced;
}  // namespace

// Replaces the function of the C library.
extern "C" int fsync(int file) {
  std::error_code ignored;
  const auto path = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file), ignored);
  const std::lock_guard lock(mutex);
  synced.push_back(path.string());
  return static_cast<int>(::syscall(SYS_fsync, file));
}

namespace gaitwright {

std::vector<std::string> TakeSyncedFiles() {
  const std::lock_guard lock(mutex);
  return std::exchange(synced, {});
}

}  // namespace gaitwright
