// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/places.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

/// A patch's name in two: "step 2" is number 2 of "step".
PlaceName SplitName(const std::string& name) {
  constexpr std::size_t kMostDigits = 6;
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  if (digits == 0 || digits == name.size() || name.size() - digits > kMostDigits) return {name, 0};
  const std::size_t end = name.find_last_not_of(" _-", digits - 1) + 1;
  return end == 0 ? PlaceName{name, 0} : PlaceName{name.substr(0, end), std::stoi(name.substr(digits))};
}

Vector2 MiddleOf(const TerrainPatch& patch) {
  Vector2 mean_T = Vector2::Zero();
  for (const Vector2& corner : patch.outline_T) mean_T += corner / static_cast<double>(patch.outline_T.size());
  return (patch.X_WT * Vector3(mean_T.x(), mean_T.y(), 0.0)).head<2>();
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
  return places;
}

Vector2 CentreOf(const Terrain& terrain, const PlaceName& place) {
  for (const TerrainMarker& marker : terrain.markers) {
    if (marker.name == place.name) return marker.p_W;
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
  if (found == nullptr) throw InvalidArgument(fmt::format("there is no place '{}' {}", place.name, place.number));
  return MiddleOf(*found);
}

}  // namespace gaitwright
