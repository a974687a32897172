// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

using OfTime = std::function<double(double)>;

/// One coordinate of a body in the air, by its acceleration; integrated from rest.
struct FlownBy {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
};

std::vector<FlownBy> Integrated(const OfTime& acceleration, int rows, double step_s) {
  constexpr int kFine = 50;
  std::vector<FlownBy> states;
  FlownBy now;
  for (int k = 0; k < rows; ++k) {
    now.acceleration = acceleration(k * step_s);
    states.push_back(now);
    for (int i = 0; i < kFine; ++i) {
      const double h = step_s / kFine, a = acceleration(k * step_s + (i + 0.5) * h);
      now.value += h * now.rate + 0.5 * h * h * a;
      now.rate += h * a;
    }
  }
  return states;
}

/// The A1 in its standing posture, 1 m over the ground and without any contact for 0.3 s. Its centre of mass has a
/// given vertical acceleration, and it turns about a vertical axis through it with another one.
class InTheAir {
 public:
  static constexpr double kLasts = 0.3;

  explicit InTheAir(double step_s = 0.005) : model_(LoadNamedRobot("a1").value()), step_s_(step_s) {}

  const RobotModel& model() const { return model_; }

  MotionPlan Moved(const OfTime& up_m_s2, const OfTime& turn_rad_s2 = {}) const {
    const int rows = 1 + static_cast<int>(std::lround(kLasts / step_s_));
    const auto heights = Integrated(up_m_s2, rows, step_s_);
    const auto turns = Integrated(
        turn_rad_s2 ? turn_rad_s2 : [](double) { return 0.0; }, rows, step_s_);
    MotionPlan plan;
    plan.robot = model_.name;
    plan.terrain = FlatTerrain();
    plan.schedule.phases = {{0.0, kLasts, 0}};
    plan.whole_body.step_s = step_s_;
    for (std::size_t k = 0; k < heights.size(); ++k) AddRow(heights[k], turns[k], plan.whole_body);
    return plan;
  }

  /// Rate of the angular momentum in a turn about a vertical axis, from the inertia of the whole robot.
  double RateOfMomentum(double rate_rad_s, double acceleration_rad_s2) const {
    DynamicsScratch scratch(model_);
    ForwardKinematics(model_, StandingConfiguration(model_), scratch);
    const Matrix3 inertia = LockedInertia(model_, scratch);
    const Vector3 w = rate_rad_s * Vector3::UnitZ();
    return (inertia * (acceleration_rad_s2 * Vector3::UnitZ()) + w.cross(inertia * w)).norm();
  }

 private:
  void AddRow(const FlownBy& height, const FlownBy& turn, WholeBodyTrajectory& rows) const {
    const VectorX standing = StandingConfiguration(model_);
    DynamicsScratch scratch(model_);
    ForwardKinematics(model_, standing, scratch);
    const Matrix3 R = YawRotation(turn.value);
    const Vector3 arm = R * (standing.head<3>() - CentreOfMass(model_, scratch));
    const Vector3 w = turn.rate * Vector3::UnitZ(), dw = turn.acceleration * Vector3::UnitZ();
    VectorX q = standing, v = VectorX::Zero(model_.nv()), a = v;
    q.head<3>() = arm + (1.0 + height.value) * Vector3::UnitZ();
    q.segment<4>(3) = Quaternion(R * BaseRotation(standing)).coeffs();
    v.head<3>() = height.rate * Vector3::UnitZ() + w.cross(arm);
    v.segment<3>(3) = w;
    a.head<3>() = height.acceleration * Vector3::UnitZ() + dw.cross(arm) + w.cross(w.cross(arm));
    a.segment<3>(3) = dw;
    VectorX needed;
    InverseDynamics(model_, q, v, a, scratch, needed);
    rows.q.push_back(q);
    rows.v.push_back(v);
    rows.a.push_back(a);
    rows.tau.push_back(needed.tail(model_.num_dofs()));
    rows.wrenches.emplace_back(model_.feet.size());
  }

  RobotModel model_;
  double step_s_;
};

/// Smooth from 0 to `most` at a time and back within 40 ms.
OfTime Bump(double at_s, double most) {
  return [=](double t) {
    const double u = (t - at_s) / 0.02;
    return std::abs(u) >= 1.0 ? 0.0 : most * std::pow(std::cos(0.5 * std::numbers::pi * u), 2);
  };
}

OfTime Falling(const OfTime& besides = {}) {
  return [=](double t) { return -kGravity + (besides ? besides(t) : 0.0); };
}

std::vector<Violation> OfFlight(const AuditReport& report) {
  std::vector<Violation> found;
  std::copy_if(report.violations.begin(), report.violations.end(), std::back_inserter(found),
               [](const Violation& v) { return v.law == Law::kFlight || v.law == Law::kDynamics; });
  return found;
}

std::vector<Violation> OfFlight(const InTheAir& air, const MotionPlan& plan) {
  return OfFlight(Audit(air.model(), plan, {}).value());
}

TEST(AuditFlight, ABallisticBodyKeepsTheLaw) {
  const InTheAir air;
  EXPECT_TRUE(OfFlight(air, air.Moved(Falling())).empty());
  AuditOptions options;
  options.margins = true;
  const AuditReport report = Audit(air.model(), air.Moved(Falling()), options).value();
  int found = 0;
  for (const AuditMargin& margin : report.margins) {
    if (margin.law != Law::kFlight) continue;
    ++found;
    EXPECT_LT(margin.value, 1e-6) << margin.where;
    EXPECT_NEAR(margin.limit, 0.02, 1e-12) << margin.where;
  }
  EXPECT_EQ(found, 2) << "force and moment are both judged";
}

