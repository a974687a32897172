// SPDX-License-Identifier: BSD-3-Clause
#include <tinyxml2.h>

#include "kinematics/model/mend_urdf_internal.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// A repaired element: its text in one line, the findings, and whether it was changed.
struct MendedPart {
  std::string text;
  std::vector<Finding> findings;
  bool changed = false;

  std::vector<FailureCode> codes() const {
    std::vector<FailureCode> all;
    for (const Finding& finding : findings) all.push_back(finding.code);
    return all;
  }
};

template <class Mend>
MendedPart MendedBy(const std::string& text, const Mend& mend) {
  tinyxml2::XMLDocument xml;
  xml.Parse(text.c_str());
  EXPECT_FALSE(xml.Error()) << text;
  MendedPart made;
  made.changed = mend(*xml.RootElement(), made.findings);
  tinyxml2::XMLPrinter printer(nullptr, true);
  xml.Print(&printer);
  made.text = Replaced(printer.CStr(), "\"", "'");
  return made;
}

MendedPart MendedLinkOf(const std::string& inside) {
  return MendedBy("<link name='l'>" + inside + "</link>", [](auto& e, auto& findings) {
    return MendLink(e, {PartKind::kLink, "l"}, findings);
  });
}

MendedPart MendedJointOf(const std::string& type, const std::string& inside, bool at_root = false) {
  return MendedBy("<joint type='" + type + "'>" + inside + "</joint>", [&](auto& e, auto& findings) {
    return MendJoint(e, {PartKind::kJoint, "j"}, at_root, findings);
  });
}

TEST(MendParts, SoundPartsStayAsTheyAre) {
  const std::string link =
      "<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>"
      "<collision><geometry><box size='1 2 3'/></geometry></collision>";
  const MendedPart same = MendedLinkOf(link);
  EXPECT_FALSE(same.changed);
  EXPECT_TRUE(same.findings.empty());
  EXPECT_EQ(same.text, "<link name='l'>" + link + "</link>");
  const std::string limit = "<limit lower='-1' upper='1' effort='5' velocity='6'/>";
  EXPECT_FALSE(MendedJointOf("revolute", limit).changed);
  EXPECT_FALSE(MendedJointOf("continuous", "").changed);
  EXPECT_FALSE(MendedJointOf("floating", "").changed) << "not at the root";
}

TEST(MendParts, SizesOfZeroBecomeThin) {
  const auto shape = [](const std::string& text) {
    return MendedLinkOf("<collision><geometry>" + text + "</geometry></collision>");
  };
  const MendedPart box = shape("<box size='0.1 0.0 -0'/>");
  ExpectSays(box.text, {"size='0.1 0.0001 0.0001'"});
  EXPECT_EQ(box.codes(), std::vector<FailureCode>{FailureCode::kZeroSize});
  EXPECT_TRUE(box.changed);
  ExpectSays(shape("<cylinder radius='0' length='0.2'/>").text, {"radius='0.0001'", "length='0.2'"});
  EXPECT_FALSE(shape("<sphere radius='x'/>").changed) << "a word is left for the check";
}

TEST(MendParts, WhatCannotBeShownIsLeftOut) {
  EXPECT_EQ(MendedLinkOf("<visual/>").text, "<link name='l'/>");
  EXPECT_EQ(MendedLinkOf("<visual><geometry/></visual><collision/>").codes(),
            (std::vector<FailureCode>{FailureCode::kNoGeometry, FailureCode::kNoGeometry}));
  EXPECT_EQ(MendedLinkOf("<visual><geometry><mesh filename=''/></geometry></visual>").text, "<link name='l'/>");
  EXPECT_FALSE(MendedLinkOf("<collision><geometry><mesh filename=''/></geometry></collision>").changed)
      << "a collision mesh without a file is refused by the check";
}

TEST(MendParts, HalfAnInertialIsCompleted) {
  EXPECT_EQ(MendedLinkOf("<inertial/>").text, "<link name='l'/>");
  const MendedPart no_tensor = MendedLinkOf("<inertial><mass value='2'/></inertial>");
  EXPECT_EQ(no_tensor.codes(), std::vector<FailureCode>{FailureCode::kNoInertia});
  ExpectSays(no_tensor.text, {"ixx='0'", "iyz='0'", "izz='0'"});
  const MendedPart no_mass = MendedLinkOf("<inertial><inertia ixx='1' iyy='1' izz='1'/></inertial>");
  EXPECT_EQ(no_mass.codes(), std::vector<FailureCode>{FailureCode::kNoMass});
  ExpectSays(no_mass.text, {"<mass value='0'/>", "ixx='1'", "ixy='0'"});
}

TEST(MendParts, LimitsThatAreMissingAreNone) {
  const MendedPart none = MendedJointOf("revolute", "");
  ExpectSays(none.text, {"type='continuous'", "effort='1e9'", "velocity='1e9'"});
  EXPECT_EQ(none.text.find("lower"), std::string::npos);
  EXPECT_EQ(none.codes(), std::vector<FailureCode>(3, FailureCode::kMissingLimit));
  const MendedPart lower = MendedJointOf("revolute", "<limit upper='1' effort='5' velocity='6'/>");
  ExpectSays(lower.text, {"type='revolute'", "lower='-1000'", "upper='1'"});
  const MendedPart slide = MendedJointOf("prismatic", "<limit effort='5' velocity='6'/>");
  ExpectSays(slide.text, {"type='prismatic'", "lower='-1000'", "upper='1000'"});
}

TEST(MendParts, AContinuousJointWithNarrowLimitsIsARevoluteOne) {
  const auto with = [](const std::string& range) {
    return MendedJointOf("continuous", "<limit " + range + " effort='5' velocity='6'/>");
  };
  const MendedPart held = with("lower='-1' upper='1'");
  ExpectSays(held.text, {"type='revolute'"});
  EXPECT_EQ(held.codes(), std::vector<FailureCode>{FailureCode::kLimitedContinuous});
  for (const char* free : {"lower='-3.14' upper='3.14'", "lower='0' upper='0'", "lower='1' upper='-1'", "lower='-1'"})
    EXPECT_FALSE(with(free).changed) << free;
}

TEST(MendParts, AFreeJointAtTheRootBecomesFixed) {
  for (const char* type : {"floating", "planar"}) {
    const MendedPart root = MendedJointOf(type, "", true);
    ExpectSays(root.text, {"type='fixed'"});
    EXPECT_EQ(root.codes(), std::vector<FailureCode>{FailureCode::kFloatingRoot});
  }
  EXPECT_FALSE(MendedJointOf("fixed", "", true).changed);
}

TEST(MendParts, FindingsNameThePartAndItsLine) {
  const MendedPart part = MendedLinkOf("\n\n<visual/>");
  ASSERT_EQ(part.findings.size(), 1U);
  EXPECT_EQ(PartText(part.findings[0].part), "link 'l'");
  EXPECT_EQ(part.findings[0].line, 3);
  EXPECT_EQ(part.findings[0].level, FindingLevel::kInfo);
}

}  // namespace
}  // namespace gaitwright
