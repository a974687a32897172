// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/job_journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "kinematics/base/file.h"

namespace gaitwright {
namespace {

constexpr char kHead[] = "gaitwright journal of ";

Failure Refused(const std::string& path, const std::string& why, const std::vector<std::string>& hints = {}) {
  return {FailureKind::kBadInput, "so_far", "JobJournal", fmt::format("'{}' {}", path, why), hints};
}

void WriteAll(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0)
      throw std::runtime_error(fmt::format("cannot keep what is done so far: {}", std::strerror(errno)));
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(file) != 0 && errno != EINVAL)
    throw std::runtime_error(fmt::format("cannot keep what is done so far: {}", std::strerror(errno)));
}

/// Lines with their end; what follows the last end was cut off.
std::vector<std::string> WholeLines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    lines.push_back(text.substr(at, end - at));
  return lines;
}

}  // namespace

JobJournal::JobJournal(JobJournal&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), lines_(std::move(other.lines_)) {}

JobJournal::~JobJournal() {
  if (file_ >= 0) ::close(file_);
}

Result<JobJournal> JobJournal::Open(const std::string& path, const std::string& identity, bool resume) {
  namespace fs = std::filesystem;
  const std::string anew = fmt::format("delete '{}' to begin anew", path), head = kHead + identity;
  std::error_code error;
  if (fs::path(path).has_parent_path()) fs::create_directories(fs::path(path).parent_path(), error);
  const bool there = fs::exists(path, error) && fs::file_size(path, error) > 0;
  if (there && !resume) return Refused(path, "holds work that was not finished", {"--resume to go on with it", anew});
  JobJournal journal;
  journal.path_ = path;
  journal.file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (journal.file_ < 0) return Refused(path, fmt::format("cannot be written: {}", std::strerror(errno)));
  if (::flock(journal.file_, LOCK_EX | LOCK_NB) != 0)
    return Refused(path, "is being written by another process", {"let that finish, or name another output"});
  const Result<std::string> text = there ? ReadFile(path) : Result<std::string>(std::string());
  if (!text) return text.failure();
  const std::vector<std::string> lines = WholeLines(*text);
  if (!lines.empty() && !lines.front().starts_with(kHead))
    return Refused(path, "is no journal of this program", {anew});
  if (!lines.empty() && lines.front() != head) {
    return Refused(path, "is of other work: another robot, command, option, seed or version of the program",
                   {"repeat the command line of that work", anew});
  }
  std::size_t length = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0 && !journal.Keep(lines[i])) return Refused(path, fmt::format("is broken in line {}", i + 1), {anew});
    length += lines[i].size() + 1;
  }
  if (::ftruncate(journal.file_, static_cast<off_t>(length)) != 0 || ::lseek(journal.file_, 0, SEEK_END) < 0)
    return Refused(path, fmt::format("cannot be written: {}", std::strerror(errno)));
  if (length == 0) WriteAll(journal.file_, head + "\n");
  return journal;
}

bool JobJournal::Keep(const std::string& line) {
  std::size_t job = 0;
  const char* end = line.data() + line.size();
  const auto [after, problem] = std::from_chars(line.data(), end, job);
  if (problem != std::errc{} || after == end || *after != ' ') return false;
  lines_[job] = std::string(after + 1, end);
  return true;
}

std::optional<std::string> JobJournal::Find(std::size_t job) const {
  const auto line = lines_.find(job);
  return line == lines_.end() ? std::nullopt : std::optional<std::string>(line->second);
}

void JobJournal::Add(std::size_t job, const std::string& line) {
  if (file_ < 0) return;
  const std::lock_guard lock(mutex_);
  WriteAll(file_, fmt::format("{} {}\n", job, line));
}

void JobJournal::Remove() {
  if (file_ < 0) return;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
  ::close(std::exchange(file_, -1));
}

}  // namespace gaitwright
