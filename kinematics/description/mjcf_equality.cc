// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "kinematics/base/nearest_name.h"
#include "kinematics/description/mjcf_equality_internal.h"
#include "kinematics/description/mjcf_loops_internal.h"

namespace gaitwright {
namespace {

/// The joint that an equality names; -1 if it does not name a joint.
int MjcfCoupledJoint(const MjcfAttributes& attributes, const MjcfTree& tree, const std::string& key) {
  const std::string name = attributes.Name(key);
  if (name.empty()) return -1;
  const auto at = tree.joint_named.find(name);
  if (at != tree.joint_named.end()) return at->second;
  std::vector<std::string> names;
  for (const auto& [known, index] : tree.joint_named) names.push_back(known);
  RefuseMjcf(FailureCode::kMjcfEquality, fmt::format("{}: its {} '{}' does not exist{}", attributes.owner(), key,
                                                     ShownMjcf(name), NearestOrAll(name, names)));
}

/// Adds couplings of joints one after the other.
class MjcfCoupler {
 public:
  MjcfCoupler(MjcfContext& context, const MjcfTree& tree, const std::vector<MjcfDrive>& drives)
      : context_(context), tree_(tree), drives_(drives), couplings_(tree.joints.size()) {}

  /// Adds MuJoCo's constraint q1 - ref1 = a0 + a1 (q2 - ref2) + ...
  void Couple(const MjcfAttributes& attributes) {
    const int first = MjcfCoupledJoint(attributes, tree_, "joint1");
    const int second = MjcfCoupledJoint(attributes, tree_, "joint2");
    if (first < 0) RefuseMjcf(FailureCode::kMjcfMissing, fmt::format("{}: it has no 'joint1'", attributes.owner()));
    if (!tree_.IsRobotJoint(first) && (second < 0 || !tree_.IsRobotJoint(second)))
      return;  // there is a note on its body
    if (!tree_.Moves(first) || (second >= 0 && !tree_.Moves(second))) {
      context_.Note(attributes.owner(), "it couples a joint that is left out; the equality is left out too");
      return;
    }
    if (!JointAt(first).is_scalar() || (second >= 0 && !JointAt(second).is_scalar()) || first == second)
      RefuseMjcf(
          FailureCode::kMjcfEquality,
          fmt::format(
              "{}: it couples a ball joint, or a joint to itself; two different hinge or slide joints are accepted",
              attributes.owner()));
    std::vector<double> a = {0.0, 1.0, 0.0, 0.0, 0.0};
    const std::vector<double> given = attributes.Numbers("polycoef", 1, a.size());
    std::copy(given.begin(), given.end(), a.begin());
    if (a[2] != 0.0 || a[3] != 0.0 || a[4] != 0.0)
      RefuseMjcf(FailureCode::kMjcfEquality,
                 fmt::format("{}: 'polycoef' is '{}'; only linear couplings are supported: the last "
                             "three numbers must be 0",
                             attributes.owner(), ShownMjcf(attributes.Text("polycoef"))));
    constexpr double kLeast = 1e-6, kMost = 1e6;
    if (a[1] != 0.0 && !(std::abs(a[1]) >= kLeast && std::abs(a[1]) <= kMost))
      RefuseMjcf(FailureCode::kMjcfEquality,
                 fmt::format("{}: the second number of 'polycoef' is {}; accepted: 0, or a magnitude of {} to {}",
                             attributes.owner(), a[1], kLeast, kMost));
    if (second < 0 || a[1] == 0.0) {
      Lock(attributes, first, JointAt(first).ref + a[0]);
    } else {
      const double offset = JointAt(first).ref + a[0] - a[1] * JointAt(second).ref;
      Follow(attributes, {first, second}, a[1], offset);
    }
  }

  std::vector<MjcfCoupling>& couplings() { return couplings_; }

