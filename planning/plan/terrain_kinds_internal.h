// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright::terrain {

// One struct for each built-in ground with its parameters. The constructor sets values that suit a robot; options may
// change them. Build() throws InvalidArgument for parameters that are each in range but do not fit together.

/// Extent of the level ground beside a pit [m].
inline constexpr double kLevelReach = 20.0;

struct FlatGround {
  double friction = 0.8;

  explicit FlatGround(const TerrainScale&) {}
  OptionFields Fields();
  Terrain Build() const;
};

/// Parameters of a feature that the robot walks over or past.
struct Feature {
  double start_m, width_m;
  double friction = 0.8;

  explicit Feature(const TerrainScale& scale);
  /// These fields, with those of the kind of ground in between.
  OptionFields With(OptionFields own);
};

struct SlopeGround : Feature {
  double angle_deg = 5.0;
  double length_m, plateau_m;

  explicit SlopeGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct RampGround : Feature {
  double angle_deg = 5.0;
  double length_m;

  explicit RampGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct StairsGround : Feature {
  double rise_m, tread_m, landing_m;
  int count = 3;

  explicit StairsGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct BlockGround : Feature {
  double height_m, length_m;

  explicit BlockGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct GapGround {
  double start_m, width_m;
  double friction = 0.8;

  explicit GapGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct StonesGround {
  double start_m, size_m, spacing_m, jitter_m, height_jitter_m;
  int count = 8, rows;
  int seed = 1;
  double friction = 0.8;

  explicit StonesGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct BeamGround {
  double start_m, width_m, length_m;
  double friction = 0.8;

  explicit BeamGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct CinderGround {
  double start_m, block_m, height_m;
  double tilt_deg = 5.0;
  int count = 6, rows;
  int seed = 1;
  double friction = 0.8;

  explicit CinderGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct RoughGround : Feature {
  double amplitude_m, wavelength_m, length_m, resolution_m;
  int seed = 1;

  explicit RoughGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

/// Parameters of walls on level ground.
struct Walls {
  double start_m, passage_m, height_m, thickness_m;
  double friction = 0.8;

  Walls(const TerrainScale& scale, double passage);
  OptionFields With(OptionFields own);
};

struct CorridorGround : Walls {
  double length_m;

  explicit CorridorGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct DoorwayGround : Walls {
  double lintel_m, length_m, offset_m = 0.0;

  explicit DoorwayGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

struct MazeGround : Walls {
  int columns = 5, rows = 5;
  int seed = 1;

  explicit MazeGround(const TerrainScale& scale);
  OptionFields Fields();
  Terrain Build() const;
};

/// Rounds to two significant digits, so that sizes derived from a robot are easy to read and to write down.
double Readable(double value);

OptionField StartField(double* start_m);
OptionField FrictionField(double* friction);
OptionField SeedField(int* seed);
OptionField AngleField(double* angle_deg, const std::string& meaning);
/// A length from 1 mm to `highest`.
OptionField LengthField(const std::string& key, double* target, double highest, const std::string& meaning);

/// A rectangle in plan view.
struct Rectangle {
  double x0, x1, y0, y1;
};

/// A rectangle across the x axis, symmetric to it.
Rectangle Across(double x0, double x1, double width);

/// A patch over a rectangle; its height is z0 at x0 and z1 at x1.
TerrainPatch PatchOver(const std::string& name, const Rectangle& area, double z0, double z1, double friction);

/// Level ground at z = 0 up to `start` and from `end` on, without ground between them.
std::vector<TerrainPatch> LevelBanks(const std::string& what, double start, double end, double friction);

/// A box on height z0 with its edges along the axes of W.
Obstacle BoxOver(const std::string& name, const Rectangle& area, double z0, double z1);

}  // namespace gaitwright::terrain
