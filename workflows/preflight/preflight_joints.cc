// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/preflight/preflight_joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace gaitwright {
namespace {

/// Checks with a limit for each joint, in the order of their columns, and the column headings.
const std::vector<std::pair<Law, std::string>>& JointLaws() {
  static const std::vector<std::pair<Law, std::string>> laws = {{Law::kJointPosition, "position"},
                                                                {Law::kJointVelocity, "speed"},
                                                                {Law::kJointAcceleration, "acceleration"},
                                                                {Law::kJointJerk, "jerk"},
                                                                {Law::kJointTorque, "torque"},
                                                                {Law::kTorqueSpeed, "torque at speed"},
                                                                {Law::kContinuousTorque, "continuous"}};
  return laws;
}

std::string CellOf(const AuditMargin& margin) {
  return margin.share ? fmt::format("{:.0f} %", 100.0 * *margin.share) : AuditFigure(margin.margin, margin.unit);
}

}  // namespace

JointMargins JointMarginsOf(const std::vector<AuditMargin>& margins) {
  JointMargins table;
  std::map<std::string, std::map<Law, const AuditMargin*>> of;  // by joint and law
  std::vector<Law> laws;
  for (const auto& [law, heading] : JointLaws()) {
    for (const AuditMargin& margin : margins) {
      if (margin.law != law) continue;
      of[margin.where][law] = &margin;
      if (laws.empty() || laws.back() != law) {
        laws.push_back(law);
        table.headings.push_back(heading);
      }
    }
  }
  for (const auto& [joint, by_law] : of) {
    JointMargins::Row row{joint, {}, {}};
    for (const Law law : laws) {
      const auto found = by_law.find(law);
      row.cells.push_back(found == by_law.end() ? "\u2013" : CellOf(*found->second));
      row.broken.push_back(found != by_law.end() && found->second->margin < 0.0);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace gaitwright
