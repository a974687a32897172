// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/mend_urdf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/text.h"
#include "kinematics/model/mend_inertia.h"
#include "kinematics/model/urdf_check.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

const Finding* FindingOf(const RobotModel& model, FailureCode code) {
  const auto at =
      std::find_if(model.findings.begin(), model.findings.end(), [&](const Finding& f) { return f.code == code; });
  return at == model.findings.end() ? nullptr : &*at;
}

/// The robot with one text replaced. It must load with one finding of this code, and must be refused with `strict`.
RobotModel Mended(const std::string& from, const std::string& to, FailureCode code, const std::string& part) {
  const std::string urdf = Replaced(FourLegs(), from, to);
  EXPECT_NE(urdf, FourLegs());
  Result<RobotModel> model = LoadRobotFromText(urdf, "");
  if (!model) throw std::runtime_error(model.failure().message);
  const Finding* finding = FindingOf(*model, code);
  EXPECT_NE(finding, nullptr) << code;
  if (finding != nullptr) {
    EXPECT_EQ(PartText(finding->part), part);
  }
  EXPECT_NE(MessageOf(urdf, "", true), "") << "strictly it is refused";
  return std::move(*model);
}

TEST(MendUrdf, ASoundFileStaysAsItIs) {
  EXPECT_EQ(MendUrdf(FourLegs()).text, FourLegs());
  EXPECT_TRUE(MendUrdf(FourLegs()).findings.empty());
  EXPECT_TRUE(LoadRobotFromText(FourLegs(), "")->findings.empty());
}

TEST(MendUrdf, LimitsThatAreNotGivenAreNone) {
  const RobotModel none = Mended(" lower='-2' upper='1'", "", FailureCode::kMissingLimit, "joint 'A_hip'");
  EXPECT_TRUE(std::isinf(none.dof_lower(0)) && std::isinf(none.dof_upper(0)));
  const RobotModel lower = Mended(" lower='-2'", "", FailureCode::kMissingLimit, "joint 'A_hip'");
  EXPECT_LE(lower.dof_lower(0), -1000.0);
  EXPECT_EQ(lower.dof_upper(0), 1.0);
  EXPECT_TRUE(std::isinf(Mended(" effort='30'", "", FailureCode::kMissingLimit, "joint 'A_hip'").dof_effort_limit(0)));
}

TEST(MendUrdf, RangesOfZeroOfAllJointsArePlaceholders) {
  const std::string none = Replaced(FourLegs(), "lower='-2' upper='1'", "lower='0' upper='0.0'");
  const RobotModel model = LoadRobotFromText(none, "").value();
  const Finding* finding = FindingOf(model, FailureCode::kMissingLimit);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->level, FindingLevel::kWarning);
  EXPECT_TRUE(std::isinf(model.dof_lower(0)) && std::isinf(model.dof_upper(0)));
  const std::string one = Replaced(none, "<joint name='A_hip' type='revolute'>",
                                   "<joint name='A_hip' type='revolute'><limit lower='-2' upper='1' effort='9' "
                                   "velocity='9'/>");
  EXPECT_TRUE(MendUrdf(one).findings.empty()) << "joints that are held beside one that moves";
}

TEST(MendUrdf, AFloatingJointOfALimbIsNotTheBases) {
  const std::string urdf =
      Replaced(FourLegs(), "<joint name='A_hip' type='revolute'>", "<joint name='A_hip' type='floating'>");
  ExpectSays(MessageOf(urdf), {"joint 'A_hip'", "type 'floating' is not supported"});
}

TEST(MendUrdf, AnInertiaWithoutMassIsReported) {
  const std::string urdf = Replaced(FourLegs(), "<link name='A_foot'><inertial><mass value='1'/>",
                                    "<link name='A_foot'><inertial><mass value='0'/>");
  const RobotModel model = LoadRobotFromText(urdf, "").value();
  const Finding* finding = FindingOf(model, FailureCode::kNoMass);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(PartText(finding->part), "link 'A_foot'");
}

