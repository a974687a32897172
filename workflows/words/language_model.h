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

/// Requests the next message. Uses only http and https, follows no redirects and reads at most a megabyte. Failures
/// kBadInput: `interpreter_url` for an invalid URL; `interpreter` if no answer arrives in time, its status is not a
/// success, or it is not a chat completion.
Result<std::string> Complete(const LanguageModel& model, const std::vector<ChatMessage>& messages);

}  // namespace gaitwright
