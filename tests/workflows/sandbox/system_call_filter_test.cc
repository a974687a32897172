// SPDX-License-Identifier: BSD-3-Clause
// Each attempt runs in a separate process with the filter.
#include "workflows/sandbox/system_call_filter.h"

#include <asm/ioctls.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <functional>
#include <string>

namespace gaitwright {
namespace {

constexpr int kNoFilter = 255;

/// The wait status of a process whose exit status is the error number of `attempt` (0: no error), or kNoFilter.
int StatusOf(const std::function<long()>& attempt) {
  std::array<int, 2> pipe{};
  EXPECT_EQ(pipe2(pipe.data(), O_CLOEXEC), 0);
  const pid_t process = fork();
  if (process == 0) {
    close(pipe[1]);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || ApplyCallFilter(pipe[0]) != 0) _exit(kNoFilter);
    _exit(attempt() < 0 ? errno : 0);
  }
  EXPECT_EQ(WriteCallFilter(process, pipe[1]), 0);
  close(pipe[0]);
  close(pipe[1]);
  int status = -1;
  EXPECT_EQ(waitpid(process, &status, 0), process);
  return status;
}

int ErrorOf(const std::function<long()>& attempt) {
  const int status = StatusOf(attempt);
  EXPECT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  return WEXITSTATUS(status);
}

class SystemCallFilter : public testing::Test {
 protected:
  void SetUp() override {
    if (!ReasonNoCallFilter().empty()) GTEST_SKIP() << ReasonNoCallFilter();
  }
};

TEST_F(SystemCallFilter, LetsAProgramHaveFilesMemoryAndItself) {
  EXPECT_EQ(ErrorOf([] { return open("/dev/null", O_RDONLY | O_CLOEXEC); }), 0);
  EXPECT_EQ(ErrorOf([] { return open("/dev/null", O_WRONLY | O_CREAT | O_TRUNC, 0600); }), 0);
  EXPECT_EQ(ErrorOf([] { return access("/", R_OK); }), 0);
  EXPECT_EQ(ErrorOf([] { return fcntl(0, F_GETFL) < 0 && errno != EBADF ? -1 : 0; }), 0);
  EXPECT_EQ(ErrorOf([] {
              void* const memory = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
              return memory == MAP_FAILED ? -1 : munmap(memory, 4096);
            }),
            0);
  EXPECT_EQ(ErrorOf([] { return kill(getpid(), 0); }), 0);
  EXPECT_EQ(ErrorOf([] {
              rlimit limit{};
              return getrlimit(RLIMIT_AS, &limit);
            }),
            0);
  EXPECT_EQ(ErrorOf([] { return execl("/no/such/program", "program", nullptr); }), ENOENT);
}

struct Call {
  const char* name;
  long number;
};

TEST_F(SystemCallFilter, RefusesWhateverIsNotOnItsList) {
  constexpr Call kCalls[] = {{"clone", SYS_clone},
                             {"socket", SYS_socket},
                             {"ptrace", SYS_ptrace},
                             {"process_vm_readv", SYS_process_vm_readv},
                             {"bpf", SYS_bpf},
                             {"keyctl", SYS_keyctl},
                             {"userfaultfd", SYS_userfaultfd},
                             {"io_uring_setup", SYS_io_uring_setup},
                             {"memfd_create", SYS_memfd_create},
                             {"mount", SYS_mount},
                             {"prctl", SYS_prctl},
                             // Lists of forbidden calls often miss these.
                             {"seccomp", SYS_seccomp},
                             {"splice", SYS_splice},
                             {"vmsplice", SYS_vmsplice},
                             {"inotify_init1", SYS_inotify_init1},
                             {"timer_create", SYS_timer_create},
                             {"mbind", SYS_mbind},
                             {"membarrier", SYS_membarrier},
                             {"remap_file_pages", SYS_remap_file_pages},
                             {"execveat", SYS_execveat},
                             {"mlockall", SYS_mlockall},
                             {"sync", SYS_sync},
                             {"a call of a newer kernel", 900}};
  for (const Call& call : kCalls) {
    EXPECT_EQ(ErrorOf([&] { return syscall(call.number, 0, 0, 0, 0, 0, 0); }), EPERM) << call.name;
  }
}

TEST_F(SystemCallFilter, HidesCallsWhoseArgumentsItCannotSee) {
  EXPECT_EQ(ErrorOf([] { return syscall(SYS_clone3, nullptr, 0); }), ENOSYS);
  EXPECT_EQ(ErrorOf([] { return syscall(SYS_openat2, AT_FDCWD, "/", nullptr, 0); }), ENOSYS);
}

TEST_F(SystemCallFilter, LooksAtArguments) {
  EXPECT_EQ(ErrorOf([] { return kill(getppid(), 0); }), EPERM);
  EXPECT_EQ(ErrorOf([] { return kill(-1, 0); }), EPERM);
  EXPECT_EQ(ErrorOf([] { return syscall(SYS_tgkill, getppid(), getppid(), 0); }), EPERM);
  EXPECT_EQ(ErrorOf([] { return prlimit(getppid(), RLIMIT_AS, nullptr, nullptr); }), EPERM);
  for (const int command : {F_SETOWN, F_SETSIG, F_SETLEASE, F_NOTIFY})
    EXPECT_EQ(ErrorOf([&] { return fcntl(0, command, 0); }), EPERM) << command;
  for (const int command : {TIOCSTI, FIOASYNC, TIOCSCTTY})
    EXPECT_EQ(ErrorOf([&] { return syscall(SYS_ioctl, 0, command, 0); }), EPERM) << command;
}

/// Emptying a file is a write, however the file is opened.
TEST_F(SystemCallFilter, EmptiesOnlyFilesThatAreOpenedForWriting) {
  for (const int flags : {O_TRUNC, O_TRUNC | O_RDONLY | O_CREAT, O_TRUNC | O_ACCMODE}) {
    EXPECT_EQ(ErrorOf([&] { return syscall(SYS_openat, AT_FDCWD, "/dev/null", flags, 0600); }), EPERM) << flags;
#ifdef SYS_open
    EXPECT_EQ(ErrorOf([&] { return syscall(SYS_open, "/dev/null", flags, 0600); }), EPERM) << flags;
#endif
  }
  EXPECT_EQ(ErrorOf([] { return syscall(SYS_openat, AT_FDCWD, "/dev/null", O_RDWR | O_TRUNC, 0600); }), 0);
}

#ifdef __x86_64__
TEST_F(SystemCallFilter, EndsAProcessThatCallsByAnotherTable) {
  constexpr long kX32 = 0x40000000;
  const int status = StatusOf([] { return syscall(kX32 | SYS_getpid); });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGSYS);
}
#endif

TEST_F(SystemCallFilter, AFilterThatIsNotThereIsAnError) {
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  EXPECT_EQ(ApplyCallFilter(nothing), ENODATA);
  close(nothing);
  EXPECT_EQ(ApplyCallFilter(-1), EBADF);
}

}  // namespace
}  // namespace gaitwright