  /// Returns the couplings. A joint that follows a locked joint becomes locked too.
  std::vector<MjcfCoupling> Take() {
    for (std::size_t j = 0; j < couplings_.size(); ++j) {
      std::vector<int> chain = {static_cast<int>(j)};
      while (CouplingOf(chain.back()).leader >= 0) chain.push_back(CouplingOf(chain.back()).leader);
      for (std::size_t i = chain.size() - 1; i > 0 && CouplingOf(chain[i]).locked; --i) {
        const MjcfCoupling follows = CouplingOf(chain[i - 1]);
        CouplingOf(chain[i - 1]) = {-1, 1.0, 0.0, follows.multiplier * *CouplingOf(chain[i]).locked + follows.offset};
      }
    }
    return std::move(couplings_);
  }

 private:
  const MjcfJoint& JointAt(int joint) const { return tree_.joints[static_cast<std::size_t>(joint)]; }
  MjcfCoupling& CouplingOf(int joint) { return couplings_[static_cast<std::size_t>(joint)]; }
  bool IsDriven(int joint) const { return drives_[static_cast<std::size_t>(joint)].actuators > 0; }

  void RefuseSecond(const MjcfAttributes& attributes, int joint) const {
    RefuseMjcf(FailureCode::kMjcfEquality, fmt::format("{}: joint '{}' is already coupled by another equality",
                                                       attributes.owner(), JointAt(joint).name));
  }

  void Lock(const MjcfAttributes& attributes, int joint, double position) {
    if (!CouplingOf(joint).moves_alone()) RefuseSecond(attributes, joint);
    CouplingOf(joint).locked = position;
    context_.Note(attributes.owner(),
                  fmt::format("joint '{}' is locked at {} and becomes a fixed joint", JointAt(joint).name, position));
  }

  /// Whether the leaders of `leader` include `joint`.
  bool LeadsTo(int leader, int joint) {
    for (int at = leader; at >= 0; at = CouplingOf(at).leader) {
      if (at == joint) return true;
    }
    return false;
  }

  /// Makes the first joint follow the second one. If only the first has an actuator, or if it already follows another
  /// joint, the second follows the first.
  void Follow(const MjcfAttributes& attributes, std::pair<int, int> joints, double multiplier, double offset) {
    auto [follower, leader] = joints;
    const bool reversed = !CouplingOf(follower).moves_alone() || (IsDriven(follower) && !IsDriven(leader));
    if (reversed && CouplingOf(leader).moves_alone()) {
      std::swap(follower, leader);
      offset = -offset / multiplier;
      multiplier = 1.0 / multiplier;
    }
    if (!CouplingOf(follower).moves_alone()) RefuseSecond(attributes, follower);
    if (LeadsTo(leader, follower))
      RefuseMjcf(FailureCode::kMjcfEquality,
                 fmt::format("{}: the joints follow one another in a cycle", attributes.owner()));
    CouplingOf(follower) = {leader, multiplier, offset, std::nullopt};
    if (IsDriven(follower))
      context_.Note(attributes.owner(), fmt::format("joint '{}' follows '{}'; its own actuators are left out",
                                                    JointAt(follower).name, JointAt(leader).name));
  }

  MjcfContext& context_;
  const MjcfTree& tree_;
  const std::vector<MjcfDrive>& drives_;
  std::vector<MjcfCoupling> couplings_;
};

}  // namespace

std::vector<MjcfCoupling> ReadMjcfCouplings(MjcfContext& context, const MjcfTree& tree,
                                            const std::vector<MjcfDrive>& drives, const std::vector<double>& masses) {
  MjcfCoupler coupler(context, tree, drives);
  for (const tinyxml2::XMLElement* element : context.document.InSections("equality")) {
    const std::string tag = element->Name();
    const MjcfAttributes attributes = context.defaults.Of(*element, "equality");
    if (!attributes.Flag("active", true)) {
      context.Note(attributes.owner(), "it is not active; it is left out");
    } else if (tag == "joint") {
      coupler.Couple(attributes);
    } else if (tag != "connect" && tag != "weld") {
      RefuseMjcf(
          FailureCode::kMjcfEquality,
          fmt::format("{}: an equality <{}> is not supported; only joint equalities are", attributes.owner(), tag));
    }
  }
  LockMjcfLoops(context, tree, masses, coupler.couplings());
  return coupler.Take();
}

}  // namespace gaitwright
