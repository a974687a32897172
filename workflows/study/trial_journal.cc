// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trial_journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "kinematics/base/file.h"

namespace gaitwright {
namespace {

constexpr char kFormat[] = "gaitwright-trials-so-far";

std::string HeadLine(const std::string& hash) {
  return nlohmann::ordered_json{{"format", kFormat}, {"schema", 1}, {"run", hash}}.dump() + "\n";
}

void WriteAll(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t n = ::write(file, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw std::runtime_error(fmt::format("cannot keep the outcomes so far: {}", std::strerror(errno)));
    done += static_cast<std::size_t>(n);
  }
  if (::fsync(file) != 0 && errno != EINVAL)
    throw std::runtime_error(fmt::format("cannot keep the outcomes so far: {}", std::strerror(errno)));
}

Failure Refused(const std::string& path, const std::string& why, std::vector<std::string> hints) {
  return {FailureKind::kBadInput, "trials_so_far", "RunTrials", fmt::format("'{}' {}", path, why), std::move(hints)};
}

/// What a journal holds up to `length`, the end of its last whole line.
struct Held {
  std::string run;
  std::vector<TrialOutcome> outcomes;
  std::size_t length = 0;
};

/// @throws InvalidArgument for a line, not the last, that is broken.
Held Parse(const std::string& text) {
  Held held;
  int line = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos) break;  // cut short
    ++line;
    const std::string one = text.substr(at, end - at);
    try {
      if (line == 1) {
        const auto head = nlohmann::json::parse(one);
        if (head.at("format") != kFormat || head.at("schema") != 1) throw InvalidArgument("another format");
        held.run = head.at("run").get<std::string>();
      } else {
        held.outcomes.push_back(OutcomeFromLine(one));
      }
    } catch (const std::exception&) {
      if (line > 1 && end + 1 == text.size()) break;  // cut short, too
      throw InvalidArgument(fmt::format("is broken in line {}", line));
    }
    at = held.length = end + 1;
  }
  return held;
}

}  // namespace

TrialJournal::~TrialJournal() {
  if (file_ >= 0) ::close(file_);
}

TrialJournal& TrialJournal::operator=(TrialJournal&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(file_, other.file_);
  return *this;
}

Result<TrialJournal> TrialJournal::Open(const std::string& path, const std::string& hash, bool resume,
                                        std::vector<TrialOutcome>& found) {
  namespace fs = std::filesystem;
  const std::string anew = fmt::format("delete '{}' to begin anew", path);
  std::error_code error;
  if (fs::path(path).has_parent_path()) fs::create_directories(fs::path(path).parent_path(), error);
  const bool there = fs::exists(path, error) && fs::file_size(path, error) > 0;
  if (there && !resume) return Refused(path, "holds a run that was not finished", {"--resume to go on with it", anew});
  TrialJournal journal;
  journal.path_ = path;
  journal.file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (journal.file_ < 0) return Refused(path, fmt::format("cannot be written: {}", std::strerror(errno)), {});
  if (::flock(journal.file_, LOCK_EX | LOCK_NB) != 0)
    return Refused(path, "is being written by another process", {"let that finish, or name another --out"});
  Held held;
  if (there) {
    const Result<std::string> text = ReadBytes(path);
    if (!text) return text.failure();
    try {
      held = Parse(*text);
    } catch (const InvalidArgument& broken) {
      return Refused(path, broken.what(), {anew});
    }
    if (!held.run.empty() && held.run != hash) {
      return Refused(path,
                     fmt::format("is of another run ({}; this one is {}): another plan, option, disturbance, seed or "
                                 "version of the program",
                                 held.run, hash),
                     {"repeat the command line of that run", anew});
    }
  }
  if (::ftruncate(journal.file_, static_cast<off_t>(held.length)) != 0 || ::lseek(journal.file_, 0, SEEK_END) < 0) {
    return Refused(path, fmt::format("cannot be written: {}", std::strerror(errno)), {});
  }
  if (held.length == 0) WriteAll(journal.file_, HeadLine(hash));
  found = std::move(held.outcomes);
  return journal;
}

void TrialJournal::Append(const TrialOutcome& outcome) {
  if (file_ >= 0) WriteAll(file_, OutcomeToLine(outcome) + "\n");
}

void TrialJournal::Remove() {
  if (file_ < 0) return;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
  ::close(std::exchange(file_, -1));
}

}  // namespace gaitwright
