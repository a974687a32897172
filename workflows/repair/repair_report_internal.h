// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "workflows/repair/repair_motion_internal.h"
#include "workflows/walk/engine_verdict.h"

namespace gaitwright {

enum class RepairChangeKind {
  kSmoothed,
  kLifted,
  kSlowed,
  kLeftOut,
  kStood,
  kPinned,
  kParted,
  kHeld,
  kContacts,
  kOtherContact
};
/// The name in JSON and Python, such as `smoothed`.
const char* RepairChangeName(RepairChangeKind kind);

/// A change that a repair made, or would make.
struct RepairChange {
  RepairChangeKind kind = RepairChangeKind::kSmoothed;
  std::string where;  ///< foot; "" for the whole robot
  double start_s = 0.0, end_s = 0.0;
  double by = 0.0;  ///< in `unit`
  std::string unit;
  std::string text;  ///< one sentence
};

/// The changes of contacts and times, in order.
std::vector<RepairChange> ChangesOf(const RobotModel& model, const MotionFindings& findings);

/// Result of a repair with the playback of its plan, if it was played.
struct RepairResult {
  const RobotModel& model;
  const MotionFindings& findings;
  const RepairedMotion* repaired = nullptr;  ///< null: only examined
  const PlayedWalk* played = nullptr;

  /// The audit passes, and all engines that played.
  bool pass() const;
};

std::string RepairText(const RepairResult& result);

/// An object as of docs/repair.md. @param files  written files: kind ("plan", "report") and path.
std::string RepairJson(const RepairResult& result, const std::vector<std::pair<std::string, std::string>>& files = {});

}  // namespace gaitwright
