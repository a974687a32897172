// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/load_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "kinematics/base/data_path.h"
#include "kinematics/base/file.h"
#include "kinematics/base/hash.h"
#include "kinematics/base/options.h"
#include "kinematics/description/mjcf.h"
#include "kinematics/model/apply_transmissions.h"
#include "kinematics/model/apply_yaml.h"
#include "kinematics/model/ball_joints.h"
#include "kinematics/model/build_model.h"
#include "kinematics/model/check_feet.h"
#include "kinematics/model/collision_meshes.h"
#include "kinematics/model/derive_legs.h"
#include "kinematics/model/inertia_box.h"
#include "kinematics/model/leg_plane.h"
#include "kinematics/model/mend_urdf.h"
#include "kinematics/model/mesh_file.h"
#include "kinematics/model/mesh_hulls_internal.h"
#include "kinematics/model/name_of_description.h"
#include "kinematics/model/reroot_urdf.h"
#include "kinematics/model/robot_yaml.h"
#include "kinematics/model/toe_joints.h"
#include "kinematics/model/urdf_check.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

Failure BadInput(FailureCode code, const std::string& message) {
  return {FailureKind::kBadInput, code, "LoadRobot", message, {}};
}

/// Hash of the texts and of the points of the meshes.
std::string RobotHash(const RobotModel& model) {
  std::string bytes = model.urdf_text + '\0' + model.yaml_text;
  for (const MeshHull& mesh : model.meshes) {
    bytes += '\0' + mesh.file + '\0';
    for (const Vector3& v : mesh.vertices) bytes.append(reinterpret_cast<const char*>(v.data()), sizeof(double) * 3);
  }
  return HexHash(bytes);
}

/// Removes the data of the robot.yaml for joints that were fixed because they move nothing or a toe.
void DropFixedJoints(const RobotModel& model, RobotYaml& yaml) {
  const auto is_fixed = [&](const auto& entry) {
    const RobotPart part{PartKind::kJoint, entry.joint};
    return std::any_of(model.findings.begin(), model.findings.end(), [&](const Finding& f) {
      return (f.code == FailureCode::kNoInertia || f.code == FailureCode::kToeHeld) && f.part == part;
    });
  };
  std::erase_if(yaml.limits, is_fixed);
  std::erase_if(yaml.standing, is_fixed);
  std::erase_if(yaml.gains, is_fixed);
  std::erase_if(yaml.motors, is_fixed);
}

/// The failure of a strict reader if a mesh was replaced or left out.
std::optional<Failure> RefusedMesh(const RobotModel& model) {
  for (const Finding& finding : model.findings) {
    if (finding.code != FailureCode::kMissingMesh || finding.level == FindingLevel::kInfo) continue;
    Failure failure = BadInput(finding.code, PartText(finding.part) + ": " + finding.message);
    failure.part = finding.part;
    return failure;
  }
  return std::nullopt;
}

/// The texts from which a robot is built.
struct RobotTexts {
  const std::string& urdf;
  const std::string& yaml;
  const std::string& name;
  bool strict;
};

/// A model with bodies and shapes only.
struct BuiltTree {
  RobotModel model;
  std::vector<MeshHull> meshes;
  std::vector<MissingMesh> missing;
};

Result<BuiltTree> BuildTree(const std::string& tree, const RobotTexts& texts, double scale, const MeshSource& source) {
  BuiltTree built;
  UrdfParts parts = SplitUrdf(tree, scale);
  built.meshes = FillMeshes(parts.collision, source, built.missing);
  for (const MissingMesh& mesh : built.missing) parts.incomplete.insert(mesh.link);
  Result<RobotModel> model = BuildModel(parts, texts.name, scale, texts.strict);
  if (!model) return model.failure();
  built.model = std::move(*model);
  return built;
}

/// Runs BuildTree. If legs end in feet of two links, runs it again with locked toes.
Result<BuiltTree> BuildWithToesHeld(const std::string& tree, const RobotTexts& texts, const RobotYaml& yaml,
                                    const MeshSource& source) {
  Result<BuiltTree> built = BuildTree(tree, texts, yaml.scale, source);
  if (!built || texts.strict || !yaml.feet.empty() || !yaml.transmissions.empty()) return built;
  RobotModel turned = built->model;
  ApplyAxes(yaml, turned);
  const std::vector<std::string> toes = ToeJoints(turned);
  if (toes.empty()) return built;
  built = BuildTree(WithFixedJoints(tree, toes), texts, yaml.scale, source);
  if (!built) return built;
  for (const std::string& toe : toes) {
    built->model.findings.push_back({FindingLevel::kInfo, FailureCode::kToeHeld, RobotPart{PartKind::kJoint, toe}, 0,
                                     "it moves a toe, which is locked here, so both links of the foot form one sole; "
                                     "name the feet in robot.yaml to let the toe move"});
  }
  return built;
}

