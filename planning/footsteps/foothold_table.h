// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "planning/footsteps/foothold_check.h"
#include "planning/footsteps/search_footsteps.h"

namespace gaitwright {

/// A possible foothold of the search.
struct FootholdChoice {
  PlacedFoot placed;
  Polygon outline_W;         ///< area of the foot in plan view
  double station_m = 0.0;    ///< station of the route at which the foot's nominal position is nearest
  double departure_m = 0.0;  ///< distance from that position
  bool goal = false;         ///< the foot stands there as at the end of the route
};

/// The footholds of a route: several for each foot and step of the route, computed at the first query. A place found
/// from several steps is one foothold.
class FootholdTable {
 public:
  /// Number of times that each fault occurred in the search for footholds of a foot and step.
  using Faults = std::array<int, static_cast<std::size_t>(FootholdFault::kObstacle) + 1>;

  /// All arguments must outlive the table. @param beside_goal  feet count as at the goal within four times the goal
  /// tolerance.
  FootholdTable(const RobotModel& model, const FootholdChecker& checker, const FootstepQuery& query,
                const FootstepSearchOptions& options, bool beside_goal = false);

  /// Indices of the footholds near a foot's nominal position at step `step` of the route, best first.
  const std::vector<int>& Near(int foot, int step);
  /// The foot's foothold at the start of the route, or the reason why it cannot stand there.
  Placing Start(int foot, int& index);

  /// Nominal position of the foot at a station: its place in the standing posture under the base.
  PlanarPose PlaceAt(int foot, double station_m) const;
  /// The foot's nominal pose at a step of the route.
  const PlanarPose& PlaceAtStep(int foot, int step) const {
    return places_[static_cast<std::size_t>(foot)][static_cast<std::size_t>(step)];
  }
  /// Faults that occurred in Near(foot, step); all zero without such a query.
  Faults FaultsAt(int foot, int step) const;

  const FootholdChoice& operator[](int index) const { return choices_[static_cast<std::size_t>(index)]; }
  int num_steps() const { return num_steps_; }     ///< the end of the route is this step
  double step_m() const { return step_m_; }        ///< length of a step in stations
  double stride_m() const { return stride_m_; }    ///< stations per cycle; the route is a whole number of advances
  double advance_m() const { return advance_m_; }  ///< stations in the time of one group: stride / groups
  double offset_m() const { return offset_m_; }    ///< largest distance from the nominal position

 private:
  struct Cell {
    bool known = false;
    std::vector<int> choices;
    Faults faults{};
  };

  void Fill(int foot, int step, Cell& cell);
  /// Candidate footholds around a foot's nominal position.
  struct Offer {
    std::size_t most = 0;  ///< largest number of footholds
    int parts = 0;         ///< number of lattice units; 0 for a few places beside the nominal one only
  };
  Offer OfferAround(int foot, const Placing& own) const;
  void ListPlaces(int foot, const PlanarPose& at, int parts, std::vector<PlanarPose>& places) const;
  int Intern(const PlacedFoot& placed, int step);
  void Locate(FootholdChoice& choice, int step) const;

  const FootholdChecker* checker_;
  const FootstepQuery* query_;
  FootstepSearchOptions options_;
  bool beside_goal_;
  std::vector<Pose> standing_;
  double leg_m_, offset_m_, stride_m_, advance_m_, step_m_;
  int num_steps_;
  std::vector<std::vector<Cell>> cells_;         // by foot, by step
  std::vector<std::vector<PlanarPose>> places_;  // by foot, by step
  std::vector<FootholdChoice> choices_;
  std::unordered_map<std::uint64_t, int> index_;  // by foot and place
};

}  // namespace gaitwright
