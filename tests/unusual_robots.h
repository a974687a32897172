// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

namespace gaitwright::unusual {

/// The text of a URDF, put together link by link. Lengths in m, masses in kg, all scaled by `scale` and its cube;
/// efforts by its fourth power and speeds by its inverse root, so that robots of all sizes are alike.
class UrdfText {
 public:
  explicit UrdfText(double scale = 1.0) : scale_(scale) {}

  /// @param shape collision geometry in the link's frame, as Ball and Block make it, or none.
  void Link(const std::string& name, double mass, double size, const std::string& shape = "") {
    const double m = mass * scale_ * scale_ * scale_, i = 0.1 * m * size * size * scale_ * scale_;
    text_ += fmt::format(
        "<link name='{}'><inertial><mass value='{}'/><inertia ixx='{}' iyy='{}' izz='{}' ixy='0' ixz='0' iyz='0'/>"
        "</inertial>{}</link>\n",
        name, m, i, i, i, shape);
  }
  std::string Ball(double radius) const {
    return fmt::format("<collision><geometry><sphere radius='{}'/></geometry></collision>", scale_ * radius);
  }
  std::string Block(double x, double y, double z, double below = 0.0) const {
    return fmt::format("<collision><origin xyz='0 0 {}'/><geometry><box size='{} {} {}'/></geometry></collision>",
                       -scale_ * below, scale_ * x, scale_ * y, scale_ * z);
  }

  struct Motion {
    std::string type = "revolute", axis = "0 1 0";
    double lower = -1.5, upper = 1.5, effort = 40.0, turned = 0.0;  ///< turned: about z [rad]
    double speed = 20.0;
    std::string extra = {};
  };
  void Joint(const std::string& parent, const std::string& child, const std::vector<double>& xyz, const Motion& m) {
    const bool slides = m.type == "prismatic";
    text_ += fmt::format(
        "<joint name='{0}_joint' type='{1}'><parent link='{2}'/><child link='{0}'/><origin xyz='{3} {4} {5}' rpy='0 0 "
        "{6}'/><axis xyz='{7}'/><limit lower='{8}' upper='{9}' effort='{10}' velocity='{11}'/>{12}</joint>\n",
        child, m.type, parent, scale_ * xyz[0], scale_ * xyz[1], scale_ * xyz[2], m.turned, m.axis,
        slides ? scale_ * m.lower : m.lower, slides ? scale_ * m.upper : m.upper,
        m.effort * scale_ * scale_ * scale_ * (slides ? 1.0 : scale_), m.speed / std::sqrt(scale_), m.extra);
  }
  std::string Done(const std::string& name) const { return "<robot name='" + name + "'>\n" + text_ + "</robot>\n"; }