TEST(MendUrdf, LimitsOfAContinuousJointHoldItWhereTheyAreLessThanATurn) {
  const auto knees = [](const std::string& limit) {
    const std::string urdf = Replaced(FourLegs(), "type='revolute'", "type='continuous'");
    return LoadRobotFromText(Replaced(urdf, "lower='-2' upper='1'", limit), "").value().joints[1];
  };
  EXPECT_EQ(knees("lower='-2' upper='1'").type, JointType::kRevolute);
  EXPECT_NEAR(knees("lower='-2' upper='1'").upper, 1.0, 1e-12);
  for (const std::string limit :
       {"lower='-3.15' upper='3.15'", "lower='0' upper='0'", "lower='1' upper='-1'", "upper='1'"})
    EXPECT_EQ(knees(limit).type, JointType::kContinuous) << limit;
}

TEST(MendUrdf, CommasAreReadAsPointsOrAsSpaces) {
  const RobotModel points = Mended("0 0 -0.2", "0 0 -0,25", FailureCode::kNumberFormat, "joint 'A_knee'");
  EXPECT_DOUBLE_EQ(points.joints[1].X_PJ.translation().z(), -0.25);
  const RobotModel spaces = Mended("0 0 -0.2", "0, 0, -0.25", FailureCode::kNumberFormat, "joint 'A_knee'");
  EXPECT_DOUBLE_EQ(spaces.joints[1].X_PJ.translation().z(), -0.25);
  EXPECT_DOUBLE_EQ(
      Mended("0 0 -0.2", "0,0,-1", FailureCode::kNumberFormat, "joint 'A_knee'").joints[1].X_PJ.translation().z(),
      -1.0);
}

TEST(MendUrdf, NumbersThatAreTooManyAreRefusedByName) {
  ExpectSays(MessageOf(Replaced(FourLegs(), "0 0 -0.2", "0 0 -0.2 0")), {"joint 'A_knee'", "origin xyz", "4 numbers"});
}

TEST(MendUrdf, ABallWithoutSizeIsAPointFoot) {
  const RobotModel model = Mended("radius='0.02'", "radius='0'", FailureCode::kZeroSize, "link 'A_foot'");
  EXPECT_EQ(model.feet[0].type, FootType::kPoint);
  EXPECT_NEAR(model.feet[0].X_BF.translation().z(), -0.2, 1e-9);
}

TEST(MendUrdf, AFloatingJointAtTheRootIsTheFreeBase) {
  for (const std::string type : {"floating", "planar"}) {
    const std::string world = "<link name='world'/><joint name='free' type='" + type +
                              "'><parent link='world'/><child link='trunk'/></joint></robot>";
    const std::string urdf = Replaced(FourLegs(), "</robot>", world);
    const Result<RobotModel> model = LoadRobotFromText(urdf, "");
    ASSERT_TRUE(model.ok()) << model.failure().message;
    EXPECT_EQ(model->num_dofs(), 8);
    ASSERT_NE(FindingOf(*model, FailureCode::kFloatingRoot), nullptr);
    EXPECT_EQ(PartText(FindingOf(*model, FailureCode::kFloatingRoot)->part), "joint 'free'");
  }
  ExpectSays(MessageOf(Replaced(FourLegs(), "name='A_end' type='fixed'", "name='A_end' type='floating'")),
             {"joint 'A_end'", "'floating'"});
}

