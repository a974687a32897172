// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/upper_body.h"

#include <algorithm>
#include <cmath>

#include "kinematics/model/body_tree.h"

namespace gaitwright {
namespace {

enum class Side { kLeft, kRight, kMiddle, kBoth };

/// The tree of all parts that do not belong to a leg, in the standing posture.
class FreeParts {
 public:
  explicit FreeParts(const RobotModel& model) : model_(model), X_OB_(BodyPoses(model, model.standing_joints)) {
    const std::size_t count = model.joints.size();
    std::vector<int> legs(count, 0);
    for (const Leg& leg : model.legs) {
      for (const int joint : leg.joints) ++legs[static_cast<std::size_t>(joint)];
    }
    in_leg_.assign(count, false);
    std::vector<bool> of_one_leg(count, false);
    is_end_.assign(count, true);
    for (std::size_t j = 0; j < count; ++j) {
      const int parent = model.joints[j].parent_body - 1;
      const auto p = static_cast<std::size_t>(parent);
      of_one_leg[j] = legs[j] == 1 || (parent >= 0 && of_one_leg[p]);
      in_leg_[j] = legs[j] > 0 || of_one_leg[j];
      if (parent >= 0) is_end_[p] = false;
    }
    FindSides();
  }

  /// The first joint of each part whose ends are all on this side.
  std::vector<int> Roots(Side side) const {
    std::vector<int> roots;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      if (in_leg_[j] || side_[j] != side) continue;
      const int parent = model_.joints[j].parent_body - 1;
      const bool inside =
          parent >= 0 && !in_leg_[static_cast<std::size_t>(parent)] && side_[static_cast<std::size_t>(parent)] == side;
      if (!inside) roots.push_back(static_cast<int>(j));
    }
    return roots;
  }

  /// The chain from a joint to the end that is farthest from it.
  Limb LimbFrom(int root) const {
    int farthest = root;
    for (std::size_t j = static_cast<std::size_t>(root); j < model_.joints.size(); ++j) {
      if (is_end_[j] && Carries(model_, root + 1, static_cast<int>(j) + 1) && Reach(root, j) > Reach(root, farthest))
        farthest = static_cast<int>(j);
    }
    Limb limb;
    limb.end_body = farthest + 1;
    limb.p_BE = model_.bodies[static_cast<std::size_t>(limb.end_body)].p_BC;
    for (const int joint : ChainTo(model_, limb.end_body)) {
      const int dof = model_.joints[static_cast<std::size_t>(joint)].dof;
      if (joint >= root && std::find(limb.dofs.begin(), limb.dofs.end(), dof) == limb.dofs.end())
        limb.dofs.push_back(dof);
    }
    return limb;
  }

  double Reach(int root, std::size_t end) const { return (EndOf(end) - Origin(root)).norm(); }
  double Reach(int root, int end) const { return Reach(root, static_cast<std::size_t>(end)); }
  double Rise(int root, const Limb& limb) const {
    return EndOf(static_cast<std::size_t>(limb.end_body) - 1).z() - Origin(root).z();
  }

  /// Share of a joint's axis along the body's y; 1 for a joint that nods, 0 for a prismatic joint.
  double Nods(int dof) const {
    const int joint = model_.dof_joint[static_cast<std::size_t>(dof)];
    const Vector3 axis_O = X_OB_[static_cast<std::size_t>(joint) + 1].linear() * model_.LeaderOf(dof).axis_J;
    return model_.LeaderOf(dof).is_prismatic() ? 0.0 : std::abs(axis_O.y());
  }

 private:
  Vector3 Origin(int joint) const { return X_OB_[static_cast<std::size_t>(joint) + 1].translation(); }
  Vector3 EndOf(std::size_t joint) const { return X_OB_[joint + 1] * model_.bodies[joint + 1].p_BC; }

  void FindSides() {
    const double middle = 0.1 * model_.leg_length_m();
    side_.assign(model_.joints.size(), Side::kMiddle);
    std::vector<bool> known(model_.joints.size(), false);
    for (std::size_t j = model_.joints.size(); j-- > 0;) {
      const double y = EndOf(j).y();
      if (is_end_[j]) side_[j] = y > middle ? Side::kLeft : y < -middle ? Side::kRight : Side::kMiddle;
      const int parent = model_.joints[j].parent_body - 1;
      if (parent < 0 || in_leg_[j]) continue;
      const auto p = static_cast<std::size_t>(parent);
      side_[p] = known[p] && side_[p] != side_[j] ? Side::kBoth : side_[j];
      known[p] = true;
    }
  }

  const RobotModel& model_;
  const std::vector<Pose> X_OB_;
  std::vector<bool> in_leg_, is_end_;  // by joint: belongs to a leg or is carried by one; carries no other joint
  std::vector<Side> side_;             // by joint: side of all ends that it carries
};

std::optional<Limb> ArmOf(const FreeParts& parts, Side side) {
  std::optional<Limb> arm;
  double reach = 0.0;
  for (const int root : parts.Roots(side)) {
    Limb limb = parts.LimbFrom(root);
    const double far = parts.Reach(root, limb.end_body - 1);
    if (limb.dofs.size() < 2 || far <= reach) continue;
    reach = far;
    arm = std::move(limb);
  }
  return arm;
}

std::optional<Limb> HeadOf(const FreeParts& parts) {
  const double least = std::sqrt(0.5);
  for (const int root : parts.Roots(Side::kMiddle)) {
    Limb limb = parts.LimbFrom(root);
    const bool nods = std::any_of(limb.dofs.begin(), limb.dofs.end(), [&](int d) { return parts.Nods(d) > least; });
    if (nods && parts.Rise(root, limb) > 0.0) return limb;
  }
  return std::nullopt;
}

}  // namespace

UpperBody FindUpperBody(const RobotModel& model) {
  const FreeParts parts(model);
  return {ArmOf(parts, Side::kLeft), ArmOf(parts, Side::kRight), HeadOf(parts)};
}

}  // namespace gaitwright
