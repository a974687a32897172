// SPDX-License-Identifier: BSD-3-Clause
// Hostile submissions: each gets no points and leaves nothing behind.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <thread>

#include "tests/workflows/grade/made_class.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// A part with this time limit: short if the test waits for the limit, otherwise longer than a busy machine needs.
std::string PartOfLimit(double time_s) {
  return fmt::format(
      "{{name: zmp, kind: function, file: work.py, points: 10, reference: pendulum_zmp, cases: 3, "
      "limits: {{time_s: {}, memory_mb: 512, file_mb: 2}}}}\n",
      time_s);
}
const std::string kPart = PartOfLimit(30.0);
constexpr double kSoon = 1.0;  // [s]
const std::string kRightCode = "    return c[:2] - a[:2] * h / 9.81\n";

class Hostile : public MadeClass {
 protected:
  void SetUp() override {
    if (!CanRunCode()) GTEST_SKIP() << ReasonNotConfined();
    while (waitpid(-1, nullptr, WNOHANG) > 0) continue;  // what tests before this one left
    others_ = ChildProcesses();
    HandIn("eve", "secret.txt", "the solution");
    fs::create_directories(In("tmp"));
    fs::permissions(In("tmp"), fs::perms(0711));
    setenv("TMPDIR", In("tmp").c_str(), 1);  // folder in which submissions run
  }
  void TearDown() override {
    EXPECT_EQ(LeftProcesses(), std::set<std::string>()) << "a process is left";
    EXPECT_EQ(ProcessesWith("HOME=" + In("tmp").string()), 0);
    EXPECT_FALSE(fs::exists(In("evil")));
    EXPECT_TRUE(!fs::exists(In("tmp")) || fs::is_empty(In("tmp")));
    unsetenv("TMPDIR");
  }
  /// Marks a function whose body begins with this text and then returns the right answer.
  PartMark MarkBody(const std::string& body, double time_s = 30.0) const {
    return MarkCode(PartOfLimit(time_s), "import ctypes, os, socket, sys, time\ndef pendulum_zmp(c, a, h):\n    " +
                                             body + "\n" + kRightCode);
  }
  /// The result of an attempt, as reported by the submission.
  std::string Attempt(const std::string& expression) const {
    const PartMark mark = MarkBody("raise RuntimeError('it got ' + str(" + expression + "))");
    EXPECT_EQ(mark.points, 0.0);
    return mark.reasons.size() > 2 ? mark.reasons[2] : mark.reasons.back();
  }
  void ExpectDenied(const std::string& expression, const std::string& how = "ermission") const {
    const std::string words = Attempt(expression);
    EXPECT_EQ(words.find("it got"), std::string::npos) << expression << ": " << words;
    EXPECT_NE(words.find(how), std::string::npos) << expression << ": " << words;
  }

