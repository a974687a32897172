// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/plan_walk.h"

#include <filesystem>

#include "kinematics/base/cpu_clock.h"
#include "kinematics/ik/leg_workspace.h"
#include "optimisation/pipeline/options_of_robot_internal.h"
#include "optimisation/search/plan_parts.h"
#include "optimisation/search/plan_turn_internal.h"
#include "optimisation/search/plan_within.h"
#include "optimisation/search/refuse_walk.h"
#include "planning/footsteps/uneven_footsteps.h"
#include "planning/gait/read_sequence.h"
#include "planning/terrain/load_terrain.h"

namespace gaitwright {
namespace {

/// Least number of strides of a gait that limits them (OwnStride), for a command without a speed; otherwise 0. Errors
/// of the gait are reported later by planning.
int LeastStridesOf(const RobotModel& model, const std::string& gait, const WalkCommand& command) {
  const Result<double> stride_m = OwnStride(model, gait);
  return stride_m ? LeastStrides(*stride_m, command) : 0;
}

/// Whether the body turns over in a gait. Errors of the gait are reported later by planning.
bool TurnsOver(const RobotModel& model, const std::string& gait) {
  const Result<std::optional<std::array<double, 2>>> travel_m = OwnTravel(model, gait);
  return travel_m && travel_m->has_value();
}

Result<PlannedWalk> PlanAsked(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                              SearchTrace* trace) {
  if (request.sequence.empty()) {
    if (TurnsOver(model, request.gait)) return PlanTurn(model, terrain, request, trace);
    const int strides = LeastStridesOf(model, request.gait, request.command);
    return strides > 0 ? PlanInFewestStrides(model, terrain, request, strides, trace)
                       : PlanWithin(model, terrain, request, trace);
  }
  Result<std::vector<AskedPart>> parts = ReadSequence(request.sequence);
  if (!parts) return parts.failure();
  for (std::size_t k = 0; k < parts->size(); ++k) {
    AskedPart& part = (*parts)[k];
    const int strides = part.stands() ? 0 : LeastStridesOf(model, part.gait, part.command);
    if (strides == 0) continue;
    WalkRequest alone = request;
    alone.sequence.clear();
    alone.gait = part.gait;
    alone.command = part.command;
    const Result<PlannedWalk> planned = PlanInFewestStrides(model, terrain, alone, strides, trace);
    if (!planned) return OfPart(k, part.gait, planned.failure());
    part.command = planned->motion.plan.parts.front().command;
  }
  return PlanPartsWithin(model, terrain, request, *parts, trace);
}

}  // namespace

OptionFields RequestFields(WalkRequest& request) {
  const auto file_name = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
  if (!request.gait.empty()) request.gait = file_name(request.gait);
  request.terrain = file_name(request.terrain);
  if (!SequenceFileOf(request.sequence).empty()) request.sequence = file_name(request.sequence);
  return Joined({{{"gait", &request.gait, "", 0.0, 0.0, "Requested gait; empty for the robot's best gait."},
                  {"terrain", &request.terrain, "", 0.0, 0.0, "Requested ground."},
                  {"sequence", &request.sequence, "", 0.0, 0.0, "Requested parts; empty for a single part."}},
                 request.Fields()});
}

Result<PlannedWalk> PlanWalk(const RobotModel& model, const WalkRequest& request, SearchTrace* trace) {
  const CpuClock clock;
  WalkRequest checked = request;
  CheckOptions(checked.Fields());
  const Result<Terrain> terrain = LoadTerrain(request.terrain, ScaleOf(model));
  if (!terrain) return terrain.failure();
  Result<PlannedWalk> planned = PlanWalkOn(model, *terrain, request, trace);
  if (planned) planned->planning_cpu_s = clock.elapsed_s();
  return planned;
}

Result<PlannedWalk> PlanWalkOn(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                               SearchTrace* trace) {
  const CpuClock clock;
  WalkRequest checked = request;
  CheckOptions(checked.Fields());
  checked.motion = OptionsOf(model, checked.motion);
  checked.motion.footsteps.search.workspaces = std::make_shared<LegWorkspaces>();
  Result<PlannedWalk> planned = PlanAsked(model, terrain, checked, trace);
  if (!planned) return planned;
  Provenance& provenance = planned->motion.plan.provenance;
  for (const auto& [key, value] : provenance.options) {
    if (key == "footholds") checked.motion.footholds = value;  // other footholds than requested may have been used
  }
  provenance.seed = request.seed;
  provenance.options = TextsOf(RequestFields(checked));
  planned->planning_cpu_s = clock.elapsed_s();
  return planned;
}

}  // namespace gaitwright
