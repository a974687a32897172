// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planning/plan/terrain_kinds_internal.h"

namespace gaitwright::terrain {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Length for the whole robot to stand on: more than one body length, and enough for a stride.
double Landing(const TerrainScale& scale) {
  return Readable(std::max(1.2 * scale.body_length_m, 2.5 * scale.foot_length_m));
}

}  // namespace

OptionFields FlatGround::Fields() { return {FrictionField(&friction)}; }

Terrain FlatGround::Build() const { return FlatTerrain(friction); }

SlopeGround::SlopeGround(const TerrainScale& scale)
    : Feature(scale), length_m(Readable(2.0 * scale.body_length_m)), plateau_m(Landing(scale)) {}

OptionFields SlopeGround::Fields() {
  return With({AngleField(&angle_deg, "Inclination of both slopes."),
               LengthField("length_m", &length_m, 100.0, "Length of each slope in plan view."),
               LengthField("plateau_m", &plateau_m, 100.0, "Length of the level plateau between the slopes.")});
}

Terrain SlopeGround::Build() const {
  const double rise = length_m * std::tan(angle_deg * kDegree);
  const double top = start_m + length_m, down = top + plateau_m;
  Terrain terrain = FlatTerrain(friction);
  terrain.patches.push_back(PatchOver("slope up", Across(start_m, top, width_m), 0.0, rise, friction));
  terrain.patches.push_back(PatchOver("plateau", Across(top, down, width_m), rise, rise, friction));
  terrain.patches.push_back(PatchOver("slope down", Across(down, down + length_m, width_m), rise, 0.0, friction));
  return terrain;
}

RampGround::RampGround(const TerrainScale& scale) : Feature(scale), length_m(Readable(2.0 * scale.body_length_m)) {}

OptionFields RampGround::Fields() {
  return With({AngleField(&angle_deg, "Inclination of the ramp."),
               LengthField("length_m", &length_m, 100.0, "Length of the ramp in plan view.")});
}

Terrain RampGround::Build() const {
  const double rise = length_m * std::tan(angle_deg * kDegree), top = start_m + length_m;
  Terrain terrain = FlatTerrain(friction);
  terrain.patches.push_back(PatchOver("ramp", Across(start_m, top, width_m), 0.0, rise, friction));
  terrain.patches.push_back(PatchOver("high ground", Across(top, top + kLevelReach, width_m), rise, rise, friction));
  return terrain;
}

StairsGround::StairsGround(const TerrainScale& scale)
    : Feature(scale),
      rise_m(Readable(0.08 * scale.leg_length_m)),
      tread_m(Readable(std::max(1.2 * scale.foot_length_m, 0.6 * scale.leg_length_m))),
      landing_m(Landing(scale)) {}

OptionFields StairsGround::Fields() {
  return With(
      {LengthField("rise_m", &rise_m, 1.0, "Height of each step."),
       LengthField("tread_m", &tread_m, 5.0, "Depth of each step."),
       {"count", &count, "1", 1, 200, "Number of steps up, including the one onto the landing; as many lead down."},
       LengthField("landing_m", &landing_m, 100.0, "Length of the landing.")});
}

Terrain StairsGround::Build() const {
  Terrain terrain = FlatTerrain(friction);
  const auto add = [&](const std::string& name, double x0, double x1, int steps) {
    terrain.patches.push_back(PatchOver(name, Across(x0, x1, width_m), steps * rise_m, steps * rise_m, friction));
  };
  const double landing = start_m + (count - 1) * tread_m, down = landing + landing_m;
  for (int k = 1; k < count; ++k) add(fmt::format("step {}", k), start_m + (k - 1) * tread_m, start_m + k * tread_m, k);
  add(fmt::format("step {}", count), landing, down, count);
  for (int k = 1; k < count; ++k)
    add(fmt::format("step {} down", k), down + (k - 1) * tread_m, down + k * tread_m, count - k);
  return terrain;
}

BlockGround::BlockGround(const TerrainScale& scale)
    : Feature(scale), height_m(Readable(0.08 * scale.leg_length_m)), length_m(Landing(scale)) {}

OptionFields BlockGround::Fields() {
  return With({LengthField("height_m", &height_m, 1.0, "Height of the block's top above the ground."),
               LengthField("length_m", &length_m, 100.0, "Length of the block along the x axis.")});
}

Terrain BlockGround::Build() const {
  Terrain terrain = FlatTerrain(friction);
  terrain.patches.push_back(
      PatchOver("block", Across(start_m, start_m + length_m, width_m), height_m, height_m, friction));
  return terrain;
}

}  // namespace gaitwright::terrain
