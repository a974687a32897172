// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// What of the file system a process may use.
struct FileRights {
  std::vector<std::string> readable;  ///< files and folders with all below them; of those that are not there, nothing
  std::string writable;  ///< a folder in which files may be made, written and removed, but no folder or link; or ""
};

/// Why this machine cannot confine a process to some files (Landlock, Linux 5.13 or newer); "" where it can.
std::string WhyNoLandlock();

/// Rights that a process takes upon itself and cannot lay down again, by the kernel's Landlock: whatever is not granted
/// cannot be opened, listed, run, written, made, removed, renamed or linked. What files there are, by their whole path,
/// and how large, it can still ask.
class LandlockRules {
 public:
  /// Failure `landlock`: the kernel has no such thing, or the writable folder is not there.
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
