// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

/// Splits the name of a patch: "step 2" is number 2 of "step".
PlaceName SplitName(const std::string& name) {
  constexpr std::size_t kMostDigits = 6;
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  if (digits == 0 || digits == name.size() || name.size() - digits > kMostDigits) return {name, 0};
  const std::size_t end = name.find_last_not_of(" _-", digits - 1) + 1;
  return end == 0 ? PlaceName{name, 0} : PlaceName{name.substr(0, end), std::stoi(name.substr(digits))};
}

const TerrainPatch* PatchOf(const Terrain& terrain, const std::string& name) {
  for (const TerrainPatch& patch : terrain.patches) {
    if (patch.name == name && !patch.outline_T.empty()) return &patch;
  }
  return nullptr;
}

Vector2 MiddleOf(const TerrainPatch& patch) {
  Vector2 mean_T = Vector2::Zero();
  for (const Vector2& corner : patch.outline_T) mean_T += corner / static_cast<double>(patch.outline_T.size());
  return (patch.X_WT * Vector3(mean_T.x(), mean_T.y(), 0.0)).head<2>();
}

/// Extent of a patch along a direction.
double Farthest(const TerrainPatch& patch, const Vector2& along) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Vector2& corner : patch.outline_T)
    farthest = std::max(farthest, along.dot((patch.X_WT * Vector3(corner.x(), corner.y(), 0.0)).head<2>()));
  return farthest;
}

/// The ground at an end of stairs, beyond their outermost step; the patches of stairs are named "step 1" and so on.
struct StairsFoot {
  const TerrainPatch* outermost = nullptr;
  Vector2 outward = Vector2::Zero();
};

/// @param behind  the end that is reached by walking up and down again.
std::optional<StairsFoot> FootOf(const Terrain& terrain, bool behind) {
  const TerrainPatch *outer = PatchOf(terrain, "step 1"), *inner = PatchOf(terrain, "step 2");
  if (behind) {
    outer = PatchOf(terrain, "step 1 down");
    for (int k = 2; const TerrainPatch* next = PatchOf(terrain, fmt::format("step {} down", k)); ++k)
      inner = std::exchange(outer, next);
    if (outer == PatchOf(terrain, "step 1 down")) inner = PatchOf(terrain, "step 2");
  }
  if (outer == nullptr || inner == nullptr) return std::nullopt;
  const Vector2 outward = MiddleOf(*outer) - MiddleOf(*inner);
  if (outward.norm() == 0.0) return std::nullopt;
  return StairsFoot{outer, outward.normalized()};
}

/// The place at the same distance from the steps as the robot's start.
Vector2 PlaceAt(const Terrain& terrain, const StairsFoot& foot) {
  const StairsFoot before = *FootOf(terrain, false);
  const double start_m = std::max(0.0, -Farthest(*before.outermost, before.outward));
  const Vector2 middle = MiddleOf(*foot.outermost);
  return middle + (Farthest(*foot.outermost, foot.outward) - foot.outward.dot(middle) + start_m) * foot.outward;
}

}  // namespace

std::vector<PlaceName> PlacesOf(const Terrain& terrain) {
  std::vector<PlaceName> places;
  for (const TerrainMarker& marker : terrain.markers) places.push_back({marker.name, 0});
  for (const TerrainPatch& patch : terrain.patches) {
    if (patch.name.empty() || patch.outline_T.empty()) continue;
    const PlaceName name = SplitName(patch.name);
    const auto known =
        std::find_if(places.begin(), places.end(), [&](const PlaceName& place) { return place.name == name.name; });
    if (known == places.end()) {
      places.push_back(name);
    } else {
      known->number = std::max(known->number, name.number);
    }
  }
  if (FootOf(terrain, false)) places.push_back({kStartOfStairs, 0});
  if (FootOf(terrain, true)) places.push_back({kEndOfStairs, 0});
  return places;
}

bool IsPlace(const std::string& patch, const PlaceName& place, const Terrain& terrain) {
  const PlaceName name = SplitName(patch);
  if (name.name != place.name) return false;
  if (place.number >= 0) return name.number == place.number || place.number == 0;
  return std::none_of(terrain.patches.begin(), terrain.patches.end(), [&](const TerrainPatch& other) {
    const PlaceName another = SplitName(other.name);
    return another.name == place.name && another.number > name.number;
  });
}

Vector2 CentreOf(const Terrain& terrain, const PlaceName& place) {
  for (const TerrainMarker& marker : terrain.markers) {
    if (marker.name == place.name) return marker.p_W;
  }
  for (const bool behind : {false, true}) {
    const std::optional<StairsFoot> foot = FootOf(terrain, behind);
    if (foot && place.name == (behind ? kEndOfStairs : kStartOfStairs)) return PlaceAt(terrain, *foot);
  }
  const TerrainPatch* found = nullptr;
  int highest = -1;
  for (const TerrainPatch& patch : terrain.patches) {
    const PlaceName name = SplitName(patch.name);
    if (name.name != place.name || patch.outline_T.empty()) continue;
    if (place.number > 0 ? name.number != place.number : name.number <= highest) continue;
    highest = name.number;
    found = &patch;
  }
  if (found == nullptr) throw InvalidArgument(fmt::format("place '{}' {} does not exist", place.name, place.number));
  return MiddleOf(*found);
}

}  // namespace gaitwright
