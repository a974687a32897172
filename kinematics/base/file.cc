// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>
#include <utf8cpp/utf8.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include "kinematics/base/writable.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

Failure FileFailure(FailureCode code, const std::string& message) {
  return {FailureKind::kBadInput, code, "File", message, {}};
}

Failure Unwritable(const std::string& path, const std::string& why) {
  return FileFailure(FailureCode::kUnwritableFile, fmt::format("cannot write '{}': {}", path, why));
}

Failure Unwritable(const std::string& path, const std::error_code& error) { return Unwritable(path, error.message()); }

/// Waits until a file, or a folder with its names, is on the disk, so that it survives a power failure. Some file
/// systems do not support this (EINVAL), and it is not possible for a folder without read permission.
std::error_code Sync(const fs::path& path) {
  const int handle = ::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return {errno == EACCES ? 0 : errno, std::generic_category()};
  const int error = ::fsync(handle) != 0 && errno != EINVAL ? errno : 0;
  ::close(handle);
  return {error, std::generic_category()};
}

/// Delays signals to end the program, such as Ctrl-C, until files are complete, in the thread that writes them.
class EndingsHeldBack {
 public:
  EndingsHeldBack() {
    sigset_t endings;
    sigemptyset(&endings);
    for (const int ending : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) sigaddset(&endings, ending);
    pthread_sigmask(SIG_BLOCK, &endings, &former_);
  }
  EndingsHeldBack(const EndingsHeldBack&) = delete;
  EndingsHeldBack& operator=(const EndingsHeldBack&) = delete;
  ~EndingsHeldBack() { pthread_sigmask(SIG_SETMASK, &former_, nullptr); }

 private:
  sigset_t former_{};
};

/// A group of files that are written together. All changes are undone unless all files succeed.
class Transaction {
 public:
  Transaction() = default;
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction() {
    if (!done_) Undo();
  }

  /// Creates the folder and writes the text beside the target.
  std::optional<Failure> Prepare(const std::string& path, std::string_view text) {
    if (const std::string why = ReasonNotWritable(path); !why.empty()) return Unwritable(path, why);
    std::error_code error;
    const fs::path target(path);
    if (!MakeFolder(target.parent_path(), error)) {
      return FileFailure(FailureCode::kUnwritableFile,
                         fmt::format("cannot create the folder '{}' for '{}': {}", target.parent_path().string(), path,
                                     error.message()));
    }
    steps_.push_back({target, path + fmt::format(".{}.part", ::getpid()), {}, false});
    errno = 0;
    std::ofstream stream(steps_.back().temporary, std::ios::binary | std::ios::trunc);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) return Unwritable(path, {errno != 0 ? errno : EIO, std::generic_category()});
    if (const std::error_code unsafe = Sync(steps_.back().temporary)) return Unwritable(path, unsafe);
    return std::nullopt;
  }

  /// Renames all files to their targets; the old files are kept until all are renamed.
  std::optional<Failure> Commit() {
    std::error_code error;
    for (Step& step : steps_) {
      if (steps_.size() > 1 && !KeepFormer(step, error)) return Unwritable(step.target.string(), error);
      fs::rename(step.temporary, step.target, error);
      if (error) return Unwritable(step.target.string(), error);
      step.placed = true;
    }
    for (const fs::path& folder : FoldersWithNewNames()) {
      if (const std::error_code unsafe = Sync(folder)) return Unwritable(folder.string(), unsafe);
    }
    done_ = true;
    for (const Step& step : steps_) {
      if (!step.former.empty()) fs::remove(step.former, error);
    }
    return std::nullopt;
  }

 private:
  struct Step {
    fs::path target, temporary, former;
    bool placed = false;
  };

  bool MakeFolder(const fs::path& folder, std::error_code& error) {
    std::vector<fs::path> missing;
    for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) missing.push_back(at);
    error.clear();
    std::reverse(missing.begin(), missing.end());
    for (const fs::path& at : missing) {
      if (fs::create_directory(at, error)) folders_.push_back(at);
      if (error) return false;
    }
    return true;
  }

  std::set<fs::path> FoldersWithNewNames() const {
    std::set<fs::path> changed;
    for (const Step& step : steps_) changed.insert(step.target.parent_path());
    for (const fs::path& made : folders_) changed.insert(made.parent_path());
    return changed;
  }

  /// Keeps the old file under a second name (a hard link, or a copy if the file system has no hard links), so that
  /// there is always a complete file at the target.
  static bool KeepFormer(Step& step, std::error_code& error) {
    if (!fs::exists(step.target, error)) {
      error.clear();
      return true;
    }
    const fs::path former = step.target.string() + fmt::format(".{}.former", ::getpid());
    fs::remove(former, error);
    fs::create_hard_link(step.target, former, error);
    if (error) fs::copy_file(step.target, former, error);
    if (!error) step.former = former;
    return !error;
  }

  void Undo() {
    std::error_code ignored;
    for (const Step& step : steps_) {
      fs::remove(step.temporary, ignored);
      if (step.placed && step.former.empty()) fs::remove(step.target, ignored);
      if (step.placed && !step.former.empty()) fs::rename(step.former, step.target, ignored);
      if (!step.placed && !step.former.empty()) fs::remove(step.former, ignored);
    }
    std::for_each(folders_.rbegin(), folders_.rend(), [&](const fs::path& folder) { fs::remove(folder, ignored); });
  }

  std::vector<Step> steps_;
  std::vector<fs::path> folders_;  ///< created folders, outer ones first
  bool done_ = false;
};

}  // namespace