Result<RobotModel> Load(const RobotTexts& texts, const MeshSource& source) {
  const MendedUrdf mended = texts.strict ? MendedUrdf{texts.urdf, {}} : MendUrdf(texts.urdf);
  if (const auto failure = CheckUrdf(mended.text, texts.strict)) return *failure;
  std::string tree = WithoutBallJoints(mended.text);
  std::optional<RerootedUrdf> rerooted;
  if (!texts.strict) rerooted = RerootFromLimbEnd(tree);
  if (rerooted) tree = rerooted->text;
  if (tree != mended.text) {
    if (const auto failure = CheckUrdf(tree)) return *failure;
  }
  RobotYaml yaml = ParseRobotYaml(texts.yaml);
  Result<BuiltTree> built = BuildWithToesHeld(tree, texts, yaml, source);
  if (!built) return built.failure();
  RobotModel model = std::move(built->model);
  std::vector<MeshHull> meshes = std::move(built->meshes);
  std::vector<MissingMesh> missing = std::move(built->missing);
  DropFixedJoints(model, yaml);
  model.findings.insert(model.findings.begin(), mended.findings.begin(), mended.findings.end());
  if (rerooted) {
    model.findings.push_back(
        {FindingLevel::kInfo, FailureCode::kRootOfLimb, RobotPart{PartKind::kLink, rerooted->former}, 0,
         fmt::format("it is the root of the file but the end of a limb; link '{}' is used as the base",
                     rerooted->root)});
  }
  model.name = yaml.name.empty() ? texts.name : yaml.name;
  model.description = yaml.description;
  ApplyAxes(yaml, model);
  ApplyLimits(yaml, model);
  ApplyMotors(yaml, model);
  ApplyTransmissions(yaml, model);
  TakeVisualsOfFeet(yaml.feet, source, model, meshes);
  const Result<int> legs = DeriveLegs(model, yaml, GivenPosture(yaml, model));
  if (!legs) return legs.failure();
  if (const auto failure = CheckFeetAreKnown(model, yaml.feet, missing)) return *failure;
  TakeInertiaBoxes(missing, model);
  if (const auto failure = texts.strict ? RefusedMesh(model) : std::nullopt) return *failure;
  model.missing_meshes = std::move(missing);
  ApplyStanding(yaml, model);
  ApplyRests(yaml, model);
  const std::vector<std::string> notes = DerivationNotes(yaml, model);
  model.notes.insert(model.notes.begin(), notes.begin(), notes.end());
  model.urdf_text = texts.urdf;
  model.yaml_text = texts.yaml;
  model.meshes = std::move(meshes);
  model.hash = RobotHash(model);
  return model;
}

/// Whether a knee is straight in the standing posture.
bool HasStraightKnee(const RobotModel& model) {
  constexpr double kStraight = 0.05;  // [rad]
  return std::any_of(model.legs.begin(), model.legs.end(), [&](const Leg& leg) {
    const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
    return leg.knee_joint >= 0 && std::abs(KneeBend(model, leg, foot, model.standing_joints)) < kStraight;
  });
}

Result<RobotModel> LoadGuarded(const RobotTexts& texts, const MeshSource& source) {
  try {
    return Load(texts, source);
  } catch (const InvalidArgument& error) {
    return BadInput(FailureCode::kRobotYaml, error.what());
  }
}

const MeshHull* HullNamed(const std::vector<MeshHull>& meshes, const std::string& file) {
  const auto at = std::find_if(meshes.begin(), meshes.end(), [&](const MeshHull& mesh) { return mesh.file == file; });
  return at == meshes.end() ? nullptr : &*at;
}

/// Visual geometry whose mesh the description itself contains is drawn as its hull.
void TakeInnerPictures(const std::vector<MeshHull>& meshes, RobotModel& model) {
  for (Shape& shape : model.visual_shapes) {
    const MeshHull* hull = shape.type == ShapeType::kMesh ? HullNamed(meshes, shape.mesh_file) : nullptr;
    if (hull == nullptr) continue;
    for (const Vector3& v : hull->vertices) shape.vertices.push_back(shape.size.cwiseProduct(v));
  }
}

void NoteMissingPictures(const std::string& folder, const PackageFolders& packages, RobotModel& model) {
  for (const Shape& shape : model.visual_shapes) {
    if (shape.type != ShapeType::kMesh || !shape.vertices.empty()) continue;
    const Result<std::string> file = FindMeshFile(shape.mesh_file, folder, packages);
    if (!file) model.notes.push_back(fmt::format("link '{}' is not drawn: {}", shape.link, file.failure().message));
  }
}

/// The line of the text on which the element of a part begins; 0 if there is no such element.
int LineOfPart(const std::string& text, const RobotPart& part) {
  if (part.kind != PartKind::kLink && part.kind != PartKind::kJoint) return 0;
  const std::string kind = part.kind == PartKind::kLink ? "<link" : "<joint";
  for (std::size_t at = text.find(kind); at != std::string::npos; at = text.find(kind, at + 1)) {
    const std::string head = text.substr(at, std::min(text.find('>', at), text.size()) - at);
    if (head.find("\"" + part.name + "\"") == std::string::npos &&
        head.find("'" + part.name + "'") == std::string::npos)
      continue;
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  }
  return 0;
}

