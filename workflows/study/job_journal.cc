// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/job_journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace gaitwright {
namespace {

constexpr std::string_view kHead = "gaitwright journal of ";
constexpr std::size_t kLongestLine = std::size_t{16} << 20;

Failure Refused(const std::string& path, const std::string& why, const std::vector<Suggestion>& suggestions = {}) {
  return {FailureKind::kBadInput, FailureCode::kSoFar, "JobJournal", fmt::format("'{}' {}", path, why), suggestions};
}

std::string Anew(const std::string& path) { return fmt::format("delete '{}' to start again", path); }

/// Writes a whole text. @return 0, or the error number.
int WriteAll(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : EIO;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) != 0 && errno != EINVAL ? errno : 0;
}

/// Syncs a folder, so that a new file in it survives a power cut, if the file system supports it.
void SyncFolder(const std::filesystem::path& folder) {
  const int handle = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) return;
  ::fsync(handle);
  ::close(handle);
}

/// Whether an open file is still the one at the path, since its previous owner may have deleted it.
bool IsAt(int file, const std::string& path) {
  struct stat open = {}, there = {};
  return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &there) == 0 && open.st_ino == there.st_ino &&
         open.st_dev == there.st_dev;
}

/// The number at the start of a line; nothing unless the line begins with a number and a space.
std::optional<std::size_t> JobOf(std::string_view line) {
  std::size_t job = 0;
  const char* end = line.data() + line.size();
  const auto [after, problem] = std::from_chars(line.data(), end, job);
  if (problem != std::errc{} || after == end || *after != ' ') return std::nullopt;
  return job;
}

}  // namespace

/// Reads a file line by line, with only one line in memory.
class JobJournal::Reader {
 public:
  explicit Reader(const std::string& path)
      : stream_(path, std::ios::binary), room_(std::make_unique_for_overwrite<char[]>(kRoom)) {}

  /// The next complete line, without its end; nothing at the end of the file, and at a line that is truncated or too
  /// long.
  std::optional<std::string_view> Next() {
    at_ += length_;
    length_ = 0;
    stream_.getline(room_.get(), static_cast<std::streamsize>(kRoom));
    const auto size = static_cast<std::size_t>(stream_.gcount());
    too_long_ = stream_.fail() && !stream_.eof();
    rest_ = std::string_view(room_.get(), size);
    if (stream_.fail() || stream_.eof()) return std::nullopt;
    length_ = static_cast<std::int64_t>(size);
    return rest_.substr(0, size - 1);
  }

  bool too_long() const { return too_long_; }
  /// The text after the last complete line.
  std::string_view rest() const { return rest_; }
  /// Position of the present line; after the last one, the end of the complete lines.
  std::int64_t at() const { return at_; }

 private:
  static constexpr std::size_t kRoom = kLongestLine + 1;

  std::ifstream stream_;
  std::unique_ptr<char[]> room_;
  std::string_view rest_;
  std::int64_t at_ = 0, length_ = 0;
  bool too_long_ = false;
};

JobJournal::JobJournal(JobJournal&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      lines_(std::move(other.lines_)),
      length_(other.length_),
      empty_(std::exchange(other.empty_, false)),
      spoilt_(other.spoilt_) {}

JobJournal::~JobJournal() {
  if (empty_) Remove();
  if (file_ >= 0) ::close(file_);
}

Result<JobJournal> JobJournal::Open(const std::string& path, const std::string& identity, bool resume) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  JobJournal journal;
  journal.path_ = path;
  const std::string head = std::string(kHead) + identity;
  if (auto failure = journal.Hold()) return *failure;
  if (auto failure = journal.Read(head, resume)) return *failure;
  if (journal.lines_.empty()) {
    if (auto failure = journal.Begin(head)) return *failure;
  }
  return journal;
}

std::optional<Failure> JobJournal::Hold() {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) return Refused(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0 && IsAt(file_, path_)) return std::nullopt;
  return Refused(path_, "is being written by another process", {"wait until it ends, or give another output"});
}

std::optional<Failure> JobJournal::Read(const std::string& head, bool resume) {
  Reader reader(path_);
  const std::optional<std::string_view> first = reader.Next();
  const std::string_view begin = first ? *first : reader.rest();
  if (!begin.starts_with(kHead) && (first || !kHead.starts_with(begin)))
    return Refused(path_, "is not a journal of this program", {Anew(path_)});
  const bool same = begin == head;
  for (std::size_t number = 2; const std::optional<std::string_view> line = reader.Next(); ++number) {
    if (!resume) return Refused(path_, "contains an unfinished run", {"use --resume to continue it", Anew(path_)});
    if (!same) {
      return Refused(path_,
                     "belongs to another run: another robot, command, option, file, seed or version of the program",
                     {"use the command line of that run", Anew(path_)});
    }
    const std::optional<std::size_t> job = JobOf(*line);
    if (!job) return Refused(path_, fmt::format("is damaged in line {}", number), {Anew(path_)});
    const std::size_t before = line->find(' ') + 1;
    lines_[*job] = {reader.at() + static_cast<std::int64_t>(before), line->size() - before};
  }
  if (reader.too_long())
    return Refused(path_, fmt::format("has a line of more than {} bytes", kLongestLine), {Anew(path_)});
  length_ = reader.at();
  if (::ftruncate(file_, length_) == 0 && ::lseek(file_, 0, SEEK_END) >= 0) return std::nullopt;
  return Refused(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
}

std::optional<Failure> JobJournal::Begin(const std::string& head) {
  int error = ::ftruncate(file_, 0) == 0 && ::lseek(file_, 0, SEEK_SET) == 0 ? 0 : errno;
  if (error == 0) error = WriteAll(file_, head + "\n");
  if (error != 0) return Refused(path_, fmt::format("cannot be written: {}", std::strerror(error)));
  SyncFolder(std::filesystem::path(path_).parent_path());
  length_ = static_cast<std::int64_t>(head.size()) + 1;
  empty_ = true;
  return std::nullopt;
}

std::size_t JobJournal::found(std::size_t from) const {
  return static_cast<std::size_t>(std::distance(lines_.lower_bound(from), lines_.end()));
}

std::optional<std::string> JobJournal::Find(std::size_t job) const {
  const auto found = lines_.find(job);
  if (found == lines_.end()) return std::nullopt;
  const auto& [at, length] = found->second;
  std::string line(length, '\0');
  for (std::size_t read = 0; read < length;) {
    const ssize_t more = ::pread(file_, &line[read], length - read, at + static_cast<std::int64_t>(read));
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) throw std::runtime_error(fmt::format("cannot read '{}' any more", path_));
    read += static_cast<std::size_t>(more);
  }
  return line;
}

void JobJournal::Add(std::size_t job, const std::string& line) {
  if (file_ < 0) return;
  const std::lock_guard lock(mutex_);
  if (spoilt_) throw CannotKeep(fmt::format("'{}' could not be written, so no further results are kept in it", path_));
  const std::string text = fmt::format("{} {}\n", job, line);
  if (const int error = WriteAll(file_, text); error != 0) {
    spoilt_ = true;
    std::string why = std::strerror(error);
    // The rest of the line has no line end, so that a reader drops it.
    if (::ftruncate(file_, length_) != 0) why += ", and its last line is truncated";
    throw CannotKeep(fmt::format("cannot keep intermediate results in '{}': {}", path_, why));
  }
  length_ += static_cast<std::int64_t>(text.size());
  empty_ = false;
}

void JobJournal::Remove() {
  if (file_ < 0) return;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
  ::close(std::exchange(file_, -1));
  empty_ = false;
}

}  // namespace gaitwright
