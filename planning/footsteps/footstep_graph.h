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

/// Stances of the search: a foothold of each foot, and the group that steps next.
///
/// Stances are numbered in order of creation; equal footholds and group are one stance.
class FootstepGraph {
 public:
  /// A step of the group that is next.
  struct Edge {
    int to = 0;
    double cost = 0.0;
  };
  /// Why a step was not made.
  struct Refusals {
    int no_foothold = 0, too_long = 0, too_high = 0, riser = 0, obstacle = 0;
  };

  FootstepGraph(const RobotModel& model, const FootstepQuery& query, FootholdTable& table, StanceChecker& stances,
                const GroundIndex& ground, const FootstepSearchOptions& options);

  /// The stance of these footholds, by foot, with that group next.
  int StanceOf(const std::vector<int>& footholds, int group);

  /// All steps of the group that is next, whether or not the stances that they lead to hold; see Holds.
  void Steps(int stance, std::vector<Edge>& edges, Refusals* refusals = nullptr);
  /// Whether the robot can stand in this stance; computed once.
  bool Holds(int stance) { return FaultOf(stance) == StanceFault::kNone; }
  StanceFault FaultOf(int stance);

  /// Least cost from a stance to the end of the route.
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

  /// Highest ground along the straight way between two footholds, over the lower of them [m].
  double RiseOnWay(const FootholdChoice& from, const FootholdChoice& to) const;

 private:
  void StepsTo(int stance, int step, std::vector<Edge>& edges, Refusals& refusals);
  void CombineLevel(int stance, std::size_t budget, std::vector<Edge>& edges);
  void Combine(int stance, std::size_t member, std::size_t budget, std::vector<Edge>& edges);
  double CostOf(int stance);  // of stepping from it to chosen_
  double LandingTilt();       // of the base over chosen_ where all feet leap at once [rad]; else 0
  bool SwingHolds(const FootholdChoice& from, const FootholdChoice& to, Refusals& refusals) const;
  bool WayIsFree(const FootholdChoice& from, const FootholdChoice& to) const;
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
  std::vector<int> fault_;      // by stance; -1 while unknown
  std::vector<int> slots_;      // hash table of stances; -1 for none
  std::vector<int> chosen_;     // footholds of a stance in the making
  std::vector<std::vector<int>> options_by_member_;
  std::vector<Pose> poses_;  // scratch
  std::vector<const Polygon*> outlines_;
  int checked_ = 0;
};

}  // namespace gaitwright
