// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Results of numbered jobs in a file, a line each, on the disk as soon as it is there, so that work that was cut off,
/// by SIGKILL too, can go on where it was. The first line says whose results they are. One process holds it at a time.
class JobJournal {
 public:
  /// One that keeps nothing.
  JobJournal() = default;
  ~JobJournal();
  JobJournal(JobJournal&& other) noexcept;
  JobJournal& operator=(JobJournal&&) = delete;

  /// Begins a journal, or with `resume` goes on with the one that is there, if any. A last line that was cut short is
  /// dropped.
  /// @param identity  a text that is the same for the same work alone, without an end of line
  /// Failure kBadInput when it cannot be read or written, is there without `resume`, is no journal or one of other
  /// work, is broken before its last line, or is held by another process.
  static Result<JobJournal> Open(const std::string& path, const std::string& identity, bool resume);

  /// The result of a job that was there when it was opened.
  std::optional<std::string> Find(std::size_t job) const;
  /// How many were there.
  std::size_t found() const { return lines_.size(); }
  /// Adds the result of a job, one line, and waits until it is on the disk. To be called from any thread.
  /// @throws std::runtime_error when it cannot be written.
  void Add(std::size_t job, const std::string& line);
  /// Deletes the file: the work is finished.
  void Remove();

 private:
  bool Keep(const std::string& line);

  std::string path_;
  int file_ = -1;
  std::mutex mutex_;
  std::map<std::size_t, std::string> lines_;
};

}  // namespace gaitwright
