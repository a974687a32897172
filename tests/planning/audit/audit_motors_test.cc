// SPDX-License-Identifier: BSD-3-Clause
// Checks of motors: each is violated by a slightly too weak motor, and kept by a slightly stronger one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "planning/audit/joint_watch.h"
#include "planning/audit/motor_effort.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

class MotorLaw : public testing::TestWithParam<std::string> {
 protected:
  MotorLaw() : model_(GoodPlanOf(GetParam()).model), plan_(GoodPlanOf(GetParam()).plan) {
    for (Motor& each : model_.motors) each = Motor();  // no motor data
    dof_ = model_.joints[static_cast<std::size_t>(model_.legs[0].knee_joint)].dof;
    for (const double time_s : SampleTimes(plan_)) {
      times_.push_back(time_s);
      samples_.emplace_back();
      SampleWholeBody(plan_.whole_body, time_s, samples_.back());
    }
  }
  Motor& motor() { return model_.motors[static_cast<std::size_t>(dof_)]; }
  Joint& joint() { return model_.joints[static_cast<std::size_t>(model_.dof_joint[static_cast<std::size_t>(dof_)])]; }
  const std::string& name() const { return model_.dof_names[static_cast<std::size_t>(dof_)]; }
  double v(std::size_t k) const { return samples_[k].v[6 + dof_]; }
  double a(std::size_t k) const { return samples_[k].a[6 + dof_]; }
  double tau(std::size_t k) const { return samples_[k].tau[dof_]; }

  /// The largest value of a figure over the samples from `first` on, and its time.
  std::pair<double, double> Largest(const std::function<double(std::size_t)>& figure, std::size_t first = 0) const {
    std::pair<double, double> largest = {-1e300, 0.0};
    for (std::size_t k = first; k < samples_.size(); ++k) {
      if (figure(k) > largest.first) largest = {figure(k), times_[k]};
    }
    return largest;
  }
  /// The only violation; it must be that of this joint.
  Violation Only(const AuditOptions& options = {}) const {
    const auto found = Audit(model_, plan_, options).value().violations;
    EXPECT_EQ(found.size(), 1U);
    if (found.size() != 1) return {};
    EXPECT_EQ(found[0].where, name());
    return found[0];
  }
  bool Passes() const { return ViolationsOf(model_, plan_).empty(); }

  RobotModel model_;
  MotionPlan plan_;
  int dof_ = 0;
  std::vector<double> times_;
  std::vector<WholeBodySample> samples_;
};

INSTANTIATE_TEST_SUITE_P(Robots, MotorLaw, testing::Values("a1", "nao"), [](const auto& robot) { return robot.param; });

TEST_P(MotorLaw, TorqueSpeedFindsATorqueThatTheMotorDoesNotHaveAtItsSpeed) {
  const double peak = model_.dof_effort_limit(dof_);
  // The smallest no-load speed at which the curve from the peak at rest is kept.
  const auto [least, at_s] = Largest(
      [&](std::size_t k) { return tau(k) * v(k) > 0.0 ? std::abs(v(k)) / (1.0 - std::abs(tau(k)) / peak) : 0.0; });
  ASSERT_GT(least, 0.1);
  motor().corner_speed = 0.0;
  motor().no_load_speed = 1.001 * least;
  EXPECT_TRUE(Passes());
  motor().no_load_speed = 0.97 * least;
  const Violation found = Only();
  EXPECT_EQ(found.law, Law::kTorqueSpeed);
  const Moment at(model_, plan_, found.at_s);
  EXPECT_NEAR(found.value, std::abs(at.sample.tau[dof_]), 1e-9);
  EXPECT_NEAR(found.limit, std::max(0.0, peak * (1.0 - std::abs(at.sample.v[6 + dof_]) / motor().no_load_speed)), 1e-9);
  EXPECT_GT(found.value, found.limit);
  EXPECT_GT(at.sample.tau[dof_] * at.sample.v[6 + dof_], 0.0) << "braking has the whole peak";
}

