// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "optimisation/pipeline/solve_windows_internal.h"
#include "workflows/study/job_journal.h"

namespace gaitwright {

/// A line of a journal that holds a solution exactly, and the reverse. @throws std::runtime_error for another line.
std::string LineOfSolve(const SolvedWindow& solved);
SolvedWindow SolveOfLine(const std::string& line);

/// Solutions of a motion's windows in a journal. Those of which the line would be too long for it are not kept.
class KeptSolves : public SolveRecord {
 public:
  /// The journal must outlive this.
  explicit KeptSolves(JobJournal& journal) : journal_(journal) {}

  std::optional<SolvedWindow> Find(std::size_t solve) override;
  /// @throws CannotKeep if it cannot be written.
  void Keep(std::size_t solve, const SolvedWindow& solved) override;

 private:
  JobJournal& journal_;
};

}  // namespace gaitwright
