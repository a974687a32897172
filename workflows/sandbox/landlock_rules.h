// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Parts of the file system that a process may use.
struct FileRights {
  std::vector<std::string> readable;  ///< files and folders with everything below; missing ones are ignored
  std::string writable;  ///< a folder in which files (not folders or links) may be created, written and removed; or ""
};

/// Why this machine cannot confine a process to some files (Landlock, Linux 5.13 or newer); "" if it can.
std::string ReasonNoLandlock();

/// Irrevocable restrictions of a process by the kernel's Landlock: files that are not granted cannot be opened, listed,
/// run, written, created, removed, renamed or linked. The existence and size of a file can still be queried by its full
/// path.
class LandlockRules {
 public:
  /// Failure `landlock`: the kernel has no Landlock, or the writable folder does not exist.
  static Result<LandlockRules> Make(const FileRights& rights);

  LandlockRules(LandlockRules&& other) noexcept : handle_(other.handle_) { other.handle_ = -1; }
  LandlockRules& operator=(LandlockRules&&) = delete;
  LandlockRules(const LandlockRules&) = delete;
  LandlockRules& operator=(const LandlockRules&) = delete;
  ~LandlockRules();

  /// Takes effect on the calling process, which needs PR_SET_NO_NEW_PRIVS. Safe after fork. @return 0 or the error.
  int RestrictSelf() const;

 private:
  explicit LandlockRules(int handle) : handle_(handle) {}

  int handle_;
};

}  // namespace gaitwright
