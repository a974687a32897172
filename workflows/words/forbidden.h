// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/words/clause.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Actions that an instruction forbids, and a check that its tasks respect this.
class Forbidden {
 public:
  explicit Forbidden(const std::string& text) : text_(text) {}

  /// Adds "don't walk". It cancels an equal task, if there is one. Otherwise it must contrast with a requested task
  /// before or after it: "don't turn right, turn left". @return whether a task was cancelled. @throws Refused
  bool Add(const Clause& clause, std::vector<Draft>& drafts);

  /// Adds "not the right one". @return whether it denies the last request, so that the next words replace it.
  /// @throws Refused if it has more detail than the request that it corrects.
  bool AddNot(const Clause& clause, const std::vector<Draft>& drafts);

  /// @throws Refused for a task that is forbidden, and for a forbidden action without a similar requested task.
  void Check(const std::vector<Draft>& drafts) const;

 private:
  struct One {
    Draft what;
    bool asked = false;  ///< needs no contrasting task
  };

  std::string text_;
  std::vector<One> all_;
};

}  // namespace gaitwright::words
