// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/words/clause.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// What an instruction says is not to be done, and whether its tasks keep to that.
class Forbidden {
 public:
  explicit Forbidden(const std::string& text) : text_(text) {}

  /// "don't walk": takes back the task that is so, if there is one; else it must differ from one that is asked for,
  /// before or after: "don't turn right, turn left". @return whether a task was taken back. @throws Refused
  bool Add(const Clause& clause, std::vector<Draft>& drafts);

  /// "not the right one". @return whether it denies what was said last, so that what comes next is meant instead.
  /// @throws Refused where it says more than the task from which it differs.
  bool AddNot(const Clause& clause, const std::vector<Draft>& drafts);

  /// @throws Refused for a task that is forbidden, and for what is forbidden and like nothing that is asked for.
  void Check(const std::vector<Draft>& drafts) const;

 private:
  struct One {
    Draft what;
    bool asked = false;  ///< needs no task that it differs from
  };

  std::string text_;
  std::vector<One> all_;
};

}  // namespace gaitwright::words
