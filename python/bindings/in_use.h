// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>

#include "kinematics/base/result.h"

namespace gaitwright::python {

/// Marks an object that one thread uses. Other threads may run at that time, since the interpreter's lock is released.
class InUse {
 public:
  /// Exists as long as the object is in use. @throws InvalidArgument if another thread uses the object.
  class Turn {
   public:
    Turn(InUse& what, const std::string& name) : what_(what) {
      if (what_.taken_.exchange(true))
        throw InvalidArgument(name + " is in use by another thread: give each thread its own");
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn() { what_.taken_ = false; }

   private:
    InUse& what_;
  };

 private:
  std::atomic<bool> taken_ = false;
};

}  // namespace gaitwright::python
