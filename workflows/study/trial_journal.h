// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "playback/trials/trial_outcome.h"

namespace gaitwright {

/// The file in which a run keeps what it has, so that nothing is lost when it is interrupted: a first line that says
/// what run it is, then one line of JSON for each outcome, each on the disk before the next trial is reported. One
/// process holds it at a time.
class TrialJournal {
 public:
  TrialJournal() = default;
  ~TrialJournal();
  TrialJournal(TrialJournal&& other) noexcept : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}
  TrialJournal& operator=(TrialJournal&& other) noexcept;

  /// Begins a journal, or with `resume` goes on with the one that is there, if any: then `found` gets its outcomes. A
  /// last line that was cut short is dropped.
  /// @param hash  of the run, see HashOf.
  /// @return a failure when it cannot be written, is there without `resume`, is of another run, held by another
  /// process, or broken before its last line.
  static Result<TrialJournal> Open(const std::string& path, const std::string& hash, bool resume,
                                   std::vector<TrialOutcome>& found);

  /// Adds an outcome and waits until it is on the disk. @throws std::runtime_error when it cannot be.
  void Append(const TrialOutcome& outcome);

  /// Deletes the file: the run is finished.
  void Remove();

 private:
  std::string path_;
  int file_ = -1;
};

}  // namespace gaitwright
