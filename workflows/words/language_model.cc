// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/language_model.h"

#include <curl/curl.h>
#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

#include "kinematics/base/text.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = std::size_t{1} << 20;

Failure NoAnswer(const std::string& why, FailureCode code = FailureCode::kInterpreter) {
  return {FailureKind::kBadInput, code, "Complete", fmt::format("the language model did not answer: {}", why), {}};
}

std::size_t Receive(char* bytes, std::size_t size, std::size_t count, void* to) {
  auto& body = *static_cast<std::string*>(to);
  if (body.size() + size * count > kMostBytes) return 0;
  body.append(bytes, size * count);
  return size * count;
}

std::string EndpointOf(std::string url) {
  while (url.ends_with('/')) url.pop_back();
  return url.ends_with("/chat/completions") ? url : url + "/chat/completions";
}

std::string RequestOf(const LanguageModel& model, const std::vector<ChatMessage>& messages) {
  Json list = Json::array();
  for (const ChatMessage& message : messages) list.push_back({{"role", message.role}, {"content", message.content}});
  const Json request = {{"model", model.model}, {"messages", list}, {"temperature", 0}};
  return request.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The text of the first choice.
Result<std::string> ContentOf(const std::string& body) {
  const Json json = Json::parse(body, nullptr, false);
  const Json* at = &json;
  if (at->is_object() && at->contains("choices")) at = &(*at)["choices"];
  if (!at->is_array() || at->empty() || !(*at)[0].is_object()) return NoAnswer("it is not a chat completion");
  const Json message = (*at)[0].value("message", Json::object());
  if (!message.is_object() || !message.contains("content") || !message["content"].is_string())
    return NoAnswer("its first choice has no message with text");
  return message["content"].get<std::string>();
}

}  // namespace

std::string ApiKeyFromEnvironment() {
  for (const char* name : {"GAITWRIGHT_API_KEY", "OPENAI_API_KEY"}) {
    if (const char* key = std::getenv(name); key != nullptr && *key != 0) return key;
  }
  return "";
}

Result<std::string> Complete(const LanguageModel& model, const std::vector<ChatMessage>& messages) {
  if (!model.url.starts_with("http://") && !model.url.starts_with("https://"))
    return NoAnswer(fmt::format("'{}' is not an http or https URL", Shortened(model.url)),
                    FailureCode::kInterpreterUrl);
  const std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> curl(curl_easy_init(), &curl_easy_cleanup);
  if (!curl) return NoAnswer("no connection can be made");
  curl_slist* list = curl_slist_append(nullptr, "Content-Type: application/json");
  if (!model.key.empty()) list = curl_slist_append(list, ("Authorization: Bearer " + model.key).c_str());
  const std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)> headers(list, &curl_slist_free_all);
  const std::string url = EndpointOf(model.url), request = RequestOf(model, messages);
  std::string body;
  curl_easy_setopt(curl.get(), CURLOPT_URL, url.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(curl.get(), CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(curl.get(), CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl.get(), CURLOPT_TIMEOUT_MS, static_cast<long>(1e3 * model.longest_s));
  curl_easy_setopt(curl.get(), CURLOPT_HTTPHEADER, headers.get());
  curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDS, request.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request.size()));
  curl_easy_setopt(curl.get(), CURLOPT_WRITEFUNCTION, &Receive);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEDATA, &body);
  const CURLcode code = curl_easy_perform(curl.get());
  if (code == CURLE_URL_MALFORMAT)
    return NoAnswer(fmt::format("'{}' is not a URL", Shortened(url)), FailureCode::kInterpreterUrl);
  if (code == CURLE_WRITE_ERROR) return NoAnswer("its answer is over a megabyte");
  if (code != CURLE_OK) return NoAnswer(curl_easy_strerror(code));
  long status = 0;
  curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &status);
  if (status != 200) return NoAnswer(fmt::format("the endpoint answered with status {}", status));
  return ContentOf(body);
}

}  // namespace gaitwright
