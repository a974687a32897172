// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/workflows/exchange/bvh_text.h"
#include "tests/workflows/exchange/recorded_walk.h"
#include "workflows/exchange/deepmimic_motion_internal.h"
#include "workflows/exchange/frame_motion_internal.h"

namespace gaitwright {
namespace {

using namespace synthetic;

std::string WTurn(const Matrix3& R) {
  const Quaternion q(R);
  return fmt::format(", {:.12g}, {:.12g}, {:.12g}, {:.12g}", q.w(), q.x(), q.y(), q.z());
}

/// Frames with a quaternion for each run of at least so many hinges. @param R_SB  axes of the file.
std::string DeepMimicText(const RobotModel& model, const std::vector<VectorX>& motion, std::size_t least,
                          const Matrix3& R_SB) {
  std::string text = "{\"Loop\": \"none\",\n\"Frames\": [\n";
  for (const VectorX& q : motion) {
    const Vector3 p = R_SB * q.head<3>();
    text += fmt::format("[0.02, {:.12g}, {:.12g}, {:.12g}", p[0], p[1], p[2]) +
            WTurn(R_SB * BaseRotation(q) * R_SB.transpose());
    for (const std::vector<int>& run : StemRuns(model)) {
      const JointRun joints = RunOf(model, run);
      Matrix3 R_B = Matrix3::Identity();
      for (std::size_t i = 0; i < run.size(); ++i) {
        R_B = R_B * Eigen::AngleAxisd(q[7 + run[i]], joints.axes[i]).toRotationMatrix();
        if (run.size() < least) text += fmt::format(", {:.12g}", q[7 + run[i]]);
      }
      if (run.size() >= least) text += WTurn(R_SB * R_B * R_SB.transpose());
    }
    text += &q == &motion.back() ? "]\n" : "],\n";
  }
  return text + "]}\n";
}

std::string ReasonNoFrames(const RobotModel& model, const std::string& text) {
  const auto read = ParseDeepMimic(model, text, "a.json", {});
  return read.ok() ? "" : read.failure().message;
}

Matrix3 YUpwardXForward() {
  Matrix3 R_SB;
  R_SB << 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0;
  return R_SB;
}

TEST(DeepMimic, TheNumberOfColumnsDecides) {
  const RobotModel& model = NamedRobot("nao");  // it has ball joints of two hinges and of three
  const std::vector<VectorX> motion = MovingRows(model, 15).q;
  for (const std::size_t least : {2U, 3U, 4U}) {
    for (const Matrix3& R_SB : {Matrix3(Matrix3::Identity()), YUpwardXForward()}) {
      SCOPED_TRACE(fmt::format("{} {}", least, R_SB.isIdentity() ? "z" : "y"));
      const auto table = ParseDeepMimic(model, DeepMimicText(model, motion, least, R_SB), "a.json", {});
      ASSERT_TRUE(table.ok()) << table.failure().message;
      EXPECT_EQ(table->format, MotionFormat::kFramesDeepMimic);
      ASSERT_EQ(table->rows(), 15);
      for (std::size_t k = 0; k < motion.size(); ++k) {
        EXPECT_NEAR(table->time_s[k], 0.02 * static_cast<double>(k), 1e-12);
        EXPECT_LT((table->base_m[k] - motion[k].head<3>()).norm(), 1e-9);
        EXPECT_NEAR(std::abs(table->quaternion[k].dot(motion[k].segment<4>(3))), 1.0, 1e-9);
        EXPECT_LT((table->q[k] - motion[k].tail(model.num_dofs())).lpNorm<Eigen::Infinity>(), 1e-6) << k;
      }
    }
  }
}

TEST(DeepMimic, IsDistinguishedFromMotionImitation) {
  EXPECT_TRUE(HoldsDeepMimicFrames("{\"Loop\": \"wrap\", \"Frames\": [[]]}"));
  EXPECT_FALSE(HoldsDeepMimicFrames("{\"LoopMode\": \"Wrap\", \"FrameDuration\": 0.02, \"Frames\": [[]]}"));
  EXPECT_FALSE(HoldsDeepMimicFrames("[1]"));
}

TEST(DeepMimic, RefusesWithThePath) {
  const RobotModel& model = NamedRobot("h1");
  const std::vector<VectorX> motion = MovingRows(model, 3).q;
  const std::string good = DeepMimicText(model, motion, 3, Matrix3::Identity());
  EXPECT_NE(ReasonNoFrames(model, "{\"Frames\": [[0.1, 1, 2]]}").find("'Frames[0]' has 3 numbers; robot 'h1' needs"),
            std::string::npos)
      << ReasonNoFrames(model, "{\"Frames\": [[0.1, 1, 2]]}");
  EXPECT_NE(ReasonNoFrames(model, "{\"Frames\": []}").find("'Frames' is empty"), std::string::npos);
  std::string text = good;
  text.replace(text.find("[0.02"), 5, "[0.00");
  EXPECT_NE(ReasonNoFrames(model, text).find("'Frames[0]' has a duration of 0 s"), std::string::npos);
  text = good;
  text.replace(text.rfind("[0.02"), 5, "[0, 0");
  EXPECT_NE(ReasonNoFrames(model, text).find("'Frames[2]' has 32 numbers; the frames before have 31"),
            std::string::npos)
      << "a number more";
  text = good;
  const std::size_t quaternion = text.find(", 1,");
  ASSERT_NE(quaternion, std::string::npos);
  text.replace(quaternion, 4, ", 2,");
  EXPECT_NE(ReasonNoFrames(model, text).find("has a quaternion of length 2 in columns 5 to 8"), std::string::npos)
      << ReasonNoFrames(model, text);
  EXPECT_NE(ReasonNoFrames(model, good.substr(0, 100)), "");
}

}  // namespace
}  // namespace gaitwright
