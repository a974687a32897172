// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/check_state.h"

#include <fmt/format.h>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

void CheckNumbers(const RobotModel& model, const char* name, const VectorX& numbers, int size) {
  if (numbers.size() != size)
    throw InvalidArgument(fmt::format("{} has {} numbers; '{}' needs {}", name, numbers.size(), model.name, size));
  if (!numbers.allFinite()) throw InvalidArgument(fmt::format("{} contains a value that is not finite", name));
}

}  // namespace

void CheckState(const RobotModel& model, const VectorX& q, const VectorX& v) {
  constexpr double kShortest = 1e-9;
  CheckNumbers(model, "q", q, model.nq());
  CheckNumbers(model, "v", v, model.nv());
  if (q.segment<4>(3).norm() < kShortest) throw InvalidArgument("the quaternion in q[3:7] is zero");
}

}  // namespace gaitwright
