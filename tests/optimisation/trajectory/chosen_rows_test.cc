// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "optimisation/trajectory/chosen_rows_internal.h"
#include "tests/optimisation/trajectory/trotting_problem.h"

namespace gaitwright {
namespace {

/// Any problem with a pace and two footholds to choose, a cycle that repeats with a turn, and powers in its cost.
struct ChosenProblem {
  explicit ChosenProblem(const std::string& robot) : any(robot) {
    any.problem.weights.power = 0.7;
    any.problem.limits_jerk = false;
    any.problem.knots[1].tie.emplace();
    any.problem.knots[3].tie = CycleTie{0, 0.4, {0.3, -0.2, 0.1}};
    choices.pace_points = 5;
    choices.longest = 1.2;
    choices.footholds = {{"one", {Vector3::UnitX(), Vector3::UnitY()}, {-0.1, -0.2}, {0.3, 0.4}, {{1, 0}, {2, 0, 0.5}}},
                         {"other", {Vector3::UnitY(), Vector3::UnitZ()}, {-0.1, -0.2}, {0.3, 0.4}, {{2, 1}, {3, 1}}}};
  }
  AnyProblem any;
  BodyChoices choices;
};

class RowsOfChoices : public testing::TestWithParam<const char*> {
 protected:
  RowsOfChoices() : rows_(of_.any.problem, of_.choices, of_.any.z) {
    z_ = rows_.StartOf(of_.any.z) + 0.1 * random_.Vector(rows_.StartOf(of_.any.z).size());
    rows_.Evaluate(z_);
    rows_.Differentiate();
  }

