// SPDX-License-Identifier: BSD-3-Clause
// Conventions of a URDF do not matter: the same robot with other frames, names and signs has the same standing posture.
#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "tests/disguised_urdf.h"
#include "tests/kinematics/random_state.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

struct Case {
  std::string name, urdf;
};

void PrintTo(const Case& robot, std::ostream* out) { *out << robot.name; }

std::vector<Case> Cases() {
  std::vector<Case> cases;
  for (const std::string& name : RobotNames()) {
    // Ball joints become rotations about the axes of their frame, which differs in the changed URDF.
    if (name != "humanoid") cases.push_back({name, LoadNamedRobot(name).value().urdf_text});
  }
  cases.push_back({"insect", unusual::Insect()});
  cases.push_back({"telescopic", unusual::Telescopic()});
  cases.push_back({"wheeled", unusual::Wheeled()});
  cases.push_back({"tripod", unusual::Tripod()});
  cases.push_back({"biped", unusual::SoledBiped(true, true)});
  cases.push_back({"arm_and_tail", unusual::ArmAndTail()});
  return cases;
}

class Disguised : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(All, Disguised, testing::ValuesIn(Cases()), [](const auto& c) { return c.param.name; });

TEST_P(Disguised, StandsAsItDid) {
  const RobotModel plain = LoadRobotFromText(GetParam().urdf, "").value();
  for (unsigned seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    DisguisedUrdf disguise(GetParam().urdf, seed);
    const Result<RobotModel> loaded = LoadRobotFromText(disguise.text(), "");
    ASSERT_TRUE(loaded.ok()) << loaded.failure().message;
    const RobotModel& model = *loaded;
    ASSERT_EQ(model.legs.size(), plain.legs.size());
    EXPECT_NEAR(model.total_mass_kg, plain.total_mass_kg, 1e-9);
    EXPECT_NEAR(model.leg_length_m(), plain.leg_length_m(), 1e-6);
    EXPECT_NEAR(model.standing_base_height_m, plain.standing_base_height_m, 1e-6);
    EXPECT_NEAR(model.nominal_speed_m_s, plain.nominal_speed_m_s, 1e-6);
    DynamicsScratch of_plain(plain), of_model(model);
    ForwardKinematics(plain, StandingConfiguration(plain), of_plain);
    ForwardKinematics(model, StandingConfiguration(model), of_model);
    EXPECT_LT((CentreOfMass(plain, of_plain) - CentreOfMass(model, of_model)).norm(), 1e-5);
    for (std::size_t f = 0; f < plain.feet.size(); ++f) {
      EXPECT_EQ(model.feet[f].link, disguise.NameOf(plain.feet[f].link));
      EXPECT_EQ(model.feet[f].type, plain.feet[f].type);
      EXPECT_EQ(model.legs[f].mirror, plain.legs[f].mirror);
      const int i = static_cast<int>(f);
      EXPECT_LT((ContactFrame(plain, of_plain, i).matrix() - ContactFrame(model, of_model, i).matrix()).norm(), 1e-5);
    }
  }
}

}  // namespace
}  // namespace gaitwright
