// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "kinematics/collision/link_distances_internal.h"
#include "kinematics/model/body_tree.h"
#include "workflows/repair/part_links_internal.h"

namespace gaitwright {
namespace {

class LinkParter {
 public:
  LinkParter(const RobotModel& model, double least_m)
      : model_(model), least_m_(least_m), distances_(model), scratch_(model), of_leg_(DofsOfLegs(model)) {}

  std::vector<PartedLinks> Run(EvenMotion& motion) {
    constexpr double kFades = 0.15;  // [s]
    const double fade = std::exp(-motion.step_s / kFades);
    VectorX moved = VectorX::Zero(model_.num_dofs());
    for (int row = 0; row < motion.size(); ++row) {
      VectorX& q = motion.q[static_cast<std::size_t>(row)];
      const VectorX given = q.tail(model_.num_dofs());
      ForwardKinematics(model_, q, scratch_);
      for (const NearPair& near : distances_.Near(scratch_, 0.0)) Add(near, motion.TimeOf(row));
      moved *= fade;
      if (!moved.isZero(1e-9)) Set(given + moved, q);
      Part(q);
      moved = q.tail(model_.num_dofs()) - given;
    }
    std::vector<PartedLinks> parted;
    for (auto& [pair, links] : parted_) parted.push_back(std::move(links));
    std::stable_sort(parted.begin(), parted.end(), [](const auto& a, const auto& b) { return a.depth_m > b.depth_m; });
    return parted;
  }

 private:
  void Add(const NearPair& near, double at_s) {
    if (near.distance_m >= 0.0) return;
    const auto [found, is_new] = parted_.try_emplace(near.pair);
    PartedLinks& links = found->second;
    if (is_new) links = {distances_.NameOf(near.pair), 0.0, at_s, at_s};
    links.depth_m = std::max(links.depth_m, -near.distance_m);
    links.end_s = at_s;
  }

  /// Sets the joints, within their ranges as far as they were.
  void Set(const VectorX& joints, VectorX& q) const {
    for (int dof = 0; dof < model_.num_dofs(); ++dof) {
      if (of_leg_[static_cast<std::size_t>(dof)]) continue;
      const double before = q[7 + dof];
      q[7 + dof] =
          std::clamp(joints[dof], std::min(before, model_.dof_lower(dof)), std::max(before, model_.dof_upper(dof)));
    }
  }

  void Part(VectorX& q) {
    constexpr int kIterations = 12;
    VectorX gradient(model_.nv());
    for (int i = 0; i < kIterations; ++i) {
      ForwardKinematics(model_, q, scratch_);
      VectorX change = VectorX::Zero(model_.num_dofs());
      int count = 0;
      for (const NearPair& near : distances_.Near(scratch_, least_m_)) {
        const double lacking = std::min(least_m_, 0.5 * distances_.standing_m(near.pair)) - near.distance_m;
        if (lacking <= 0.0) continue;
        gradient.setZero();
        distances_.AddGradient(near.pair, distances_.At(near.pair, scratch_), scratch_, 1.0, gradient);
        VectorX by = gradient.tail(model_.num_dofs());
        for (int dof = 0; dof < model_.num_dofs(); ++dof) {
          if (of_leg_[static_cast<std::size_t>(dof)]) by[dof] = 0.0;
        }
        constexpr double kUseless = 1e-4;  // [m^2]
        if (by.squaredNorm() < kUseless) continue;
        change += lacking / by.squaredNorm() * by;
        ++count;
      }
      if (count == 0) return;
      Set(q.tail(model_.num_dofs()) + change / count, q);
    }
  }

  const RobotModel& model_;
  const double least_m_;
  LinkDistances distances_;
  DynamicsScratch scratch_;
  const std::vector<bool> of_leg_;
  std::map<int, PartedLinks> parted_;  ///< by pair
};

}  // namespace

std::vector<PartedLinks> PartLinks(const RobotModel& model, double least_m, EvenMotion& motion) {
  return LinkParter(model, least_m).Run(motion);
}

}  // namespace gaitwright
