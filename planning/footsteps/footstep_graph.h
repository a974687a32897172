// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "planning/footsteps/foothold_table.h"
#include "planning/footsteps/stance_check.h"

namespace gaitwright {

/// Stances of the search: a foothold of each foot, and the group of feet that steps next.
///
/// Stances are numbered in order of creation; equal footholds with an equal group are one stance.
class FootstepGraph {
 public:
  /// A step of the next group.
  struct Edge {
    int to = 0;
    double cost = 0.0;
  };
  /// Counts of the reasons why steps were rejected.
  struct Refusals {
    int no_foothold = 0, too_long = 0, too_high = 0, riser = 0, obstacle = 0;
  };

  FootstepGraph(const RobotModel& model, const FootstepQuery& query, FootholdTable& table, StanceChecker& stances,
                const GroundIndex& ground, const FootstepSearchOptions& options);

  /// The stance with these footholds, by foot, and this next group.
  int StanceOf(const std::vector<int>& footholds, int group);

  /// All steps of the next group, including those to stances where the robot cannot stand; see Holds.
  void Steps(int stance, std::vector<Edge>& edges, Refusals* refusals = nullptr);
  /// Whether the robot can stand in this stance; computed once.
  bool Holds(int stance) { return FaultOf(stance) == StanceFault::kNone; }
  StanceFault FaultOf(int stance);

  /// Lower bound of the cost from a stance to the end of the route.
  double Heuristic(int stance) const;
  bool IsGoal(int stance) const;
  /// Mean of the feet's stations [m].
  double Progress(int stance) const;

  std::span<const int> FootholdsOf(int stance) const;
  /// The group that steps next.
  int GroupOf(int stance) const { return group_[static_cast<std::size_t>(stance)]; }
  const std::vector<std::vector<int>>& groups() const { return groups_; }
  const FootholdTable& table() const { return *table_; }
  int size() const { return static_cast<int>(group_.size()); }
  int checked() const { return checked_; }

  /// Height of the highest ground on the straight line between two footholds, above the lower one [m].
  double RiseBetween(const FootholdChoice& from, const FootholdChoice& to) const;

 private:
  void StepsTo(int stance, int step, std::vector<Edge>& edges, Refusals& refusals);
  void CombineLevel(int stance, std::size_t budget, std::vector<Edge>& edges);
  void Combine(int stance, std::size_t member, std::size_t budget, std::vector<Edge>& edges);
  double CostOf(int stance);  // cost of the step from it to chosen_
  double LandingTilt();       // tilt of the base above chosen_ if all feet leap together [rad]; otherwise 0
  bool SwingHolds(const FootholdChoice& from, const FootholdChoice& to, Refusals& refusals) const;
  bool IsFreeBetween(const FootholdChoice& from, const FootholdChoice& to) const;
  std::size_t Hash(std::span<const int> footholds, int group) const;
  void Grow();

  const FootstepQuery* query_;
  FootholdTable* table_;
  StanceChecker* stances_;
  const GroundIndex* ground_;
  FootstepSearchOptions options_;
  double leg_m_;
  std::vector<std::vector<int>> groups_;
  std::size_t num_feet_;
  std::vector<int> footholds_;  // by stance, by foot
  std::vector<int> group_;      // by stance
  std::vector<int> fault_;      // by stance; -1 if not yet known
  std::vector<int> slots_;      // hash table of stances; -1 for an empty slot
  std::vector<int> chosen_;     // footholds of the stance that is being created
  std::vector<std::vector<int>> options_by_member_;
  std::vector<Pose> poses_;  // scratch
  std::vector<const Polygon*> outlines_;
  int checked_ = 0;
};

}  // namespace gaitwright
