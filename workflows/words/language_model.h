// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// A language model behind an endpoint that speaks as OpenAI's chat completions do.
struct LanguageModel {
  std::string url;    ///< the base, such as "http://localhost:8000/v1"; "/chat/completions" is added where it lacks
  std::string model;  ///< its name there
  std::string key;    ///< sent as a bearer token; "" sends none
  double longest_s = 60.0;
};

/// One of the messages of a conversation.
struct ChatMessage {
  std::string role, content;  ///< role: "system", "user", "assistant"
};

/// The key for language models from the environment: GAITWRIGHT_API_KEY, else OPENAI_API_KEY, else "".
std::string ApiKeyFromEnvironment();

/// Asks for the next message. Nothing but http and https is spoken, no redirect followed, and at most a megabyte read.
/// Failures kBadInput: `interpreter_url` for a URL that is none; `interpreter` for no answer in time, one that is not
/// a success or not what chat completions are.
Result<std::string> Complete(const LanguageModel& model, const std::vector<ChatMessage>& messages);

}  // namespace gaitwright
