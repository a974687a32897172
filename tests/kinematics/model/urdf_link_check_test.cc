// SPDX-License-Identifier: BSD-3-Clause
#include <tinyxml2.h>

#include "kinematics/model/urdf_xml_internal.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// The failure that a call throws; code kInternal if it does not throw.
template <class Call>
Failure LinkRefusal(const Call& call) {
  try {
    call();
  } catch (const Failure& failure) {
    return failure;
  }
  return {};
}

/// The failure of a refused link.
Failure CheckedLink(const std::string& inside, bool strict = false) {
  tinyxml2::XMLDocument xml;
  xml.Parse(("<link name='l'>" + inside + "</link>").c_str());
  EXPECT_FALSE(xml.Error()) << inside;
  return LinkRefusal([&] { CheckLink(*xml.RootElement(), strict, "link 'l'"); });
}

std::string InertialOf(const std::string& mass, const std::string& moments) {
  return "<inertial><mass value='" + mass + "'/><inertia " + moments + " ixy='0' ixz='0' iyz='0'/></inertial>";
}

std::string CollisionOf(const std::string& shape) {
  return "<collision><geometry>" + shape + "</geometry></collision>";
}

TEST(UrdfLinkCheck, SoundLinksPass) {
  for (const std::string& inside :
       {std::string(), InertialOf("1", "ixx='0.1' iyy='0.1' izz='0.1'"), InertialOf("0", "ixx='0' iyy='0' izz='0'"),
        CollisionOf("<box size='1 2 3'/>"), CollisionOf("<capsule radius='+1e-3' length='1'/>"),
        CollisionOf("<mesh filename='a.stl' scale='1 -1 1'/>"),
        std::string("<visual><origin xyz='0 0 1' rpy='0 0 3'/><geometry><sphere radius='1'/></geometry></visual>")})
    EXPECT_EQ(CheckedLink(inside, true).message, "") << inside;
}

TEST(UrdfLinkCheck, RefusesByCodeAndNamesTheLink) {
  const std::string moments = "ixx='0.1' iyy='0.1' izz='0.1'";
  const std::vector<std::pair<std::string, FailureCode>> rows = {
      {InertialOf("-1", moments), FailureCode::kNegativeMass},
      {InertialOf("heavy", moments), FailureCode::kUrdfNumber},
      {InertialOf("2e6", moments), FailureCode::kUrdfNumber},
      {InertialOf("1", "ixx='nan' iyy='1' izz='1'"), FailureCode::kUrdfNumber},
      {InertialOf("1", "ixx='1' iyy='1'"), FailureCode::kUrdfMissing},
      {"<inertial><mass value='1'/></inertial>", FailureCode::kUrdfMissing},
      {"<inertial><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>", FailureCode::kUrdfMissing},
      {"<inertial><origin xyz='0 0'/></inertial>", FailureCode::kUrdfNumber},
      {CollisionOf("<box size='1 2'/>"), FailureCode::kUrdfNumber},
      {CollisionOf("<box size='1 2 0'/>"), FailureCode::kUrdfGeometry},
      {CollisionOf("<box/>"), FailureCode::kUrdfMissing},
      {CollisionOf("<sphere radius='-1'/>"), FailureCode::kUrdfGeometry},
      {CollisionOf("<sphere radius='1001'/>"), FailureCode::kUrdfNumber},
      {CollisionOf("<cylinder radius='1'/>"), FailureCode::kUrdfMissing},
      {CollisionOf("<cone radius='1'/>"), FailureCode::kUrdfGeometry},
      {CollisionOf("<mesh/>"), FailureCode::kUrdfMissing},
      {CollisionOf("<mesh filename=''/>"), FailureCode::kUrdfMissing},
      {CollisionOf("<mesh filename='a.stl' scale='1 0 1'/>"), FailureCode::kUrdfGeometry},
      {CollisionOf("<mesh filename='a.stl' scale='2'/>"), FailureCode::kUrdfNumber}};
  for (const auto& [inside, code] : rows) {
    const Failure failure = CheckedLink(inside);
    EXPECT_EQ(failure.code, code) << inside;
    ExpectSays(failure.message, {"link 'l'"});
  }
}

TEST(UrdfLinkCheck, AnInertiaThatNoBodyHasIsRefusedStrictlyOnly) {
  const std::string impossible = InertialOf("1", "ixx='0.1' iyy='0.1' izz='0.3'");  // 0.1 + 0.1 < 0.3
  EXPECT_EQ(CheckedLink(impossible).message, "");
  EXPECT_EQ(CheckedLink(impossible, true).code, FailureCode::kImpossibleInertia);
  EXPECT_EQ(CheckedLink(InertialOf("1", "ixx='-0.1' iyy='0.1' izz='0.1'"), true).code, FailureCode::kImpossibleInertia);
  EXPECT_EQ(CheckedLink(InertialOf("1", "ixx='0.1' iyy='0.1' izz='0.2'"), true).message, "") << "a flat plate";
}

TEST(UrdfLinkCheck, AnInertiaWithoutMassIsRefusedStrictlyOnly) {
  const std::string massless = InertialOf("0", "ixx='0.1' iyy='0.1' izz='0.1'");
  EXPECT_EQ(CheckedLink(massless).message, "");
  const Failure failure = CheckedLink(massless, true);
  EXPECT_EQ(failure.code, FailureCode::kNoMass);
  ExpectSays(failure.message, {"link 'l'", "its mass is 0 but its inertia is not"});
  EXPECT_EQ(CheckedLink(InertialOf("0", "ixx='1e-22' iyy='0' izz='0'"), true).message, "") << "by rounding";
}

TEST(UrdfNumbers, AreReadExactlyOrRefused) {
  EXPECT_EQ(Numbers(" 1\t-2.5 +3e0\n", 3, "it"), (std::vector<double>{1.0, -2.5, 3.0}));
  EXPECT_EQ(Numbers("5", 1, "it", 5.0).front(), 5.0);
  for (const char* text : {"", "1 2", "1,5", "0x1", "--1", "1e400", "inf"})
    EXPECT_EQ(LinkRefusal([&] { Numbers(text, 1, "it"); }).code, FailureCode::kUrdfNumber) << text;
  EXPECT_EQ(LinkRefusal([] { Numbers("-5.1", 1, "it", 5.0); }).code, FailureCode::kUrdfNumber);
}

TEST(UrdfAttribute, IsPlainTextOfBoundedLength) {
  tinyxml2::XMLDocument xml;
  xml.Parse(("<a fine='\xC3\xA9 b' wrong='\xFF' control='&#1;' long='" + std::string(1001, 'a') + "'/>").c_str());
  const tinyxml2::XMLElement& element = *xml.RootElement();
  EXPECT_EQ(Attribute(element, "fine", "it"), "\xC3\xA9 b");
  const auto code = [&](const char* name) { return LinkRefusal([&] { Attribute(element, name, "it"); }).code; };
  EXPECT_EQ(code("none"), FailureCode::kUrdfMissing);
  EXPECT_EQ(code("wrong"), FailureCode::kNotText);
  EXPECT_EQ(code("control"), FailureCode::kNotText);
  EXPECT_EQ(code("long"), FailureCode::kLongText);
}

}  // namespace
}  // namespace gaitwright
