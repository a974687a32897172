// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf.h"

#include <fmt/format.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/description/mjcf_keyframe_internal.h"
#include "kinematics/description/mjcf_others_internal.h"
#include "kinematics/description/mjcf_tendons_internal.h"
#include "kinematics/description/mjcf_write_internal.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestMjcfFile = std::size_t{16} << 20;  // [byte]

/// Inertias and shapes of the robot's bodies.
void ReadMjcfBodies(MjcfContext& context, const MjcfMeshAssets& assets, MjcfRobot& robot) {
  const std::set<std::string> paired = MjcfPairedGeoms(context);
  const std::size_t count = robot.tree.bodies.size();
  robot.inertias.resize(count);
  robot.collision.resize(count);
  robot.visual.resize(count);
  MjcfInertias inertias(context, assets);
  std::vector<std::vector<MjcfGeom>> geoms_of(count);
  for (std::size_t b = 0; b < count; ++b) {
    if (robot.tree.in_robot[b]) geoms_of[b] = ReadMjcfGeoms(context, robot.tree.bodies[b], paired);
  }
  LetHiddenMjcfGeomsCollide(context, geoms_of);
  for (std::size_t b = 0; b < count; ++b) {
    if (!robot.tree.in_robot[b]) continue;
    const std::vector<MjcfGeom>& geoms = geoms_of[b];
    robot.inertias[b] = inertias.Of(robot.tree.bodies[b], geoms);
    for (const MjcfGeom& geom : geoms) {
      if (!geom.collides && !geom.is_shown) continue;
      const std::optional<MjcfUrdfShape> shape = ShapeOfMjcfGeom(context, geom, assets);
      if (shape && geom.collides) robot.collision[b].push_back(*shape);
      if (shape && geom.is_shown) robot.visual[b].push_back(*shape);
    }
  }
}

/// Scales masses and inertias to the total mass of <compiler>, if it gives one.
void SetMjcfTotalMass(MjcfContext& context, MjcfRobot& robot) {
  double total = 0.0;
  for (const MjcfInertia& inertia : robot.inertias) total += inertia.mass;
  if (!(context.compiler.settotalmass > 0.0) || !(total > 0.0)) return;
  const double scale = context.compiler.settotalmass / total;
  for (MjcfInertia& inertia : robot.inertias) {
    inertia.mass *= scale;
    inertia.I_C *= scale;
  }
}

std::string NameOfMjcf(const MjcfContext& context) {
  MjcfAttributes::Values values;
  if (const char* name = context.document.root().Attribute("model")) values["model"] = name;
  return MjcfAttributes(context.document.Owner(context.document.root()), values).Name("model");
}

ConvertedMjcf ConvertMjcfOrThrow(const std::string& text, const MjcfFiles& files, const std::string& name) {
  MjcfContext context(text, files, name);
  MjcfRobot robot;
  robot.name = NameOfMjcf(context);
  robot.tree = ReadMjcfTree(context);
  MjcfMeshAssets assets = ReadMjcfMeshes(context);
  ReadMjcfBodies(context, assets, robot);
  SetMjcfTotalMass(context, robot);
  robot.drives = ReadMjcfDrives(context, robot.tree);
  DriveMjcfJointsByTendons(context, robot.tree, robot.drives);
  std::vector<double> masses;
  for (const MjcfInertia& inertia : robot.inertias) masses.push_back(inertia.mass);
  robot.couplings = ReadMjcfCouplings(context, robot.tree, robot.drives, masses);
  std::vector<bool> follows;
  for (const MjcfCoupling& coupling : robot.couplings) follows.push_back(!coupling.moves_alone());
  robot.efforts = MjcfEfforts(context, robot.tree, robot.drives, follows);
  for (std::size_t j = 0; j < robot.couplings.size(); ++j) {
    const MjcfJoint& joint = robot.tree.joints[j];
    if (robot.couplings[j].leader >= 0 && joint.armature > 0.0)
      context.Note(joint.owner, "it follows another joint; its armature is left out");
  }
  robot.posture = ReadMjcfPosture(context, robot.tree, robot.couplings);
  NoteMjcfOthers(context);
  ConvertedMjcf converted;
  converted.urdf = WriteMjcfUrdf(robot);
  converted.yaml = WriteMjcfYaml(robot);
  robot.posture.clear();
  converted.yaml_without_posture = WriteMjcfYaml(robot);
  for (auto& [label, asset] : assets) {
    if (!asset.inner.vertices.empty()) converted.meshes.push_back({asset.file, std::move(asset.inner)});
  }
  converted.notes = std::move(context.notes);
  return converted;
}

}  // namespace

bool IsMjcf(const std::string& text) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while (true) {
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == std::string::npos || text[at] != '<') return false;
    const bool is_comment = text.compare(at, 4, "<!--") == 0;
    if (!is_comment && text[at + 1] != '?' && text[at + 1] != '!') break;
    const std::size_t end = text.find(is_comment ? "-->" : ">", at);
    if (end == std::string::npos) return false;
    at = end + (is_comment ? 3 : 1);
  }
  const std::string name = text.substr(at + 1, text.find_first_of(" \t\r\n/>", at) - at - 1);
  return name == "mujoco" || name == "mujocoinclude";
}

Result<ConvertedMjcf> ConvertMjcfText(const std::string& text, const MjcfFiles& files, const std::string& name) {
  try {
    ConvertedMjcf converted = ConvertMjcfOrThrow(text, files, name);
    if (!IsMjcf(text)) {
      return Failure{FailureKind::kBadInput,
                     FailureCode::kNotMjcf,
                     "LoadRobot",
                     fmt::format("{}: it is not a MuJoCo model, because its root element is not <mujoco>", name),
                     {}};
    }
    return converted;
  } catch (const Failure& failure) {
    return failure;
  }
}

Result<ConvertedMjcf> ConvertMjcf(const std::string& path, const MjcfMeshReader& read_mesh) {
  const Result<std::string> text = ReadFile(path, kLargestMjcfFile);
  if (!text) return text.failure();
  const fs::path folder = fs::path(path).parent_path();
  MjcfFiles files;
  files.text = [&](const std::string& file) { return ReadFile((folder / file).string(), kLargestMjcfFile); };
  files.mesh = read_mesh;
  return ConvertMjcfText(*text, files, fs::path(path).filename().string());
}

}  // namespace gaitwright
