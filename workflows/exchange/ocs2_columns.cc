// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/ocs2_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/nearest_name.h"
#include "kinematics/dynamics/dynamics.h"
#include "workflows/exchange/column_target.h"

namespace gaitwright {
namespace {

constexpr std::array<const char*, 4> kLegs = {"LF", "RF", "LH", "RH"};
constexpr std::array<const char*, 3> kJoints = {"HAA", "HFE", "KFE"};

/// The legs of a model in OCS2's order.
using LegIndices = std::array<int, 4>;

/// Finds the legs by the names of their joints; -1 if there is none.
LegIndices LegsByName(const RobotModel& model) {
  LegIndices legs = {-1, -1, -1, -1};
  for (std::size_t i = 0; i < kLegs.size(); ++i) {
    for (std::size_t l = 0; l < model.legs.size(); ++l) {
      const std::vector<int>& joints = model.legs[l].joints;
      const auto is = [&](std::size_t j) {
        return model.joints[static_cast<std::size_t>(joints[j])].name == fmt::format("{}_{}", kLegs[i], kJoints[j]);
      };
      if (joints.size() == kJoints.size() && is(0) && is(1) && is(2)) legs[i] = static_cast<int>(l);
    }
  }
  return legs;
}

/// Finds the legs by the position of their feet around their centre; -1 if there is none or more than one.
LegIndices LegsByPlace(const RobotModel& model) {
  LegIndices legs = {-1, -1, -1, -1};
  if (model.legs.size() != kLegs.size()) return legs;
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  std::vector<Vector3> feet;
  Vector3 middle = Vector3::Zero();
  for (const Foot& foot : model.feet) {
    feet.push_back(FramePose(scratch, foot.body, foot.X_BF).translation());
    middle += feet.back() / static_cast<double>(model.feet.size());
  }
  for (std::size_t l = 0; l < model.legs.size(); ++l) {
    if (model.legs[l].joints.size() != kJoints.size()) return {-1, -1, -1, -1};
    const Vector3 p = feet[static_cast<std::size_t>(model.legs[l].foot)] - middle;
    const std::size_t place = (p.x() > 0.0 ? 0U : 2U) + (p.y() > 0.0 ? 0U : 1U);
    if (legs[place] >= 0) return {-1, -1, -1, -1};
    legs[place] = static_cast<int>(l);
  }
  return legs;
}

bool Complete(const LegIndices& legs) {
  return std::all_of(legs.begin(), legs.end(), [](int leg) { return leg >= 0; });
}

void AddBase(ColumnNames& names) {
  names.ours = {{"time", "time_s"}};
  for (const char* axis : {"x", "y", "z"}) {
    names.ours[fmt::format("base_positionInWorld_{}", axis)] = fmt::format("base_{}_m", axis);
    names.ignored.push_back(fmt::format("base_linearvelocityInBase_{}", axis));
    names.ignored.push_back(fmt::format("base_angularvelocityInBase_{}", axis));
  }
  for (const char* part : {"w", "x", "y", "z"})
    names.ours[fmt::format("base_quaternion_{}", part)] = fmt::format("base_q{}", part);
}

void AddLeg(const RobotModel& model, const Leg& leg, const std::string& theirs, ColumnNames& names) {
  const std::string& link = model.feet[static_cast<std::size_t>(leg.foot)].link;
  names.ours["contactflag_" + theirs] = "contact_" + link;
  for (const char* axis : {"x", "y", "z"}) {
    names.ours[fmt::format("contactForcesInWorld_{}_{}", theirs, axis)] = fmt::format("force_{}_{}_n", link, axis);
  }
  for (std::size_t j = 0; j < kJoints.size(); ++j) {
    const Joint& joint = model.joints[static_cast<std::size_t>(leg.joints[j])];
    const std::string position = PositionColumn(joint);
    names.ours[fmt::format("jointAngle_{}_{}", theirs, kJoints[j])] = position;
    names.ours[fmt::format("jointVelocity_{}_{}", theirs, kJoints[j])] = "v" + position.substr(1) + "_s";
  }
}

/// A column of a leg that OCS2 does not have; nothing if there is none.
std::optional<std::string> Misnamed(const CsvTable& table, const ColumnNames& names) {
  for (const std::string& column : table.columns) {
    for (const char* kind : {"jointAngle_", "jointVelocity_", "contactflag_", "contactForcesInWorld_"}) {
      if (column.starts_with(kind) && names.ours.count(column) == 0) return column;
    }
  }
  return std::nullopt;
}

}  // namespace

bool IsOcs2Motion(const CsvTable& table) {
  return table.Find("base_positionInWorld_x") >= 0 &&
         std::any_of(table.columns.begin(), table.columns.end(),
                     [](const auto& c) { return c.starts_with("jointAngle_"); });
}

Result<ColumnNames> Ocs2ColumnNames(const RobotModel& model, const CsvTable& table, std::vector<DerivedPart>& derived) {
  LegIndices legs = LegsByName(model);
  if (!Complete(legs)) {
    legs = LegsByPlace(model);
    if (!Complete(legs)) {
      return Failure{FailureKind::kBadInput,
                     FailureCode::kOcs2,
                     "ImportMotion",
                     fmt::format("'{}' is a motion of an OCS2 quadruped, with legs LF, RF, LH and RH of three joints "
                                 "each; robot '{}' has no such legs",
                                 table.source, model.name),
                     {"name the columns in a file: --columns FILE"}};
    }
    std::string said;
    for (std::size_t i = 0; i < kLegs.size(); ++i) {
      const Leg& leg = model.legs[static_cast<std::size_t>(legs[i])];
      for (std::size_t j = 0; j < kJoints.size(); ++j) {
        said += fmt::format("{}{}_{} is {}", said.empty() ? "" : ", ", kLegs[i], kJoints[j],
                            model.joints[static_cast<std::size_t>(leg.joints[j])].name);
      }
    }
    derived.push_back({"joints", "mapped by leg position, from the base outward, with this robot's signs: " + said});
  }
  ColumnNames names;
  names.may_lack = true;
  AddBase(names);
  for (std::size_t i = 0; i < kLegs.size(); ++i)
    AddLeg(model, model.legs[static_cast<std::size_t>(legs[i])], kLegs[i], names);
  if (const auto column = Misnamed(table, names)) {
    std::vector<std::string> known;
    for (const auto& [theirs, ours] : names.ours) known.push_back(theirs);
    return Failure{FailureKind::kBadInput,
                   FailureCode::kOcs2,
                   "ImportMotion",
                   fmt::format("'{}' is a motion of an OCS2 quadruped, which has no column '{}'{}", table.source,
                               *column, NearestOrAll(*column, known)),
                   {"name the columns in a file: --columns FILE"}};
  }
  return names;
}

}  // namespace gaitwright
