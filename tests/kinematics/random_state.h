// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {

/// A robot that comes with the program, or a failed test.
inline RobotModel Robot(const std::string& name) {
  Result<RobotModel> model = LoadNamedRobot(name);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return std::move(model).value();
}

/// Seeded normal numbers.
class RandomState {
 public:
  explicit RandomState(unsigned seed) : engine_(seed) {}

  VectorX Vector(Eigen::Index size) {
    std::normal_distribution<double> normal;
    VectorX v(size);
    for (Eigen::Index i = 0; i < size; ++i) v[i] = normal(engine_);
    return v;
  }
  VectorX Configuration(const RobotModel& model) {
    VectorX q = Vector(model.nq());
    q.segment<4>(3).normalize();
    return q;
  }

 private:
  std::mt19937 engine_;
};

/// q moved along v for a time.
inline VectorX Moved(const VectorX& q, const VectorX& v, double time_s) {
  VectorX moved = q;
  moved.head<3>() += time_s * v.head<3>();
  const Matrix3 R = Quaternion(q[6], q[3], q[4], q[5]).toRotationMatrix();
  moved.segment<4>(3) = Quaternion(RotationExp(time_s * v.segment<3>(3)) * R).coeffs();
  moved.tail(q.size() - 7) += time_s * v.tail(v.size() - 6);
  return moved;
}

}  // namespace gaitwright
