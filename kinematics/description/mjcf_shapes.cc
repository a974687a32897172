// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "kinematics/base/text.h"
#include "kinematics/description/mjcf_shapes_internal.h"

namespace gaitwright {
namespace {

MjcfUrdfShape MjcfRound(const std::string& element, double radius, double length, const Pose& X_BS) {
  return {element, {{"radius", MjcfText(radius)}, {"length", MjcfText(length)}}, X_BS};
}

MjcfUrdfShape MjcfBox(const Vector3& edges, const Pose& X_BS) { return {"box", {{"size", MjcfText(edges)}}, X_BS}; }

/// A capsule around an ellipsoid: along its longest axis, with the radius of its middle axis.
MjcfUrdfShape AroundMjcfEllipsoid(MjcfContext& context, const MjcfGeom& geom) {
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return geom.size[a] < geom.size[b]; });
  const double shortest = geom.size[order[0]], middle = geom.size[order[1]], longest = geom.size[order[2]];
  constexpr double kFlat = 0.8;
  if (shortest < kFlat * middle) {
    context.Note(geom.owner, "its bounding box is used instead of the ellipsoid");
    return MjcfBox(2.0 * geom.size, geom.X_BG);
  }
  constexpr double kRound = 1e-3;
  if (longest - middle < kRound * longest) return {"sphere", {{"radius", MjcfText(longest)}}, geom.X_BG};
  context.Note(geom.owner, "its bounding capsule is used instead of the ellipsoid");
  Pose X_BS = geom.X_BG;
  X_BS.linear() = geom.X_BG.linear() * MjcfRotationOfZ(Vector3::Unit(order[2]));
  return MjcfRound("capsule", middle, 2.0 * (longest - middle), X_BS);
}

/// The reason why a mesh cannot be used; "" if it can be used. A collision mesh file that cannot be read is reported
/// when it is loaded.
std::string ReasonNoMjcfMesh(const MjcfMeshAsset& asset, bool collides) {
  if (asset.file.empty()) return "its mesh has neither 'file' nor 'vertex'";
  if (!asset.inner.vertices.empty() || collides) return "";
  const std::string kind = LowerCase(std::filesystem::path(asset.file).extension().string());
  if (kind == ".stl" || kind == ".obj" || kind == ".dae") return "";
  return fmt::format("its mesh '{}' has an unsupported format; accepted: '.stl', '.obj', '.dae'",
                     ShownMjcf(asset.file));
}

std::optional<MjcfUrdfShape> MeshOfMjcfGeom(MjcfContext& context, const MjcfGeom& geom, const MjcfMeshAssets& assets) {
  const MjcfMeshAsset& asset = MjcfMeshOf(geom, assets);
  if (const std::string reason = ReasonNoMjcfMesh(asset, geom.collides); !reason.empty()) {
    context.Note(geom.owner, reason + "; it is left out");
    return std::nullopt;
  }
  // The URDF scales along the axes of the file; MuJoCo scales along the axes of refquat.
  const bool even = (asset.scale.array() == asset.scale.x()).all();
  if (!even && !asset.R_ref.isIdentity(1e-12))
    RefuseMjcf(FailureCode::kMjcfMesh,
               fmt::format("{}: 'refquat' together with a scale that differs by axis is not supported", asset.owner));
  Pose X_GM = Pose::Identity();
  X_GM.linear() = asset.R_ref.transpose();
  X_GM.translation() = asset.b();
  MjcfUrdfShape shape{"mesh", {{"filename", asset.file}}, geom.X_BG * X_GM};
  if (!asset.scale.isOnes(0.0)) shape.attributes.emplace_back("scale", MjcfText(asset.scale));
  return shape;
}

}  // namespace

std::string MjcfText(double value) { return fmt::format("{}", value == 0.0 ? 0.0 : value); }

std::string MjcfText(const Vector3& v) {
  return fmt::format("{} {} {}", MjcfText(v.x()), MjcfText(v.y()), MjcfText(v.z()));
}

Vector3 MjcfRollPitchYaw(const Matrix3& R) {
  // If cos(pitch) is zero, rounding decides yaw, and roll matches it.
  const double yaw = std::atan2(R(1, 0), R(0, 0));
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
  const double s = std::sin(yaw), c = std::cos(yaw);
  return {std::atan2(s * R(0, 2) - c * R(1, 2), c * R(1, 1) - s * R(0, 1)), pitch, yaw};
}

std::optional<MjcfUrdfShape> ShapeOfMjcfGeom(MjcfContext& context, const MjcfGeom& geom, const MjcfMeshAssets& assets) {
  const Vector3& size = geom.size;
  switch (geom.type) {
    case MjcfGeomType::kSphere:
      return MjcfUrdfShape{"sphere", {{"radius", MjcfText(size.x())}}, geom.X_BG};
    case MjcfGeomType::kCapsule:
      return MjcfRound("capsule", size.x(), 2.0 * size.y(), geom.X_BG);
    case MjcfGeomType::kCylinder:
      return MjcfRound("cylinder", size.x(), 2.0 * size.y(), geom.X_BG);
    case MjcfGeomType::kEllipsoid:
      return AroundMjcfEllipsoid(context, geom);
    case MjcfGeomType::kBox:
      return MjcfBox(2.0 * size, geom.X_BG);
    case MjcfGeomType::kMesh:
      break;
  }
  return MeshOfMjcfGeom(context, geom, assets);
}

}  // namespace gaitwright
