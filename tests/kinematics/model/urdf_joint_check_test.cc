// SPDX-License-Identifier: BSD-3-Clause
#include <tinyxml2.h>

#include <array>
#include <tuple>

#include "kinematics/model/urdf_xml_internal.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// Why a joint of a type is refused; code kInternal where it is not.
Failure CheckedJoint(const std::string& type, const std::string& inside, bool strict = false) {
  tinyxml2::XMLDocument xml;
  xml.Parse(("<joint>" + inside + "</joint>").c_str());
  EXPECT_FALSE(xml.Error()) << inside;
  try {
    CheckMotion(*xml.RootElement(), type, strict, "joint 'j'");
  } catch (const Failure& failure) {
    return failure;
  }
  return {};
}

/// The failure of refused mimics of joints. Each row has name, type and content of a joint.
Failure CheckedMimics(const std::vector<std::array<std::string, 3>>& joints) {
  std::string text = "<robot>";
  for (const auto& [name, type, inside] : joints)
    text += "<joint name='" + name + "' type='" + type + "'>" + inside + "</joint>";
  tinyxml2::XMLDocument xml;
  xml.Parse((text + "</robot>").c_str());
  try {
    CheckMimics(*xml.RootElement());
  } catch (const Failure& failure) {
    return failure;
  }
  return {};
}

std::string MimicOf(const std::string& joint, const std::string& more = "") {
  return "<mimic joint='" + joint + "' " + more + "/>";
}

const char kFullLimit[] = "<limit lower='-1' upper='1' effort='5' velocity='6'/>";

TEST(UrdfJointCheck, SoundJointsPass) {
  EXPECT_EQ(CheckedJoint("revolute", kFullLimit).message, "");
  EXPECT_EQ(CheckedJoint("prismatic", "<limit lower='0' upper='0' effort='0' velocity='0'/>").message, "");
  EXPECT_EQ(CheckedJoint("continuous", "").message, "");
  EXPECT_EQ(CheckedJoint("continuous", "<limit effort='5' velocity='6'/>").message, "");
  EXPECT_EQ(CheckedJoint("spherical", "<axis xyz='0 0 0'/>").message, "") << "a ball joint has no axis";
  EXPECT_EQ(CheckedJoint("revolute", std::string(kFullLimit) + "<safety_controller k_position='-5'/>").message, "");
}

TEST(UrdfJointCheck, StrictlyARangeOfZeroIsRefused) {
  const std::string zero = "<limit lower='0' upper='0.0' effort='5' velocity='6'/>";
  EXPECT_EQ(CheckedJoint("revolute", zero).message, "");
  const Failure failure = CheckedJoint("revolute", zero, true);
  EXPECT_EQ(failure.code, FailureCode::kMissingLimit);
  ExpectSays(failure.message, {"joint 'j'", "0 to 0", "make the joint fixed"});
  EXPECT_EQ(CheckedJoint("continuous", zero, true).message, "");
  EXPECT_EQ(CheckedJoint("revolute", zero + MimicOf("other"), true).message, "") << "its leader has the range";
  EXPECT_EQ(CheckedJoint("revolute", kFullLimit, true).message, "");
}

TEST(UrdfJointCheck, RefusesByCode) {
  const std::string limit = kFullLimit;
  const std::vector<std::tuple<std::string, std::string, FailureCode>> rows = {
      {"revolute", "", FailureCode::kMissingLimit},
      {"prismatic", "<limit effort='1' velocity='1' lower='0'/>", FailureCode::kMissingLimit},
      {"revolute", "<limit effort='1' velocity='1' upper='0'/>", FailureCode::kMissingLimit},
      {"revolute", "<limit lower='0' upper='1' velocity='1'/>", FailureCode::kUrdfMissing},
      {"revolute", "<limit lower='1' upper='0' effort='1' velocity='1'/>", FailureCode::kBadLimit},
      {"revolute", "<limit lower='0' upper='1' effort='-1' velocity='1'/>", FailureCode::kBadLimit},
      {"continuous", "<limit effort='1' velocity='-1'/>", FailureCode::kBadLimit},
      {"revolute", "<limit lower='a' upper='1' effort='1' velocity='1'/>", FailureCode::kUrdfNumber},
      {"revolute", limit + "<axis xyz='0 0 1e-10'/>", FailureCode::kZeroAxis},
      {"revolute", limit + "<axis xyz='0 1'/>", FailureCode::kUrdfNumber},
      {"revolute", limit + "<axis/>", FailureCode::kUrdfMissing},
      {"revolute", limit + "<dynamics damping='-0.1'/>", FailureCode::kBadDynamics},
      {"revolute", limit + "<dynamics friction='nan'/>", FailureCode::kUrdfNumber},
      {"revolute", limit + "<calibration rising='x'/>", FailureCode::kUrdfNumber}};
  for (const auto& [type, inside, code] : rows) {
    const Failure failure = CheckedJoint(type, inside);
    EXPECT_EQ(failure.code, code) << type << ": " << inside;
    ExpectSays(failure.message, {"joint 'j'"});
  }
}

TEST(UrdfJointCheck, MimicsThatLeadToAMovingJointPass) {
  EXPECT_EQ(CheckedMimics({{"a", "revolute", MimicOf("b", "multiplier='-2' offset='1'")},
                           {"b", "revolute", MimicOf("c")},
                           {"c", "continuous", ""}})
                .message,
            "");
  EXPECT_EQ(CheckedMimics({{"a", "fixed", MimicOf("nothing")}}).message, "") << "a fixed joint follows nothing";
}

TEST(UrdfJointCheck, RefusesMimicsByCode) {
  const auto code = [](const std::string& mimic) {
    return CheckedMimics({{"a", "revolute", mimic}, {"b", "revolute", ""}, {"f", "fixed", ""}}).code;
  };
  EXPECT_EQ(code(MimicOf("a")), FailureCode::kBadMimic);
  EXPECT_EQ(code(MimicOf("z")), FailureCode::kUnknownMimic);
  EXPECT_EQ(code(MimicOf("f")), FailureCode::kBadMimic);
  EXPECT_EQ(code(MimicOf("b", "multiplier='0'")), FailureCode::kBadMimic);
  EXPECT_EQ(code(MimicOf("b", "multiplier='two'")), FailureCode::kUrdfNumber);
  EXPECT_EQ(code(MimicOf("b", "offset='inf'")), FailureCode::kUrdfNumber);
  EXPECT_EQ(code("<mimic/>"), FailureCode::kUrdfMissing);
}

TEST(UrdfJointCheck, ACircleOfMimicsIsNamedInItsOrder) {
  const Failure failure = CheckedMimics(
      {{"a", "revolute", MimicOf("b")}, {"b", "revolute", MimicOf("c")}, {"c", "revolute", MimicOf("b")}});
  EXPECT_EQ(failure.code, FailureCode::kBadMimic);
  ExpectSays(failure.message, {"'a' mimics 'b', which mimics 'c', which mimics 'b'"});
}

}  // namespace
}  // namespace gaitwright
