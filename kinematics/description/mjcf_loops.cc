// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/description/mjcf_loops_internal.h"

namespace gaitwright {
namespace {

/// A part is small if its mass is less than kMostOfMass of the robot's. It carries no foot if all of it is higher above
/// the lowest body than kLeastOfHeight of the robot's height.
constexpr double kMostOfMass = 0.1, kLeastOfHeight = 0.25;

/// The body at one end of a tie, from the name of the body or of a site; -1 for the world. Throws a Failure for an
/// unknown name.
int EndOfMjcfTie(const MjcfAttributes& attributes, const MjcfTree& tree, const std::string& number) {
  const bool by_site = attributes.Has("site" + number);
  const std::string key = (by_site ? "site" : "body") + number, name = attributes.Name(key);
  if (!by_site && (name.empty() || name == "world")) return -1;
  const auto& named = by_site ? tree.body_of_site : tree.body_named;
  if (const auto at = named.find(name); at != named.end()) return at->second;
  std::vector<std::string> names;
  for (const auto& [known, body] : named) names.push_back(known);
  RefuseMjcf(FailureCode::kMjcfEquality, fmt::format("{}: its {} '{}' does not exist{}", attributes.owner(), key,
                                                     ShownMjcf(name), NearestOrAll(name, names)));
}

/// A body and its ancestors, up to the first body of its tree.
std::vector<int> MjcfCarriers(const MjcfTree& tree, int body) {
  std::vector<int> chain;
  for (int b = body; b >= 0; b = tree.bodies[static_cast<std::size_t>(b)].parent) chain.push_back(b);
  return chain;
}

/// The bodies of the loop that a tie closes: both branches below the last common ancestor of its ends.
std::vector<int> LoopOfMjcf(const MjcfTree& tree, int one, int other) {
  std::vector<int> a = MjcfCarriers(tree, one), b = MjcfCarriers(tree, other);
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.pop_back();
    b.pop_back();
  }
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<int> JointsOfMjcf(const MjcfTree& tree, const std::vector<int>& bodies) {
  std::vector<int> joints;
  for (const int b : bodies) {
    const std::vector<int>& own = tree.bodies[static_cast<std::size_t>(b)].joints;
    joints.insert(joints.end(), own.begin(), own.end());
  }
  return joints;
}

std::string NamesOfMjcfJoints(const MjcfTree& tree, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int j : joints) names.push_back(ShownMjcf(tree.joints[static_cast<std::size_t>(j)].name));
  return QuotedList(names);
}

/// Whether the bodies and the parts that they carry are light and far from the ground in the pose of the file.
bool IsSmallMjcfPart(const MjcfTree& tree, const std::vector<double>& masses, const std::vector<int>& bodies) {
  const std::size_t count = tree.bodies.size();
  std::vector<bool> in_part(count, false);
  for (const int b : bodies) in_part[static_cast<std::size_t>(b)] = true;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double part = 0.0, all = 0.0, lowest = kFar, highest = -kFar, lowest_of_part = kFar;
  std::vector<Pose> X_WB(count, Pose::Identity());
  for (std::size_t b = 0; b < count; ++b) {
    const int parent = tree.bodies[b].parent;
    if (parent >= 0) {
      X_WB[b] = X_WB[static_cast<std::size_t>(parent)] * tree.bodies[b].X_PB;
      in_part[b] = in_part[b] || in_part[static_cast<std::size_t>(parent)];
    } else {
      X_WB[b] = tree.bodies[b].X_PB;
    }
    if (!tree.in_robot[b]) continue;
    const double z = X_WB[b].translation().z();
    all += masses[b];
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
    if (!in_part[b]) continue;
    part += masses[b];
    lowest_of_part = std::min(lowest_of_part, z);
  }
  return part <= kMostOfMass * all && lowest_of_part >= lowest + kLeastOfHeight * (highest - lowest) &&
         highest > lowest;
}

/// Locks a joint at a position, and the joints that lead it at the matching positions.
void LockMjcfJoint(int joint, double position, std::vector<MjcfCoupling>& couplings) {
  for (std::size_t steps = 0; joint >= 0 && steps <= couplings.size(); ++steps) {
    const MjcfCoupling before = couplings[static_cast<std::size_t>(joint)];
    if (before.locked) return;
    couplings[static_cast<std::size_t>(joint)] = {-1, 1.0, 0.0, position};
    position = (position - before.offset) / before.multiplier;
    joint = before.leader;
  }
}

}  // namespace

void LockMjcfLoops(MjcfContext& context, const MjcfTree& tree, const std::vector<double>& masses,
                   std::vector<MjcfCoupling>& couplings) {
  for (const tinyxml2::XMLElement* element : context.document.InSections("equality")) {
    const std::string tag = element->Name();
    const MjcfAttributes attributes = context.defaults.Of(*element, "equality");
    if ((tag != "connect" && tag != "weld") || !attributes.Flag("active", true)) continue;
    const int one = EndOfMjcfTie(attributes, tree, "1"), other = EndOfMjcfTie(attributes, tree, "2");
    const auto is_robots = [&](int body) { return body >= 0 && tree.in_robot[static_cast<std::size_t>(body)]; };
    if (!is_robots(one) && !is_robots(other)) {
      context.Note(attributes.owner(), "it is not part of the robot; it is left out");
      continue;
    }
    if (!is_robots(one) || !is_robots(other))
      RefuseMjcf(FailureCode::kMjcfLoop,
                 fmt::format("{}: it ties the robot to the world or to another body; a walking robot must be free",
                             attributes.owner()));
    const std::vector<int> bodies = LoopOfMjcf(tree, one, other);
    const std::vector<int> joints = JointsOfMjcf(tree, bodies);
    if (!IsSmallMjcfPart(tree, masses, bodies))
      RefuseMjcf(
          FailureCode::kMjcfLoop,
          fmt::format("{}: it closes a loop of the joints {}, but the joints must form a tree; if the loop only "
                      "transmits a motor's torque, remove it and its rods and put the actuator on the driven joint",
                      attributes.owner(), NamesOfMjcfJoints(tree, joints)));
    for (const int j : joints) LockMjcfJoint(j, tree.joints[static_cast<std::size_t>(j)].ref, couplings);
    if (!joints.empty())
      context.Note(attributes.owner(),
                   fmt::format("it closes a loop of the joints {}, which are locked in the posture of the file",
                               NamesOfMjcfJoints(tree, joints)));
  }
}

}  // namespace gaitwright
