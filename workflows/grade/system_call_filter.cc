// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/system_call_filter.h"

#include <asm/sockios.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>

namespace gaitwright {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kProcessor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kProcessor = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kProcessor = 0;
#endif

/// Numbers that this many processors share, of calls that are newer than the headers may be.
constexpr std::uint32_t kMountSetattr = 442, kFirstUnknown = 446;
/// Calls of the x32 table of x86-64, which has numbers of its own.
constexpr std::uint32_t kX32 = 0x40000000;

constexpr int kSetOwnEx = 15;  // F_SETOWN_EX, which is not in every header

/// Refused whatever their arguments are.
constexpr std::uint32_t kRefused[] = {
    // Processes and threads.
    __NR_clone,
    __NR_unshare,
    __NR_setns,
    __NR_ptrace,
    __NR_process_vm_readv,
    __NR_process_vm_writev,
    __NR_kcmp,
    __NR_pidfd_open,
    __NR_pidfd_getfd,
    __NR_pidfd_send_signal,
    __NR_tkill,
    __NR_rt_sigqueueinfo,
    __NR_rt_tgsigqueueinfo,
    __NR_setpriority,
    __NR_sched_setscheduler,
    __NR_sched_setparam,
    __NR_sched_setattr,
    __NR_sched_setaffinity,
    __NR_ioprio_set,
    __NR_process_madvise,
    __NR_setpgid,
    __NR_setsid,
    __NR_migrate_pages,
    __NR_move_pages,
    // Sockets.
    __NR_socket,
    __NR_socketpair,
    __NR_bind,
    __NR_connect,
    __NR_listen,
    __NR_accept,
    __NR_accept4,
    __NR_sendmsg,
    __NR_sendmmsg,
    __NR_recvmsg,
    __NR_recvmmsg,
    // What a file is beside its bytes, and room on the disk that its size does not tell.
    __NR_fallocate,
    __NR_fchmod,
    __NR_fchmodat,
    __NR_fchown,
    __NR_fchownat,
    __NR_utimensat,
    __NR_setxattr,
    __NR_lsetxattr,
    __NR_fsetxattr,
    __NR_removexattr,
    __NR_lremovexattr,
    __NR_fremovexattr,
    __NR_truncate,
    __NR_mknodat,
    __NR_flock,
    __NR_name_to_handle_at,
    __NR_open_by_handle_at,
    __NR_fanotify_init,
    __NR_fanotify_mark,
    // Memory that is not counted as the process's own, or stays.
    __NR_memfd_create,
    __NR_shmget,
    __NR_shmat,
    __NR_shmctl,
    __NR_msgget,
    __NR_msgctl,
    __NR_msgsnd,
    __NR_msgrcv,
    __NR_semget,
    __NR_semctl,
    __NR_semop,
    __NR_semtimedop,
    __NR_mq_open,
    __NR_mq_unlink,
    __NR_add_key,
    __NR_request_key,
    __NR_keyctl,
    __NR_userfaultfd,
    __NR_io_setup,
    // The system's.
    __NR_mount,
    __NR_umount2,
    __NR_pivot_root,
    __NR_chroot,
    __NR_open_tree,
    __NR_move_mount,
    __NR_fsopen,
    __NR_fsconfig,
    __NR_fsmount,
    __NR_fspick,
    kMountSetattr,
    __NR_swapon,
    __NR_swapoff,
    __NR_reboot,
    __NR_sethostname,
    __NR_setdomainname,
    __NR_init_module,
    __NR_finit_module,
    __NR_delete_module,
    __NR_kexec_load,
    __NR_bpf,
    __NR_perf_event_open,
    __NR_acct,
    __NR_quotactl,
    __NR_settimeofday,
    __NR_clock_settime,
    __NR_adjtimex,
    __NR_clock_adjtime,
    __NR_syslog,
    __NR_personality,
    __NR_vhangup,
    __NR_setuid,
    __NR_setgid,
    __NR_setreuid,
    __NR_setregid,
    __NR_setresuid,
    __NR_setresgid,
    __NR_setgroups,
    __NR_setfsuid,
    __NR_setfsgid,
    __NR_capset,
#if defined(__x86_64__)
    __NR_fork,
    __NR_vfork,
    __NR_chmod,
    __NR_chown,
    __NR_lchown,
    __NR_utime,
    __NR_utimes,
    __NR_futimesat,
    __NR_mknod,
    __NR_iopl,
    __NR_ioperm,
    __NR_modify_ldt,
    __NR_uselib,
    __NR_kexec_file_load,
#endif
};

/// As if there were no such calls: libraries then take older ones, whose arguments can be looked at.
constexpr std::uint32_t kUnknown[] = {__NR_clone3, __NR_openat2, __NR_io_uring_setup, __NR_io_uring_enter,
                                      __NR_io_uring_register};

constexpr sock_filter Statement(unsigned code, std::uint32_t value) {
  return {static_cast<std::uint16_t>(code), 0, 0, value};
}
constexpr sock_filter Jump(unsigned code, std::uint32_t value, unsigned yes, unsigned no) {
  return {static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(yes), static_cast<std::uint8_t>(no), value};
}
constexpr sock_filter Load(std::size_t at) {
  return Statement(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(at));
}
constexpr sock_filter Give(std::uint32_t verdict) { return Statement(BPF_RET | BPF_K, verdict); }
constexpr std::uint32_t Fail(int error) { return SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error); }

