// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/stranger.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/built_paths.h"
#include "tests/scratch_folder.h"

namespace gaitwright::cli {
namespace {

namespace fs = std::filesystem;

/// Adds a word to a shell command, quoted.
void Append(std::string& command, const std::string& word) {
  command.push_back('\'');
  for (const char c : word) {
    if (c == '\'') command.append("'\\'");
    command.push_back(c);
  }
  command.append("' ");
}

std::string ReadAll(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

}  // namespace

std::string ProgramPath() { return BuildFolder() + "/gaitwright"; }

Stranger::Stranger() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path own = ScratchFolder() / test->name();
  folder_ = own / "here";
  talk_ = own / "talk";
  fs::create_directories(folder_);
  fs::create_directories(talk_);
}

Stranger::~Stranger() {
  std::error_code ignored;
  fs::remove_all(folder_.parent_path(), ignored);
}

Ran Stranger::Run(const std::vector<std::string>& arguments) const {
  std::string command = "cd ";
  Append(command, folder_.string());
  command.append("&& ");
  Append(command, ProgramPath());
  for (const std::string& argument : arguments) Append(command, argument);
  command.append("</dev/null >");
  Append(command, (talk_ / "out").string());
  command.append("2>");
  Append(command, (talk_ / "err").string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, ReadAll(talk_ / "out"), ReadAll(talk_ / "err")};
}

Ran Stranger::RunUntil(const std::vector<std::string>& arguments, int signal, const std::function<bool()>& now) const {
  std::vector<std::string> words = {ProgramPath()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return RunWords(words, signal, now);
}

Ran Stranger::RunWords(std::vector<std::string> words, int signal, const std::function<bool()>& now) const {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::string out = (talk_ / "out").string(), err = (talk_ / "err").string();
  const pid_t child = ::fork();
  if (child == 0) {
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(::open(out.c_str(), flags, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), flags, 0600), STDERR_FILENO);
    if (::chdir(folder_.c_str()) == 0) ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  int status = 0;
  pid_t ended = 0;
  for (bool sent = signal == 0; ended == 0; ended = ::waitpid(child, &status, WNOHANG)) {
    if (!sent && now()) sent = ::kill(child, signal) == 0;
    ::usleep(2000);
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), ReadAll(out), ReadAll(err)};
}

std::vector<std::string> Stranger::Found() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string Stranger::Read(const std::string& name) const { return ReadAll(In(name)); }

void Stranger::Write(const std::string& name, const std::string& text) const {
  fs::create_directories(In(name).parent_path());
  std::ofstream(In(name), std::ios::binary) << text;
}

Json Stranger::MakePlan(const std::string& name) const {
  const Ran ran = Run({"plan", "--robot", "a1", "--distance", "0.3", "--out", name, "--quiet"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  return Json::parse(Read(name));
}

void ExpectRefused(const Ran& ran, int status, const std::vector<std::string>& parts) {
  EXPECT_EQ(ran.status, status) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(ran.err.starts_with("gaitwright: ")) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << "one line is wanted:\n" << ran.err;
  for (const std::string& part : parts) {
    EXPECT_NE(ran.err.find(part), std::string::npos) << "'" << part << "' is not said by: " << ran.err;
  }
}

}  // namespace gaitwright::cli
