// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/ball_joints.h"

#include <tinyxml2.h>

#include <cstring>
#include <vector>

namespace gaitwright {
namespace {

using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;

std::vector<XMLElement*> BallJoints(XMLElement& robot) {
  std::vector<XMLElement*> joints;
  for (XMLElement* j = robot.FirstChildElement("joint"); j != nullptr; j = j->NextSiblingElement("joint")) {
    if (std::strcmp(j->Attribute("type"), "spherical") == 0) joints.push_back(j);
  }
  return joints;
}

XMLElement* Added(XMLElement& parent, const char* name) { return parent.InsertNewChildElement(name); }

/// Adds a joint about one axis of a ball joint, with the effort and speed limits of the ball joint, if it has any.
XMLElement* AddTurn(XMLElement& robot, const XMLElement& ball, const std::string& name, const std::string& parent,
                    const std::string& child, const char* axis) {
  XMLElement* joint = Added(robot, "joint");
  joint->SetAttribute("name", name.c_str());
  joint->SetAttribute("type", "continuous");
  Added(*joint, "parent")->SetAttribute("link", parent.c_str());
  Added(*joint, "child")->SetAttribute("link", child.c_str());
  Added(*joint, "axis")->SetAttribute("xyz", axis);
  for (const char* kept : {"limit", "dynamics"}) {
    if (const XMLElement* element = ball.FirstChildElement(kept))
      joint->InsertEndChild(element->DeepClone(joint->GetDocument()));
  }
  return joint;
}

void Replace(XMLElement& robot, XMLElement* ball) {
  const std::string name = ball->Attribute("name");
  const std::string parent = ball->FirstChildElement("parent")->Attribute("link");
  const std::string child = ball->FirstChildElement("child")->Attribute("link");
  for (const char* between : {"_x", "_y"}) Added(robot, "link")->SetAttribute("name", (child + between).c_str());
  XMLElement* first = AddTurn(robot, *ball, name + "_x", parent, child + "_x", "1 0 0");
  if (const XMLElement* origin = ball->FirstChildElement("origin"))
    first->InsertEndChild(origin->DeepClone(first->GetDocument()));
  AddTurn(robot, *ball, name + "_y", child + "_x", child + "_y", "0 1 0");
  AddTurn(robot, *ball, name + "_z", child + "_y", child, "0 0 1");
  robot.DeleteChild(ball);
}

}  // namespace

std::string WithoutBallJoints(const std::string& urdf_text) {
  XMLDocument document;
  document.Parse(urdf_text.c_str(), urdf_text.size());
  XMLElement& robot = *document.RootElement();
  const std::vector<XMLElement*> joints = BallJoints(robot);
  if (joints.empty()) return urdf_text;
  for (XMLElement* joint : joints) Replace(robot, joint);
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace gaitwright
