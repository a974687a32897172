// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>
#include <tinyxml2.h>

#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The same robot as somebody else would have written it: other names, a frame in each link that is turned at random,
/// joints that count in the opposite direction, and frames without mass before joints.
class DisguisedUrdf {
 public:
  DisguisedUrdf(const std::string& urdf_text, unsigned seed) : random_(seed) {
    document_.Parse(urdf_text.c_str(), urdf_text.size());
    for (Element* link = robot().FirstChildElement("link"); link != nullptr; link = link->NextSiblingElement("link")) {
      const std::string name = link->Attribute("name");
      turn_[name] = IsRoot(name) ? Matrix3(Matrix3::Identity()) : RandomTurn();  // the root's axes are the base's
    }
    for (Element* link = robot().FirstChildElement("link"); link != nullptr; link = link->NextSiblingElement("link"))
      TurnLink(*link);
    std::vector<Element*> joints;
    for (Element* j = robot().FirstChildElement("joint"); j != nullptr; j = j->NextSiblingElement("joint"))
      joints.push_back(j);
    for (Element* joint : joints) TurnJoint(*joint);
    for (Element* joint : joints) {
      if (joint->FirstChildElement("mimic") != nullptr) Rename(*joint->FirstChildElement("mimic"), "joint", "q");
      Rename(*joint, "name", "q");
    }
  }

  std::string text() const {
    tinyxml2::XMLPrinter printer;
    document_.Print(&printer);
    return printer.CStr();
  }
  /// What a link of the original is called now.
  std::string NameOf(const std::string& link) { return Named("b", link); }

 private:
  using Element = tinyxml2::XMLElement;

  Element& robot() { return *document_.RootElement(); }

  bool IsRoot(const std::string& link) {
    for (Element* j = robot().FirstChildElement("joint"); j != nullptr; j = j->NextSiblingElement("joint")) {
      if (link == j->FirstChildElement("child")->Attribute("link")) return false;
    }
    return true;
  }

  Matrix3 RandomTurn() {
    std::normal_distribution<double> normal;
    const auto n = [&] { return normal(random_); };
    return Quaternion(n(), n(), n(), n()).normalized().toRotationMatrix();
  }

  std::string Named(const std::string& kind, const std::string& name) {
    const auto [at, is_new] = names_.try_emplace(kind + name, kind + std::to_string(names_.size() * 7919 % 10007));
    return at->second;
  }
  void Rename(Element& element, const char* attribute, const std::string& kind) {
    element.SetAttribute(attribute, Named(kind, element.Attribute(attribute)).c_str());
  }

  static Vector3 Three(const Element* element, const char* name) {
    Vector3 v = Vector3::Zero();
    if (element == nullptr || element->Attribute(name) == nullptr) return v;
    std::istringstream words(element->Attribute(name));
    words >> v.x() >> v.y() >> v.z();
    return v;
  }
  static Pose OriginOf(const Element& parent) {
    const Element* origin = parent.FirstChildElement("origin");
    const Vector3 rpy = Three(origin, "rpy");
    Pose X = Pose::Identity();
    X.translation() = Three(origin, "xyz");
    X.linear() = (Eigen::AngleAxisd(rpy.z(), Vector3::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3::UnitY()) *
                  Eigen::AngleAxisd(rpy.x(), Vector3::UnitX()))
                     .toRotationMatrix();
    return X;
  }
  static std::string Words(const Vector3& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z()); }
  static void SetOrigin(Element& parent, const Pose& X) {
    Element* origin = parent.FirstChildElement("origin");
    if (origin == nullptr) origin = parent.InsertNewChildElement("origin");
    const Vector3 ypr = X.linear().eulerAngles(2, 1, 0);
    origin->SetAttribute("xyz", Words(X.translation()).c_str());
    origin->SetAttribute("rpy", Words({ypr[2], ypr[1], ypr[0]}).c_str());
  }

  void TurnLink(Element& link) {
    const Pose X_NL(Matrix3(turn_.at(link.Attribute("name")).transpose()));  // N: the new frame
    for (const char* kind : {"inertial", "visual", "collision"}) {
      for (Element* e = link.FirstChildElement(kind); e != nullptr; e = e->NextSiblingElement(kind))
        SetOrigin(*e, X_NL * OriginOf(*e));
    }
    Rename(link, "name", "b");
  }

  void TurnJoint(Element& joint) {
    Element &parent = *joint.FirstChildElement("parent"), &child = *joint.FirstChildElement("child");
    const Matrix3 R_P = turn_.at(parent.Attribute("link")), R_C = turn_.at(child.Attribute("link"));
    Pose X = Pose(Matrix3(R_P.transpose())) * OriginOf(joint) * Pose(R_C);
    Rename(parent, "link", "b");
    Rename(child, "link", "b");
    const std::string type = joint.Attribute("type");
    if (type == "fixed") return SetOrigin(joint, X);
    if (random_() % 2 == 0) X = InsertFrame(parent).inverse() * X;
    SetOrigin(joint, X);
    TurnAxis(joint, R_C);
  }

  /// A link of nothing on the parent, which takes its place. @return where it is in the parent's frame.
  Pose InsertFrame(Element& parent) {
    Pose X(RandomTurn());
    X.translation() = Vector3(0.01, -0.02, 0.03);
    const std::string name = fmt::format("f{}", frames_++);
    robot().InsertNewChildElement("link")->SetAttribute("name", name.c_str());
    Element& fixed = *robot().InsertNewChildElement("joint");
    fixed.SetAttribute("name", ("to_" + name).c_str());
    fixed.SetAttribute("type", "fixed");
    fixed.InsertNewChildElement("parent")->SetAttribute("link", parent.Attribute("link"));
    fixed.InsertNewChildElement("child")->SetAttribute("link", name.c_str());
    SetOrigin(fixed, X);
    parent.SetAttribute("link", name.c_str());
    return X;
  }

  /// Joints that others follow, and those that follow, keep their sense: the ratio between them has a sign.
  void TurnAxis(Element& joint, const Matrix3& R_C) {
    Element* axis = joint.FirstChildElement("axis");
    Vector3 a = axis == nullptr ? Vector3(Vector3::UnitX()) : Three(axis, "xyz");
    if (axis == nullptr) axis = joint.InsertNewChildElement("axis");
    Element* limit = joint.FirstChildElement("limit");
    if (random_() % 2 == 0 && !has_mimics() && limit != nullptr && limit->Attribute("lower") != nullptr) {
      a = -a;
      const double lower = limit->DoubleAttribute("lower"), upper = limit->DoubleAttribute("upper");
      limit->SetAttribute("lower", -upper);
      limit->SetAttribute("upper", -lower);
    }
    axis->SetAttribute("xyz", Words(R_C.transpose() * a).c_str());
  }
  bool has_mimics() {
    for (Element* j = robot().FirstChildElement("joint"); j != nullptr; j = j->NextSiblingElement("joint")) {
      if (j->FirstChildElement("mimic") != nullptr) return true;
    }
    return false;
  }

  tinyxml2::XMLDocument document_;
  std::mt19937 random_;
  std::map<std::string, Matrix3> turn_;
  std::map<std::string, std::string> names_;
  int frames_ = 0;
};

}  // namespace gaitwright
