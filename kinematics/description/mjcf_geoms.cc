// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "kinematics/base/nearest_name.h"
#include "kinematics/description/mjcf_geoms_internal.h"
#include "kinematics/spatial/solid_hull.h"

namespace gaitwright {
namespace {

const std::vector<std::string> kMjcfGeomTypes = {"sphere", "capsule", "cylinder", "ellipsoid", "box",
                                                 "mesh",   "plane",   "hfield",   "sdf"};

/// Number of values of `size` for a type of geom.
std::size_t MjcfSizes(MjcfGeomType type, bool from_to) {
  switch (type) {
    case MjcfGeomType::kSphere:
      return 1;
    case MjcfGeomType::kCapsule:
    case MjcfGeomType::kCylinder:
      return from_to ? 1 : 2;
    case MjcfGeomType::kEllipsoid:
    case MjcfGeomType::kBox:
      return from_to ? 1 : 3;
    case MjcfGeomType::kMesh:
      break;
  }
  return 0;
}

void ReadMjcfSize(const MjcfAttributes& attributes, bool from_to, MjcfGeom& geom) {
  const std::size_t needed = MjcfSizes(geom.type, from_to);
  if (needed == 0) return;
  const std::vector<double> size = attributes.Numbers("size", needed, 3);
  if (size.empty()) RefuseMjcf(FailureCode::kMjcfGeom, fmt::format("{}: it has no 'size'", geom.owner));
  for (std::size_t i = 0; i < needed; ++i) {
    if (size[i] <= 0.0)
      RefuseMjcf(FailureCode::kMjcfGeom,
                 fmt::format("{}: 'size' contains {}; it must be positive", geom.owner, size[i]));
    geom.size[static_cast<Eigen::Index>(i)] = size[i];
  }
}

/// Pose and length of a geom from its ends. The ends are on its z axis, which points to the first one.
void ReadMjcfEnds(const MjcfAttributes& attributes, const Pose& X_BF, MjcfGeom& geom) {
  if (geom.type == MjcfGeomType::kSphere || geom.type == MjcfGeomType::kMesh)
    RefuseMjcf(FailureCode::kMjcfGeom,
               fmt::format("{}: 'fromto' is for capsule, cylinder, ellipsoid and box, not for a {}", geom.owner,
                           geom.type == MjcfGeomType::kSphere ? "sphere" : "mesh"));
  const std::vector<double> ends = attributes.Numbers("fromto", 6, 6);
  const Vector3 from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
  const double half = 0.5 * (from - to).norm();
  if (half < 1e-9)
    RefuseMjcf(FailureCode::kMjcfGeom, fmt::format("{}: the two ends of 'fromto' are the same point", geom.owner));
  if (!attributes.Three("pos", Vector3::Zero()).isZero(0.0))
    RefuseMjcf(FailureCode::kMjcfGeom, fmt::format("{}: it has both 'pos' and 'fromto'", geom.owner));
  if (geom.type == MjcfGeomType::kEllipsoid || geom.type == MjcfGeomType::kBox) {
    geom.size = Vector3(geom.size.x(), geom.size.x(), half);
  } else {
    geom.size.y() = half;
  }
  Pose X_FG = Pose::Identity();
  X_FG.translation() = 0.5 * (from + to);
  X_FG.linear() = MjcfRotationOfZ(from - to);
  geom.X_BG = X_BF * X_FG;
}

MjcfGeomType MjcfTypeNamed(const std::string& type) {
  return static_cast<MjcfGeomType>(std::find(kMjcfGeomTypes.begin(), kMjcfGeomTypes.end(), type) -
                                   kMjcfGeomTypes.begin());
}

/// Reads a geom. Nothing for types that are not used for a robot.
std::optional<MjcfGeom> ReadMjcfGeom(MjcfContext& context, const MjcfPart& part, const std::set<std::string>& paired) {
  const MjcfAttributes attributes = context.defaults.Of(*part.element, "geom", part.childclass);
  MjcfGeom geom;
  geom.owner = attributes.owner();
  geom.name = attributes.Name("name");
  geom.mesh = attributes.Name("mesh");
  const std::string type = attributes.Choice("type", kMjcfGeomTypes, "sphere");
  if (type == "plane" || type == "hfield" || type == "sdf") {
    context.Note(geom.owner, fmt::format("a geom of type '{}' is left out", type));
    return std::nullopt;
  }
  geom.type = MjcfTypeNamed(type);
  if (geom.type == MjcfGeomType::kMesh && geom.mesh.empty())
    RefuseMjcf(FailureCode::kMjcfGeom, fmt::format("{}: it is of type mesh, but has no 'mesh'", geom.owner));
  if (geom.type != MjcfGeomType::kMesh && !geom.mesh.empty()) {
    context.Note(geom.owner, fmt::format("the mesh is used instead of the {} that MuJoCo fits to it", type));
    geom.type = MjcfGeomType::kMesh;
  }
  const bool from_to = attributes.Has("fromto") && geom.type != MjcfGeomType::kMesh;
  ReadMjcfSize(attributes, from_to, geom);
  if (from_to)
    ReadMjcfEnds(attributes, part.X_BF, geom);
  else
    geom.X_BG = part.X_BF * MjcfPose(attributes, context.compiler);
  geom.group = attributes.Number("group", 0.0);
  geom.collides = attributes.Number("contype", 1.0) != 0.0 || attributes.Number("conaffinity", 1.0) != 0.0 ||
                  (!geom.name.empty() && paired.contains(geom.name));
  constexpr double kLastShown = 2.0;
  geom.is_shown = geom.group <= kLastShown;
  if (geom.collides && attributes.Has("friction") && !context.friction_is_noted) {
    context.Note(geom.owner, "'friction' is ignored here and in other geoms; the ground sets the friction");
    context.friction_is_noted = true;
  }
  geom.is_shell = attributes.Flag("shellinertia", false);
  if (attributes.Has("mass")) geom.mass = attributes.Number("mass", 0.0);
  geom.density = attributes.Number("density", geom.density);
  const double mass = geom.mass.value_or(0.0);
  if (mass < 0.0 || geom.density < 0.0) {
    const std::string value =
        mass < 0.0 ? fmt::format("mass is {} kg", mass) : fmt::format("density is {} kg/m^3", geom.density);
    RefuseMjcf(FailureCode::kMjcfGeom, fmt::format("{}: its {}; zero or more is accepted", geom.owner, value));
  }
  return geom;
}

std::string MjcfMeshFile(const MjcfAttributes& attributes, const MjcfCompiler& compiler) {
  namespace fs = std::filesystem;
  const std::string named = attributes.Name("file");
  if (named.empty()) return "";
  const fs::path path = compiler.strippath ? fs::path(named).filename() : fs::path(named);
  return (fs::path(compiler.meshdir) / path).lexically_normal().string();
}

/// The mesh of 'vertex' and 'face'; without 'face' it is the convex hull of the vertices, as in MuJoCo.
MjcfMesh ReadMjcfVertices(const MjcfAttributes& attributes) {
  constexpr std::size_t kLeast = 12, kMost = 999999;  // numbers: four points make a solid
  const auto threes = [&](const char* key, std::size_t least) {
    std::vector<Vector3> rows;
    const std::vector<double> numbers = attributes.Numbers(key, least, kMost);
    if (numbers.size() % 3 != 0)
      RefuseMjcf(FailureCode::kMjcfMesh, fmt::format("{}: '{}' has {} numbers; three for each {} are needed",
                                                     attributes.owner(), key, numbers.size(), key));
    for (std::size_t i = 0; i < numbers.size(); i += 3) rows.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return rows;
  };
  MjcfMesh mesh{threes("vertex", kLeast), {}};
  const double count = static_cast<double>(mesh.vertices.size());
  for (const Vector3& corners : threes("face", 3)) {
    for (const double corner : corners) {
      if (corner >= 0.0 && corner < count && corner == std::floor(corner)) continue;
      RefuseMjcf(FailureCode::kMjcfMesh, fmt::format("{}: 'face' names the vertex {}; accepted: whole numbers from 0 "
                                                     "to {}",
                                                     attributes.owner(), corner, count - 1.0));
    }
    mesh.triangles.emplace_back(corners.cast<int>());
  }
  if (mesh.triangles.empty()) mesh.triangles = HullTriangles(mesh.vertices);
  if (mesh.triangles.empty())
    RefuseMjcf(FailureCode::kMjcfMesh,
               fmt::format("{}: the points of 'vertex' lie in one plane; a mesh needs a volume", attributes.owner()));
  return mesh;
}

}  // namespace

MjcfMeshAssets ReadMjcfMeshes(MjcfContext& context) {
  MjcfMeshAssets assets;
  for (const tinyxml2::XMLElement* element : context.document.InSections("asset")) {
    if (std::string_view(element->Name()) != "mesh") continue;
    const MjcfAttributes attributes = context.defaults.Of(*element, "mesh");
    MjcfMeshAsset mesh;
    mesh.owner = attributes.owner();
    mesh.file = MjcfMeshFile(attributes, context.compiler);
    mesh.is_shell = attributes.Text("inertia") == "shell";
    mesh.scale = attributes.Three("scale", Vector3::Ones());
    mesh.p_ref = attributes.Three("refpos", Vector3::Zero());
    if (mesh.scale.cwiseAbs().minCoeff() == 0.0)
      RefuseMjcf(FailureCode::kMjcfMesh,
                 fmt::format("{}: its scale is 0 along an axis; other values are accepted", mesh.owner));
    if (const auto q = attributes.Numbers("refquat", 4, 4); !q.empty()) {
      const Quaternion quaternion(q[0], q[1], q[2], q[3]);
      if (quaternion.norm() < 1e-9)
        RefuseMjcf(FailureCode::kMjcfMesh,
                   fmt::format("{}: its 'refquat' is zero, which is not a rotation", mesh.owner));
      mesh.R_ref = quaternion.normalized().toRotationMatrix();
    }
    std::string name = attributes.Name("name");
    if (name.empty()) name = std::filesystem::path(mesh.file).stem().string();
    if (name.empty())
      RefuseMjcf(FailureCode::kMjcfMissing, fmt::format("{}: it has neither 'name' nor 'file'", mesh.owner));
    if (mesh.file.empty() && attributes.Has("vertex")) {
      mesh.file = "inline:" + name;
      mesh.inner = ReadMjcfVertices(attributes);
    }
    if (!assets.emplace(name, std::move(mesh)).second)
      RefuseMjcf(FailureCode::kDoubleName,
                 fmt::format("{}: two meshes are named '{}'", attributes.owner(), ShownMjcf(name)));
  }
  return assets;
}

const MjcfMeshAsset& MjcfMeshOf(const MjcfGeom& geom, const MjcfMeshAssets& assets) {
  const auto at = assets.find(geom.mesh);
  if (at != assets.end()) return at->second;
  std::vector<std::string> names;
  for (const auto& [name, asset] : assets) names.push_back(name);
  RefuseMjcf(FailureCode::kMjcfMesh, fmt::format("{}: there is no mesh '{}'{}", geom.owner, ShownMjcf(geom.mesh),
                                                 NearestOrAll(geom.mesh, names)));
}

std::set<std::string> MjcfPairedGeoms(const MjcfContext& context) {
  std::set<std::string> names;
  for (const tinyxml2::XMLElement* element : context.document.InSections("contact")) {
    if (std::string_view(element->Name()) != "pair") continue;
    for (const char* key : {"geom1", "geom2"}) {
      if (element->Attribute(key) != nullptr) names.insert(element->Attribute(key));
    }
  }
  return names;
}

std::vector<MjcfGeom> ReadMjcfGeoms(MjcfContext& context, const MjcfBody& body, const std::set<std::string>& paired) {
  std::vector<MjcfGeom> geoms;
  for (const MjcfPart& part : body.geoms) {
    if (std::optional<MjcfGeom> geom = ReadMjcfGeom(context, part, paired)) geoms.push_back(std::move(*geom));
  }
  return geoms;
}

void LetHiddenMjcfGeomsCollide(MjcfContext& context, std::vector<std::vector<MjcfGeom>>& geoms) {
  const auto any = [&](auto&& is_so) {
    return std::any_of(geoms.begin(), geoms.end(), [&](const std::vector<MjcfGeom>& of_body) {
      return std::any_of(of_body.begin(), of_body.end(), is_so);
    });
  };
  if (any([](const MjcfGeom& geom) { return geom.collides; })) return;
  if (!any([](const MjcfGeom& geom) { return !geom.is_shown; })) return;
  context.Note(context.document.Owner(context.document.root()),
               "'contype', 'conaffinity' and <pair> exclude every contact of the robot's geoms; geoms of group 3 and "
               "above, which are not shown, are used as collision geometry");
  for (std::vector<MjcfGeom>& of_body : geoms) {
    for (MjcfGeom& geom : of_body) geom.collides = !geom.is_shown;
  }
}

}  // namespace gaitwright