TEST_P(MotorLaw, DeratingNarrowsTheCurve) {
  motor().corner_speed = 0.0;
  const auto [fastest, at_s] = Largest([&](std::size_t k) { return tau(k) * v(k) > 0.0 ? std::abs(v(k)) : 0.0; });
  motor().no_load_speed = 10.0 * fastest + 10.0;
  EXPECT_TRUE(Passes());
  AuditOptions options;
  options.derate_speed = 0.9 * fastest / motor().no_load_speed;
  const auto found = Audit(model_, plan_, options).value().violations;
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Violation& each) {
    return each.law == Law::kTorqueSpeed && each.where == name() && each.limit == 0.0;
  }));
}

TEST_P(MotorLaw, TorqueSpeedTellsItsMarginWhereTheWholePeakHoldsToo) {
  const auto fastest = Largest([&](std::size_t k) { return std::abs(v(k)); });
  motor().corner_speed = 10.0 * fastest.first;
  motor().no_load_speed = 20.0 * fastest.first;
  AuditOptions options;
  options.margins = true;
  options.derate_torque = 0.9;
  const AuditReport report = Audit(model_, plan_, options).value();
  EXPECT_TRUE(report.pass()) << AuditText(report);
  const auto found = std::find_if(report.margins.begin(), report.margins.end(),
                                  [](const AuditMargin& m) { return m.law == Law::kTorqueSpeed; });
  ASSERT_NE(found, report.margins.end()) << "a curve that is kept is a law that was looked at";
  EXPECT_EQ(found->where, name());
  const auto [most, at_s] = Largest([&](std::size_t k) { return std::abs(tau(k)); });
  EXPECT_EQ(std::pair(found->value, found->at_s), std::pair(most, at_s));
  EXPECT_NEAR(found->limit, 0.9 * model_.dof_effort_limit(dof_), 1e-12) << "the limit in force";
  joint().effort_limit = 0.5 * most;
  EXPECT_EQ(Only().law, Law::kJointTorque) << "below the corner that law says it alone";
}

TEST_P(MotorLaw, ACurveWhosePeakIsAPlaceholderIsNotTakenForKnown) {
  motor().corner_speed = 1.0;
  motor().no_load_speed = 1000.0;
  const auto says = [&](const std::string& part) {
    const std::vector<std::string> lines = UnknownOfMotors(model_);
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(part) != std::string::npos; });
  };
  EXPECT_FALSE(says("torque_speed not applied to '" + name() + "'"));
  joint().effort_limit_is_placeholder = true;
  EXPECT_TRUE(says("torque_speed not applied to '" + name() + "' below the no-load speed: the peak torque"));
  AuditOptions options;
  options.margins = true;
  const AuditReport report = Audit(model_, plan_, options).value();
  for (const AuditMargin& margin : report.margins) EXPECT_NE(margin.law, Law::kTorqueSpeed);
}

TEST_P(MotorLaw, AccelerationFindsALimitPassed) {
  const auto [most, at_s] = Largest([&](std::size_t k) { return std::abs(a(k)); });
  motor().acceleration_limit = 1.001 * most;
  EXPECT_TRUE(Passes());
  motor().acceleration_limit = 0.95 * most;
  const Violation found = Only();
  EXPECT_EQ(found.law, Law::kJointAcceleration);
  EXPECT_NEAR(found.value, most, 1e-9);
  EXPECT_NEAR(found.at_s, at_s, 1e-9);
  EXPECT_EQ(found.unit, "rad/s^2");
  motor().acceleration_limit = 1.05 * most;
  AuditOptions options;
  options.derate_acceleration = 0.9;
  EXPECT_NEAR(Only(options).limit, 0.9 * 1.05 * most, 1e-9);
}

