// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "kinematics/model/load_robot.h"
#include "planning/audit/start_posture.h"
#include "planning/gait/load_gaits.h"
#include "planning/gait/read_sequence.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/plan_json.h"
#include "planning/terrain/height_map.h"
#include "planning/terrain/load_terrain.h"
#include "planning/terrain/mesh_terrain.h"
#include "tests/fuzz/inputs.h"
#include "tests/fuzz/plan_laws.h"
#include "tests/fuzz/reader.h"
#include "tests/planning/terrain/made_png.h"

namespace gaitwright::fuzz {
namespace {

Verdict Ground(const Result<Terrain>& terrain) {
  if (!terrain) return Verdict::kRefused;
  CheckTerrainLaws(*terrain);
  return Verdict::kAccepted;
}

Verdict ReadGaits(const std::string& input) {
  const Result<std::vector<GaitEntry>> gaits = LoadGaits(InFile(input, ".yaml"));
  if (!gaits) return Verdict::kRefused;
  Require(!gaits->empty(), "a file of gaits is not empty");
  for (const GaitEntry& entry : *gaits) {
    CheckGaitLaws(entry.gait);
    Require((entry.gait.cycle_s > 0.0) != (entry.cycle_per_leg_time > 0.0), "a cycle time is given in exactly one way");
    Require(!HasFlight(entry.gait) || !StandsStill(entry.gait), "a gait with flight does not stand still");
  }
  return Verdict::kAccepted;
}

Verdict Sequence(const std::string& text) {
  const Result<std::vector<AskedPart>> parts = ReadSequence(text);
  if (!parts) return Verdict::kRefused;
  Require(!parts->empty(), "a sequence has parts");
  for (const AskedPart& part : *parts) {
    const WalkCommand& c = part.command;
    Require(
        std::abs(c.speed_m_s) <= 50.0 && std::abs(c.lateral_speed_m_s) <= 50.0 && std::abs(c.yaw_rate_rad_s) <= 50.0,
        "speeds are in their range");
    Require(c.distance_m >= 0.0 && c.distance_m <= 1e4 && c.duration_s >= 0.0 && c.duration_s <= 600.0 &&
                c.steps >= 0 && std::abs(c.step_length_m) <= 10.0,
            "requested values are in their ranges");
  }
  return Verdict::kAccepted;
}
Verdict ReadSequenceText(const std::string& input) {
  return SequenceFileOf(input).empty() ? Sequence(input) : Verdict::kRefused;
}
Verdict ReadSequenceFile(const std::string& input) { return Sequence(InFile(input, ".yaml")); }

Verdict ReadTerrainSpec(const std::string& input) { return Ground(MakeTerrain(input, {})); }
Verdict ReadTerrainFile(const std::string& input) { return Ground(LoadTerrain(InFile(input, ".yaml"), {})); }

Verdict HeightMap(const std::string& path) {
  HeightMapOptions options;
  options.resolution_m = 0.05;
  options.scale_m = 0.5;
  const Result<HeightField> field = ReadHeightMap(path, options);
  return field ? Ground(Terrain{"", {}, {*field}, {}}) : Verdict::kRefused;
}
Verdict ReadCsv(const std::string& input) { return HeightMap(InFile(input, ".csv")); }
Verdict ReadPng(const std::string& input) { return HeightMap(InFile(input, ".png")); }

/// A mesh as ground; the reader mesh_obj tests the mesh format.
Verdict ReadMeshGround(const std::string& input) {
  const Result<Mesh> mesh = ReadMesh(InFile(input, ".obj"));
  if (!mesh) return Verdict::kRefused;
  MeshTerrainOptions options;
  options.resolution_m = 0.05;
  return Ground(TerrainFromMesh(*mesh, options, "input.obj"));
}

Verdict ReadStartPosture(const std::string& input) {
  static const RobotModel model = *LoadNamedRobot("a1");
  constexpr double kRounding = 1.1e-6;
  const Result<StartPosture> posture = StartPostureFromYaml(input, "input", model);
  if (!posture) return Verdict::kRefused;
  Require(posture->joints.size() == model.num_dofs(), "every joint has a position");
  for (int d = 0; d < model.num_dofs(); ++d) {
    const double q = posture->joints[d];
    Require(q >= model.dof_lower(d) - kRounding && q <= model.dof_upper(d) + kRounding,
            "joints are within their limits");
  }
  if (posture->R_WB) Require(std::abs(posture->R_WB->norm() - 1.0) < 1e-9, "quaternions have length 1");
  return Verdict::kAccepted;
}

Verdict ReadPlanFile(const std::string& input) {
  const Result<MotionPlan> plan = PlanFromJson(input, "input");
  if (!plan) return Verdict::kRefused;
  CheckPlanLaws(*plan);
  return Verdict::kAccepted;
}

std::vector<std::string> MadePlans() {
  MotionPlan bare = SmallPlan();
  bare.urdf_text = "";
  bare.meshes.clear();
  MotionPlan gated = SmallPlan();
  gated.gates = {{0.5 * (gated.whole_body.start_s + gated.whole_body.end_s()), "lift", 0.2, 1, 1.5}};
  return {PlanToJson(SmallPlan()), PlanToJson(bare), PlanToJson(gated)};
}

std::vector<std::string> MadePictures() {
  const std::string grey(12, '\x40'), wide(24, '\x11');
  return {made_png::Png(4, 3, 8, 0, grey), made_png::Png(4, 3, 16, 0, wide), made_png::Png(2, 2, 8, 2, grey)};
}

const std::vector<std::string> kYaml = {"&a", "*a", "---", "{",       "}", "[",    "]",
                                        ": ", "- ", "'",   "\"\\0\"", "~", ".nan", "|"};

std::vector<std::string> WithYaml(std::vector<std::string> words) {
  words.insert(words.end(), kYaml.begin(), kYaml.end());
  return words;
}

}  // namespace

const std::vector<Reader>& Readers() {
  static const std::vector<Reader> readers = {
      {"gaits",
       ReadGaits,
       WithYaml({"feet", "description", "cycle_s", "cycle_per_leg_time", "duty_factor", "phase", "stride_per_leg"}),
       {"planning/gait/gaits.yaml"}},
      {"sequence_text",
       ReadSequenceText,
       {"trot", "stand", "walk", ": ", "; ",
        "speed=", "lateral-speed=", "yaw-rate=", "distance=", "duration=", "steps=", "step-length=", ".yaml"},
       {}},
      {"sequence_file",
       ReadSequenceFile,
       WithYaml({"gait", "speed", "lateral-speed", "yaw-rate", "distance", "duration", "steps", "step-length"}),
       {}},
      {"terrain_spec",
       ReadTerrainSpec,
       {"flat",
        "slope",
        "stairs",
        "block",
        "gap",
        "stepping-stones",
        "beam",
        "rough",
        "cinder-blocks",
        "ramp",
        "corridor",
        "doorway",
        "maze",
        "start_m=",
        "width_m=",
        "length_m=",
        "rise_m=",
        "tread_m=",
        "count=",
        "rows=",
        "columns=",
        "resolution_m=",
        "wavelength_m=",
        "amplitude_m=",
        "seed=",
        "angle_deg=",
        "jitter_m=",
        "friction=",
        ","},
       {},
       nullptr,
       500},
      {"terrain_yaml",
       ReadTerrainFile,
       WithYaml({"builtin",    "files",           "patches",  "height_fields", "obstacles", "name", "corners_m",
                 "height_m",   "friction",        "origin_m", "resolution_m",  "heights_m", "type", "size_m",
                 "vertices_m", "position_m",      "yaw_deg",  "box",           "cylinder",  "mesh", "stairs:count=2",
                 "/dev/zero",  "a.png:scale_m=1", "markers",  "place_m"}),
       {}},
      {"height_csv", ReadCsv, {",", "\n", "#", "0.1,0.2\n", "\r\n", "+1", " "}, {}},
      {"height_png",
       ReadPng,
       {"IHDR", "IDAT", "IEND", "PLTE", "tRNS", "zTXt", "iCCP", std::string("\0\0\xff\xff", 4)},
       {},
       MadePictures},
      {"mesh_ground", ReadMeshGround, {"v 1 2 3\n", "f 1 2 3\n", "f 1 2 3 4\n", "v 0 0 1e3\n"}, {}, nullptr, 500},
      {"start_posture",
       ReadStartPosture,
       WithYaml({"joints", "base_quaternion_xyzw", "FR_hip_joint", "FL_thigh_joint", "RL_calf_joint", "[0, 0, 0, 1]"}),
       {}},
      {"plan",
       ReadPlanFile,
       {"null",
        "true",
        "{}",
        "[]",
        "\"\"",
        "-1",
        "1e400",
        "\"schema\"",
        "\"parts\"",
        "\"footholds\"",
        "\"swings\"",
        "\"patches\"",
        "\"height_fields\"",
        "\"obstacles\"",
        "\"mesh\"",
        "\"gates\"",
        "\"markers\"",
        "\"box\"",
        "\"vertices_m\"",
        "\"detour_m\"",
        "\\u0000",
        "\"clearance_m\":null",
        "\"cruise\"",
        "\"stand\"",
        "[0,0,0,0,0,0,1]"},
       {},
       MadePlans,
       500}};
  return readers;
}

}  // namespace gaitwright::fuzz
