// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/result.h"

#include <fmt/format.h>

namespace gaitwright {
namespace {

const char* KindText(PartKind kind) {
  switch (kind) {
    case PartKind::kRobot:
      return "robot";
    case PartKind::kLink:
      return "link";
    case PartKind::kJoint:
      return "joint";
    case PartKind::kLeg:
      return "leg";
    case PartKind::kTransmission:
      return "transmission";
  }
  return "";
}

}  // namespace

std::string PartText(const RobotPart& part) {
  return part.kind == PartKind::kRobot ? KindText(part.kind) : fmt::format("{} '{}'", KindText(part.kind), part.name);
}

}  // namespace gaitwright
