// SPDX-License-Identifier: BSD-3-Clause
// The predicted deviation of StanceFeedback from the plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "tests/playback/reaction.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

using displaced::BaseMoved;
using displaced::OnPlan;

/// A point mass on the line between two feet: dcm' = w (dcm - zmp), com' = w (dcm - com), in small steps.
StanceFeedback::Drift Integrated(Vector2 dcm, Vector2 com, double omega, double lookahead_s,
                                 const std::function<Vector2(const Vector2&)>& zmp) {
  constexpr int kSteps = 20000;
  const double h = lookahead_s / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const Vector2 rate = omega * (dcm - zmp(dcm));
    com += h * omega * (dcm - com) + 0.5 * h * h * omega * (rate - omega * (dcm - com));
    dcm += h * rate;
  }
  return {dcm, com};
}

/// The block quadruped in the middle of a diagonal's swing, with an error.
class PredictedDrift : public ::testing::Test {
 protected:
  StanceCase& At(const StabilisedOptions& options, const Vector2& offset, const Vector2& velocity) {
    case_ = std::make_unique<StanceCase>(model_, synthetic::SteppingPlan(model_), options);
    ControlInput input = OnPlan(case_->plan(), 1.1);
    input.q = BaseMoved(model_, input.q, Vector3(offset.x(), offset.y(), 0.0), Vector3::Zero());
    input.v.head<2>() += velocity;
    case_->Torques(input);
    EXPECT_EQ(case_->now.bearing, FootSet{0b0110});
    return *case_;
  }

  const RobotModel model_ = synthetic::Robot(4, FootType::kPoint);
  const double omega_ = std::sqrt(kGravity / synthetic::kHeight);
  std::unique_ptr<StanceCase> case_;
};

TEST_F(PredictedDrift, WithAFixedZmpIsThePendulum) {
  StabilisedOptions options;
  options.support_use = 0.0;  // the ZMP stays at its planned place
  const Vector2 x0(0.01, -0.02), v0(0.1, 0.05);
  const StanceCase& off = At(options, x0, v0);
  for (const double t : {0.0, 0.05, 0.3, 0.5}) {
    const StanceFeedback::Drift drift = off.stance.PredictedDrift(off.now, t);
    const double c = std::cosh(omega_ * t), s = std::sinh(omega_ * t);
    const Vector2 x = x0 * c + v0 / omega_ * s, v = x0 * omega_ * s + v0 * c;
    EXPECT_LT((drift.com_W - x).norm(), 1e-6) << t;
    EXPECT_LT((drift.dcm_W - x - v / omega_).norm(), 1e-6) << t;
  }
}

TEST_F(PredictedDrift, WithTheZmpAtTheEndOfItsLineIsThePendulumAboutIt) {
  StabilisedOptions options;
  options.support_use = 1.0;
  const StanceCase& off = At(options, Vector2::Zero(), {-30.0, 0.0});
  // Far beyond the rear foot of the standing ones.
  const auto& feet = off.now.measured.X_WF;
  const Vector2 end =
      (feet[1].translation().x() < feet[2].translation().x() ? feet[1] : feet[2]).translation().head<2>();
  const Vector2 zmp = 0.5 * (feet[1].translation() + feet[2].translation()).head<2>();
  const Vector2 shift = end - zmp, dcm0 = Vector2(-30.0, 0.0) / omega_;
  for (const double t : {0.1, 0.3}) {
    const StanceFeedback::Drift drift = off.stance.PredictedDrift(off.now, t);
    EXPECT_LT((drift.dcm_W - shift - (dcm0 - shift) * std::exp(omega_ * t)).norm(), 1e-6) << t;
    const double c = std::cosh(omega_ * t), s = std::sinh(omega_ * t);
    EXPECT_LT((drift.com_W - shift + shift * c - dcm0 * s).norm(), 1e-6) << t;
  }
}

TEST_F(PredictedDrift, WithTheZmpThatFollowsIsTheIntegralOfTheClosedLoop) {
  const StabilisedOptions options;
  const Vector2 x0(0.01, -0.02), v0(0.1, 0.05);
  const StanceCase& off = At(options, x0, v0);
  const auto& feet = off.now.measured.X_WF;
  const Vector2 a = feet[1].translation().head<2>(), b = feet[2].translation().head<2>();
  const Vector2 along = (b - a).normalized();
  const auto zmp = [&](const Vector2& dcm) {
    const double most = 0.5 * options.support_use * (b - a).norm();
    return Vector2(along * std::clamp(options.dcm_gain * along.dot(dcm), -most, most));
  };
  const double t = 0.2;
  const StanceFeedback::Drift drift = off.stance.PredictedDrift(off.now, t);
  const StanceFeedback::Drift exact = Integrated(x0 + v0 / omega_, x0, omega_, t, zmp);
  EXPECT_GT((exact.dcm_W - x0 - v0 / omega_).norm(), 0.01);
  EXPECT_LT((drift.dcm_W - exact.dcm_W).norm(), 0.02 * exact.dcm_W.norm());
  EXPECT_LT((drift.com_W - exact.com_W).norm(), 0.02 * exact.dcm_W.norm());
}

TEST_F(PredictedDrift, InTheAirIsThePresentErrorAndNotAnEarlierOne) {
  StanceCase& off = At({}, {0.01, -0.02}, {0.1, 0.05});
  ControlInput airborne = OnPlan(off.plan(), 1.1);
  airborne.contact = 0;
  airborne.q.head<2>() += Vector2(-0.03, 0.01);
  off.Torques(airborne);
  ASSERT_EQ(off.now.bearing, FootSet{0});
  for (const double t : {0.0, 0.2}) {
    const StanceFeedback::Drift drift = off.stance.PredictedDrift(off.now, t);
    EXPECT_LT((drift.dcm_W - Vector2(-0.03, 0.01)).norm(), 1e-9) << t;
    EXPECT_LT((drift.com_W - Vector2(-0.03, 0.01)).norm(), 1e-9) << t;
  }
}

TEST_F(PredictedDrift, WithoutErrorIsNone) {
  const StanceCase& on = At({}, Vector2::Zero(), Vector2::Zero());
  const StanceFeedback::Drift drift = on.stance.PredictedDrift(on.now, 0.5);
  EXPECT_LT(drift.dcm_W.norm(), 1e-4);
  EXPECT_LT(drift.com_W.norm(), 1e-4);
}

}  // namespace
}  // namespace gaitwright