Result<std::string> ReadBytes(const std::string& path, std::size_t most) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return FileFailure(FailureCode::kNoSuchFile, fmt::format("no such file: '{}'", path));
  if (fs::is_directory(status))
    return FileFailure(FailureCode::kNotAFile, fmt::format("'{}' is a folder, not a file", path));
  if (!fs::is_regular_file(status) && !fs::is_fifo(status)) {
    return FileFailure(FailureCode::kNotAFile, fmt::format("'{}' is a device or a socket, not a file", path));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return FileFailure(FailureCode::kUnreadableFile, fmt::format("cannot read '{}'", path));
  std::string bytes;
  constexpr std::size_t kPiece = std::size_t{1} << 16;
  for (std::size_t size = 0; stream && size <= most; size = bytes.size()) {
    bytes.resize(size + kPiece);
    stream.read(&bytes[size], static_cast<std::streamsize>(kPiece));
    bytes.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (bytes.size() > most) {
    return FileFailure(FailureCode::kLargeFile,
                       fmt::format("'{0}' has more than {1} bytes; at most {1} are read", path, most));
  }
  if (stream.bad()) return FileFailure(FailureCode::kUnreadableFile, fmt::format("cannot read '{}'", path));
  return bytes;
}

Result<std::string> ReadFile(const std::string& path, std::size_t most) {
  Result<std::string> bytes = ReadBytes(path, most);
  if (!bytes) return bytes;
  std::string& text = *bytes;
  text.erase(text.find_last_not_of('\0') + 1);
  if (const std::size_t nothing = text.find('\0'); nothing != std::string::npos) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(nothing);
    return FileFailure(FailureCode::kNotText, fmt::format("'{}', line {} is not text: it contains a byte 0x00", path,
                                                          1 + std::count(text.begin(), end, '\n')));
  }
  if (const auto bad = utf8::find_invalid(text.begin(), text.end()); bad != text.end()) {
    return FileFailure(FailureCode::kNotText,
                       fmt::format("'{}', line {} is not UTF-8 text: it contains an invalid byte 0x{:02x}", path,
                                   1 + std::count(text.begin(), bad, '\n'), static_cast<unsigned char>(*bad)));
  }
  if (utf8::starts_with_bom(text.begin(), text.end())) text.erase(0, 3);
  return bytes;
}

Result<std::string> WriteFileAtomically(const std::string& path, const std::string& text) {
  const EndingsHeldBack held_back;
  Transaction transaction;
  if (auto failure = transaction.Prepare(path, text)) return *failure;
  if (auto failure = transaction.Commit()) return *failure;
  return path;
}

Result<std::vector<std::string>> WriteFilesTogether(const std::vector<OutputFile>& files) {
  const EndingsHeldBack held_back;
  Transaction transaction;
  std::vector<std::string> paths;
  for (const OutputFile& file : files) {
    for (const std::string& other : paths) {
      if (IsSameFile(other, file.path)) {
        return FileFailure(FailureCode::kFileNamedTwice,
                           fmt::format("'{}' is given for two outputs; give each output its own file", other));
      }
    }
    if (auto failure = transaction.Prepare(file.path, file.text)) return *failure;
    paths.push_back(file.path);
  }
  if (auto failure = transaction.Commit()) return *failure;
  return paths;
}

}  // namespace gaitwright
