// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>

#include "optimisation/trajectory/body_rows_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/optimisation/numerics/derivative_check.h"
#include "tests/optimisation/trajectory/trotting_problem.h"

namespace gaitwright {
namespace {

class RowsOfBodies : public testing::TestWithParam<const char*> {
 protected:
  const AnyProblem any_{GetParam()};
};

TEST_P(RowsOfBodies, MoveAsFiniteDifferencesSay) {
  BodyRows rows(any_.problem, any_.z);
  RandomState random(2);
  constexpr double kStep = 1e-7;
  for (int trial = 0; trial < 3; ++trial) {
    const VectorX along = random.Vector(any_.z.size());
    const VectorX moved = rows.Moved(along);
    rows.Evaluate(any_.z + kStep * along);
    const VectorX after = rows.value();
    rows.Evaluate(any_.z - kStep * along);
    const VectorX difference = (after - rows.value()) / (2.0 * kStep);
    for (Eigen::Index row = 0; row < rows.count(); ++row) {
      const std::string name = row < rows.residuals() ? "" : rows.NameOf(row);
      const double tolerance = name.starts_with("distance") ? 5e-3 : 2e-5;  // distances are exact to 1e-10 m
      EXPECT_NEAR(moved[row], difference[row], tolerance * (1.0 + std::abs(difference[row]))) << row << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, RowsOfBodies, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