TEST(AuditFlight, GravityThatIsScaledIsFoundByHowMuch) {
  const InTheAir air;
  for (const double scale : {0.0, 0.9, 1.2}) {
    const auto found = OfFlight(air, air.Moved([&](double) { return -scale * kGravity; }));
    ASSERT_EQ(found.size(), 1U) << "not by `dynamics` again, at " << scale;
    EXPECT_EQ(found[0].law, Law::kFlight);
    EXPECT_EQ(found[0].where, "force on the centre of mass");
    EXPECT_NEAR(found[0].value, std::abs(1.0 - scale), 1e-6);
    EXPECT_EQ(found[0].unit, "m g");
  }
  EXPECT_TRUE(OfFlight(air, air.Moved([](double) { return -0.99 * kGravity; })).empty());
}

TEST(AuditFlight, APushInTheAirIsFoundAtItsTime) {
  const InTheAir air;
  const auto found = OfFlight(air, air.Moved(Falling(Bump(0.17, 0.5 * kGravity))));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kFlight);
  EXPECT_NEAR(found[0].at_s, 0.17, 2e-3);
  EXPECT_NEAR(found[0].value, 0.5, 1e-2);
}

TEST(AuditFlight, SpinningUpInTheAirIsFoundAtItsTime) {
  const InTheAir air;
  const double most = 60.0;
  const auto found = OfFlight(air, air.Moved(Falling(), Bump(0.1, most)));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kFlight);
  EXPECT_EQ(found[0].where, "moment about the centre of mass");
  EXPECT_EQ(found[0].unit, "m g l");
  EXPECT_NEAR(found[0].at_s, 0.1, 2e-3);
  const double rate_rad_s = 0.5 * most * 0.02;  // half of the bump's area
  const double unit = air.model().weight_n() * air.model().leg_length_m();
  EXPECT_NEAR(found[0].value, air.RateOfMomentum(rate_rad_s, most) / unit, 0.02 * found[0].value);
}

TEST(AuditFlight, VelocitiesThatDoNotFallAreFoundThoughAccelerationsDo) {
  const InTheAir air(0.001);
  MotionPlan plan = air.Moved([](double) { return 0.0; });
  for (VectorX& a : plan.whole_body.a) a[2] = -kGravity;
  const auto found = OfFlight(air, plan);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].law, Law::kFlight);
  EXPECT_NEAR(found[0].value, 1.0, 1e-6);
  EXPECT_NEAR(found[0].at_s, InTheAir::kLasts, 2e-3) << "at the end of the flight";
}

TEST(AuditFlight, SaysThatAContactIsMissing) {
  const InTheAir air;
  const AuditReport report = Audit(air.model(), air.Moved([](double) { return -0.1 * kGravity; }), {}).value();
  ASSERT_EQ(report.remarks.size(), 1U);
  EXPECT_NE(report.remarks[0].find("90 % of its weight is carried"), std::string::npos) << report.remarks[0];
  EXPECT_NE(report.remarks[0].find("a contact is missing"), std::string::npos) << report.remarks[0];
}

TEST(AuditFlight, SaysThatTimesOfContactDoNotMatch) {
  const InTheAir air;
  const AuditReport report = Audit(air.model(), air.Moved(Falling(Bump(0.01, kGravity))), {}).value();
  ASSERT_FALSE(OfFlight(report).empty());
  ASSERT_EQ(report.remarks.size(), 1U);
  EXPECT_NE(report.remarks[0].find("near take-off or touch-down"), std::string::npos) << report.remarks[0];
  const AuditReport within = Audit(air.model(), air.Moved(Falling(Bump(0.15, 0.2 * kGravity))), {}).value();
  EXPECT_FALSE(OfFlight(within).empty());
  EXPECT_TRUE(within.remarks.empty()) << "no cause is known";
}

TEST(AuditFlight, ABrokenFlightOfAPlanIsNotReportedTwice) {
  const RobotModel model = LoadNamedRobot("a1").value();
  WalkCommand command;
  command.speed_m_s = 1.0;
  command.distance_m = 0.3;
  MotionPlan plan = PlanOf(model, "pronk", command);
  ASSERT_TRUE(ViolationsOf(model, plan).empty());
  const auto flight = std::find_if(plan.schedule.phases.begin(), plan.schedule.phases.end(),
                                   [](const ContactPhase& phase) { return phase.stance == 0; });
  ASSERT_NE(flight, plan.schedule.phases.end());
  const double middle_s = 0.5 * (flight->start_s + flight->end_s);
  const auto row = static_cast<std::size_t>(std::lround((middle_s - plan.whole_body.start_s) / plan.whole_body.step_s));
  plan.whole_body.a[row][2] += 0.1 * kGravity;
  const auto found = ViolationsOf(model, plan);
  ASSERT_FALSE(found.empty());
  const Violation& fall = At(found, "force on the centre of mass");
  EXPECT_EQ(fall.law, Law::kFlight);
  EXPECT_NEAR(fall.at_s, TimeOf(plan, row), 1e-9);
  EXPECT_NEAR(fall.value, 0.1, 0.01);
  EXPECT_TRUE(std::none_of(found.begin(), found.end(), [](const Violation& v) { return v.where == "base force"; }));
}

}  // namespace
}  // namespace gaitwright
