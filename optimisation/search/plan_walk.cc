// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/plan_walk.h"

#include <filesystem>

#include "kinematics/base/cpu_clock.h"
#include "optimisation/search/plan_parts.h"
#include "optimisation/search/plan_within.h"
#include "planning/footsteps/uneven_footsteps.h"
#include "planning/gait/read_sequence.h"
#include "planning/terrain/load_terrain.h"

namespace gaitwright {
namespace {

/// A distance becomes strides of the gait's default length, if it has one. Errors of the gait are reported later by
/// planning.
WalkCommand InOwnStrides(const RobotModel& model, const WalkRequest& request, const std::string& name,
                         const WalkCommand& command) {
  const Result<Gait> gait = FindGait(model, name, CommandedSpeed(model, command), request.gait_options);
  const Result<double> stride_m = OwnStride(model, name);
  return gait && stride_m ? CountedByStride(*gait, *stride_m, command) : command;
}

Result<PlannedWalk> PlanAsked(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                              SearchTrace* trace) {
  if (request.sequence.empty()) {
    WalkRequest in_strides = request;
    in_strides.command = InOwnStrides(model, request, request.gait, request.command);
    return PlanWithin(model, terrain, in_strides, trace);
  }
  Result<std::vector<AskedPart>> parts = ReadSequence(request.sequence);
  if (!parts) return parts.failure();
  for (AskedPart& part : *parts) {
    if (!part.stands()) part.command = InOwnStrides(model, request, part.gait, part.command);
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
  Result<PlannedWalk> planned = PlanAsked(model, terrain, request, trace);
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
