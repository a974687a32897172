// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <string>

#include "optimisation/trajectory/body_rows_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/optimisation/numerics/derivative_check.h"
#include "tests/optimisation/trajectory/trotting_problem.h"

namespace gaitwright {
namespace {

class BoundsOfRows : public testing::TestWithParam<const char*> {
 protected:
  const AnyProblem any_{GetParam()};
};

TEST_P(BoundsOfRows, HaveNames) {
  const BodyRows rows(any_.problem, any_.z);
  std::set<std::string> kinds;
  for (Eigen::Index row = rows.residuals(); row < rows.count(); ++row) {
    const std::string name = rows.NameOf(row);
    EXPECT_NE(name.find(" s"), std::string::npos);
    kinds.insert(name.substr(0, name.find(' ')));
  }
  for (const char* kind :
       {"balance", "foothold", "swing", "torque", "position", "friction", "start", "distance", "acceleration", "jerk"})
    EXPECT_TRUE(kinds.contains(kind)) << kind;
}

TEST(RowBounds, LandingJointsKeepFurtherFromTheEndsOfTheirRanges) {
  const AnyProblem any("a1");
  BodyProblem lands = any.problem;
  lands.use.landing_margin = 0.2;
  const BodyRows usual(any.problem, any.z), landing(lands, any.z);
  double most = 0.0;
  for (Eigen::Index row = usual.residuals(); row < usual.count(); ++row) {
    if (!usual.NameOf(row).starts_with("position")) continue;
    const RowBounds before = usual.BoundsOf(row), now = landing.BoundsOf(row);
    for (const double kept : {now.lower - before.lower, before.upper - now.upper}) {
      EXPECT_GE(kept, 0.0);
      EXPECT_LE(kept, 0.2);
      most = std::max(most, kept);
    }
  }
  EXPECT_GT(most, 0.1);
}

/// The limit of the fourth joint, of which motions may use a share.
TEST_P(BoundsOfRows, LimitAccelerations) {
  const BodyRows rows(any_.problem, any_.z);
  int found = 0;
  for (Eigen::Index row = rows.residuals(); row < rows.count(); ++row) {
    if (!rows.NameOf(row).starts_with("acceleration of '" + any_.model.dof_names[3])) continue;
    EXPECT_EQ(rows.BoundsOf(row).lower, -1.0);
    EXPECT_EQ(rows.BoundsOf(row).upper, 1.0);
    const std::size_t k = static_cast<std::size_t>(1 + found++);
    const VectorX state = rows.StateAt(k, any_.z);
    EXPECT_NEAR(rows.value()[row], state[2 * any_.model.nv() + 6 + 3] / (0.97 * 40.0), 1e-12);
  }
  EXPECT_EQ(found, 3) << "at all knots but those whose motion is given";
}

/// The change of acceleration between knots of 10 ms, by row and knot.
TEST_P(BoundsOfRows, LimitJerks) {
  const BodyRows rows(any_.problem, any_.z);
  std::size_t k = 1;
  for (Eigen::Index row = rows.residuals(); row < rows.count(); ++row) {
    if (!rows.NameOf(row).starts_with("jerk of '" + any_.model.dof_names[4])) continue;
    EXPECT_EQ(rows.BoundsOf(row).lower, -1.0);
    EXPECT_EQ(rows.BoundsOf(row).upper, 1.0);
    const Eigen::Index at = 2 * any_.model.nv() + 6 + 4;
    const double change = rows.StateAt(k, any_.z)[at] - rows.StateAt(k - 1, any_.z)[at];
    EXPECT_NEAR(rows.value()[row], change / (0.01 * 0.97 * 700.0), 1e-9 * (1.0 + std::abs(change)));
    ++k;
  }
  EXPECT_EQ(k, any_.problem.knots.size());
  BodyProblem without = any_.problem;
  without.limits_jerk = false;
  EXPECT_EQ(BodyRows(without, any_.z).count(), rows.count() - 2 * static_cast<Eigen::Index>(k - 1));
}

INSTANTIATE_TEST_SUITE_P(Robots, BoundsOfRows, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
