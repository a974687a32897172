// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/description/mjcf_inertia_internal.h"
#include "kinematics/spatial/steiner.h"
#include "kinematics/spatial/symmetric_matrix.h"

namespace gaitwright {
namespace {

constexpr double kPi = std::numbers::pi;

/// A solid with second moments along its axes: the integral of x^2 over the volume V is V times the square of the
/// radius of gyration.
MjcfVolume MjcfSolid(double volume, const Vector3& squares) {
  return {volume, Vector3::Zero(), Matrix3((volume * squares).asDiagonal())};
}

MjcfVolume MjcfBall(double radius) {
  return MjcfSolid(4.0 / 3.0 * kPi * std::pow(radius, 3), Vector3::Constant(radius * radius / 5.0));
}

MjcfVolume MjcfCylinder(double radius, double half) {
  const double across = radius * radius / 4.0;
  return MjcfSolid(2.0 * kPi * radius * radius * half, {across, across, half * half / 3.0});
}

/// A cylinder with a hemisphere at each end; the centre of mass of a hemisphere is 3/8 r from its flat face.
MjcfVolume MjcfCapsule(double radius, double half) {
  MjcfVolume capsule = MjcfCylinder(radius, half);
  const MjcfVolume ball = MjcfBall(radius);
  capsule.volume += ball.volume;
  capsule.second += ball.second;
  capsule.second(2, 2) += ball.volume * (half * half + 0.75 * half * radius);
  return capsule;
}

MjcfVolume MjcfBoxAround(const MjcfMesh& mesh) {
  if (mesh.vertices.empty()) return {};
  Vector3 low = mesh.vertices.front(), high = low;
  for (const Vector3& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  MjcfVolume box = MjcfSolid((high - low).prod(), (high - low).cwiseAbs2() / 12.0);
  box.centre = 0.5 * (low + high);
  return box;
}

Vector3 MjcfMiddle(const MjcfMesh& mesh) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& v : mesh.vertices) sum += v;
  return mesh.vertices.empty() ? sum : Vector3(sum / static_cast<double>(mesh.vertices.size()));
}

}  // namespace

std::optional<MjcfVolume> VolumeOfMjcfMesh(const MjcfMesh& mesh) {
  const Vector3 middle = MjcfMiddle(mesh);
  double volume = 0.0, area = 0.0;
  Vector3 first = Vector3::Zero(), open = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
  for (const Eigen::Vector3i& t : mesh.triangles) {
    if (t.minCoeff() < 0 || static_cast<std::size_t>(t.maxCoeff()) >= mesh.vertices.size()) return std::nullopt;
    const auto corner = [&](int i) -> Vector3 { return mesh.vertices[static_cast<std::size_t>(t[i])] - middle; };
    const Vector3 a = corner(0), b = corner(1), c = corner(2), sum = a + b + c;
    const double of_this = a.dot(b.cross(c)) / 6.0;
    volume += of_this;
    first += of_this / 4.0 * sum;
    second += of_this / 20.0 * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    const Vector3 face = (b - a).cross(c - a);
    area += face.norm();
    open += face;
  }
  // The areas of the faces of a closed body sum to zero. If all faces point inward, all signs are reversed.
  constexpr double kOpen = 1e-3, kFlat = 1e-6;
  if (!(open.norm() <= kOpen * area) || !(std::abs(volume) > kFlat * MjcfBoxAround(mesh).volume)) return std::nullopt;
  const double sign = volume > 0.0 ? 1.0 : -1.0;
  const Vector3 p = first / volume;
  return MjcfVolume{sign * volume, middle + p, sign * (second - volume * p * p.transpose())};
}

Matrix3 InertiaOfMjcfVolume(const MjcfVolume& volume, double mass) {
  const Matrix3 about = volume.second.trace() * Matrix3::Identity() - volume.second;
  return mass * (about / volume.volume);  // the density of a tiny volume would overflow
}

MjcfVolume MjcfInertias::VolumeOfMesh(const MjcfGeom& geom) {
  const MjcfMeshAsset& asset = MjcfMeshOf(geom, assets_);
  if (!of_file_.contains(asset.file)) {
    const bool is_inner = !asset.inner.vertices.empty();
    if (asset.file.empty() || (!is_inner && !context_.files.mesh))
      RefuseMjcf(FailureCode::kMjcfInertia,
                 fmt::format("{}: the inertia of its body comes from the mesh '{}', which cannot be "
                             "read here; give the body an <inertial>",
                             geom.owner, geom.mesh));
    const Result<MjcfMesh> mesh = is_inner ? Result<MjcfMesh>(asset.inner) : context_.files.mesh(asset.file);
    if (!mesh)
      RefuseMjcf(FailureCode::kMjcfInertia, fmt::format("{}: the inertia of its body comes from the mesh '{}': {}",
                                                        geom.owner, geom.mesh, mesh.failure().message));
    std::optional<MjcfVolume> volume = VolumeOfMjcfMesh(*mesh);
    if (!volume) {
      context_.Note(asset.owner, "its triangles do not enclose a volume; its bounding box is used for the inertia");
      volume = MjcfBoxAround(*mesh);
    }
    of_file_[asset.file] = *volume;
  }
  const MjcfVolume& file = of_file_.at(asset.file);
  const Matrix3 A = asset.A();
  const double stretch = std::abs(A.determinant());
  return {stretch * file.volume, A * file.centre + asset.b(), stretch * A * file.second * A.transpose()};
}