 private:
  double scale_;
  std::string text_;
};

struct Hip {
  std::string name;
  double x, y;
};

inline std::vector<Hip> Four() { return {{"a", 0.2, 0.06}, {"b", 0.2, -0.06}, {"c", -0.2, 0.06}, {"d", -0.2, -0.06}}; }

/// Abduction, hip and a knee of some kind, ending in a ball.
inline void MammalLeg(UrdfText& urdf, const Hip& hip, const UrdfText::Motion& abduction, const UrdfText::Motion& knee,
                      double shank = 0.2) {
  const std::string& n = hip.name;
  urdf.Link(n + "1", 0.4, 0.08);
  urdf.Link(n + "2", 0.7, 0.2);
  urdf.Link(n + "3", 0.25, 0.2);
  urdf.Link(n + "_foot", 0.05, 0.05, urdf.Ball(0.02));
  urdf.Joint("body", n + "1", {hip.x, hip.y, 0.0}, abduction);
  urdf.Joint(n + "1", n + "2", {0.0, hip.y > 0.0 ? 0.07 : -0.07, 0.0}, {.lower = -1.5, .upper = 3.0});
  urdf.Joint(n + "2", n + "3", {0.0, 0.0, -0.2}, knee);
  urdf.Joint(n + "3", n + "_foot", {0.0, 0.0, -shank}, {.type = "fixed"});
}

inline UrdfText::Motion Abduction() { return {.axis = "1 0 0", .lower = -0.8, .upper = 0.8}; }
inline UrdfText::Motion Knee() { return {.lower = -2.7, .upper = -0.4}; }

/// Four such legs under a body that weighs 8 kg.
inline std::string FourLegged(const UrdfText::Motion& abduction, const UrdfText::Motion& knee, double shank = 0.2,
                              double scale = 1.0) {
  UrdfText urdf(scale);
  urdf.Link("body", 8.0, 0.4, urdf.Block(0.4, 0.2, 0.1));
  for (const Hip& hip : Four()) MammalLeg(urdf, hip, abduction, knee, shank);
  return urdf.Done("four_legged");
}

inline std::string Plain(double scale = 1.0) { return FourLegged(Abduction(), Knee(), 0.2, scale); }

/// Its knees are slides of 0.15 m.
inline std::string Telescopic() {
  return FourLegged(Abduction(), {.type = "prismatic", .axis = "0 0 -1", .lower = 0.0, .upper = 0.15, .effort = 400.0},
                    0.1);
}

/// Its legs have no abduction.
inline std::string Planar() { return FourLegged({.type = "fixed"}, Knee()); }

/// Four legs of two halves each, whose hips turn about one axis; what would join the halves' ends is not there.
inline std::string OpenFiveBars() {
  UrdfText urdf;
  urdf.Link("body", 8.0, 0.4, urdf.Block(0.4, 0.2, 0.1));
  char name = 'a';
  for (const Hip& hip : Four()) {
    for (const double lateral : {0.0, 0.03}) {
      const std::string n(1, name++);
      urdf.Link(n + "1", 0.3, 0.1);
      urdf.Link(n + "2", 0.1, 0.2);
      urdf.Link(n + "_foot", 0.05, 0.05, urdf.Ball(0.02));
      urdf.Joint("body", n + "1", {hip.x, hip.y + (hip.y > 0.0 ? lateral : -lateral), 0.0}, {});
      urdf.Joint(n + "1", n + "2", {0.0, 0.0, -0.1},
                 lateral > 0.0 ? Knee() : UrdfText::Motion{.lower = 0.4, .upper = 2.7});
      urdf.Joint(n + "2", n + "_foot", {0.0, 0.0, -0.2}, {.type = "fixed"});
    }
  }
  return urdf.Done("open_five_bars");
}

/// Its knees follow its hips.
inline std::string Pantograph() {
  UrdfText urdf;
  urdf.Link("body", 8.0, 0.4, urdf.Block(0.4, 0.2, 0.1));
  for (const Hip& hip : Four()) {
    UrdfText::Motion knee = Knee();
    knee.extra = "<mimic joint='" + hip.name + "2_joint' multiplier='-2'/>";
    MammalLeg(urdf, hip, Abduction(), knee);
  }
  return urdf.Done("pantograph");
}

/// Its feet are driven wheels of 0.08 m.
inline std::string Wheeled() {
  UrdfText urdf;
  urdf.Link("body", 8.0, 0.4, urdf.Block(0.4, 0.2, 0.1));
  for (const Hip& hip : Four()) {
    const std::string& n = hip.name;
    urdf.Link(n + "1", 0.4, 0.08);
    urdf.Link(n + "2", 0.7, 0.2);
    urdf.Link(n + "3", 0.25, 0.2);
    urdf.Link(n + "_foot", 0.2, 0.1, urdf.Ball(0.08));
    urdf.Joint("body", n + "1", {hip.x, hip.y, 0.0}, Abduction());
    urdf.Joint(n + "1", n + "2", {0.0, hip.y > 0.0 ? 0.07 : -0.07, 0.0}, {.lower = -1.5, .upper = 3.0});
    urdf.Joint(n + "2", n + "3", {0.0, 0.0, -0.2}, Knee());
    urdf.Joint(n + "3", n + "_foot", {0.0, 0.0, -0.2}, {.type = "continuous"});
  }
  return urdf.Done("wheeled");
}

/// Six legs that sprawl: an upright coxa, then two joints that bend in the plane that it swings about.
inline std::string Insect() {
  UrdfText urdf;
  urdf.Link("body", 3.0, 0.4, urdf.Block(0.4, 0.2, 0.1));
  const std::vector<Hip> hips = {{"a", 0.2, 0.12},  {"b", 0.2, -0.12}, {"c", 0.0, 0.15},
                                 {"d", 0.0, -0.15}, {"e", -0.2, 0.12}, {"f", -0.2, -0.12}};
  for (const Hip& hip : hips) {
    const std::string& n = hip.name;
    urdf.Link(n + "1", 0.2, 0.06);
    urdf.Link(n + "2", 0.3, 0.12);
    urdf.Link(n + "3", 0.2, 0.15);
    urdf.Link(n + "_foot", 0.02, 0.05, urdf.Ball(0.02));
    urdf.Joint("body", n + "1", {hip.x, hip.y, 0.0},
               {.axis = "0 0 1", .lower = -1.0, .upper = 1.0, .turned = std::atan2(hip.y, hip.x)});
    urdf.Joint(n + "1", n + "2", {0.05, 0.0, 0.0}, {});
    urdf.Joint(n + "2", n + "3", {0.12, 0.0, 0.0}, {.lower = 0.0, .upper = 2.5});
    urdf.Joint(n + "3", n + "_foot", {0.2, 0.0, 0.0}, {.type = "fixed"});
  }
  return urdf.Done("insect");
}

/// Two legs of three joints that end in balls: two points to stand on.
inline std::string PointBiped() {
  UrdfText urdf;
  urdf.Link("body", 6.0, 0.4, urdf.Block(0.2, 0.2, 0.1));
  for (const Hip& hip : {Hip{"a", 0.0, 0.06}, Hip{"b", 0.0, -0.06}}) MammalLeg(urdf, hip, Abduction(), Knee());
  return urdf.Done("point_biped");
}

/// Three legs, one in front.
inline std::string Tripod() {
  UrdfText urdf;
  urdf.Link("body", 8.0, 0.4, urdf.Block(0.4, 0.2, 0.1));
  for (const Hip& hip : {Hip{"a", 0.2, 0.0}, Hip{"b", -0.15, 0.12}, Hip{"c", -0.15, -0.12}})
    MammalLeg(urdf, hip, Abduction(), Knee());
  return urdf.Done("tripod");
}

/// Two legs with soles; with or without ankles that roll them, and with a waist under arms and head or not.
inline std::string SoledBiped(bool rolls, bool waist) {
  UrdfText urdf;
  urdf.Link("body", waist ? 4.0 : 10.0, 0.25);
  if (waist) {
    urdf.Link("waist", 0.5, 0.1);
    urdf.Link("chest", 5.0, 0.25, urdf.Block(0.15, 0.2, 0.3, -0.2));
    urdf.Joint("body", "waist", {0.0, 0.0, 0.1}, {.axis = "0 0 1"});
    urdf.Joint("waist", "chest", {0.0, 0.0, 0.05}, {.lower = -0.5, .upper = 0.5});
    for (const double side : {1.0, -1.0}) {
      const std::string n = side > 0.0 ? "left_arm" : "right_arm";
      urdf.Link(n, 0.6, 0.2);
      urdf.Link(n + "_hand", 0.4, 0.15);
      urdf.Joint("chest", n, {0.0, 0.15 * side, 0.3}, {.lower = -3.0, .upper = 3.0});
      urdf.Joint(n, n + "_hand", {0.0, 0.05 * side, -0.2}, {.lower = -2.0, .upper = 0.0});
    }
  }
  for (const double side : {1.0, -1.0}) {
    const std::string n = side > 0.0 ? "l" : "r";
    urdf.Link(n + "1", 0.3, 0.06);
    urdf.Link(n + "2", 0.3, 0.06);
    urdf.Link(n + "3", 1.0, 0.25);
    urdf.Link(n + "4", 0.8, 0.25);
    urdf.Joint("body", n + "1", {0.0, 0.1 * side, -0.05},
               {.axis = "0 0 1", .lower = -0.8, .upper = 0.8, .effort = 90.0});
    urdf.Joint(n + "1", n + "2", {0.0, 0.0, 0.0}, {.axis = "1 0 0", .lower = -0.6, .upper = 0.6, .effort = 90.0});
    urdf.Joint(n + "2", n + "3", {0.0, 0.0, 0.0}, {.lower = -1.8, .upper = 1.2, .effort = 90.0});
    urdf.Joint(n + "3", n + "4", {0.0, 0.0, -0.3}, {.lower = 0.0, .upper = 2.5, .effort = 90.0});
    if (rolls) {
      urdf.Link(n + "5", 0.1, 0.06);
      urdf.Joint(n + "4", n + "5", {0.0, 0.0, -0.3}, {.lower = -1.0, .upper = 1.0, .effort = 90.0});
    }
    urdf.Link(n + "_foot", 0.4, 0.15, urdf.Block(0.2, 0.1, 0.02, 0.05));
    const UrdfText::Motion roll{.axis = "1 0 0", .lower = -0.6, .upper = 0.6, .effort = 90.0};
    const UrdfText::Motion pitch{.lower = -1.0, .upper = 1.0, .effort = 90.0};
    urdf.Joint(rolls ? n + "5" : n + "4", n + "_foot", {0.0, 0.0, rolls ? 0.0 : -0.3}, rolls ? roll : pitch);
  }
  return urdf.Done("soled_biped");
}

/// A humanoid of 45 kg and 0.87 m of leg, as strong in the legs as the Unitree H1 (hips 200 N m and 23 rad/s, knees 300
/// and 14, ankles 40 and 9, arms 40 and 9), with ankles that roll.
inline std::string Runner() {
  UrdfText urdf;
  urdf.Link("body", 20.0, 0.5, urdf.Block(0.2, 0.3, 0.5, -0.35));
  for (const double side : {1.0, -1.0}) {
    const std::string n = side > 0.0 ? "l" : "r";
    const auto hip = [](const std::string& axis, double lower, double upper) {
      return UrdfText::Motion{.axis = axis, .lower = lower, .upper = upper, .effort = 200.0, .speed = 23.0};
    };
    const auto ankle = [](const std::string& axis, double most) {
      return UrdfText::Motion{.axis = axis, .lower = -most, .upper = most, .effort = 40.0, .speed = 9.0};
    };
    urdf.Link(n + "_arm", 1.5, 0.25);
    urdf.Link(n + "_forearm", 1.0, 0.25);
    urdf.Joint("body", n + "_arm", {0.0, 0.22 * side, 0.5}, {.lower = -2.8, .upper = 2.8, .speed = 9.0});
    urdf.Joint(n + "_arm", n + "_forearm", {0.0, 0.0, -0.25}, {.lower = -2.2, .upper = 0.0, .effort = 18.0});
    urdf.Link(n + "_yaw", 1.5, 0.1);
    urdf.Link(n + "_hip", 1.5, 0.1);
    urdf.Link(n + "_thigh", 4.0, 0.35);
    urdf.Link(n + "_shank", 2.2, 0.35);
    urdf.Link(n + "_ankle", 0.2, 0.06);
    urdf.Link(n + "_foot", 0.6, 0.2, urdf.Block(0.2, 0.1, 0.02, 0.06));
    urdf.Joint("body", n + "_yaw", {0.0, 0.1 * side, 0.0}, hip("0 0 1", -0.6, 0.6));
    urdf.Joint(n + "_yaw", n + "_hip", {0.0, 0.0, -0.05}, hip("1 0 0", -0.5, 0.5));
    urdf.Joint(n + "_hip", n + "_thigh", {0.0, 0.0, 0.0}, hip("0 1 0", -2.2, 1.5));
    urdf.Joint(n + "_thigh", n + "_shank", {0.0, 0.0, -0.4},
               {.lower = -0.1, .upper = 2.2, .effort = 300.0, .speed = 14.0});
    urdf.Joint(n + "_shank", n + "_ankle", {0.0, 0.0, -0.4}, ankle("0 1 0", 1.0));
    urdf.Joint(n + "_ankle", n + "_foot", {0.0, 0.0, 0.0}, ankle("1 0 0", 0.5));
  }
  return urdf.Done("runner");
}

/// A four-legged one that carries an arm in front and a tail behind.
inline std::string ArmAndTail() {
  UrdfText urdf;
  urdf.Link("body", 8.0, 0.4, urdf.Block(0.4, 0.2, 0.1));
  for (const Hip& hip : Four()) MammalLeg(urdf, hip, Abduction(), Knee());
  urdf.Link("arm1", 0.4, 0.1);
  urdf.Link("arm2", 0.4, 0.2);
  urdf.Joint("body", "arm1", {0.15, 0.0, 0.08}, {.axis = "0 0 1"});
  urdf.Joint("arm1", "arm2", {0.0, 0.0, 0.15}, {});
  urdf.Link("tail1", 0.2, 0.1);
  urdf.Link("tail2", 0.1, 0.1);
  urdf.Joint("body", "tail1", {-0.2, 0.0, 0.0}, {});
  urdf.Joint("tail1", "tail2", {-0.15, 0.0, 0.0}, {});
  return urdf.Done("arm_and_tail");
}

}  // namespace gaitwright::unusual