 private:
  /// Child processes that this test has started and that do not end within some seconds.
  std::set<std::string> LeftProcesses() const {
    std::set<std::string> left;
    for (int look = 0; look < 100; ++look) {
      left = ChildProcesses();
      std::erase_if(left, [&](const std::string& child) { return others_.contains(child); });
      if (left.empty()) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return left;
  }

  std::set<std::string> others_;  // child processes that other tests have left
};

TEST_F(Hostile, TheSameCodeWithoutMaliceIsRight) { EXPECT_EQ(MarkBody("pass").points, 10.0); }

TEST_F(Hostile, Crashes) {
  ExpectNothing(MarkBody("ctypes.string_at(0)"), {"the submission was stopped: the code crashed: signal SIGSEGV"});
  ExpectNothing(MarkBody("os._exit(0)"), {"the code ended early, with exit status 0"});
  ExpectNothing(MarkBody("os.abort()"), {"the code crashed: signal"});
  ExpectNothing(MarkBody("sys.exit(3)"), {"the code ended early, with exit status 3"});
}

TEST_F(Hostile, LoopsForEver) {
  ExpectNothing(MarkBody("exec('while True: pass')", kSoon), {"more than 1 s of CPU time"});
}

TEST_F(Hostile, Sleeps) {
  ExpectNothing(MarkBody("time.sleep(1e6)", kSoon), {"the code slept for more than 11 s in total"});
}

TEST_F(Hostile, TakesAllMemory) { ExpectNothing(MarkBody("bytearray(10 ** 10)"), {"MemoryError"}); }

TEST_F(Hostile, WritesElsewhere) {
  const std::string evil = In("evil").string();
  for (const std::string& path :
       {evil, std::string("../evil"), std::string("/dev/shm/evil"), std::string("/etc/passwd")})
    ExpectDenied(fmt::format("open('{}', 'w')", path));
  const std::string other = In("eve").string();
  ExpectDenied(fmt::format("os.remove('{}/secret.txt')", other));
  ExpectDenied(fmt::format("os.rename('{}/secret.txt', 'x')", other));
  ExpectDenied(fmt::format("os.truncate('{}/secret.txt', 0)", other));
  ExpectDenied(fmt::format("os.open('{}/secret.txt', os.O_RDONLY | os.O_TRUNC)", other));
  ExpectDenied(fmt::format("os.open('{}/secret.txt', 3 | os.O_TRUNC)", other));
  ExpectDenied("os.open('own', 3 | os.O_TRUNC | os.O_CREAT, 0o600)");
  ExpectDenied("os.posix_fallocate(os.open('own', os.O_WRONLY | os.O_CREAT, 0o600), 0, 1 << 20)");
  ExpectDenied(fmt::format("os.chmod('{}/secret.txt', 0o777)", other));
  ExpectDenied(fmt::format("os.utime('{}/secret.txt', (0, 0))", other));
  ExpectDenied("open(__file__, 'a')");
  ExpectDenied("os.mkdir('folder')");
  ExpectDenied("os.symlink('/etc/passwd', 'link')");
  ExpectDenied("os.mkfifo('pipe')");
  std::ifstream stream(In("eve") / "secret.txt");
  std::string kept;
  std::getline(stream, kept);
  EXPECT_EQ(kept, "the solution");
}

TEST_F(Hostile, ReadsAnothersSubmission) {
  const std::string other = In("eve").string();
  ExpectDenied(fmt::format("open('{}/secret.txt').read()", other));
  ExpectDenied(fmt::format("os.listdir('{}')", other));
  ExpectDenied("open('/etc/passwd').read()");
  ExpectDenied("open('/proc/self/environ').read()");
  ExpectDenied("os.listdir('/tmp')");
  EXPECT_NE(Attempt("sorted(k for k in os.environ if 'PATH' in k)").find("it got []"), std::string::npos);
}

TEST_F(Hostile, StartsProcesses) {
  ExpectDenied("os.fork()");
  ExpectDenied("os.posix_spawn('/usr/bin/true', ['true'], {})");
  ExpectDenied("__import__('subprocess').run(['/usr/bin/true'])");
  ExpectDenied("__import__('threading').Thread(target=print).start()", "can't start new thread");
  ExpectNothing(MarkBody("exec('while True:\\n  try: os.fork()\\n  except OSError: pass')", kSoon), {"CPU time"});
  ExpectDenied("os.execv('/usr/bin/true', ['true'])");
}

TEST_F(Hostile, ReachesForOthers) {
  ExpectDenied("os.kill(os.getppid(), 9)");
  ExpectDenied("os.kill(-1, 9)");
  ExpectDenied("socket.socket()");
  ExpectDenied("os.setpriority(os.PRIO_PROCESS, os.getppid(), 19)");
  ExpectDenied("os.sched_setaffinity(os.getppid(), {0})");
  ExpectDenied("__import__('resource').prlimit(os.getppid(), 0, (1, 1))");
  ExpectDenied("os.memfd_create('x')");
  ExpectDenied("__import__('fcntl').fcntl(3, 8, os.getppid())");
  EXPECT_NE(Attempt("ctypes.CDLL(None).ptrace(16, os.getppid(), 0, 0)").find("it got -1"), std::string::npos);
  EXPECT_NE(Attempt("ctypes.CDLL(None).prctl(1, 0)").find("it got -1"), std::string::npos);
  EXPECT_NE(Attempt("ctypes.CDLL(None).shmget(0, 4096, 0o1600)").find("it got -1"), std::string::npos);
}

/// System calls that Python does not need are refused; for the whole list see system_call_filter_test.cc.
TEST_F(Hostile, MakesCallsThatAreNotOnTheList) {
  for (const long call : {SYS_io_uring_setup, SYS_userfaultfd, SYS_bpf, SYS_keyctl, SYS_process_vm_readv, SYS_splice,
                          SYS_inotify_init1, SYS_timer_create, SYS_execveat})
    EXPECT_NE(Attempt(fmt::format("(lambda c: (c.syscall({}, 0, 0, 0, 0), ctypes.get_errno()))"
                                  "(ctypes.CDLL(None, use_errno=True))",
                                  call))
                  .find(fmt::format("it got (-1, {})", EPERM)),
              std::string::npos)
        << call;
}

TEST_F(Hostile, IsNobodyWhereTheProgramIsRoot) {
  if (geteuid() != 0) GTEST_SKIP() << "not root";
  EXPECT_NE(Attempt("(os.getresuid(), os.getresgid(), os.getgroups())")
                .find("((65534, 65534, 65534), (65534, 65534, 65534), [])"),
            std::string::npos);
}

TEST_F(Hostile, HasNoOpenFilesOfTheProgram) {
  std::ofstream kept(In("eve") / "open.txt");
  const int handle = open((In("eve") / "secret.txt").c_str(), O_RDONLY);  // without O_CLOEXEC
  EXPECT_NE(Attempt("[h for h in range(5, 64) if ctypes.CDLL(None).fcntl(h, 1) >= 0]").find("it got []"),
            std::string::npos);
  close(handle);
}

TEST_F(Hostile, ForgesItsReport) {
  ExpectNothing(MarkBody("os.write(4, b'{\"points\": 10, \"verdict\": \"pass\"}\\n')"), {"its answer cannot be read"});
  ExpectNothing(MarkBody("os.write(4, b'{\"answer\": 10}\\n')"), {"the answer is a number; 2 numbers are needed"});
  ExpectNothing(MarkBody("os.write(4, b'{\"error\": {}}\\n{\"error\": 1}\\n')"), {"its answer cannot be read"});
  ExpectNothing(MarkBody("os.write(4, b'[' * 900000 + b'\\n')"), {"its answer cannot be read"});
  ExpectNothing(MarkBody("os.write(4, b'{\"answer\": ' + b'[' * 900000 + b'\\n')"), {"case 0"});
  ExpectNothing(MarkBody("os.write(4, b'{\"error\": ' + b'[' * 900000 + b'\\n')"), {"its answer cannot be read"});
  ExpectNothing(MarkBody("os.close(4)"), {"the submission was stopped"});
}

TEST_F(Hostile, AnswersTooMuch) {
  ExpectNothing(MarkBody("return [0.0] * 300000"), {"more than 1048576 bytes"});
  ExpectNothing(MarkBody("exec(\"while True: os.write(4, b'x' * 65536)\")"), {"more than 1048576 bytes"});
}

TEST_F(Hostile, PrintsWithoutEnd) {
  const PartMark mark = MarkBody("[os.write(1, b'x' * 1000000) for i in range(1000)]");
  EXPECT_EQ(mark.points, 10.0) << mark.reasons.front();  // the attempt had no effect, and the answers are right
}

TEST_F(Hostile, FillsTheDisk) {
  ExpectDenied("open('large', 'wb').write(b'x' * 3000000)", "too large");
  ExpectNothing(MarkBody("[open(str(i), 'wb').write(b'x' * 1000000) for i in range(60)]; time.sleep(60)"),
                {"the code wrote more than 2 MB"});
}

TEST_F(Hostile, HandsInWhatIsNoFile) {
  const auto expect = [&](const std::string& student, const char* what) {
    ExpectNothing(Mark(kPart, student), {what});
  };
  fs::create_directories(In("link"));
  fs::create_symlink("/etc/passwd", In("link") / "work.py");
  expect("link", "'work.py' is a link; a file is needed");
  fs::create_directories(In("folder") / "work.py");
  expect("folder", "'work.py' is a folder; a file is needed");
  fs::create_directories(In("pipe"));
  ASSERT_EQ(mkfifo((In("pipe") / "work.py").c_str(), 0600), 0);
  expect("pipe", "'work.py' is a pipe; a file is needed");
  HandIn("large", "work.py", "#");
  fs::resize_file(In("large") / "work.py", 1ULL << 30);
  expect("large", "'work.py' has 1073741824 bytes; at most 2097152 are accepted");
  HandIn("empty", "work.py", "\n \n");
  expect("empty", "'work.py' is empty");
  HandIn("bytes", "work.py", std::string("\x00\xfe\xff", 3));
  expect("bytes", "the submission says");
}

/// Links in the folder of a student's code are not followed.
TEST_F(Hostile, OtherModulesThatAreLinksAreLeftOut) {
  HandIn("ada", "work.py", "");
  fs::create_symlink(In("eve") / "secret.txt", In("ada") / "stolen.py");
  ExpectNothing(MarkCode(kPart, "import stolen\n"), {"No module named 'stolen'"});
}

}  // namespace
}  // namespace gaitwright
