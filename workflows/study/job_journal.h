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

/// Thrown if results cannot be saved, for example on a full disk.
class CannotKeep : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Results of numbered jobs in a file, one per line, flushed to disk at once, so that interrupted work (even by
/// SIGKILL) can continue. The first line identifies the work. Only one process at a time can hold it. A journal without
/// results counts as absent: it is started again when opened, and deleted when closed.
class JobJournal {
 public:
  /// Largest number of bytes of a result.
  static constexpr std::size_t kLongestResult = (std::size_t{16} << 20) - 32;

  /// A journal that stores nothing.
  JobJournal() = default;
  /// The file is kept if it contains a result.
  ~JobJournal();
  JobJournal(JobJournal&& other) noexcept;
  JobJournal& operator=(JobJournal&&) = delete;

  /// Begins a journal, or continues an existing one with `resume`. A truncated last line is dropped. A journal may have
  /// any size, because only the positions of its lines are kept in memory.
  /// @param identity  a one-line text that is equal only for equal work.
  /// Failure kBadInput if the journal cannot be read or written, contains results without `resume`, is not a journal or
  /// one of other work, is damaged before its last line, has a line of over 16 MiB, or is held by another process.
  static Result<JobJournal> Open(const std::string& path, const std::string& identity, bool resume);

  /// The result of a job that was present on opening. @throws std::runtime_error if it cannot be read.
  std::optional<std::string> Find(std::size_t job) const;
  /// Number of results present on opening, of the jobs from a number on.
  std::size_t found(std::size_t from = 0) const;
  /// Adds the result of a job, one line, and waits until it is on disk. Thread-safe.
  /// @throws CannotKeep if it cannot be written: the file is then left as before, and nothing more is added.
  void Add(std::size_t job, const std::string& line);
  /// Deletes the file, once the work is finished and its outcome is saved.
  void Remove();

 private:
  /// Position of a job's result in the file.
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
  std::int64_t length_ = 0;  ///< length of the valid part
  bool empty_ = false;       ///< begun, but without a result
  bool spoilt_ = false;      ///< a line could not be written
};

}  // namespace gaitwright
