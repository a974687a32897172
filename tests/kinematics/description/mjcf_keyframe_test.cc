// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf_keyframe_internal.h"
#include "tests/kinematics/description/mjcf_texts.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

const MjcfFiles kNoKeyFiles;
using MjcfPosture = std::vector<std::pair<std::string, double>>;

/// A base with a chain of three hinges a, b, c, whose keyframes are given. Couplings are set by hand.
class MjcfPostureTest : public testing::Test {
 protected:
  MjcfPosture PostureOf(const std::string& keys, const std::string& joint = "") {
    const std::string chain = "<body name='p'><joint name='a'/><body name='q'><joint name='b' " + joint +
                              "/><body name='r'><joint name='c'/></body></body></body>";
    MjcfContext context("<mujoco><compiler angle='radian'/><worldbody><body name='base'><freejoint/>" + chain +
                            "</body></worldbody>" + keys + "</mujoco>",
                        kNoKeyFiles, "model.xml");
    const MjcfTree tree = ReadMjcfTree(context);
    couplings_.resize(tree.joints.size());
    MjcfPosture posture = ReadMjcfPosture(context, tree, couplings_);
    notes_ = context.notes;
    return posture;
  }

  static std::string Keys(const std::string& qpos) {
    return "<keyframe><key name='home' qpos='0 0 1 1 0 0 0 " + qpos + "'/></keyframe>";
  }

  std::vector<MjcfCoupling> couplings_;
  std::vector<std::string> notes_;
};

TEST_F(MjcfPostureTest, HomeInAnyLettersComesBeforeTheFirst) {
  const std::string keys =
      "<keyframe><key name='up' qpos='0 0 1 1 0 0 0 1 2 3'/><key name='Home' qpos='0 0 1 1 0 0 0 4 5 6'/></keyframe>";
  EXPECT_EQ(PostureOf(keys), (MjcfPosture{{"a", 4.0}, {"b", 5.0}, {"c", 6.0}}));
  EXPECT_EQ(PostureOf(Replaced(keys, "Home", "homes")), (MjcfPosture{{"a", 1.0}, {"b", 2.0}, {"c", 3.0}}));
}

TEST_F(MjcfPostureTest, WithoutPositionsThereIsNone) {
  EXPECT_TRUE(PostureOf("").empty());
  EXPECT_TRUE(PostureOf("<keyframe><key name='home'/></keyframe>").empty());
  EXPECT_TRUE(notes_.empty());
  EXPECT_TRUE(PostureOf(Keys("1 2")).empty());
  ASSERT_EQ(notes_.size(), 1U);
  ExpectSays(notes_[0], {"9 numbers", "need 10"});
}

TEST_F(MjcfPostureTest, FollowersAndLockedJointsHaveNoPosition) {
  couplings_.resize(4);
  couplings_[1].locked = 0.0;
  couplings_[3].leader = 2;
  EXPECT_EQ(PostureOf(Keys("1 2 3")), (MjcfPosture{{"b", 2.0}}));
}

TEST_F(MjcfPostureTest, ALeaderKeepsTheRangeOfItsFollowers) {
  couplings_.resize(4);
  couplings_[2].leader = 1;  // b = -2 a + 0.5, within -1 to 1: a within -0.25 to 0.75
  couplings_[2].multiplier = -2.0;
  couplings_[2].offset = 0.5;
  const std::string range = "range='-1 1'";
  EXPECT_EQ(PostureOf(Keys("0.7 0 0"), range).front(), (std::pair<std::string, double>{"a", 0.7}));
  EXPECT_EQ(PostureOf(Keys("0.7505 0 0"), range).front().second, 0.75) << "beyond by rounding";
  EXPECT_EQ(PostureOf(Keys("-0.3 0 0"), range), (MjcfPosture{{"c", 0.0}}));
  EXPECT_EQ(PostureOf(Keys("0.8 0 0"), range), (MjcfPosture{{"c", 0.0}}));
}

TEST_F(MjcfPostureTest, ABallJointGivesThreeTurnsAndNoneOfAZeroQuaternion) {
  const MjcfPosture posture = PostureOf(Keys("1 2 0 0 2 3"), "type='ball'");  // a right angle about z
  ASSERT_EQ(posture.size(), 5U);
  EXPECT_EQ(posture[1].first, "b_x");
  EXPECT_NEAR(posture[3].second, 0.5 * std::numbers::pi, 1e-12);
  EXPECT_EQ(posture[4], (std::pair<std::string, double>{"c", 3.0}));
  EXPECT_EQ(PostureOf(Keys("1 0 0 0 0 3"), "type='ball'").size(), 2U);
}

TEST(MjcfTurns, MakeUpTheRotationWhereverTheSecondTurnIs) {
  RandomState random(17);
  for (int i = 0; i < 200; ++i) {
    const Vector3 drawn = random.Vector(3);
    const double second = i % 3 == 0 ? 0.5 * std::numbers::pi : i % 3 == 1 ? -0.5 * std::numbers::pi : drawn.y();
    const Matrix3 R = RotationExp(drawn.x() * Vector3::UnitX()) * RotationExp(second * Vector3::UnitY()) *
                      RotationExp(drawn.z() * Vector3::UnitZ());
    const Vector3 turns = MjcfTurns(R);
    const Matrix3 made = RotationExp(turns.x() * Vector3::UnitX()) * RotationExp(turns.y() * Vector3::UnitY()) *
                         RotationExp(turns.z() * Vector3::UnitZ());
    EXPECT_LT((made - R).norm(), 1e-9) << i;
    EXPECT_LE(std::abs(turns.y()), 0.5 * std::numbers::pi + 1e-12);
  }
}

}  // namespace
}  // namespace gaitwright
