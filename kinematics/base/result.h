// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/failure_code.h"
#include "kinematics/base/law.h"
#include "kinematics/base/suggestion.h"

namespace gaitwright {

/// Thrown for a wrong argument of the caller: the message names the argument, its value and the accepted values.
class InvalidArgument : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Kind of failure of a stage; the program maps it to its exit status.
enum class FailureKind {
  kBadInput,    ///< a file or argument is wrong (exit status 1)
  kInfeasible,  ///< no plan exists within the limits (exit status 2)
};

/// Kind of a part of a robot description.
enum class PartKind { kRobot, kLink, kJoint, kLeg, kTransmission };

/// A part of a robot description.
struct RobotPart {
  PartKind kind = PartKind::kRobot;
  std::string name = {};  ///< empty for the whole robot

  bool operator==(const RobotPart&) const = default;
};
/// The text for the user and JSON: `robot`, `link 'trunk'`, `joint 'FL_KFE'`.
std::string PartText(const RobotPart& part);

/// Reason why a stage has no result: one sentence, and hints.
struct Failure {
  FailureKind kind = FailureKind::kBadInput;
  FailureCode code = FailureCode::kInternal;
  std::string stage;  ///< the stage that failed, such as `LoadRobot`
  std::string message;
  std::vector<Suggestion> suggestions;      ///< hints, the most promising first
  std::optional<Violation> violation = {};  ///< the violated check of the audit, if it is the reason
  std::optional<RobotPart> part = {};       ///< the part of the robot description that is wrong, if it is one

  bool operator==(const Failure&) const = default;
};

/// A complete value or a Failure.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}              // NOLINT(google-explicit-constructor)
  Result(Failure failure) : failure_(std::move(failure)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return value_.has_value(); }
  explicit operator bool() const { return ok(); }

  /// The value. @throws std::logic_error if this contains a failure (a bug of the caller).
  const T& value() const& {
    Require();
    return *value_;
  }
  T& value() & {
    Require();
    return *value_;
  }
  T&& value() && {
    Require();
    return std::move(*value_);
  }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  /// The failure. Call only if `!ok()`.
  const Failure& failure() const { return failure_; }

 private:
  void Require() const {
    if (!value_) throw std::logic_error("Result without a value: " + failure_.message);
  }

  std::optional<T> value_;
  Failure failure_;
};

}  // namespace gaitwright