/// Sets the lines of findings about a link or a joint.
void FillLines(const std::string& text, std::vector<Finding>& findings) {
  for (Finding& finding : findings) {
    if (finding.line == 0) finding.line = LineOfPart(text, finding.part);
  }
}

/// Puts file and line before a message on a link or a joint, and the file before one on the whole document.
Failure WithLine(Failure failure, const std::string& path, const std::string& text) {
  constexpr FailureCode kOfDocument[] = {FailureCode::kNotXml, FailureCode::kNotUrdf, FailureCode::kUrdfRoots,
                                         FailureCode::kUrdfMissing};
  const std::string file = fs::path(path).filename().string();
  if (failure.part) {
    const int line = LineOfPart(text, *failure.part);
    if (line > 0) failure.message = fmt::format("{}, line {}: {}", file, line, failure.message);
  } else if (std::find(std::begin(kOfDocument), std::end(kOfDocument), failure.code) != std::end(kOfDocument)) {
    failure.message = fmt::format("{}: {}", file, failure.message);
  }
  return failure;
}

}  // namespace

std::string RobotsFolder() { return DataPath("robots", "GAITWRIGHT_ROBOTS"); }

Result<RobotModel> LoadRobotFromText(const std::string& urdf_text, const std::string& yaml_text,
                                     const std::string& name, const std::vector<MeshHull>& meshes, bool strict) {
  const MeshSource source = [&](const std::string& file) -> Result<std::vector<Vector3>> {
    if (const MeshHull* mesh = HullNamed(meshes, file)) return mesh->vertices;
    return BadInput(FailureCode::kNoFile,
                    fmt::format("the mesh '{}' is not among the meshes that were given with the robot's text", file));
  };
  return LoadGuarded({urdf_text, yaml_text, name, strict}, source);
}

Result<RobotModel> LoadRobot(const std::string& urdf_path, const std::string& yaml_path) {
  return LoadRobot(urdf_path, RobotLoading{.yaml_path = yaml_path});
}

Result<RobotModel> LoadRobot(const std::string& path, const RobotLoading& loading) {
  const Result<RobotDescription> description = ReadDescription(path, loading);
  if (!description) return description.failure();
  const fs::path folder = fs::path(path).parent_path();
  const std::string name = NameOfDescription(path, description->urdf);
  const PackageFolders packages(loading.packages.begin(), loading.packages.end());
  const MeshSource source = [&](const std::string& file) -> Result<std::vector<Vector3>> {
    if (const MeshHull* inner = HullNamed(description->meshes, file)) return inner->vertices;
    const Result<std::string> mesh_path = FindMeshFile(file, folder.string(), packages);
    if (!mesh_path) return mesh_path.failure();
    return HullsOfThisRun().Of(*mesh_path);
  };
  Result<RobotModel> model = LoadGuarded({description->urdf, description->yaml, name, loading.strict}, source);
  const bool has_key =
      description->yaml_without_posture != description->yaml && !description->yaml_without_posture.empty();
  const bool stands = model.ok() || model.failure().code != FailureCode::kRobotYaml;
  if (has_key && (!stands || (model && HasStraightKnee(*model)))) {
    Result<RobotModel> other =
        LoadGuarded({description->urdf, description->yaml_without_posture, name, loading.strict}, source);
    if (other) {
      other->findings.push_back(
          {FindingLevel::kInfo, FailureCode::kMjcf, RobotPart(), 0,
           stands ? "a leg is straight in its keyframe, so no foot could be lifted; a posture is derived instead"
                  : "the robot does not stand in its keyframe's posture; a posture is derived instead"});
    }
    if (other || !stands) model = std::move(other);
  }
  // Line numbers of a text that was converted from the file would not match the file.
  const Result<std::string> text = ReadFile(path);
  const bool has_lines = description->findings.empty() && !(text && IsMjcf(*text));
  if (!model) return has_lines ? WithLine(model.failure(), path, description->urdf) : model.failure();
  TakeInnerPictures(description->meshes, *model);
  NoteMissingPictures(folder.string(), packages, *model);
  if (has_lines) {
    FillLines(description->urdf, model->findings);
  } else {
    for (Finding& finding : model->findings) finding.line = 0;
  }
  model->findings.insert(model->findings.begin(), description->findings.begin(), description->findings.end());
  return model;
}

Result<RobotModel> WithRest(const RobotModel& model, const std::string& link) {
  const std::string yaml = model.yaml_text + (model.yaml_text.empty() || model.yaml_text.ends_with('\n') ? "" : "\n");
  return LoadRobotFromText(model.urdf_text, yaml + fmt::format("rests: ['{}']\n", link), model.name, model.meshes);
}

std::vector<std::string> RobotNames() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(RobotsFolder(), error)) {
    if (fs::exists(entry.path() / "robot.urdf", error)) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Result<RobotModel> LoadNamedRobot(const std::string& name) {
  const std::vector<std::string> names = RobotNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    return BadInput(FailureCode::kUnknownRobot,
                    fmt::format("there is no robot '{}'; the robots are {}; load your own URDF with --urdf FILE", name,
                                QuotedList(names)));
  }
  return LoadRobot((fs::path(RobotsFolder()) / name / "robot.urdf").string());
}

}  // namespace gaitwright