TEST(MendUrdf, NamesGivenTwice) {
  const RobotModel joints = Mended("'B_knee'", "'A_knee'", FailureCode::kDoubleName, "joint 'A_knee'");
  EXPECT_EQ(joints.DofIndex("A_knee_2"), joints.DofIndex("B_hip") + 1);
  const RobotModel links =
      Mended("</robot>", SmallLink("A_thigh") + "</robot>", FailureCode::kDoubleName, "link 'A_thigh'");
  EXPECT_DOUBLE_EQ(links.total_mass_kg, LoadRobotFromText(FourLegs(), "")->total_mass_kg);
  ExpectSays(MessageOf(Replaced(FourLegs(), "</robot>", SmallLink("A_thigh", "<sphere radius='1'/>") + "</robot>")),
             {"link 'A_thigh'", "two links"});
  EXPECT_EQ(Mended("</robot>", SmallLink("bench") + "</robot>", FailureCode::kLooseLink, "link 'bench'").frames.size(),
            13U);
}

TEST(MendUrdf, InertialsThatLackAHalf) {
  const std::string tensor = "<inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/>";
  const RobotModel shapes = Mended(tensor, "", FailureCode::kNoInertia, "link 'trunk'");
  // A box of 0.4 x 0.2 x 0.1 m and 1 kg.
  EXPECT_NEAR(shapes.bodies[0].I_C(0, 0), (0.04 + 0.01) / 12.0, 1e-12);
  EXPECT_NEAR(shapes.bodies[0].I_C(2, 2), (0.16 + 0.04) / 12.0, 1e-12);
}