MjcfVolume MjcfInertias::VolumeOf(const MjcfGeom& geom) {
  const Vector3& size = geom.size;
  switch (geom.type) {
    case MjcfGeomType::kSphere:
      return MjcfBall(size.x());
    case MjcfGeomType::kCapsule:
      return MjcfCapsule(size.x(), size.y());
    case MjcfGeomType::kCylinder:
      return MjcfCylinder(size.x(), size.y());
    case MjcfGeomType::kEllipsoid:
      return MjcfSolid(4.0 / 3.0 * kPi * size.prod(), size.cwiseAbs2() / 5.0);
    case MjcfGeomType::kBox:
      return MjcfSolid(8.0 * size.prod(), size.cwiseAbs2() / 3.0);
    case MjcfGeomType::kMesh:
      break;
  }
  return VolumeOfMesh(geom);
}

MjcfInertia MjcfInertias::FromGeoms(const std::vector<MjcfGeom>& geoms) {
  std::vector<MjcfInertia> parts;
  MjcfInertia all;
  for (const MjcfGeom& geom : geoms) {
    const bool counts = geom.group >= context_.compiler.lowest_group && geom.group <= context_.compiler.highest_group;
    if (!counts || geom.mass.value_or(geom.density) == 0.0) continue;
    if (geom.is_shell || (geom.type == MjcfGeomType::kMesh && MjcfMeshOf(geom, assets_).is_shell))
      RefuseMjcf(
          FailureCode::kMjcfInertia,
          fmt::format("{}: the inertia of its body comes from this shell, and shells are not supported; give the "
                      "body an <inertial>",
                      geom.owner));
    const MjcfVolume volume = VolumeOf(geom);
    if (!(volume.volume > 0.0)) continue;
    const double mass = geom.mass.value_or(geom.density * volume.volume);
    const Matrix3 R = geom.X_BG.linear();
    parts.push_back({mass, geom.X_BG * volume.centre, R * InertiaOfMjcfVolume(volume, mass) * R.transpose()});
    all.mass += mass;
    all.p_BC += mass * parts.back().p_BC;
  }
  if (!(all.mass > 0.0)) return {};
  all.p_BC /= all.mass;
  for (const MjcfInertia& part : parts) all.I_C += part.I_C + Steiner(part.mass, part.p_BC - all.p_BC);
  return all;
}

MjcfInertia MjcfInertias::FromElement(const MjcfPart& part) const {
  const MjcfAttributes attributes = context_.defaults.Of(*part.element, "inertial");
  const std::string& owner = attributes.owner();
  if (!attributes.Has("mass")) RefuseMjcf(FailureCode::kMjcfInertia, fmt::format("{}: it has no 'mass'", owner));
  MjcfInertia inertia;
  inertia.mass = attributes.Number("mass", 0.0);
  if (inertia.mass < 0.0)
    RefuseMjcf(FailureCode::kNegativeMass,
               fmt::format("{}: its mass is {} kg; zero or more is accepted", owner, inertia.mass));
  const Pose X_BI = part.X_BF * MjcfPose(attributes, context_.compiler);
  inertia.p_BC = X_BI.translation();
  const Vector3 diagonal = attributes.Three("diaginertia", Vector3::Zero());
  Matrix3 I = diagonal.asDiagonal();
  if (const auto full = attributes.Numbers("fullinertia", 6, 6); !full.empty()) {
    if (attributes.Has("diaginertia"))
      RefuseMjcf(FailureCode::kMjcfInertia, fmt::format("{}: it has both 'diaginertia' and 'fullinertia'", owner));
    I = SymmetricMatrix(full[0], full[3], full[4], full[1], full[5], full[2]);
  }
  inertia.I_C = X_BI.linear() * I * X_BI.linear().transpose();
  return inertia;
}

void MjcfInertias::Bound(MjcfInertia& inertia) const {
  const MjcfCompiler& compiler = context_.compiler;
  inertia.mass = std::max(inertia.mass, compiler.boundmass);
  if (!(compiler.boundinertia > 0.0) && !compiler.balanceinertia) return;
  const Eigen::SelfAdjointEigenSolver<Matrix3> principal(inertia.I_C);
  Vector3 moments = principal.eigenvalues().cwiseMax(compiler.boundinertia);
  if (compiler.balanceinertia && moments[0] + moments[1] < moments[2]) moments.setConstant(moments.mean());
  inertia.I_C = principal.eigenvectors() * moments.asDiagonal() * principal.eigenvectors().transpose();
}

MjcfInertia MjcfInertias::Of(const MjcfBody& body, const std::vector<MjcfGeom>& geoms) {
  MjcfInertia inertia;
  const MjcfInertiaSource source = context_.compiler.inertia;
  if (body.inertial && source != MjcfInertiaSource::kGeoms)
    inertia = FromElement(*body.inertial);
  else if (source != MjcfInertiaSource::kInertial)
    inertia = FromGeoms(geoms);
  Bound(inertia);
  return inertia;
}

}  // namespace gaitwright
