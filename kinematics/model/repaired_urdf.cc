// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/repaired_urdf.h"

#include <fmt/format.h>

#include <vector>

#include "kinematics/model/mend_inertia.h"
#include "kinematics/model/mend_urdf.h"
#include "kinematics/model/urdf_pose_internal.h"
#include "kinematics/model/urdf_xml_internal.h"
#include "kinematics/spatial/symmetric_matrix.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

/// Shapes of a link in its own frame.
std::vector<Shape> ShapesInLink(const RobotModel& model, const std::string& link) {
  const Pose X_LB = model.frames[static_cast<std::size_t>(model.FrameIndex(link))].X_BF.inverse();
  std::vector<Shape> shapes;
  for (const std::vector<Shape>* all : {&model.collision_shapes, &model.visual_shapes}) {
    if (!shapes.empty()) break;
    for (Shape shape : *all) {
      if (shape.link != link) continue;
      shape.X_BS = X_LB * shape.X_BS;
      shapes.push_back(std::move(shape));
    }
  }
  return shapes;
}

/// The rotation of <origin rpy>.
Matrix3 AxesOf(const XMLElement& inertial) {
  const XMLElement* origin = inertial.FirstChildElement("origin");
  if (origin == nullptr || origin->Attribute("rpy") == nullptr) return Matrix3::Identity();
  const std::vector<double> rpy = Numbers(origin->Attribute("rpy"), 3, "rpy");
  urdf::Pose pose;
  pose.rotation.setFromRPY(rpy[0], rpy[1], rpy[2]);
  return FromUrdf(pose).linear();
}

/// @return whether the link's inertia was written anew.
bool WriteMendedInertia(const RobotModel& model, XMLElement& link) {
  XMLElement* inertial = link.FirstChildElement("inertial");
  if (inertial == nullptr) return false;
  XMLElement& inertia = *inertial->FirstChildElement("inertia");
  const auto I = [&](const char* name) { return Number(inertia, name, "inertia"); };
  const Matrix3 given = SymmetricMatrix(I("ixx"), I("ixy"), I("ixz"), I("iyy"), I("iyz"), I("izz"));
  const std::vector<Shape> shapes = ShapesInLink(model, link.Attribute("name"));
  std::vector<const Shape*> pointers;
  for (const Shape& shape : shapes) pointers.push_back(&shape);
  const Matrix3 R = AxesOf(*inertial);
  const double mass = Number(*inertial->FirstChildElement("mass"), "value", "mass");
  const auto mended = MendInertia(R * given * R.transpose(), mass, pointers);
  if (!mended || mended->was.empty()) return false;
  const Matrix3 used = R.transpose() * mended->I * R;
  const auto put = [&](const char* name, double value) {
    inertia.SetAttribute(name, fmt::format("{}", value).c_str());
  };
  put("ixx", used(0, 0));
  put("ixy", used(0, 1));
  put("ixz", used(0, 2));
  put("iyy", used(1, 1));
  put("iyz", used(1, 2));
  put("izz", used(2, 2));
  return true;
}

}  // namespace

std::string RepairedUrdf(const RobotModel& model) {
  const std::string text = MendUrdf(model.urdf_text).text;
  tinyxml2::XMLDocument document;
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS) return text;
  bool changed = false;
  XMLElement* robot = document.RootElement();
  for (XMLElement* link = robot->FirstChildElement("link"); link != nullptr; link = link->NextSiblingElement("link"))
    changed = WriteMendedInertia(model, *link) || changed;
  if (!changed) return text;
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace gaitwright
