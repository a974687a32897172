// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/submission.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "kinematics/base/text.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostStudents = 10000, kMostOthers = 100;

Failure NoClass(const std::string& message,
                const std::string& hint = "the folder must have one folder for each student") {
  return {FailureKind::kBadInput, FailureCode::kSubmissions, "FindStudents", message, {hint}};
}

Failure NotHandedIn(const std::string& message) {
  return {FailureKind::kBadInput, FailureCode::kSubmission, "ReadSubmission", message, {}};
}

/// A name in which bytes that are not printable ASCII are written as \xHH.
std::string Visible(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x20 || byte > 0x7e ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return text;
}

/// Closes an open file at its end.
class Handle {
 public:
  explicit Handle(int number) : number_(number) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

const char* WhatItIs(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISLNK(mode) ? "a link" : "a device or a socket";
}

/// Removes the byte-order mark with which spreadsheets begin their files.
std::string WithoutMark(std::string bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kMark)) bytes.erase(0, kMark.size());
  return bytes;
}

/// Failure if an open file is not accepted.
std::optional<Failure> ReasonRefused(int handle, const std::string& file, std::size_t most_bytes) {
  struct stat what {};
  if (fstat(handle, &what) != 0) return NotHandedIn(fmt::format("'{}' cannot be read", file));
  if (!S_ISREG(what.st_mode))
    return NotHandedIn(fmt::format("'{}' is {}; a file is needed", file, WhatItIs(what.st_mode)));
  if (static_cast<std::size_t>(what.st_size) > most_bytes)
    return NotHandedIn(fmt::format("'{}' has {} bytes; at most {} are accepted", file, what.st_size, most_bytes));
  return std::nullopt;
}

}  // namespace

Result<std::vector<Student>> FindStudents(const std::string& folder) {
  std::vector<Student> students;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    std::error_code unknown;
    if (name.starts_with(".") || !fs::is_directory(at->symlink_status(unknown))) continue;
    if (!IsPlainText(name) || name.find('\n') != std::string::npos || name.find('\t') != std::string::npos)
      return NoClass(fmt::format("the folder '{}' in '{}' has a name that is not plain text", Visible(name), folder),
                     "rename it");
    students.push_back({name, at->path().string()});
    if (students.size() > kMostStudents)
      return NoClass(fmt::format("'{}' has more than {} folders", folder, kMostStudents));
  }
  if (error) return NoClass(fmt::format("cannot read the folder '{}': {}", folder, error.message()));
  if (students.empty()) return NoClass(fmt::format("'{}' contains no folder of a student", folder));
  std::sort(students.begin(), students.end(), [](const Student& a, const Student& b) { return a.name < b.name; });
  return students;
}

Result<std::string> ReadSubmission(const Student& student, const std::string& file, std::size_t most_bytes) {
  const Handle folder(open(student.folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (folder.number() < 0) return NotHandedIn(fmt::format("'{}' was not handed in", file));
  const Handle handle(openat(folder.number(), file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (handle.number() < 0) {
    if (errno == ELOOP) return NotHandedIn(fmt::format("'{}' is a link; a file is needed", file));
    if (errno == ENOENT) return NotHandedIn(fmt::format("'{}' was not handed in", file));
    return NotHandedIn(fmt::format("'{}' is not a readable file", file));
  }
  if (auto failure = ReasonRefused(handle.number(), file, most_bytes)) return *failure;
  std::string bytes;
  std::array<char, 65536> piece{};
  while (true) {
    const ssize_t n = read(handle.number(), piece.data(), piece.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return NotHandedIn(fmt::format("'{}' cannot be read", file));
    if (n == 0) return WithoutMark(std::move(bytes));
    bytes.append(piece.data(), static_cast<std::size_t>(n));
    if (bytes.size() > most_bytes)  // the file grew while it was read
      return NotHandedIn(fmt::format("'{}' has more than {} bytes; at most that many are accepted", file, most_bytes));
  }
}

std::vector<OutputFile> OtherPythonFiles(const Student& student, const std::string& file, std::size_t most_bytes) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(student.folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name != file && name.ends_with(".py")) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  if (names.size() > kMostOthers) names.resize(kMostOthers);
  std::vector<OutputFile> files;
  for (const std::string& name : names) {
    Result<std::string> text = ReadSubmission(student, name, most_bytes);
    if (text) files.push_back({name, std::move(*text)});
  }
  return files;
}

}  // namespace gaitwright
