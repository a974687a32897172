// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/program.h"
#include "planning/plan/built_in_terrain.h"

namespace gaitwright::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  Common common;
  std::string terrain;
};

int List(const Common& common) {
  Json list = Json::array();
  for (const BuiltInTerrain& entry : BuiltInTerrains()) {
    list.push_back({{"name", entry.name}, {"description", entry.description}});
    if (common.json) continue;
    common.quiet ? fmt::print("{}\n", entry.name) : fmt::print("{:<14} {}\n", entry.name, entry.description);
  }
  if (common.json) fmt::print("{}\n", Json{{"terrains", list}}.dump(2));
  return kPass;
}

/// The corners of a patch in W, as [x, y, z].
Json Corners(const TerrainPatch& patch) {
  Json corners = Json::array();
  for (const Vector2& corner_T : patch.outline_T) {
    const Vector3 p = patch.X_WT * Vector3(corner_T.x(), corner_T.y(), 0.0);
    corners.push_back({p.x(), p.y(), p.z()});
  }
  return corners;
}

Json PatchJson(const TerrainPatch& patch) {
  const Vector3 origin = patch.X_WT.translation(), normal = patch.X_WT.linear().col(2);
  return {{"name", patch.name},
          {"origin_m", {origin.x(), origin.y(), origin.z()}},
          {"normal", {normal.x(), normal.y(), normal.z()}},
          {"outline_m", Corners(patch)},
          {"friction", patch.friction}};
}

void PrintPatch(const TerrainPatch& patch) {
  const Vector3 origin = patch.X_WT.translation(), normal = patch.X_WT.linear().col(2);
  fmt::print("  {}: through ({:.3f}, {:.3f}, {:.3f}) m, normal ({:.3f}, {:.3f}, {:.3f}), {}, friction {}\n", patch.name,
             origin.x(), origin.y(), origin.z(), normal.x(), normal.y(), normal.z(),
             patch.outline_T.empty() ? "without end" : fmt::format("{} corners", patch.outline_T.size()),
             patch.friction);
}

int Show(const Arguments& a) {
  const Result<Terrain> terrain = MakeTerrain(a.terrain, {});
  if (!terrain) return Report(terrain.failure(), a.common);
  std::string description;
  for (const BuiltInTerrain& entry : BuiltInTerrains()) {
    if (entry.name == a.terrain) description = entry.description;
  }
  if (a.common.json) {
    Json patches = Json::array();
    for (const TerrainPatch& patch : terrain->patches) patches.push_back(PatchJson(patch));
    const Json json = {{"name", terrain->name}, {"description", description}, {"patches", patches}};
    fmt::print("{}\n", json.dump(2));
  } else if (a.common.quiet) {
    fmt::print("{}\n", terrain->name);
  } else {
    fmt::print("{}: {}\npatches, where they overlap the highest holds\n", terrain->name, description);
    for (const TerrainPatch& patch : terrain->patches) PrintPatch(patch);
  }
  return kPass;
}

}  // namespace

void AddTerrains(CLI::App& app, int& status) {
  auto a = std::make_shared<Arguments>();
  CLI::App& verb = *app.add_subcommand("terrains", "List the grounds; 'terrains show X' describes one");
  CLI::App& show = *verb.add_subcommand("show", "Describe one ground: its patches and their friction");
  AddText(show, "TERRAIN", "NAME", a->terrain, "A name of the list.")->required();
  AddCommon(verb, a->common, {"terrains", "terrains show flat"});
  AddCommon(show, a->common, {"terrains show flat"});
  verb.require_subcommand(0, 1);
  verb.callback([a, &status] {
    status = Guarded(a->common, [&] {
      ApplySets("--set", a->common.sets, {});
      return a->terrain.empty() ? List(a->common) : Show(*a);
    });
  });
}

}  // namespace gaitwright::cli