TEST_P(MotorLaw, JerkFindsALimitPassedOverTenMilliseconds) {
  const auto [most, at_s] = Largest([&](std::size_t k) { return std::abs(a(k) - a(k - 10)) / 0.01; }, 10);
  motor().jerk_limit = 1.001 * most;
  EXPECT_TRUE(Passes());
  motor().jerk_limit = 0.95 * most;
  const Violation found = Only();
  EXPECT_EQ(found.law, Law::kJointJerk);
  EXPECT_NEAR(found.value, most, 1e-6 * most);
  EXPECT_NEAR(found.at_s, at_s - 0.005, 1e-9);
  EXPECT_EQ(found.unit, "rad/s^3");
  motor().jerk_limit = 1.05 * most;
  AuditOptions options;
  options.derate_jerk = 0.9;
  EXPECT_EQ(Only(options).law, Law::kJointJerk);
}

TEST_P(MotorLaw, ContinuousTorqueIsTheMeanOverTheWholePlanWhereThatIsShort) {
  double sum = 0.0;
  for (std::size_t k = 0; k < samples_.size(); ++k) sum += tau(k) * tau(k);
  const double mean = std::sqrt(sum / static_cast<double>(samples_.size()));
  motor().thermal_s = 2.0 * plan_.duration_s();
  motor().continuous_effort = 1.001 * mean;
  EXPECT_TRUE(Passes());
  motor().continuous_effort = 0.98 * mean;
  const Violation found = Only();
  EXPECT_EQ(found.law, Law::kContinuousTorque);
  EXPECT_NEAR(found.value, mean, 1e-6 * mean);
  EXPECT_NEAR(found.at_s, times_.back(), 1e-9);
}

TEST_P(MotorLaw, ContinuousTorqueIsTheWorstMeanOverTheThermalTime) {
  constexpr std::size_t kWindow = 200;
  ASSERT_GT(samples_.size(), 2 * kWindow);
  const auto mean = [&](std::size_t last) {
    double sum = 0.0;
    for (std::size_t k = last + 1 - kWindow; k <= last; ++k) sum += tau(k) * tau(k);
    return std::sqrt(sum / kWindow);
  };
  const auto [most, at_s] = Largest(mean, kWindow - 1);
  motor().thermal_s = 0.2;
  motor().continuous_effort = 1.001 * most;
  EXPECT_TRUE(Passes());
  motor().continuous_effort = 0.98 * most;
  const Violation found = Only();
  EXPECT_EQ(found.law, Law::kContinuousTorque);
  EXPECT_NEAR(found.value, most, 1e-6 * most);
  EXPECT_NEAR(found.at_s, at_s, 1e-9);
  motor().continuous_effort = 1.05 * most;
  AuditOptions options;
  options.derate_continuous = 0.9;
  EXPECT_EQ(Only(options).law, Law::kContinuousTorque);
}

TEST_P(MotorLaw, WhatJointAndRotorTakeThemselvesIsPartOfTheTorque) {
  const auto [without, at_s] = Largest([&](std::size_t k) { return std::abs(tau(k)); });
  const double d = 0.05 * without, c = 0.1 * without, inertia = 0.001 * without;
  const auto effort = [&](std::size_t k) {
    return std::abs(tau(k) + d * v(k) + c * std::clamp(100.0 * v(k), -1.0, 1.0) + inertia * a(k));
  };
  const auto [with, later_s] = Largest(effort);
  ASSERT_GT(with, 1.02 * without);
  joint().effort_limit = 1.01 * without;
  EXPECT_TRUE(Passes());
  joint().damping = d;
  joint().friction = c;
  motor().rotor_inertia = inertia;
  const Violation found = Only();
  EXPECT_EQ(found.law, Law::kJointTorque);
  EXPECT_NEAR(found.value, with, 1e-9);
  EXPECT_NEAR(found.at_s, later_s, 1e-9);
  joint().effort_limit = 1.001 * with;
  EXPECT_TRUE(Passes()) << "dynamics are those of the bodies alone";
}

