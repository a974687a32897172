// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/words/interpret.h"

namespace gaitwright {

/// One of the messages of a conversation.
struct ChatMessage {
  std::string role, content;  ///< role: "system", "user", "assistant"
};

/// Asks for the next message. Nothing but http and https is spoken, no redirect followed, and at most a megabyte read.
/// Failures kBadInput: `interpreter_url` for a URL that is none; `interpreter` for no answer in time, one that is not
/// a success or not what chat completions are.
Result<std::string> Complete(const LanguageModel& model, const std::vector<ChatMessage>& messages);

}  // namespace gaitwright
