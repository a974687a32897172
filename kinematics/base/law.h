// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaitwright {

/// The checks of the audit, in the order of reports. Causes come before their consequences, so the first violation is
/// usually the cause: inconsistent columns make all other results doubtful, postures come before contact forces, and
/// contact forces come before torques.
enum class Law {
  kConsistency,  ///< the columns of a plan are consistent
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
  kFlight,  ///< free fall and constant angular momentum without contact
  kDynamics,
  kJointTorque,
  kTorqueSpeed,
  kContinuousTorque,
};

/// All checks in their order.
const std::vector<Law>& AllLaws();

/// Name in files, JSON and reports, such as `zmp_support`.
const std::string& LawName(Law law);
/// The names of all checks, in their order.
const std::vector<std::string>& LawNames();
std::optional<Law> LawOfName(std::string_view name);
/// Writes the name of a check.
std::ostream& operator<<(std::ostream& out, Law law);

/// The largest violation of a check.
struct Violation {
  Law law = Law::kConsistency;
  double at_s = 0.0;  ///< time of the worst value; NaN if unknown
  std::string where;  ///< joint, foot or pair of links
  double value = 0.0, limit = 0.0;
  std::string unit;  ///< unit of value and limit; "1" if they have no unit

  bool operator==(const Violation&) const = default;
};

}  // namespace gaitwright
