// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/sandbox/landlock_rules.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace gaitwright {
namespace {

/// Rights of versions 3 and 5, which old headers do not define.
constexpr std::uint64_t kTruncate = 1ULL << 14, kIoctlDevice = 1ULL << 15;
constexpr std::uint64_t kReadFile = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_EXECUTE;
constexpr std::uint64_t kRead = kReadFile | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kWrite = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR |
                                 LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_MAKE_REG |
                                 LANDLOCK_ACCESS_FS_REMOVE_FILE | kTruncate;

int Version() {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  return static_cast<int>(version);
}

/// All rights that the kernel can restrict.
std::uint64_t Handled(int version) {
  std::uint64_t rights = (1ULL << 13) - 1;
  if (version >= 2) rights |= LANDLOCK_ACCESS_FS_REFER;
  if (version >= 3) rights |= kTruncate;
  if (version >= 5) rights |= kIoctlDevice;
  return rights;
}

/// Grants rights below a path. @return 0 or the error; a missing path is not an error.
int Grant(int rules, const std::string& path, std::uint64_t rights) {
  const int at = open(path.c_str(), O_PATH | O_CLOEXEC);
  if (at < 0) return errno == ENOENT || errno == ENOTDIR || errno == EACCES ? 0 : errno;
  struct stat what {};
  int error = fstat(at, &what) == 0 ? 0 : errno;
  if (!S_ISDIR(what.st_mode)) rights &= kReadFile | LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;
  const landlock_path_beneath_attr below{rights, at};
  if (error == 0 && syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &below, 0) != 0) error = errno;
  close(at);
  return error;
}

Failure NoRules(const std::string& why) {
  return {
      FailureKind::kBadInput, FailureCode::kLandlock, "LandlockRules", "a submission cannot be confined: " + why, {}};
}

}  // namespace

std::string ReasonNoLandlock() {
  return Version() >= 1 ? "" : "the kernel cannot restrict file access (Landlock needs Linux 5.13 or newer)";
}

Result<LandlockRules> LandlockRules::Make(const FileRights& rights) {
  if (const std::string why = ReasonNoLandlock(); !why.empty()) return NoRules(why);
  const std::uint64_t handled = Handled(Version());
  const landlock_ruleset_attr attributes{handled};
  const long handle = syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0);
  if (handle < 0) return NoRules(std::strerror(errno));
  LandlockRules rules(static_cast<int>(handle));
  for (const std::string& path : rights.readable) {
    if (const int error = Grant(rules.handle_, path, kRead & handled))
      return NoRules(fmt::format("'{}': {}", path, std::strerror(error)));
  }
  if (const int error = Grant(rules.handle_, "/dev/null", kReadFile | LANDLOCK_ACCESS_FS_WRITE_FILE))
    return NoRules(std::strerror(error));
  if (rights.writable.empty()) return rules;
  if (const int error = Grant(rules.handle_, rights.writable, kWrite & handled))
    return NoRules(fmt::format("'{}': {}", rights.writable, std::strerror(error)));
  return rules;
}

LandlockRules::~LandlockRules() {
  if (handle_ >= 0) close(handle_);
}

int LandlockRules::RestrictSelf() const { return syscall(SYS_landlock_restrict_self, handle_, 0) == 0 ? 0 : errno; }

}  // namespace gaitwright