TEST_P(MotorLaw, MarginsAreTheClosestApproachOfEachLaw) {
  EXPECT_TRUE(Audit(model_, plan_, {}).value().margins.empty()) << "only when asked for";
  AuditOptions options;
  options.margins = true;
  const auto most_torque = Largest([&](std::size_t k) { return std::abs(tau(k)); });
  const auto most_speed = Largest([&](std::size_t k) { return std::abs(v(k)); });
  const AuditReport report = Audit(model_, plan_, options).value();
  EXPECT_TRUE(report.pass());
  std::vector<Law> laws;
  for (const AuditMargin& m : TightestOfEachLaw(report.margins)) laws.push_back(m.law);
  for (const Law law : {Law::kConsistency, Law::kJointPosition, Law::kJointVelocity, Law::kReach, Law::kSelfCollision,
                        Law::kFootClearance, Law::kBodyClearance, Law::kZmpSupport, Law::kUnilateral,
                        Law::kFrictionCone, Law::kDynamics, Law::kJointTorque})
    EXPECT_EQ(std::count(laws.begin(), laws.end(), law), 1) << law;
  EXPECT_EQ(laws.size(), 12U) << "and none without a limit";
  for (const AuditMargin& m : report.margins) {
    EXPECT_GE(m.margin, -2e-3) << m.law << " " << m.where;
    EXPECT_NEAR(std::abs(m.limit - m.value), std::abs(m.margin), 1e-12) << m.law;
    if (m.where != name()) continue;
    if (m.law == Law::kJointTorque) {
      EXPECT_EQ(std::pair(m.value, m.at_s), most_torque);
    }
    if (m.law == Law::kJointVelocity) {
      EXPECT_EQ(std::pair(m.value, m.at_s), most_speed);
    }
    if (m.share) {
      EXPECT_NEAR(*m.share, m.margin / m.limit, 1e-12);
    }
  }
}

TEST_P(MotorLaw, MarginsOfABrokenLimitAreNegative) {
  const auto [most, at_s] = Largest([&](std::size_t k) { return std::abs(v(k)); });
  joint().velocity_limit = 0.9 * most;
  AuditOptions options;
  options.margins = true;
  const AuditReport report = Audit(model_, plan_, options).value();
  const auto at = std::find_if(report.margins.begin(), report.margins.end(),
                               [](const AuditMargin& m) { return m.law == Law::kJointVelocity; });
  ASSERT_NE(at, report.margins.end());
  EXPECT_EQ(at->where, name()) << "the least of a law comes first";
  EXPECT_NEAR(at->margin, -0.1 * most, 1e-9);
  EXPECT_NEAR(*at->share, -1.0 / 9.0, 1e-9);
  EXPECT_NE(AuditText(report).find("smallest margin of each check"), std::string::npos);
  EXPECT_NE(AuditJson(report).find("\"margins\""), std::string::npos);
}

TEST_P(MotorLaw, WhatIsNotKnownIsListed) {
  EXPECT_EQ(UnknownOfMotors(model_).size(), 4U);
  EXPECT_EQ(UnknownOfMotors(model_)[0],
            "joint_acceleration not applied: robot.yaml does not give any limit of acceleration");
  for (Motor& each : model_.motors) each.jerk_limit = 1.0;
  EXPECT_EQ(UnknownOfMotors(model_).size(), 3U);
  motor().jerk_limit = Motor::kNone;
  EXPECT_EQ(UnknownOfMotors(model_)[1],
            "joint_jerk not applied to '" + name() + "': robot.yaml does not give their limit of jerk");
}

TEST(MotorEffortOfMimics, CountsTheJointsThatFollow) {
  RobotModel model = GoodPlanOf("nao").model;
  const auto follows =
      std::find_if(model.joints.begin(), model.joints.end(), [](const Joint& j) { return j.is_mimic; });
  ASSERT_NE(follows, model.joints.end());
  for (Joint& joint : model.joints) joint.damping = joint.friction = 0.0;
  follows->damping = 2.0;
  follows->friction = 3.0;
  const double r = follows->multiplier;
  const auto all = [&](double each) { return VectorX(VectorX::Constant(model.num_dofs(), each)); };
  EXPECT_NEAR(MotorEffort(model).Of(follows->dof, all(1.0), all(0.5), all(7.0)),
              1.0 + 2.0 * r * r * 0.5 + 3.0 * std::abs(r), 1e-12);
}

}  // namespace
}  // namespace gaitwright
