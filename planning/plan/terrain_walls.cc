// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planning/plan/terrain_kinds_internal.h"

namespace gaitwright::terrain {

Walls::Walls(const TerrainScale& scale, double passage)
    : start_m(Feature(scale).start_m),
      passage_m(Readable(passage)),
      height_m(Readable(1.2 * scale.body_height_m)),
      thickness_m(Readable(0.2 * scale.leg_length_m)) {}

OptionFields Walls::With(OptionFields own) {
  OptionFields fields = {
      StartField(&start_m), LengthField("passage_m", &passage_m, 20.0, "Clear width of the passage."),
      LengthField("height_m", &height_m, 10.0, "Height of the walls; for a doorway, its clear height."),
      LengthField("thickness_m", &thickness_m, 5.0, "Thickness of the walls.")};
  fields.insert(fields.end(), own.begin(), own.end());
  fields.push_back(FrictionField(&friction));
  return fields;
}

CorridorGround::CorridorGround(const TerrainScale& scale)
    : Walls(scale, 1.8 * scale.body_width_m), length_m(Readable(4.0 * scale.body_length_m)) {}

OptionFields CorridorGround::Fields() {
  return With({LengthField("length_m", &length_m, 100.0, "Length of the corridor along the x axis.")});
}

Terrain CorridorGround::Build() const {
  const double end = start_m + length_m, inner = 0.5 * passage_m, outer = inner + thickness_m;
  Terrain terrain = FlatTerrain(friction);
  terrain.obstacles = {BoxOver("left wall", {start_m, end, inner, outer}, 0.0, height_m),
                       BoxOver("right wall", {start_m, end, -outer, -inner}, 0.0, height_m)};
  return terrain;
}

DoorwayGround::DoorwayGround(const TerrainScale& scale)
    : Walls(scale, 1.6 * scale.body_width_m),
      lintel_m(Readable(0.3 * scale.body_height_m)),
      length_m(Readable(8.0 * std::max(scale.body_length_m, scale.body_width_m))) {
  height_m = Readable(1.3 * scale.body_height_m);
}

OptionFields DoorwayGround::Fields() {
  return With({LengthField("lintel_m", &lintel_m, 10.0, "Height of the wall above the doorway."),
               LengthField("length_m", &length_m, 100.0, "Length of the whole wall along the y axis."),
               {"offset_m", &offset_m, "m", -50.0, 50.0, "Lateral offset of the doorway; positive is to the left."}});
}

Terrain DoorwayGround::Build() const {
  const double half = 0.5 * length_m, right = offset_m - 0.5 * passage_m, left = offset_m + 0.5 * passage_m;
  if (!(right > -half && left < half)) {
    throw InvalidArgument(fmt::format("a doorway of passage_m {} at offset_m {} is not within a wall of length_m {}",
                                      passage_m, offset_m, length_m));
  }
  const double end = start_m + thickness_m, top = height_m + lintel_m;
  Terrain terrain = FlatTerrain(friction);
  terrain.obstacles = {BoxOver("wall left of the door", {start_m, end, left, half}, 0.0, top),
                       BoxOver("wall right of the door", {start_m, end, -half, right}, 0.0, top),
                       BoxOver("lintel", {start_m, end, right, left}, height_m, top)};
  return terrain;
}

}  // namespace gaitwright::terrain
