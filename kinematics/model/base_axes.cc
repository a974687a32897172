// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/base_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/model/body_tree.h"

namespace gaitwright {
namespace {

constexpr double kAlong = 0.9;  // cosine of 25 degrees

/// A chain of two joints or more from the base to a leaf, at joint positions zero.
struct Limb {
  Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< positions of its first and last joint
  Vector3 middle = Vector3::Zero();  ///< mean position of the last body's shapes from the last joint
  std::array<int, 3> turning = {};   ///< number of its joints about x, y and z, within 25 degrees
};

std::vector<Limb> LimbsOf(const RobotModel& model) {
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  std::vector<Limb> limbs;
  for (const std::vector<int>& chain : Limbs(model)) {
    const auto b = static_cast<std::size_t>(chain.back()) + 1;
    Limb limb;
    limb.from = X_OB[static_cast<std::size_t>(chain.front() + 1)].translation();
    limb.to = X_OB[b].translation();
    for (const int joint : chain) {
      const auto j = static_cast<std::size_t>(joint);
      Eigen::Index axis = 0;
      const double along = (X_OB[j + 1].linear() * model.joints[j].axis_J).cwiseAbs().maxCoeff(&axis);
      if (!model.joints[j].is_prismatic() && along > kAlong) ++limb.turning[static_cast<std::size_t>(axis)];
    }
    double shapes = 0.0;
    for (const Shape& shape : model.collision_shapes) {
      if (shape.body != static_cast<int>(b)) continue;
      limb.middle += X_OB[b].linear() * shape.X_BS.translation();
      shapes += 1.0;
    }
    if (shapes > 0.0) limb.middle /= shapes;
    limbs.push_back(limb);
  }
  return limbs;
}

double SizeOf(const std::vector<Limb>& limbs) {
  double size = 0.0;
  for (const Limb& limb : limbs) size = std::max({size, limb.from.norm(), limb.to.norm()});
  return size;
}

/// Whether the limbs mirror each other along an axis: the mirrored end of nearly every limb is the end of a limb, and
/// two limbs or more end away from the mirror plane.
bool Mirrors(const std::vector<Limb>& limbs, int axis, double size) {
  constexpr double kSame = 0.05, kShare = 0.8;
  std::size_t alike = 0, off_plane = 0;
  for (const Limb& limb : limbs) {
    Vector3 other = limb.to;
    other[axis] = -other[axis];
    if (std::any_of(limbs.begin(), limbs.end(), [&](const Limb& l) { return (l.to - other).norm() < kSame * size; }))
      ++alike;
    if (std::abs(limb.to[axis]) > kSame * size) ++off_plane;
  }
  return off_plane >= 2 && static_cast<double>(alike) >= kShare * static_cast<double>(limbs.size());
}

Vector3 Signed(int axis, double value) { return (value < 0.0 ? -1.0 : 1.0) * Vector3::Unit(axis); }

/// Largest distance between the ends of limbs along an axis.
double Spread(const std::vector<Limb>& limbs, int axis) {
  const auto by = [axis](const Limb& a, const Limb& b) { return a.to[axis] < b.to[axis]; };
  const auto [low, high] = std::minmax_element(limbs.begin(), limbs.end(), by);
  return high->to[axis] - low->to[axis];
}

/// Number of joints of all limbs that rotate about each axis.
std::array<int, 3> Turning(const std::vector<Limb>& limbs) {
  std::array<int, 3> turning = {};
  for (const Limb& limb : limbs) {
    for (std::size_t axis = 0; axis < 3; ++axis) turning[axis] += limb.turning[axis];
  }
  return turning;
}

/// Whether the limbs bend about x: more of their joints rotate about x than about y, and no joint rotates about z,
/// which would rotate the plane of a leg. If no joint rotates about y, no leg can step along x. Otherwise the limbs
/// must mirror each other along x too.
bool BendSideways(const std::vector<Limb>& limbs, bool mirror_along_x) {
  const std::array<int, 3> turning = Turning(limbs);
  return turning[2] == 0 && turning[0] > turning[1] && (mirror_along_x || turning[1] == 0);
}

}  // namespace

const std::vector<std::string>& AxisNames() {
  static const std::vector<std::string> names = {"x", "y", "z", "-x", "-y", "-z"};
  return names;
}

Vector3 AxisNamed(int index) { return (index < 3 ? 1.0 : -1.0) * Vector3::Unit(index % 3); }

std::string NameOfAxis(const Vector3& axis) {
  int index = 0;
  for (int i = 1; i < 6; ++i) {
    if (axis.dot(AxisNamed(i)) > axis.dot(AxisNamed(index))) index = i;
  }
  return AxisNames()[static_cast<std::size_t>(index)];
}

BaseAxes DeriveBaseAxes(const RobotModel& model) {
  const std::vector<Limb> limbs = LimbsOf(model);
  if (limbs.size() < 2) return {};
  const double size = SizeOf(limbs);
  std::array<bool, 3> mirrors = {};
  for (int axis = 0; axis < 3; ++axis) mirrors[static_cast<std::size_t>(axis)] = Mirrors(limbs, axis, size);
  const bool sideways = mirrors[1] && BendSideways(limbs, mirrors[0]);
  if (!sideways && (mirrors[1] || (!mirrors[0] && !mirrors[2]))) return {};
  Vector3 hang = Vector3::Zero(), middle = Vector3::Zero();
  double length = 0.0;
  for (const Limb& limb : limbs) {
    hang += limb.to - limb.from;
    length += (limb.to - limb.from).norm();
    middle += limb.middle;
  }
  int up = sideways ? 2 : 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (!mirrors[static_cast<std::size_t>(axis)] && std::abs(hang[axis]) > std::abs(hang[up])) up = axis;
  }
  constexpr double kHang = 0.5;  // share of the total length; below this, the limbs do not show which axis is down
  if (std::abs(hang[up]) < kHang * length) return {};
  // Four legs mirror each other along both level axes. The forward axis is the one with the larger distance of feet.
  int across = mirrors[0] || sideways ? 0 : 2;
  if (mirrors[0] && mirrors[2]) across = Spread(limbs, 0) < Spread(limbs, 2) ? 0 : 2;
  const int forward = 3 - up - across;
  // Legs that bend about y step along x, though their sides are not quite alike.
  if (const std::array<int, 3> turning = Turning(limbs); up == 2 && forward == 1 && turning[1] > turning[0]) return {};
  return {Signed(forward, middle[forward]), Signed(up, -hang[up])};
}

void TurnBase(const BaseAxes& axes, RobotModel& model) {
  Matrix3 R;
  R << axes.forward, axes.up.cross(axes.forward), axes.up;
  R.transposeInPlace();
  const Pose X(R);
  Body& base = model.bodies.front();
  base.p_BC = R * base.p_BC;
  base.I_C = R * base.I_C * R.transpose();
  for (Joint& joint : model.joints) {
    if (joint.parent_body == 0) joint.X_PJ = X * joint.X_PJ;
  }
  for (Frame& frame : model.frames) {
    if (frame.body == 0) frame.X_BF = X * frame.X_BF;
  }
  for (std::vector<Shape>* shapes : {&model.collision_shapes, &model.visual_shapes}) {
    for (Shape& shape : *shapes) {
      if (shape.body == 0) shape.X_BS = X * shape.X_BS;
    }
  }
}

}  // namespace gaitwright
