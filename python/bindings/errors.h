// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <utility>

#include "kinematics/base/result.h"

namespace gaitwright::python {

/// Carries a failure to Python, where it becomes a BadInputError or an InfeasibleError.
class FailureError : public std::exception {
 public:
  explicit FailureError(Failure failure) : failure_(std::move(failure)) {}
  const Failure& failure() const { return failure_; }
  const char* what() const noexcept override { return failure_.message.c_str(); }

 private:
  Failure failure_;
};

/// The value of a result. @throws FailureError if it is a failure.
template <class T>
T Value(Result<T> result) {
  if (!result) throw FailureError(result.failure());
  return std::move(result).value();
}

}  // namespace gaitwright::python