  RandomState random_{5};
  ChosenProblem of_{GetParam()};
  ChosenRows rows_;
  VectorX z_;
};

TEST_P(RowsOfChoices, MoveAsFiniteDifferencesSay) {
  constexpr double kStep = 1e-7;
  for (int trial = 0; trial < 3; ++trial) {
    VectorX along = random_.Vector(z_.size());
    if (trial > 0) along.head(of_.any.z.size()).setZero();
    const VectorX moved = rows_.Moved(along);
    rows_.Evaluate(z_ + kStep * along);
    const VectorX after = rows_.value();
    rows_.Evaluate(z_ - kStep * along);
    const VectorX difference = (after - rows_.value()) / (2.0 * kStep);
    for (Eigen::Index row = 0; row < rows_.count(); ++row) {
      const std::string name = row < rows_.residuals() ? "" : rows_.NameOf(row);
      const double tolerance = name.starts_with("distance") ? 5e-3 : 5e-5;
      EXPECT_NEAR(moved[row], difference[row], tolerance * (1.0 + std::abs(difference[row]))) << row << name;
    }
  }
}

TEST_P(RowsOfChoices, GradientIsTheTransposeOfTheMove) {
  const VectorX along = random_.Vector(z_.size()), by = random_.Vector(rows_.count());
  const double product = by.dot(rows_.Moved(along));
  EXPECT_GT(std::abs(product), 1.0);
  EXPECT_NEAR(rows_.Gradient(by).dot(along), product, 1e-10 * by.norm() * rows_.Moved(along).norm());
}

TEST_P(RowsOfChoices, FactorsSolveTheNormalEquations) {
  VectorX weights = random_.Vector(rows_.count()).cwiseAbs2();
  constexpr double kDamping = 0.01;
  ASSERT_TRUE(rows_.Factor(weights, kDamping));
  const VectorX right = random_.Vector(z_.size()), solved = rows_.Solved(right);
  const VectorX moved = rows_.Moved(solved);
  weights.head(rows_.residuals()).setOnes();
  const VectorX back = rows_.Gradient(weights.cwiseProduct(moved)) + kDamping * solved;
  EXPECT_LT((back - right).norm(), 1e-6 * right.norm());
}

TEST_P(RowsOfChoices, BoundTheirChoices) {
  const Eigen::Index first = rows_.count() - of_.choices.count() - 1;
  EXPECT_NEAR(rows_.BoundsOf(first).lower, std::log(0.8), 1e-15);
  EXPECT_NEAR(rows_.BoundsOf(first + 4).upper, std::log(1.25), 1e-15);
  EXPECT_EQ(rows_.BoundsOf(first + 5).lower, -0.1);
  EXPECT_EQ(rows_.BoundsOf(first + 8).upper, 0.4);
  EXPECT_EQ(rows_.BoundsOf(rows_.count() - 1).lower, 0.0);
  EXPECT_NEAR(rows_.BoundsOf(rows_.count() - 1).upper, 0.2, 1e-15);
  EXPECT_EQ(rows_.value()[first + 6], z_[of_.any.z.size() + 6]);
}

/// Of a state that repeats with a turn of 0.4 rad about the vertical axis: coordinates, rates and accelerations.
TEST(ChosenRows, RefuseLimitsOfJerkWithAPaceThatIsChosen) {
  ChosenProblem of("a1");
  of.any.problem.limits_jerk = true;
  EXPECT_THROW(ChosenRows(of.any.problem, of.choices, of.any.z), InvalidArgument);
  of.choices.pace_points = 0;
  EXPECT_NO_THROW(ChosenRows(of.any.problem, of.choices, of.any.z));
}

TEST_P(RowsOfChoices, RepeatTheStateOfACycle) {
  const Eigen::Index n = of_.any.model.nv(), rows = 3 * n;
  const VectorX start = rows_.StartOf(of_.any.z), state = start.tail(rows);
  EXPECT_EQ(state.size() + of_.choices.count() + of_.any.z.size(), start.size());
  rows_.Evaluate(start);
  const auto tied = [&](std::size_t k) {
    const Eigen::Index end = rows_.inner().RowsOf(k)[1].second;
    return VectorX(rows_.inner().value().segment(end - rows, rows));
  };
  EXPECT_EQ(tied(1).norm(), 0.0) << "the first knot decides where a cycle starts";
  const VectorX there = rows_.inner().StateAt(3, of_.any.z);
  const double turned = 0.4;
  EXPECT_NEAR(tied(3)[0], there[0] - (std::cos(turned) * state[0] - std::sin(turned) * state[1] + 0.3), 1e-12);
  EXPECT_NEAR(tied(3)[3], there[3] - (state[3] + turned), 1e-12);
  const double rate = there[n + 1] - (std::sin(turned) * state[n] + std::cos(turned) * state[n + 1]);
  EXPECT_NEAR(tied(3)[n + 1], 0.1 * rate, 1e-12) << "in units of 0.1 s";
  EXPECT_NEAR(tied(3)[rows - 1], 0.01 * (there[rows - 1] - state[rows - 1]), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Robots, RowsOfChoices, testing::ValuesIn(kAnyRobots));

TEST(PaceSpline, IsConstantForEqualPoints) {
  const PaceSpline pace(1.0, 3.0, VectorX::Constant(7, std::log(1.2)));
  for (const double time_s : {1.0, 1.3, 2.0, 3.0}) {
    EXPECT_NEAR(pace.At(time_s).rate, 1.2, 1e-12);
    EXPECT_NEAR(pace.At(time_s).slope, 0.0, 1e-12);
  }
}

TEST(PaceSpline, SlopeIsTheDerivativeOfTheRate) {
  RandomState random(1);
  const PaceSpline pace(1.0, 3.0, random.Vector(7));
  constexpr double kStep = 1e-6;
  for (const double time_s : {1.1, 1.49, 1.51, 2.2, 2.9}) {
    const double difference = (pace.At(time_s + kStep).rate - pace.At(time_s - kStep).rate) / (2.0 * kStep);
    EXPECT_NEAR(pace.At(time_s).slope, difference, 1e-7);
  }
}

TEST(PaceSpline, IsTheProblemsOwnWithoutPoints) {
  const PaceSpline pace(1.0, 3.0, VectorX());
  EXPECT_EQ(pace.At(2.0).rate, 1.0);
  EXPECT_EQ(pace.At(2.0).slope, 0.0);
}

/// A sine whose pace changes, against its derivatives by time.
TEST(PaceSpline, DerivativesByTimeAreThoseOfTheChain) {
  const KnotBasis basis{{1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {3.0, 0.0, 0.0}};
  const KnotBasis now = AtPace(basis, {1.5, 0.4});
  EXPECT_EQ(now.value[0], 1.0);
  EXPECT_NEAR(now.rate[0], 3.0, 1e-15);
  EXPECT_NEAR(now.acceleration[0], 1.5 * (1.5 * 3.0 + 0.4 * 2.0), 1e-15);
}

}  // namespace
}  // namespace gaitwright
