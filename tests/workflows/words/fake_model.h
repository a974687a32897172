// SPDX-License-Identifier: BSD-3-Clause
// A stand-in for a language model on the loopback address, with the answers of a test.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace gaitwright {

/// The answer to one request.
struct FakeAnswer {
  enum class Kind { kContent, kBody, kStatus, kSilence, kHangUp };

  Kind kind = Kind::kContent;
  std::string text;  ///< the content of the message; for kBody the whole body
  int status = 200;
};

/// An HTTP server that sends its answers in order and repeats the last one.
class FakeModel {
 public:
  explicit FakeModel(std::vector<FakeAnswer> answers);
  ~FakeModel();
  FakeModel(const FakeModel&) = delete;

  std::string url() const { return "http://127.0.0.1:" + std::to_string(port_) + "/v1"; }
  /// The requests so far, with their headers.
  std::vector<std::string> requests() const;

 private:
  void Serve();
  void Answer(int connection);

  std::vector<FakeAnswer> answers_;
  int socket_ = -1, port_ = 0;
  std::atomic<bool> stopping_ = false;
  mutable std::mutex mutex_;
  std::vector<std::string> requests_;
  std::thread thread_;
};

}  // namespace gaitwright
