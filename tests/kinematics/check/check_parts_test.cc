// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "kinematics/check/check_parts_internal.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

RobotModel SoundFour() { return *LoadRobotFromText(FourLegs(), ""); }

/// The kinds of findings about the trunk.
std::vector<FailureCode> BodyCodes(const RobotModel& model) {
  std::vector<Finding> findings;
  CheckBodies(model, findings);
  std::erase_if(findings, [](const Finding& finding) { return PartText(finding.part) != "link 'trunk'"; });
  std::vector<FailureCode> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  return codes;
}

std::vector<FailureCode> MotorCodes(const RobotModel& model) {
  std::vector<Finding> findings;
  CheckMotors(model, findings);
  std::vector<FailureCode> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  return codes;
}

bool Contains(const std::vector<FailureCode>& codes, FailureCode code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

/// A robot whose body 0, a box of 0.4 x 0.2 x 0.1 m and 1 kg, has this radius of gyration.
RobotModel WithGyration(double radius_m) {
  RobotModel model = SoundFour();
  model.bodies[0].I_C = 2.0 / 3.0 * model.bodies[0].mass * radius_m * radius_m * Matrix3::Identity();
  return model;
}

TEST(CheckBodies, ARadiusOfGyrationFitsTheShapes) {
  const double across = Vector3(0.4, 0.2, 0.1).norm();
  EXPECT_FALSE(Contains(BodyCodes(WithGyration(0.3 * across)), FailureCode::kLargeInertia));
  EXPECT_FALSE(Contains(BodyCodes(WithGyration(0.02 * across)), FailureCode::kSmallInertia));
  EXPECT_TRUE(Contains(BodyCodes(WithGyration(across)), FailureCode::kLargeInertia));
  EXPECT_TRUE(Contains(BodyCodes(WithGyration(0.002 * across)), FailureCode::kSmallInertia));
}

TEST(CheckBodies, ALightPartIsOfNoAccount) {
  RobotModel model = WithGyration(1.0);
  model.total_mass_kg = 1e5;
  EXPECT_FALSE(Contains(BodyCodes(model), FailureCode::kLargeInertia));
}

TEST(CheckBodies, MassAndShapeGoTogether) {
  RobotModel model = SoundFour();
  EXPECT_FALSE(Contains(BodyCodes(model), FailureCode::kShapeWithoutMass));
  model.bodies[0].mass = 0.0;
  EXPECT_TRUE(Contains(BodyCodes(model), FailureCode::kShapeWithoutMass));
  RobotModel bare = SoundFour();
  bare.bodies[0].mass = 5.0;
  std::erase_if(bare.collision_shapes, [](const Shape& shape) { return shape.body == 0; });
  EXPECT_TRUE(Contains(BodyCodes(bare), FailureCode::kMassWithoutShape));
}

TEST(CheckMotors, LimitsThatMotorsHavePass) {
  EXPECT_TRUE(MotorCodes(SoundFour()).empty());
  RobotModel model = SoundFour();
  const double lift = model.weight_n() * model.leg_length_m();
  model.joints[0].effort_limit = 4.9 * lift;
  EXPECT_TRUE(MotorCodes(model).empty());
  model.joints[0].effort_limit = 5.1 * lift;
  EXPECT_EQ(MotorCodes(model), std::vector<FailureCode>{FailureCode::kStrongMotor});
}

TEST(CheckMotors, SpeedsAndPowersThatNoMotorHasAreNamed) {
  RobotModel model = SoundFour();
  model.joints[1].velocity_limit = 101.0;
  EXPECT_EQ(MotorCodes(model), std::vector<FailureCode>{FailureCode::kFastMotor});
  model.joints[1].velocity_limit = 0.09;
  EXPECT_EQ(MotorCodes(model), std::vector<FailureCode>{FailureCode::kSlowMotor});
  model.joints[1].velocity_limit = 200.0;
  model.joints[1].effort_limit = 260.0;  // 52 kW
  EXPECT_EQ(MotorCodes(model), (std::vector<FailureCode>{FailureCode::kFastMotor, FailureCode::kStrongMotor}));
}

TEST(CheckMotors, AnUnknownLimitOfALegIsReportedOnce) {
  RobotModel model = SoundFour();
  model.joints[2].effort_limit_is_placeholder = true;
  model.joints[2].effort_limit = 1e6;
  EXPECT_EQ(MotorCodes(model), std::vector<FailureCode>{FailureCode::kUnknownEffort});
}

TEST(CheckMotors, ASpeedLimitThatIsAPlaceholderIsReported) {
  RobotModel model = SoundFour();
  model.joints[2].velocity_limit_is_placeholder = true;
  model.joints[2].velocity_limit = 5000.0;
  EXPECT_EQ(MotorCodes(model), std::vector<FailureCode>{FailureCode::kFastMotor});
}

TEST(CheckRanges, RangesOfManyTurnsMayBeInDegrees) {
  RobotModel model = SoundFour();
  std::vector<Finding> findings;
  CheckRanges(model, findings);
  model.joints[0].lower = -90.0;
  CheckRanges(model, findings);
  EXPECT_TRUE(findings.empty()) << "one joint may be a winch";
  model.joints[2].upper = 120.0;
  CheckRanges(model, findings);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(PartText(findings[1].part), "joint '" + model.joints[2].name + "'");
}

TEST(NumbersDiffer, ByMoreThanOnePercent) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(NumbersDiffer(100.0, 100.5));
  EXPECT_FALSE(NumbersDiffer(-100.0, -100.5));
  EXPECT_TRUE(NumbersDiffer(100.0, 102.0));
  EXPECT_TRUE(NumbersDiffer(1.0, -1.0));
  EXPECT_FALSE(NumbersDiffer(0.0, 0.0));
  EXPECT_FALSE(NumbersDiffer(kUnbounded, kUnbounded));
  EXPECT_TRUE(NumbersDiffer(kUnbounded, 1.0));
  EXPECT_EQ(NumbersDiffer(3.0, 3.1), NumbersDiffer(3.1, 3.0));
}

}  // namespace
}  // namespace gaitwright
