// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "kinematics/ik/leg_workspace.h"
#include "planning/footsteps/base_over_feet.h"
#include "planning/footsteps/foothold_check.h"
#include "planning/footsteps/ground_index.h"
#include "planning/footsteps/leg_room.h"
#include "planning/footsteps/search_footsteps.h"

namespace gaitwright {

/// Reason why a robot cannot stand with given footholds.
enum class StanceFault { kNone, kFeetClose, kReach, kTilt, kBodyLow, kLegLow, kBodyObstacle };

/// Number of times that each fault occurred, indexed by fault.
using StanceFaults = std::array<int, static_cast<std::size_t>(StanceFault::kBodyObstacle) + 1>;

/// Text of the fault, such as "out of reach of a leg".
std::string Describe(StanceFault fault);

/// The feet with soles that are at times the only feet on the ground in a gait.
std::vector<int> LoneSoles(const RobotModel& model, const Gait& gait);

/// Checks whether a robot can stand with given footholds. Caches the workspaces of the legs, so later queries are
/// cheap; not thread-safe. Model and ground must outlive it.
class StanceChecker {
 public:
  StanceChecker(const RobotModel& model, const GroundIndex& ground, const FootstepQuery& query,
                const FootholdOptions& footholds, const FootstepSearchOptions& options);

  /// @param X_WF      contact frames by foot.
  /// @param outlines  areas of the feet in plan view, by foot.
  StanceFault Check(const std::vector<Pose>& X_WF, const std::vector<const Polygon*>& outlines);

  /// The base above its feet as in the planned walk: with the mean heading of the feet.
  BaseOverFeet BaseOf(const std::vector<Pose>& X_WF) const;

  const std::vector<Pose>& standing() const { return standing_; }

 private:
  bool FeetApart(const std::vector<Pose>& X_WF, const std::vector<const Polygon*>& outlines, double yaw_rad) const;
  bool AllReach(const std::vector<Pose>& X_WF, const Pose& X_WB);
  /// Whether a leg reaches its sole with the heel raised.
  bool ReachesRaised(std::size_t leg, const Pose& X_BW, const Pose& X_WF);
  bool ReachFrom(const std::vector<Pose>& X_WF, const Pose& X_WB);
  bool LegsClear(const std::vector<Pose>& X_WF, const Pose& X_WB);
  StanceFault BodyRoom(const BaseOverFeet& base, const Pose& X_WB) const;
  void MeasureBody(const RobotModel& model);

  const RobotModel* model_;
  const GroundIndex* ground_;
  const FootstepQuery* query_;
  FootstepSearchOptions options_;
  double margin_m_;
  std::vector<Pose> standing_;
  std::shared_ptr<LegWorkspaces> workspaces_;
  std::vector<LegWorkspace*> legs_;  // by foot, in workspaces_
  std::vector<int> lone_;            // see LoneSoles
  LegRoom leg_room_;
  double leg_m_;
  Vector3 trunk_low_, trunk_high_, whole_low_, whole_high_;  // boxes in B
  bool has_trunk_ = false;
};

}  // namespace gaitwright
