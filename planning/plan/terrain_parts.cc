// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "planning/plan/terrain_kinds_internal.h"

namespace gaitwright::terrain {

double Readable(double value) {
  if (!(value > 0.0)) return value;
  const double unit = std::pow(10.0, 1 - static_cast<int>(std::floor(std::log10(value))));
  return std::round(value * unit) / unit;
}

OptionField LengthField(const std::string& key, double* target, double highest, const std::string& meaning) {
  return {key, target, "m", 0.001, highest, meaning};
}

OptionField StartField(double* start_m) {
  return {"start_m", start_m,
          "m",       -100.0,
          100.0,     "Distance along the x axis from the robot's base at the start to the start of the feature."};
}

OptionField FrictionField(double* friction) {
  return {"friction", friction, "1", 0.01, 5.0, "Friction coefficient of the ground."};
}

OptionField SeedField(int* seed) {
  return {"seed", seed, "1", 0, 1000000000, "Seed of the random numbers that draw this terrain."};
}

OptionField AngleField(double* angle_deg, const std::string& meaning) {
  return {"angle_deg", angle_deg, "deg", 0.1, 45.0, meaning};
}

Feature::Feature(const TerrainScale& scale)
    : start_m(Readable(scale.front_m + scale.body_length_m)), width_m(Readable(5.0 * scale.body_length_m)) {}

OptionFields Feature::With(OptionFields own) {
  own.insert(own.begin(), StartField(&start_m));
  own.push_back(LengthField("width_m", &width_m, 100.0, "Width of the feature along the y axis."));
  own.push_back(FrictionField(&friction));
  return own;
}

Rectangle Across(double x0, double x1, double width) { return {x0, x1, -0.5 * width, 0.5 * width}; }

TerrainPatch PatchOver(const std::string& name, const Rectangle& area, double z0, double z1, double friction) {
  return PatchThrough(
      name, {{area.x0, area.y0, z0}, {area.x1, area.y0, z1}, {area.x1, area.y1, z1}, {area.x0, area.y1, z0}}, friction);
}

std::vector<TerrainPatch> LevelBanks(const std::string& what, double start, double end, double friction) {
  const double side = 2.0 * kLevelReach;
  return {PatchOver("ground before the " + what, Across(start - kLevelReach, start, side), 0.0, 0.0, friction),
          PatchOver("ground beyond the " + what, Across(end, end + kLevelReach, side), 0.0, 0.0, friction)};
}

Obstacle BoxOver(const std::string& name, const Rectangle& area, double z0, double z1) {
  Obstacle box;
  box.name = name;
  box.X_WO.translation() << 0.5 * (area.x0 + area.x1), 0.5 * (area.y0 + area.y1), 0.5 * (z0 + z1);
  box.size_m << area.x1 - area.x0, area.y1 - area.y0, z1 - z0;
  return box;
}

}  // namespace gaitwright::terrain