TEST(MendUrdf, OtherEncodingsAndNamespaces) {
  EXPECT_EQ(*InUtf8("caf\xE9"), "caf\xC3\xA9");
  EXPECT_EQ(*InUtf8(std::string("\xFF\xFE<\0a\0>\0", 8)), "<a>");
  EXPECT_EQ(*InUtf8(std::string("\xFE\xFF\0<\0a\0>", 8)), "<a>");
  EXPECT_FALSE(InUtf8("<robot/>").has_value());
  std::string urdf = FourLegs();
  for (const std::string tag : {"robot", "link", "joint", "inertial", "inertia", "collision"}) {
    for (const std::string end : {" ", ">", "/"}) {
      urdf = Replaced(urdf, "<" + tag + end, "<u:" + tag + end);
      urdf = Replaced(urdf, "</" + tag + end, "</u:" + tag + end);
    }
  }
  const Result<RobotModel> model = LoadRobotFromText(urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_NE(FindingOf(*model, FailureCode::kNamespace), nullptr);
}

TEST(MendUrdf, WhatIsMendedNeedsNoMending) {
  for (const auto& [from, to] :
       {std::pair(" lower='-2' upper='1'", ""), {"0 0 -0.2", "0,0,-0.2"}, {"'B_knee'", "'A_knee'"}}) {
    const MendedUrdf mended = MendUrdf(Replaced(FourLegs(), from, to));
    EXPECT_FALSE(CheckUrdf(mended.text).has_value());
    EXPECT_EQ(MendUrdf(mended.text).text, mended.text);
  }
}

/// Principal second moments of a tensor; those of a body are not negative.
Vector3 SecondMoments(const Matrix3& I) { return Vector3::Constant(0.5 * I.trace()) - PrincipalMoments(I); }

TEST(MendInertia, WhatABodyHasStays) {
  EXPECT_FALSE(MendInertia(Vector3(1.0, 2.0, 3.0).asDiagonal(), 1.0, {}).has_value());
  EXPECT_FALSE(MendInertia(Matrix3::Zero(), 1.0, {}).has_value()) << "a point mass";
  EXPECT_FALSE(MendInertia(Matrix3::Zero(), 0.0, {}).has_value());
}

TEST(MendInertia, TheNearestIsOfABodyAndNoOtherIsNearer) {
  const Matrix3 I = Vector3(1.0, 1.0, 2.4).asDiagonal();
  const auto mended = MendInertia(I, 1.0, {});
  ASSERT_TRUE(mended.has_value());
  EXPECT_GE(SecondMoments(mended->I).minCoeff(), 0.0);
  // The second moments are (1.2, 1.2, -0.2). The last becomes 0, so I = diag(1.2, 1.2, 2.4).
  EXPECT_TRUE(mended->I.isApprox(Matrix3(Vector3(1.2, 1.2, 2.4).asDiagonal()), 1e-5)) << mended->I;
  const double off = (mended->I - I).norm();
  for (const Vector3& other : {Vector3(1.1, 1.3, 2.4), Vector3(1.2, 1.2, 2.3), Vector3(1.25, 1.15, 2.35)})
    EXPECT_GE((Matrix3(other.asDiagonal()) - I).norm(), off - 1e-9);
}

TEST(MendInertia, RoundingIsMendedWithoutAWord) {
  const auto mended = MendInertia(Vector3(1.0, 1.0, 2.0 + 1e-7).asDiagonal(), 1.0, {});
  ASSERT_TRUE(mended.has_value());
  EXPECT_EQ(mended->was, "");
  EXPECT_GE(SecondMoments(mended->I).minCoeff(), 0.0);
}

TEST(MendInertia, WhereNumbersTellNothingTheShapesDo) {
  Shape box;
  box.size = Vector3(0.4, 0.2, 0.1);
  const auto mended = MendInertia(Vector3(-1.0, -1.0, 3.0).asDiagonal(), 2.0, {&box});
  ASSERT_TRUE(mended.has_value());
  EXPECT_NEAR(mended->I(2, 2), 2.0 * (0.16 + 0.04) / 12.0, 1e-12);
  const auto near = MendInertia(Vector3(1.0, 1.0, 2.1).asDiagonal(), 2.0, {&box});
  EXPECT_NEAR(near->I(2, 2), 2.1, 1e-4) << "what is nearly right is kept";
}

TEST(MendInertia, AnInfinitelyThinRodIsThickened) {
  Shape rod;
  rod.size = Vector3(0.02, 0.02, 0.4);
  const Matrix3 I = Vector3(0.5, 0.5, 0.0).asDiagonal();
  const auto by_shapes = MendInertia(I, 3.0, {&rod});
  ASSERT_TRUE(by_shapes.has_value());
  EXPECT_TRUE(by_shapes->I.isApprox(Matrix3(Vector3(0.5, 0.5, 3.0 * 0.0008 / 12.0).asDiagonal()), 1e-9));
  ExpectSays(by_shapes->was, {"principal moment of zero"});
  const auto without = MendInertia(I, 3.0, {});
  ASSERT_TRUE(without.has_value());
  EXPECT_NEAR(without->I(2, 2), 0.5 * 12.0 / 800.0, 1e-12);
  ExpectSays(without->used, {"ten times as long as thick"});
  EXPECT_FALSE(MendInertia(I, 0.0, {}).has_value()) << "a rotor without mass";
  EXPECT_FALSE(MendInertia(Vector3(0.5, 0.5, 2e-6).asDiagonal(), 3.0, {}).has_value());
  EXPECT_FALSE(MendInertia(Vector3(1e-10, 1e-10, 0.0).asDiagonal(), 3.0, {}).has_value()) << "by rounding";
}

TEST(MendInertia, ALinkThatIsAThinRodIsReportedAndRefusedStrictly) {
  const std::string shank = SmallLink("A_shank"), rod = Replaced(shank, "izz='0.01'", "izz='0'");
  const std::string urdf = Replaced(FourLegs(), shank, rod);
  const Result<RobotModel> model = LoadRobotFromText(urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const Finding* finding = FindingOf(*model, FailureCode::kImpossibleInertia);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(PartText(finding->part), "link 'A_shank'");
  ExpectSays(MessageOf(urdf, "", true), {"link 'A_shank'", "principal moment of zero"});
}

TEST(MendInertia, TheChangeOfTheRobotIsReported) {
  const RobotModel model = Mended("<mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01'",
                                  "<mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.03'",
                                  FailureCode::kImpossibleInertia, "link 'trunk'");
  EXPECT_EQ(FindingOf(model, FailureCode::kImpossibleInertia)->level, FindingLevel::kWarning);
}

}  // namespace
}  // namespace gaitwright
