// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaitwright {

/// The laws that a motion is audited by, in the order of reports: a law stands before those that its breach breaks too,
/// so that the first one named is the cause. Columns that disagree make all else doubtful; then come the laws of
/// postures, which no forces could mend, then those of forces that the ground cannot give, and last those of torques.
enum class Law {
  kConsistency,  ///< columns of a plan agree with each other
  kStartPosture,
  kJointPosition,
  kJointVelocity,
  kJointAcceleration,
  kJointJerk,
  kReach,
  kSelfCollision,
  kFootClearance,
  kBodyClearance,
  kZmpSupport,
  kUnilateral,
  kFrictionCone,
  kDynamics,
  kJointTorque,
  kTorqueSpeed,
  kContinuousTorque,
};

/// All laws in their order.
const std::vector<Law>& AllLaws();

/// As files, JSON and reports have it, such as `zmp_support`.
const std::string& LawName(Law law);
/// The names of all laws, in their order.
const std::vector<std::string>& LawNames();
std::optional<Law> LawOfName(std::string_view name);
/// Writes its name.
std::ostream& operator<<(std::ostream& out, Law law);

/// A law that a motion breaks: where it is worst.
struct Violation {
  Law law = Law::kConsistency;
  double at_s = 0.0;  ///< when it is worst; NaN where that is not known
  std::string where;  ///< joint, foot or pair of links
  double value = 0.0, limit = 0.0;
  std::string unit;  ///< of both; "1" for none

  bool operator==(const Violation&) const = default;
};

}  // namespace gaitwright
