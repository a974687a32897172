// SPDX-License-Identifier: BSD-3-Clause

#include "kinematics/description/mjcf_compiler_internal.h"
#include "kinematics/description/mjcf_shapes_internal.h"
#include "tests/kinematics/description/mjcf_texts.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

Matrix3 TurnAbout(const Vector3& axis, double degrees) {
  return Eigen::AngleAxisd(kDegree * degrees, axis.normalized()).toRotationMatrix();
}
Matrix3 TurnX(double degrees) { return TurnAbout(Vector3::UnitX(), degrees); }
Matrix3 TurnY(double degrees) { return TurnAbout(Vector3::UnitY(), degrees); }
Matrix3 TurnZ(double degrees) { return TurnAbout(Vector3::UnitZ(), degrees); }

Matrix3 RotationOf(const std::string& key, const std::string& text, const MjcfCompiler& compiler = {}) {
  return MjcfRotation(MjcfAttributes("here", {{key, text}}), compiler);
}

void ExpectRotation(const Matrix3& R, const Matrix3& wanted, const std::string& what) {
  EXPECT_LT((R - wanted).norm(), 1e-12) << what << ":\n" << R << "\nwanted\n" << wanted;
  EXPECT_LT((R * R.transpose() - Matrix3::Identity()).norm(), 1e-12) << what;
  EXPECT_NEAR(R.determinant(), 1.0, 1e-12) << what;
}

TEST(MjcfRotation, HasKnownAnswers) {
  ExpectRotation(RotationOf("quat", "0.70710678118654757 0 0.70710678118654757 0"), TurnY(90), "quat");
  ExpectRotation(RotationOf("quat", "2 2 0 0"), TurnX(90), "a quaternion that is not unit");
  ExpectRotation(RotationOf("axisangle", "0 0 2 30"), TurnZ(30), "axisangle");
  ExpectRotation(RotationOf("axisangle", "1 1 0 -50"), TurnAbout({1, 1, 0}, -50), "axisangle across");
  Matrix3 swapped;
  swapped << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  ExpectRotation(RotationOf("xyaxes", "0 3 0 -1 0 0"), swapped, "xyaxes");
  ExpectRotation(RotationOf("xyaxes", "0 3 0 -1 5 0"), swapped, "y axis that is not across x");
  ExpectRotation(RotationOf("zaxis", "0 0 2"), Matrix3::Identity(), "zaxis that is z");
  ExpectRotation(RotationOf("zaxis", "1 0 0"), TurnY(90), "zaxis that is x");
  ExpectRotation(RotationOf("zaxis", "0 1 0"), TurnX(-90), "zaxis that is y");
  ExpectRotation(RotationOf("zaxis", "0 0 -1"), TurnX(180), "zaxis that is -z");
  ExpectRotation(RotationOf("zaxis", "0 1 1"), TurnX(-45), "zaxis between y and z");
  EXPECT_LT((RotationOf("zaxis", "1 -2 3").col(2) - Vector3(1, -2, 3).normalized()).norm(), 1e-12);
}

TEST(MjcfRotation, EulerAnglesGoByTheirSequence) {
  const std::string angles = "10 20 30";
  const struct {
    const char* sequence;
    Matrix3 wanted;
  } cases[] = {
      {"xyz", TurnX(10) * TurnY(20) * TurnZ(30)},  // small letters: axes rotate with the frame
      {"zyx", TurnZ(10) * TurnY(20) * TurnX(30)}, {"zxz", TurnZ(10) * TurnX(20) * TurnZ(30)},
      {"XYZ", TurnZ(30) * TurnY(20) * TurnX(10)},  // capital letters: axes are fixed, as for roll, pitch, yaw
      {"ZYX", TurnX(30) * TurnY(20) * TurnZ(10)}, {"xYz", TurnY(20) * TurnX(10) * TurnZ(30)},
  };
  for (const auto& one : cases) {
    MjcfCompiler compiler;
    compiler.eulerseq = one.sequence;
    ExpectRotation(RotationOf("euler", angles, compiler), one.wanted, one.sequence);
  }
  MjcfCompiler radians;
  radians.degrees = false;
  ExpectRotation(RotationOf("euler", "0.1 0 0", radians), TurnX(0.1 / kDegree), "radians");
}

TEST(MjcfRotation, RollPitchYawAndTurnsMakeUpTheRotation) {
  RandomState random(5);
  for (int i = 0; i < 200; ++i) {
    Matrix3 R = RotationExp(random.Vector(3));
    if (i % 4 == 0) R = TurnZ(10.0 * i) * TurnY(i % 8 == 0 ? 90 : -90) * TurnX(7.0 * i);
    const Vector3 rpy = MjcfRollPitchYaw(R) / kDegree;
    EXPECT_LT((TurnZ(rpy.z()) * TurnY(rpy.y()) * TurnX(rpy.x()) - R).norm(), 1e-12) << i;
  }
}

TEST(MjcfRotation, RefusesWhatIsNoRotation) {
  const auto with = [](const std::string& pose) { return MjcfMessage(MjcfOf(MjcfBodyOf("leg", "", pose))); };
  ExpectSays(with("quat='0 0 0 0'"), {"model.xml, line 7", "body 'leg'", "'quat' is zero"});
  ExpectSays(with("quat='1 0 0'"), {"line 7", "'quat'", "'1 0 0'", "3 numbers; 4 are needed"});
  ExpectSays(with("zaxis='0 0 0'"), {"body 'leg'", "'zaxis'", "does not define a direction"});
  ExpectSays(with("xyaxes='1 0 0 2 0 0'"), {"body 'leg'", "'xyaxes'", "parallel"});
  ExpectSays(with("euler='1 2 nan'"), {"body 'leg'", "'euler'", "'nan' is not a finite number"});
  ExpectSays(with("euler='1 2 3' quat='1 0 0 0'"), {"body 'leg'", "2 orientations"});
  ExpectSays(MjcfMessage(MjcfOf("", "<compiler eulerseq='xyw'/>")), {"line 2", "'eulerseq' is 'xyw'"});
  ExpectSays(MjcfMessage(MjcfOf("", "<compiler coordinate='global'/>")), {"line 2", "global coordinates"});
  ExpectSays(MjcfMessage(MjcfOf("", "<compiler angle='grad'/>")), {"'angle' is 'grad'", "'degree', 'radian'"});
}

}  // namespace
}  // namespace gaitwright
