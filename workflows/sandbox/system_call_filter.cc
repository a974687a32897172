// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/sandbox/system_call_filter.h"

#include <asm/ioctls.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>

namespace gaitwright {
namespace {

/// Calls that are allowed with any arguments. Calls that an architecture does not have are skipped: AArch64 has no
/// `open`.
constexpr const char* kAllowedCalls[] = {
    // The program's start and end. Landlock decides what may be executed.
    "execve", "arch_prctl", "set_tid_address", "set_robust_list", "rseq", "exit", "exit_group",
    // Memory.
    "brk", "mmap", "munmap", "mremap", "mprotect", "madvise", "msync",
    // Open files.
    "read", "write", "readv", "writev", "pread64", "pwrite64", "preadv", "pwritev", "preadv2", "pwritev2", "lseek",
    "close", "close_range", "dup", "dup2", "dup3", "fstat", "fstatfs", "ftruncate", "fsync", "fdatasync", "fadvise64",
    "sendfile", "copy_file_range", "getdents", "getdents64",
    // Paths. Landlock decides which paths may be opened, removed and renamed.
    "stat", "lstat", "newfstatat", "statx", "statfs", "access", "faccessat", "faccessat2", "readlink", "readlinkat",
    "getcwd", "chdir", "fchdir", "unlink", "unlinkat", "rename", "renameat", "renameat2", "umask",
    // Waiting. Locks use futex, also in a process with one thread.
    "futex", "poll", "ppoll", "select", "pselect6", "epoll_create", "epoll_create1", "epoll_ctl", "epoll_wait",
    "epoll_pwait", "pipe", "pipe2", "eventfd2", "sched_yield", "nanosleep", "clock_nanosleep", "restart_syscall",
    // Clocks and random numbers.
    "clock_gettime", "clock_getres", "gettimeofday", "time", "times", "getrandom",
    // The process's own signals and timers.
    "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigpending", "rt_sigsuspend", "rt_sigtimedwait",
    "sigaltstack", "alarm", "setitimer", "getitimer", "pause",
    // Data of the process and the machine.
    "getpid", "getppid", "gettid", "getuid", "geteuid", "getgid", "getegid", "getresuid", "getresgid", "getgroups",
    "getpgid", "getpgrp", "getsid", "uname", "sysinfo", "getrusage", "getrlimit", "setrlimit", "sched_getaffinity",
    "getcpu"};

/// Calls that the process sees as missing, so that the C library uses clone and openat.
constexpr const char* kMissingCalls[] = {"clone3", "openat2"};

/// Allowed commands of fcntl: without locks, leases, owners and signals.
constexpr int kFileCommands[] = {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL, F_SETFL};
/// Allowed commands of ioctl: whether a file is a terminal, closing on exec, non-blocking mode, number of readable
/// bytes.
constexpr unsigned kDeviceCommands[] = {TCGETS, TIOCGWINSZ, FIOCLEX, FIONCLEX, FIONBIO, FIONREAD};
/// Allowed modes of openat: keep the contents of a file, or empty a file that is opened for writing. Landlock in older
/// kernels does not check that O_TRUNC empties a file that is opened for reading or with both bits of the mode.
constexpr int kOpenModes[][2] = {
    {O_TRUNC, 0}, {O_TRUNC | O_ACCMODE, O_TRUNC | O_WRONLY}, {O_TRUNC | O_ACCMODE, O_TRUNC | O_RDWR}};

/// Compares the lower half of an argument (a whole `int`) with bits under a mask.
scmp_arg_cmp HasBits(unsigned argument, std::uint32_t mask, std::uint32_t bits) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, bits};
}
scmp_arg_cmp IsValue(unsigned argument, std::uint32_t value) { return HasBits(argument, 0xffffffff, value); }

/// A filter that refuses all calls without a rule.
class CallRules {
 public:
  CallRules() : rules_(seccomp_init(SCMP_ACT_ERRNO(EPERM)), &seccomp_release) {
    Note(rules_ ? 0 : -ENOMEM);
    Note(seccomp_attr_set(rules_.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS));
  }

  /// Adds a rule; a call is allowed if any of its rules allows it.
  void Add(std::uint32_t action, const char* name, std::initializer_list<scmp_arg_cmp> arguments = {}) {
    const int call = seccomp_syscall_resolve_name(name);
    if (call < 0) return;
    Note(
        seccomp_rule_add_array(rules_.get(), action, call, static_cast<unsigned>(arguments.size()), arguments.begin()));
  }
  void Allow(const char* name, std::initializer_list<scmp_arg_cmp> arguments = {}) {
    Add(SCMP_ACT_ALLOW, name, arguments);
  }

  /// @return 0, or the number of the first error.
  int Write(int file) {
    if (error_ == 0) Note(seccomp_export_bpf(rules_.get(), file));
    return -error_;
  }

 private:
  void Note(int error) {
    if (error_ == 0) error_ = error;
  }

  std::unique_ptr<void, void (*)(scmp_filter_ctx)> rules_;
  int error_ = 0;  ///< negative, as returned by libseccomp
};

}  // namespace

std::string ReasonNoCallFilter() {
  constexpr unsigned kKillsProcesses = 3;  // level of seccomp_api_get(3): Linux 4.14
  return seccomp_api_get() >= kKillsProcesses ? "" : "the kernel does not filter system calls (seccomp)";
}

int WriteCallFilter(int process, int file) {
  CallRules rules;
  for (const char* call : kAllowedCalls) rules.Allow(call);
  for (const char* call : kMissingCalls) rules.Add(SCMP_ACT_ERRNO(ENOSYS), call);
  for (const auto& [mask, bits] : kOpenModes) {
    rules.Allow("open", {HasBits(1, static_cast<std::uint32_t>(mask), static_cast<std::uint32_t>(bits))});
    rules.Allow("openat", {HasBits(2, static_cast<std::uint32_t>(mask), static_cast<std::uint32_t>(bits))});
  }
  for (const int command : kFileCommands) rules.Allow("fcntl", {IsValue(1, static_cast<std::uint32_t>(command))});
  for (const unsigned command : kDeviceCommands) rules.Allow("ioctl", {IsValue(1, command)});
  for (const char* call : {"kill", "tgkill"}) rules.Allow(call, {IsValue(0, static_cast<std::uint32_t>(process))});
  rules.Allow("prlimit64", {IsValue(0, 0)});  // only for the process itself
  return rules.Write(file);
}

int ApplyCallFilter(int file) {
  std::array<sock_filter, BPF_MAXINSNS> program{};
  char* const bytes = reinterpret_cast<char*>(program.data());
  std::size_t size = 0;
  while (size < sizeof program) {
    const ssize_t n = read(file, bytes + size, sizeof program - size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    if (n == 0) break;
    size += static_cast<std::size_t>(n);
  }
  if (size == 0 || size % sizeof program.front() != 0) return ENODATA;
  const sock_fprog whole{static_cast<unsigned short>(size / sizeof program.front()), program.data()};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &whole) == 0 ? 0 : errno;
}

}  // namespace gaitwright
