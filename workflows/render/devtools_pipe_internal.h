// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// A process connected by a pair of pipes that carry JSON messages, each ended by a byte 0.
class DevtoolsPipe {
 public:
  /// Starts the program with its descriptors 3 (it reads) and 4 (it writes). Failure: it cannot be started.
  static Result<DevtoolsPipe> Start(const std::string& program, const std::vector<std::string>& arguments);
  /// Ends the process and waits for it.
  ~DevtoolsPipe();
  DevtoolsPipe(DevtoolsPipe&& other) noexcept;
  DevtoolsPipe& operator=(DevtoolsPipe&&) = delete;

  /// Sends a message. Failure: the process no longer reads.
  Result<int> Send(const nlohmann::ordered_json& message);
  /// The next message. Failure: timeout, the process has ended, or it sent data that is not JSON.
  Result<nlohmann::ordered_json> Receive(double timeout_s);

 private:
  DevtoolsPipe() = default;

  pid_t process_ = -1;
  int to_ = -1, from_ = -1;
  std::string buffer_;
};

}  // namespace gaitwright
