// SPDX-License-Identifier: BSD-3-Clause
#include "cli/helping_rank.h"

#include <exception>
#include <string>

#include "cli/interruptible.h"
#include "cli/program.h"

namespace gaitwright::cli {

int HelpRank0(SharedWork& work, const std::function<std::optional<Failure>()>& serve) {
  const Undisturbed undisturbed;
  std::string problem;
  try {
    const std::optional<Failure> failure = serve();
    if (!failure) return kPass;
    problem = failure->message;
  } catch (const std::exception& error) {
    problem = error.what();
  }
  work.Serve({.work = "", .problem = problem}, {});
  return kPass;
}

}  // namespace gaitwright::cli
