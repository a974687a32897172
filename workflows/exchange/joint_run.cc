// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "kinematics/base/result.h"
#include "kinematics/base/text.h"
#include "kinematics/dynamics/dynamics.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/joint_run_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kLongestRun = 3;

/// In lower case, without the ending "_joint".
std::string PlainName(const std::string& name) {
  std::string plain = LowerCase(name);
  constexpr std::string_view kEnding = "_joint";
  if (plain.size() > kEnding.size() && plain.ends_with(kEnding)) plain.resize(plain.size() - kEnding.size());
  return plain;
}

bool IsAxisWord(const std::string& word) {
  static const std::set<std::string> words = {"roll", "pitch", "yaw", "x", "y", "z", "rx", "ry", "rz"};
  return words.count(word) > 0;
}

/// Whether one joint carries the body from which the other starts.
bool IsNext(const RobotModel& model, int dof, int next) {
  return model.LeaderOf(next).parent_body == model.dof_joint[static_cast<std::size_t>(dof)] + 1;
}

/// Whether two hinges in series belong to one ball joint.
bool AreOneBall(const RobotModel& model, int dof, int next) {
  return IsNext(model, dof, next) && !model.LeaderOf(dof).is_prismatic() && !model.LeaderOf(next).is_prismatic() &&
         StemOf(model.LeaderOf(dof).name) == StemOf(model.LeaderOf(next).name);
}

std::vector<int> DescribedDofOrder(const RobotModel& model) {
  std::vector<int> dofs;
  for (const std::string& name : DescribedJointOrder(model)) dofs.push_back(model.DofIndex(name));
  return dofs;
}

}  // namespace

std::string StemOf(const std::string& joint_name) {
  std::string stem;
  std::istringstream words(PlainName(joint_name));
  for (std::string word; std::getline(words, word, '_');) {
    if (!IsAxisWord(word)) stem += (stem.empty() ? "" : "_") + word;
  }
  for (bool again = true; again;) {
    again = false;
    for (const std::string_view ending : {"roll", "pitch", "yaw"}) {
      if (stem.size() <= ending.size() || !stem.ends_with(ending)) continue;
      stem.resize(stem.size() - ending.size());
      again = true;
    }
  }
  return stem;
}

JointRun RunOf(const RobotModel& model, const std::vector<int>& dofs) {
  VectorX zero = VectorX::Zero(model.nq());
  zero[6] = 1.0;
  DynamicsScratch scratch(model);
  ForwardKinematics(model, zero, scratch);
  JointRun run;
  run.dofs = dofs;
  for (const int dof : dofs) {
    const Joint& joint = model.LeaderOf(dof);
    const auto parent = static_cast<std::size_t>(joint.parent_body);
    if (run.axes.empty()) run.p = scratch.p_WB[parent] + scratch.R_WB[parent] * joint.X_PJ.translation();
    run.axes.emplace_back(scratch.R_WB[parent] * joint.X_PJ.linear() * joint.axis_J);
  }
  return run;
}

std::vector<std::vector<int>> StemRuns(const RobotModel& model) {
  std::vector<std::vector<int>> runs;
  for (const int dof : DescribedDofOrder(model)) {
    const bool goes_on =
        !runs.empty() && runs.back().size() < kLongestRun && AreOneBall(model, runs.back().back(), dof);
    if (goes_on) {
      runs.back().push_back(dof);
    } else {
      runs.push_back({dof});
    }
  }
  return runs;
}

std::vector<std::vector<int>> PartnersOf(const RobotModel& model, const std::vector<std::string>& skeleton) {
  std::vector<std::vector<int>> partners(skeleton.size());
  std::vector<int> taken(model.dof_names.size(), -1);  // by which joint of the skeleton
  const auto take = [&](std::size_t joint, int dof) {
    int& by = taken[static_cast<std::size_t>(dof)];
    if (by >= 0) {
      throw InvalidArgument(fmt::format("joints '{}' and '{}' both move joint '{}' of the robot",
                                        skeleton[static_cast<std::size_t>(by)], skeleton[joint],
                                        model.dof_names[static_cast<std::size_t>(dof)]));
    }
    by = static_cast<int>(joint);
    partners[joint].push_back(dof);
  };
  for (std::size_t i = 0; i < skeleton.size(); ++i) {
    for (int dof = 0; dof < model.num_dofs(); ++dof) {
      if (PlainName(model.dof_names[static_cast<std::size_t>(dof)]) == PlainName(skeleton[i])) take(i, dof);
    }
  }
  const std::vector<std::vector<int>> runs = StemRuns(model);
  for (std::size_t i = 0; i < skeleton.size(); ++i) {
    for (const std::vector<int>& run : runs) {
      // From the joint of that name on, or the whole run.
      auto from = partners[i].empty() ? run.begin() : std::find(run.begin(), run.end(), partners[i].front());
      const bool by_stem = partners[i].empty() && run.size() > 1 &&
                           StemOf(model.dof_names[static_cast<std::size_t>(run.front())]) == PlainName(skeleton[i]);
      if (from == run.end() || (partners[i].empty() && !by_stem)) continue;
      if (!by_stem) ++from;
      for (; from != run.end() && taken[static_cast<std::size_t>(*from)] < 0; ++from) take(i, *from);
    }
  }
  return partners;
}

}  // namespace gaitwright
