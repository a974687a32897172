// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/built_in_terrain.h"

#include <fmt/format.h>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "planning/plan/terrain_kinds_internal.h"
#include "planning/plan/terrain_spec.h"

namespace gaitwright {
namespace {

/// A ground, and the values of its parameters as text.
struct Made {
  Terrain terrain;
  std::vector<TerrainParameter> parameters;
};

std::vector<TerrainParameter> ParametersOf(const OptionFields& fields) {
  std::vector<TerrainParameter> parameters;
  for (const OptionField& field : fields)
    parameters.push_back({field.key, field.unit, field.lowest, field.highest, field.meaning, OptionText(field)});
  return parameters;
}

/// @throws InvalidArgument for wrong parameters.
template <class Ground>
Made Make(const TerrainScale& scale, const OptionTexts& texts) {
  Ground ground(scale);
  OptionFields fields = ground.Fields();
  for (const auto& [key, text] : texts) SetOption(fields, key, text);
  return {ground.Build(), ParametersOf(fields)};
}

struct Kind {
  BuiltInTerrain entry;
  Made (*make)(const TerrainScale& scale, const OptionTexts& texts);
};

const std::vector<Kind>& Kinds() {
  static const std::vector<Kind> kinds = {
      {{"flat", "infinite level ground"}, Make<terrain::FlatGround>},
      {{"slope", "a slope up, a plateau and a slope down"}, Make<terrain::SlopeGround>},
      {{"stairs", "stairs up, a landing and stairs down"}, Make<terrain::StairsGround>},
      {{"block", "a block to step onto and off"}, Make<terrain::BlockGround>},
      {{"gap", "a bottomless trench across the path"}, Make<terrain::GapGround>},
      {{"stepping-stones", "stepping stones above a pit, at random offsets"}, Make<terrain::StonesGround>},
      {{"beam", "a beam above a pit"}, Make<terrain::BeamGround>},
      {{"rough", "smooth random bumps and hollows"}, Make<terrain::RoughGround>},
      {{"cinder-blocks", "blocks one or two layers high, randomly tilted"}, Make<terrain::CinderGround>},
      {{"ramp", "a ramp up to high ground"}, Make<terrain::RampGround>},
      {{"corridor", "a corridor between two walls"}, Make<terrain::CorridorGround>},
      {{"doorway", "a wall with a doorway under a lintel"}, Make<terrain::DoorwayGround>},
      {{"maze", "a random maze of walls with one route through"}, Make<terrain::MazeGround>}};
  return kinds;
}

Failure RefusedTerrain(FailureCode code, const std::string& message) {
  return {FailureKind::kBadInput, code, "MakeTerrain", message, {"'gaitwright terrains' lists grounds and parameters"}};
}

Result<Made> MakeFrom(const std::string& spec, const TerrainScale& scale) {
  const std::size_t colon = spec.find(':');
  const std::string name = spec.substr(0, colon);
  std::vector<std::string> names;
  for (const Kind& kind : Kinds()) {
    names.push_back(kind.entry.name);
    if (kind.entry.name != name) continue;
    try {
      Made made =
          kind.make(scale, colon == std::string::npos ? OptionTexts{} : ParseParameters(spec.substr(colon + 1)));
      made.terrain.name = spec;
      return made;
    } catch (const InvalidArgument& error) {
      return RefusedTerrain(FailureCode::kTerrainParameter, fmt::format("terrain '{}': {}", name, error.what()));
    }
  }
  return RefusedTerrain(FailureCode::kUnknownTerrain, fmt::format("there is no terrain '{}'{}; accepted: {}", name,
                                                                  NearestHint(name, names), QuotedList(names)));
}

}  // namespace

const std::vector<BuiltInTerrain>& BuiltInTerrains() {
  static const std::vector<BuiltInTerrain> list = [] {
    std::vector<BuiltInTerrain> entries;
    for (const Kind& kind : Kinds()) entries.push_back(kind.entry);
    return entries;
  }();
  return list;
}

Result<std::vector<TerrainParameter>> TerrainParameters(const std::string& spec, const TerrainScale& scale) {
  Result<Made> made = MakeFrom(spec, scale);
  if (!made) return made.failure();
  return std::move(made->parameters);
}

Result<Terrain> MakeTerrain(const std::string& spec, const TerrainScale& scale) {
  Result<Made> made = MakeFrom(spec, scale);
  if (!made) return made.failure();
  return std::move(made->terrain);
}

}  // namespace gaitwright
