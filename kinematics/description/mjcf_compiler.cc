// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "kinematics/description/mjcf_compiler_internal.h"

namespace gaitwright {
namespace {

constexpr double kShortestMjcfAxis = 1e-9;

MjcfAttributes MergedMjcfCompiler(const MjcfDocument& document) {
  MjcfAttributes::Values all;
  std::string owner = "<compiler>";
  for (const tinyxml2::XMLElement* section : document.Sections("compiler")) {
    MjcfAttributes::Values values;
    for (const auto* a = section->FirstAttribute(); a != nullptr; a = a->Next()) values[a->Name()] = a->Value();
    owner = document.Owner(*section);
    if (values.contains("assetdir")) values.try_emplace("meshdir", values.at("assetdir"));
    MergeMjcfValues(all, values);
  }
  return {owner, all};
}

/// The unit vector of a direction.
Vector3 MjcfUnit(const Vector3& v, const std::string& key, const MjcfAttributes& attributes) {
  if (v.norm() < kShortestMjcfAxis)
    RefuseMjcf(FailureCode::kMjcfAxis,
               fmt::format("{}: '{}' is '{}', which does not define a direction: an axis is zero or parallel "
                           "to another",
                           attributes.owner(), key, ShownMjcf(attributes.Text(key))));
  return v.normalized();
}

Matrix3 MjcfEuler(const std::vector<double>& angles, const MjcfCompiler& compiler) {
  Matrix3 R = Matrix3::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const char axis = compiler.eulerseq[i];
    const bool stands_still = axis >= 'X' && axis <= 'Z';
    const Vector3 unit = Vector3::Unit(stands_still ? axis - 'X' : axis - 'x');
    const Matrix3 turn = Eigen::AngleAxisd(compiler.Radians(angles[i]), unit).toRotationMatrix();
    R = stands_still ? Matrix3(turn * R) : Matrix3(R * turn);
  }
  return R;
}

Matrix3 MjcfAxes(const std::vector<double>& n, const MjcfAttributes& attributes) {
  Matrix3 R;
  R.col(0) = MjcfUnit({n[0], n[1], n[2]}, "xyaxes", attributes);
  const Vector3 y = MjcfUnit({n[3], n[4], n[5]}, "xyaxes", attributes);
  R.col(1) = MjcfUnit(y - R.col(0).dot(y) * R.col(0), "xyaxes", attributes);
  R.col(2) = R.col(0).cross(R.col(1));
  return R;
}

}  // namespace

double MjcfCompiler::Radians(double angle) const { return degrees ? angle * std::numbers::pi / 180.0 : angle; }

MjcfCompiler ReadMjcfCompiler(const MjcfDocument& document) {
  const MjcfAttributes given = MergedMjcfCompiler(document);
  MjcfCompiler compiler;
  if (given.Choice("coordinate", {"local", "global"}, "local") == "global")
    RefuseMjcf(
        FailureCode::kMjcfCoordinate,
        fmt::format("{}: global coordinates are not supported; open the model with MuJoCo 2.3.3, the last version that "
                    "reads them, and save it with local coordinates",
                    given.owner()));
  compiler.degrees = given.Choice("angle", {"degree", "radian"}, "degree") == "degree";
  if (given.Has("eulerseq")) compiler.eulerseq = given.Text("eulerseq");
  if (compiler.eulerseq.size() != 3 || compiler.eulerseq.find_first_not_of("xyzXYZ") != std::string::npos)
    RefuseMjcf(FailureCode::kMjcfChoice,
               fmt::format("{}: 'eulerseq' is '{}'; three letters of x, y, z, X, Y, Z are needed", given.owner(),
                           ShownMjcf(compiler.eulerseq)));
  compiler.meshdir = given.Name("meshdir");
  compiler.strippath = given.Flag("strippath", false);
  compiler.autolimits = given.Flag("autolimits", true);
  const std::string source = given.Choice("inertiafromgeom", {"true", "false", "auto"}, "auto");
  compiler.inertia = source == "true"    ? MjcfInertiaSource::kGeoms
                     : source == "false" ? MjcfInertiaSource::kInertial
                                         : MjcfInertiaSource::kInertialElseGeoms;
  if (const std::vector<double> groups = given.Numbers("inertiagrouprange", 2, 2); !groups.empty()) {
    compiler.lowest_group = groups[0];
    compiler.highest_group = groups[1];
  }
  compiler.boundmass = given.Number("boundmass", 0.0);
  compiler.boundinertia = given.Number("boundinertia", 0.0);
  compiler.balanceinertia = given.Flag("balanceinertia", false);
  compiler.settotalmass = std::max(given.Number("settotalmass", 0.0), 0.0);
  return compiler;
}

Matrix3 MjcfRotation(const MjcfAttributes& attributes, const MjcfCompiler& compiler) {
  int given = 0;
  for (const char* key : {"quat", "axisangle", "euler", "xyaxes", "zaxis"}) given += attributes.Has(key) ? 1 : 0;
  if (given > 1)
    RefuseMjcf(FailureCode::kMjcfOrientation,
               fmt::format("{}: it has {} orientations; one of 'quat', 'axisangle', 'euler', 'xyaxes', 'zaxis' is "
                           "accepted",
                           attributes.owner(), given));
  if (const auto q = attributes.Numbers("quat", 4, 4); !q.empty()) {
    const Quaternion quaternion(q[0], q[1], q[2], q[3]);
    if (quaternion.norm() < kShortestMjcfAxis)
      RefuseMjcf(FailureCode::kMjcfOrientation,
                 fmt::format("{}: 'quat' is zero, which is not a rotation", attributes.owner()));
    return quaternion.normalized().toRotationMatrix();
  }
  if (const auto a = attributes.Numbers("axisangle", 4, 4); !a.empty()) {
    const Vector3 axis = MjcfUnit({a[0], a[1], a[2]}, "axisangle", attributes);
    return Eigen::AngleAxisd(compiler.Radians(a[3]), axis).toRotationMatrix();
  }
  if (const auto angles = attributes.Numbers("euler", 3, 3); !angles.empty()) return MjcfEuler(angles, compiler);
  if (const auto axes = attributes.Numbers("xyaxes", 6, 6); !axes.empty()) return MjcfAxes(axes, attributes);
  if (const auto z = attributes.Numbers("zaxis", 3, 3); !z.empty())
    return MjcfRotationOfZ(MjcfUnit({z[0], z[1], z[2]}, "zaxis", attributes));
  return Matrix3::Identity();
}

Pose MjcfPose(const MjcfAttributes& attributes, const MjcfCompiler& compiler) {
  Pose X = Pose::Identity();
  X.translation() = attributes.Three("pos", Vector3::Zero());
  X.linear() = MjcfRotation(attributes, compiler);
  return X;
}

Matrix3 MjcfRotationOfZ(const Vector3& direction) {
  const Vector3 z = direction.normalized(), across = Vector3::UnitZ().cross(z);
  const Vector3 axis = across.norm() < 1e-10 ? Vector3::UnitX() : Vector3(across.normalized());
  return Eigen::AngleAxisd(std::atan2(across.norm(), z.z()), axis).toRotationMatrix();
}

}  // namespace gaitwright
