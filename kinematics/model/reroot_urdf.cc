// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/reroot_urdf.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "kinematics/model/urdf_pose_internal.h"
#include "kinematics/model/urdf_xml_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

constexpr int kLeastMoving = 3;  // moving joints of a limb whose end may be the root

struct UrdfEdge {
  XMLElement* joint = nullptr;
  std::string parent, child;
  bool moves = false;
};

/// Links and joints of a URDF as a tree.
struct UrdfGraph {
  explicit UrdfGraph(XMLElement& robot) {
    for (XMLElement* l = robot.FirstChildElement("link"); l != nullptr; l = l->NextSiblingElement("link"))
      links[l->Attribute("name")] = l;
    std::set<std::string> children;
    for (XMLElement* j = robot.FirstChildElement("joint"); j != nullptr; j = j->NextSiblingElement("joint")) {
      UrdfEdge edge{j, j->FirstChildElement("parent")->Attribute("link"),
                    j->FirstChildElement("child")->Attribute("link"), std::string("fixed") != j->Attribute("type")};
      children.insert(edge.child);
      below[edge.parent].push_back(edge);
    }
    for (const auto& [name, element] : links) {
      if (!children.contains(name)) root = name;
    }
    NoteMotion();
  }

  const std::vector<UrdfEdge>& Below(const std::string& link) const {
    static const std::vector<UrdfEdge> none;
    const auto found = below.find(link);
    return found == below.end() ? none : found->second;
  }
  double MassOf(const std::string& link) const {
    const XMLElement* inertial = links.at(link)->FirstChildElement("inertial");
    const XMLElement* mass = inertial == nullptr ? nullptr : inertial->FirstChildElement("mass");
    return mass == nullptr ? 0.0 : mass->DoubleAttribute("value");
  }
  /// Mass of a link and of the links fixed beyond it [kg].
  double MassOfBody(const std::string& link) const {
    double mass = 0.0;
    std::vector<std::string> open = {link};
    while (!open.empty()) {
      const std::string at = open.back();
      open.pop_back();
      mass += MassOf(at);
      for (const UrdfEdge& edge : Below(at)) {
        if (!edge.moves) open.push_back(edge.child);
      }
    }
    return mass;
  }
  /// Joints below a link that move, or that carry a moving joint.
  std::vector<UrdfEdge> MovingBelow(const std::string& link) const {
    std::vector<UrdfEdge> moving;
    for (const UrdfEdge& edge : Below(link)) {
      if (edge.moves || carries_motion.contains(edge.child)) moving.push_back(edge);
    }
    return moving;
  }

  std::map<std::string, XMLElement*> links;
  std::map<std::string, std::vector<UrdfEdge>> below;
  std::set<std::string> carries_motion;  // links with a moving joint beyond them
  std::string root;

 private:
  void NoteMotion() {
    std::vector<std::string> order = {root};
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::vector<UrdfEdge>& edges = Below(order[i]);
      for (const UrdfEdge& edge : edges) order.push_back(edge.child);
    }
    while (!order.empty()) {
      if (!MovingBelow(order.back()).empty()) carries_motion.insert(order.back());
      order.pop_back();
    }
  }
};

/// The joints from the root to the first branch of the tree.
std::vector<UrdfEdge> StemOf(const UrdfGraph& graph) {
  std::vector<UrdfEdge> stem;
  for (std::vector<UrdfEdge> next = graph.MovingBelow(graph.root); next.size() == 1;
       next = graph.MovingBelow(stem.back().child))
    stem.push_back(next.front());
  return stem;
}

int MovingIn(const std::vector<UrdfEdge>& edges) {
  return static_cast<int>(std::count_if(edges.begin(), edges.end(), [](const UrdfEdge& e) { return e.moves; }));
}

/// Whether a link carries a limb without branches that has this number of moving joints and about this mass at its end.
bool HasLimbLike(const UrdfGraph& graph, const std::string& link, int moving, double mass) {
  constexpr double kAlike = 0.2;
  for (const UrdfEdge& first : graph.MovingBelow(link)) {
    std::vector<UrdfEdge> limb = {first};
    for (std::vector<UrdfEdge> next = graph.MovingBelow(first.child); next.size() == 1;
         next = graph.MovingBelow(limb.back().child))
      limb.push_back(next.front());
    const auto last = std::find_if(limb.rbegin(), limb.rend(), [](const UrdfEdge& e) { return e.moves; });
    const double end = graph.MassOfBody(last->child);
    if (MovingIn(limb) == moving && std::abs(end - mass) <= kAlike * std::max(end, mass)) return true;
  }
  return false;
}

/// Number of joints of the stem up to the body that carries the limbs; 0 if there is no such body.
std::size_t StemToBody(const UrdfGraph& graph, const std::vector<UrdfEdge>& stem) {
  if (stem.empty()) return 0;
  std::size_t to = stem.size();
  if (graph.MovingBelow(stem.back().child).empty()) {  // a single chain
    const auto lighter = [&](const UrdfEdge& a, const UrdfEdge& b) {
      return graph.MassOf(a.child) < graph.MassOf(b.child);
    };
    to = static_cast<std::size_t>(std::max_element(stem.begin(), stem.end(), lighter) - stem.begin()) + 1;
  }
  const std::vector<UrdfEdge> limb(stem.begin(), stem.begin() + static_cast<std::ptrdiff_t>(to));
  const int moving = MovingIn(limb);
  if (moving < kLeastMoving) return 0;
  return HasLimbLike(graph, limb.back().child, moving, graph.MassOfBody(graph.root)) ? to : 0;
}