/// The lower half of an argument; both processors have it first.
constexpr std::size_t Argument(std::size_t number) {
  return offsetof(seccomp_data, args) + number * sizeof(std::uint64_t);
}

/// A filter as it is put together; nothing of it is on the heap.
struct Program {
  std::array<sock_filter, 512> lines{};
  std::uint16_t size = 0;

  void Add(const sock_filter& line) { lines[size++] = line; }
  void Add(std::initializer_list<sock_filter> more) {
    for (const sock_filter& line : more) Add(line);
  }

  /// With the number of the call loaded: a call ends with this verdict.
  void Refuse(std::uint32_t call, std::uint32_t verdict) {
    Add({Jump(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1), Give(verdict)});
  }

  /// A call that is let pass only where its argument is `value`.
  void OnlyWith(std::uint32_t call, std::size_t argument, std::uint32_t value) {
    Add({Jump(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4), Load(Argument(argument)),
         Jump(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1), Give(SECCOMP_RET_ALLOW), Give(Fail(EPERM))});
  }

  /// A call that is refused where its argument is `value`.
  void NotWith(std::uint32_t call, std::size_t argument, std::uint32_t value) {
    Add({Jump(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4), Load(Argument(argument)),
         Jump(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1), Give(Fail(EPERM)), Load(offsetof(seccomp_data, nr))});
  }

  /// A file that is only read, or opened for neither reading nor writing (both bits of the mode), is not to be cut;
  /// older kernels' Landlock does not look at that.
  void NoCutOfReadFiles(std::uint32_t call, std::size_t flags) {
    Add({Jump(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 6), Load(Argument(flags)),
         Statement(BPF_ALU | BPF_AND | BPF_K, O_ACCMODE | O_TRUNC), Jump(BPF_JMP | BPF_JEQ | BPF_K, O_TRUNC, 1, 0),
         Jump(BPF_JMP | BPF_JEQ | BPF_K, O_ACCMODE | O_TRUNC, 0, 1), Give(Fail(EPERM)), Give(SECCOMP_RET_ALLOW)});
  }
};

void Fill(Program& program) {
  const auto self = static_cast<std::uint32_t>(getpid());
  program.Add({Load(offsetof(seccomp_data, arch)), Jump(BPF_JMP | BPF_JEQ | BPF_K, kProcessor, 1, 0),
               Give(SECCOMP_RET_KILL_PROCESS), Load(offsetof(seccomp_data, nr))});
#if defined(__x86_64__)
  program.Add({Jump(BPF_JMP | BPF_JGE | BPF_K, kX32, 0, 1), Give(Fail(ENOSYS))});
  program.NoCutOfReadFiles(__NR_open, 1);
#endif
  program.Add({Jump(BPF_JMP | BPF_JGE | BPF_K, kFirstUnknown, 0, 1), Give(Fail(ENOSYS))});
  for (const std::uint32_t call : kRefused) program.Refuse(call, Fail(EPERM));
  for (const std::uint32_t call : kUnknown) program.Refuse(call, Fail(ENOSYS));
  program.OnlyWith(__NR_kill, 0, self);
  program.OnlyWith(__NR_tgkill, 0, self);
  program.OnlyWith(__NR_prlimit64, 0, 0);
  // Signals that the kernel would send for it, and the one that ends it with the program.
  for (const int command : {F_SETOWN, kSetOwnEx, F_SETSIG, F_SETLEASE, F_NOTIFY})
    program.NotWith(__NR_fcntl, 1, static_cast<std::uint32_t>(command));
  for (const int command : {FIOSETOWN, SIOCSPGRP}) program.NotWith(__NR_ioctl, 1, static_cast<std::uint32_t>(command));
  program.NotWith(__NR_prctl, 0, PR_SET_PDEATHSIG);
  program.NoCutOfReadFiles(__NR_openat, 2);
  program.Add(Give(SECCOMP_RET_ALLOW));
}

}  // namespace

std::string WhyNoCallFilter() {
  if (kProcessor == 0) return "there is no filter of system calls for this processor";
  const std::uint32_t kill = SECCOMP_RET_KILL_PROCESS;
  if (syscall(__NR_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &kill) != 0)
    return "the kernel does not filter system calls (seccomp)";
  return "";
}

int FilterSystemCalls() {
  Program program;
  Fill(program);
  const sock_fprog whole{program.size, program.lines.data()};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &whole) == 0 ? 0 : errno;
}

}  // namespace gaitwright
