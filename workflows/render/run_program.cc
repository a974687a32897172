// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/render/run_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

extern char** environ;

namespace gaitwright {
namespace {

constexpr std::size_t kMostWords = 600;

Failure Failed(const std::string& what) {
  return {FailureKind::kBadInput, FailureCode::kProgramFailed, "RunProgram", what, {}};
}

std::string ReadAll(int from) {
  std::string text;
  std::array<char, 4096> piece{};
  while (true) {
    const ssize_t n = read(from, piece.data(), piece.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(n));
  }
}

}  // namespace

std::string FindProgram(const std::vector<std::string>& names) {
  const char* path = std::getenv("PATH");
  for (const std::string& name : names) {
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
      std::string program = (std::filesystem::path(folder) / name).string();
      if (access(program.c_str(), X_OK) == 0) return program;
    }
  }
  return "";
}

Result<std::string> RunProgram(const std::string& program, const std::vector<std::string>& arguments) {
  std::array<int, 2> words{};
  if (pipe2(words.data(), O_CLOEXEC) != 0) return Failed(fmt::format("'{}' cannot be connected by a pipe", program));
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, words[1], STDERR_FILENO);
  pid_t process = -1;
  const int error = posix_spawn(&process, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(words[1]);
  const std::string said = error == 0 ? ReadAll(words[0]) : "";
  close(words[0]);
  if (error != 0) return Failed(fmt::format("'{}' cannot be started: {}", program, std::strerror(error)));
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return said;
  const std::string end = said.size() > kMostWords ? said.substr(said.size() - kMostWords) : said;
  return Failed(fmt::format("'{}' failed: {}", program, end.empty() ? "it printed nothing" : end));
}

}  // namespace gaitwright