Pose OriginOf(const XMLElement& owner) {
  urdf::Pose pose;
  if (const XMLElement* origin = owner.FirstChildElement("origin")) {
    const auto three = [&](const char* name) {
      return origin->Attribute(name) == nullptr ? std::vector<double>(3, 0.0)
                                                : Numbers(origin->Attribute(name), 3, name);
    };
    const std::vector<double> xyz = three("xyz"), rpy = three("rpy");
    pose.position = urdf::Vector3(xyz[0], xyz[1], xyz[2]);
    pose.rotation.setFromRPY(rpy[0], rpy[1], rpy[2]);
  }
  return FromUrdf(pose);
}

void SetOrigin(const Pose& X, XMLElement& owner) {
  XMLElement* origin = owner.FirstChildElement("origin");
  if (origin == nullptr) origin = owner.InsertNewChildElement("origin");
  const Matrix3 R = X.linear();
  const double level = std::hypot(R(0, 0), R(1, 0)), pitch = std::atan2(-R(2, 0), level);
  const bool upright = level < 1e-9;  // roll and yaw turn about one axis then
  const double roll = upright ? std::atan2(-R(1, 2), R(1, 1)) : std::atan2(R(2, 1), R(2, 2));
  const double yaw = upright ? 0.0 : std::atan2(R(1, 0), R(0, 0));
  const Vector3& p = X.translation();
  origin->SetAttribute("xyz", fmt::format("{:.17g} {:.17g} {:.17g}", p.x(), p.y(), p.z()).c_str());
  origin->SetAttribute("rpy", fmt::format("{:.17g} {:.17g} {:.17g}", roll, pitch, yaw).c_str());
}

/// Moves the frame of a link to X_LN and expresses its elements in the new frame.
void MoveFrame(const Pose& X_LN, XMLElement& link) {
  for (const char* part : {"inertial", "visual", "collision"}) {
    for (XMLElement* e = link.FirstChildElement(part); e != nullptr; e = e->NextSiblingElement(part))
      SetOrigin(X_LN.inverse() * OriginOf(*e), *e);
  }
}

/// Swaps parent and child of a joint. @param X_from  pose of the joint in the frame of its new parent.
void TurnOver(const UrdfEdge& edge, const Pose& X_from) {
  edge.joint->FirstChildElement("parent")->SetAttribute("link", edge.child.c_str());
  edge.joint->FirstChildElement("child")->SetAttribute("link", edge.parent.c_str());
  SetOrigin(X_from, *edge.joint);
  if (!edge.moves) return;
  XMLElement* axis = edge.joint->FirstChildElement("axis");
  Vector3 along = Vector3::UnitX();
  if (axis == nullptr) {
    axis = edge.joint->InsertNewChildElement("axis");
  } else if (axis->Attribute("xyz") != nullptr) {
    const std::vector<double> xyz = Numbers(axis->Attribute("xyz"), 3, "axis");
    along = Vector3(xyz[0], xyz[1], xyz[2]);
  }
  axis->SetAttribute("xyz", fmt::format("{:.17g} {:.17g} {:.17g}", -along.x(), -along.y(), -along.z()).c_str());
}

}  // namespace

std::optional<RerootedUrdf> RerootFromLimbEnd(const std::string& urdf_text) try {
  tinyxml2::XMLDocument document;
  document.Parse(urdf_text.c_str(), urdf_text.size());
  if (document.Error() || document.RootElement() == nullptr) return std::nullopt;
  const UrdfGraph graph(*document.RootElement());
  std::vector<UrdfEdge> stem = StemOf(graph);
  stem.resize(StemToBody(graph, stem));
  if (stem.empty()) return std::nullopt;
  std::vector<Pose> X_LN;  // new frame of each link of the stem
  for (const UrdfEdge& edge : stem) X_LN.push_back(OriginOf(*edge.joint));
  for (std::size_t i = 0; i < stem.size(); ++i) {
    MoveFrame(X_LN[i], *graph.links.at(stem[i].parent));
    for (const UrdfEdge& side : graph.Below(stem[i].parent)) {
      if (side.joint != stem[i].joint) SetOrigin(X_LN[i].inverse() * OriginOf(*side.joint), *side.joint);
    }
  }
  for (std::size_t i = 0; i < stem.size(); ++i) {
    const bool last = i + 1 == stem.size();
    TurnOver(stem[i], last ? Pose::Identity() : Pose(X_LN[i + 1].inverse()));
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return RerootedUrdf{printer.CStr(), stem.back().child, graph.root};
} catch (const Failure&) {  // an invalid number, which other checks report
  return std::nullopt;
}

}  // namespace gaitwright
