// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/candidate.h"

namespace gaitwright {
namespace {

constexpr Variation kShorterFirst[] = {{1.0, 1}, {1.0, 2},  {1.0, 3},  {1.0, 4},  {1.0, 5},
                                       {1.0, 6}, {1.0, -1}, {1.0, -2}, {1.0, -3}, {1.0, -4}};
constexpr Variation kLongerFirst[] = {{1.0, -1}, {1.0, -2}, {1.0, -3}, {1.0, -4}, {1.0, 1},
                                      {1.0, 2},  {1.0, 3},  {1.0, 4},  {1.0, 5},  {1.0, 6}};
constexpr Variation kSlowerSteps[] = {{1.0, -1}, {1.0, -2}, {1.0, -3}, {1.0, -4}};
/// Over uneven ground: fewer and longer steps at less speed, then slow steps.
constexpr Variation kSlowerWalks[] = {{0.7, -2}, {0.5, -2}, {0.35, 0}, {0.3, -1}};
/// Flat soles; then heels that rise, also with longer swings; then longer steps of slow joints.
constexpr Variation kFinished[] = {{1.0, 0, 1.0, false, true},       {1.0, 3, 1.0, false, true},
                                   {1.0, 6, 1.0, false, true},       {1.0, 0, 1.0, false, true, 0.4},
                                   {1.0, 0, 1.12, false, true, 0.4}, {1.0, -1, 1.12, false, true, 0.35}};
constexpr std::size_t kFlatSoles = 3;  // rows of kFinished
/// A robot's own walk is calm: its heels stay down.
constexpr Variation kFinishedCalm[] = {{1.0, 0, 1.0, false, true}, {0.7, 0, 1.0, false, true}};
/// Other flights, then other footholds.
constexpr Variation kOtherLeaps[] = {{1.0, 0, 0.8}, {1.0, 0, 1.15}, {1.0, 0, 1.0, true}};

}  // namespace

std::span<const Variation> VariationsFor(const SearchSituation& s) {
  switch (s.kind) {
    case SearchSituation::Kind::kLevel:
      return s.refused_by_ground ? kLongerFirst : kShorterFirst;
    case SearchSituation::Kind::kUneven:
      return s.may_slow_down ? std::span<const Variation>(kSlowerWalks) : kSlowerSteps;
    case SearchSituation::Kind::kFlying: {
      const std::span<const Variation> all(kOtherLeaps), flights = all.first(2), feet = all.last(1);
      if (s.may_vary_flight) return s.may_move_feet ? all : flights;
      return s.may_move_feet ? feet : std::span<const Variation>();
    }
  }
  return {};
}

std::span<const Variation> FinishedVariationsFor(const SearchSituation& s) {
  switch (s.kind) {
    case SearchSituation::Kind::kLevel:
      if (s.refused_by_ground) return {};
      if (s.may_slow_down) return kFinishedCalm;
      return s.may_raise_heels ? std::span<const Variation>(kFinished) : std::span(kFinished).first(kFlatSoles);
    case SearchSituation::Kind::kUneven:
      return std::span<const Variation>(kFinished).first(1);
    case SearchSituation::Kind::kFlying:
      break;
  }
  return {};
}

Effort EarlyCheckOf(SearchSituation::Kind kind) {
  switch (kind) {
    case SearchSituation::Kind::kLevel:
      return Effort::kStart;
    case SearchSituation::Kind::kUneven:
      return Effort::kWhole;
    case SearchSituation::Kind::kFlying:
      return Effort::kFirstLook;
  }
  return Effort::kWhole;
}

}  // namespace gaitwright
