// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Thrown when what is done so far cannot be kept, as on a disk that is full.
class CannotKeep : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Results of numbered jobs in a file, a line each, on the disk as soon as it is there, so that work that was cut off,
/// by SIGKILL too, can go on where it was. The first line says whose results they are. One process holds it at a time.
/// A journal without a result is as none: it is begun anew by whoever opens it, and nothing of it is left behind.
class JobJournal {
 public:
  /// One that keeps nothing.
  JobJournal() = default;
  /// The file stays where it holds a result.
  ~JobJournal();
  JobJournal(JobJournal&& other) noexcept;
  JobJournal& operator=(JobJournal&&) = delete;

  /// Begins a journal, or with `resume` goes on with the one that is there, if any. A last line that was cut short is
  /// dropped. A journal may be of any size, as only where its lines are is kept in memory.
  /// @param identity  a text that is the same for the same work alone, without an end of line
  /// Failure kBadInput when it cannot be read or written, holds results and there is no `resume`, is no journal or one
  /// of other work, is broken before its last line, has a line of over 16 MiB, or is held by another process.
  static Result<JobJournal> Open(const std::string& path, const std::string& identity, bool resume);

  /// The result of a job that was there when it was opened. @throws std::runtime_error when it cannot be read.
  std::optional<std::string> Find(std::size_t job) const;
  /// How many were there, of the jobs from a number on.
  std::size_t found(std::size_t from = 0) const;
  /// Adds the result of a job, one line, and waits until it is on the disk. To be called from any thread.
  /// @throws CannotKeep when it cannot be written: then the file is left as it was before, and no more is added.
  void Add(std::size_t job, const std::string& line);
  /// Deletes the file: the work is finished, and its outcome is safe.
  void Remove();

 private:
  /// Where the result of a job is in the file.
  struct Place {
    std::int64_t at = 0;
    std::size_t length = 0;
  };
  class Reader;

  std::optional<Failure> Hold();
  std::optional<Failure> Read(const std::string& head, bool resume);
  std::optional<Failure> Begin(const std::string& head);

  std::string path_;
  int file_ = -1;
  std::mutex mutex_;
  std::map<std::size_t, Place> lines_;
  std::int64_t length_ = 0;  ///< of what is good
  bool empty_ = false;       ///< it is begun, and holds no result yet
  bool spoilt_ = false;      ///< a line could not be written
};

}  // namespace gaitwright
