// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/momentum_feedback.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "playback/control/swing_feedback.h"
#include "tests/playback/displaced.h"
#include "tests/playback/hops.h"

namespace gaitwright {
namespace {

/// A block on massless legs that receives the wanted foot forces: Newton and Euler, step by step.
class Block {
 public:
  Block(const RobotModel& model, const MotionPlan& plan, bool with_feedback)
      : model_(model), plan_(plan), feedback_(with_feedback), now_(model_, plan_), predictive_(model_, plan_, {}) {
    footing_.offset_W.assign(model.feet.size(), Vector3::Zero());
    for (std::size_t f = 0; f < model.feet.size(); ++f) {
      hip_B_.push_back(model.joints[3 * f].X_PJ.translation());
      foot_W_.push_back(hip_B_.back());
    }
  }

  void Run(double to_s) {
    constexpr double kStep = 0.001;
    const Matrix3 inertia_B = model_.bodies.front().I_C;
    for (; time_s_ < to_s - 1e-9; time_s_ += kStep) {
      now_.Update(model_, Measured());
      predictive_.Update(now_, footing_);
      PutDown();
      now_.Update(model_, Measured());
      predictive_.Update(now_, footing_);
      const PointWrench wrench = feedback_ ? predictive_.Wanted(now_) : Planned();
      v_W += kStep * (wrench.force_W / model_.total_mass_kg - kGravity * Vector3::UnitZ());
      const Matrix3 inertia_W = R_WB * inertia_B * R_WB.transpose();
      w_W += kStep * inertia_W.inverse() * (wrench.moment_W - w_W.cross(inertia_W * w_W));
      p_W += kStep * v_W;
      R_WB = RotationExp(kStep * w_W) * R_WB;
    }
  }

  double Off() const {
    WholeBodySample sample;
    SampleWholeBody(plan_.whole_body, time_s_, sample);
    return (p_W - sample.q.head<3>()).norm() + RotationLog(R_WB).norm();
  }
  double farthest_step_m() const { return farthest_m_; }

  Vector3 p_W = Vector3(0.0, 0.0, synthetic::kHeight), v_W = Vector3::Zero(), w_W = Vector3::Zero();
  Matrix3 R_WB = Matrix3::Identity();

 private:
  ControlInput Measured() const {
    ControlInput input = displaced::OnPlan(plan_, time_s_);
    input.q.head<3>() = p_W;
    input.q.segment<4>(3) = Quaternion(R_WB).coeffs();
    input.v.head<3>() = v_W;
    input.v.segment<3>(3) = w_W;
    for (std::size_t f = 0; f < foot_W_.size(); ++f)
      input.q.segment<3>(7 + 3 * static_cast<Eigen::Index>(f)) = R_WB.transpose() * (foot_W_[f] - p_W) - hip_B_[f];
    return input;
  }
  /// Feet touch down at the wanted places.
  void PutDown() {
    for (std::size_t f = 0; f < foot_W_.size(); ++f) {
      const int foot = static_cast<int>(f);
      if (feedback_ && Contains(now_.scheduled & ~before_, foot) && time_s_ > 0.0) {
        const Vector2 step = airborne_.middleRows<2>(2 * foot);
        foot_W_[f].head<2>() = hip_B_[f].head<2>() + step;
        farthest_m_ = std::max(farthest_m_, step.norm());
      }
    }
    before_ = now_.scheduled;
    airborne_.resize(2 * static_cast<Eigen::Index>(foot_W_.size()));
    for (std::size_t f = 0; f < foot_W_.size(); ++f)
      airborne_.segment<2>(2 * static_cast<Eigen::Index>(f)) = predictive_.Step(static_cast<int>(f));
  }
  PointWrench Planned() const {
    PointWrench wrench{p_W, Vector3::Zero(), Vector3::Zero()};
    for (std::size_t f = 0; f < foot_W_.size(); ++f) {
      wrench.force_W += now_.sample.wrenches[f].force_W;
      wrench.moment_W += (foot_W_[f] - p_W).cross(now_.sample.wrenches[f].force_W);
    }
    return wrench;
  }

  const RobotModel& model_;
  const MotionPlan& plan_;
  const bool feedback_;
  Situation now_;
  MomentumFeedback predictive_;
  Footing footing_;
  std::vector<Vector3> hip_B_, foot_W_;
  FootSet before_ = 0b1111;
  VectorX airborne_;
  double time_s_ = 0.0, farthest_m_ = 0.0;
};

class HoppingBlock : public ::testing::Test {
 protected:
  const RobotModel model_ = synthetic::Robot(4, FootType::kPoint);
  const MotionPlan plan_ = synthetic::HoppingPlan(model_);
};

TEST_F(HoppingBlock, OnItsPlanNothingIsChanged) {
  Situation now(model_, plan_);
  MomentumFeedback predictive(model_, plan_, {});
  ASSERT_TRUE(predictive.active());
  Footing footing;
  footing.offset_W.assign(4, Vector3::Zero());
  for (double t = 0.0; t < plan_.whole_body.end_s(); t += 0.004) {
    now.Update(model_, displaced::OnPlan(plan_, t));
    predictive.Update(now, footing);
    const PointWrench wanted = predictive.Wanted(now);
    Vector3 planned = Vector3::Zero();
    for (int f = 0; f < 4; ++f) {
      if (Contains(now.scheduled, f)) planned += now.sample.wrenches[static_cast<std::size_t>(f)].force_W;
      EXPECT_LT(predictive.Step(f).norm(), 1e-9);
    }
    EXPECT_LT((wanted.force_W - planned).norm(), 1e-6 * model_.weight_n()) << t;
    EXPECT_LT(wanted.moment_W.norm(), 1e-6 * model_.weight_n()) << t;
  }
}

TEST_F(HoppingBlock, GetsBackToItsPlanThoughTwoFeetInALineCannotHoldIt) {
  // An error as after a strong push: with only the planned forces it falls, with feedback it stands again.
  for (const Vector3& velocity : {Vector3(0.25, 0.0, 0.0), Vector3(0.0, -0.25, 0.1), Vector3(0.1, 0.1, -0.1)}) {
    for (const bool with_feedback : {true, false}) {
      Block block(model_, plan_, with_feedback);
      block.Run(0.6);
      block.v_W += velocity;
      block.w_W += Vector3(0.5, -0.4, 0.3);
      double most = 0.0;
      for (double t = 0.62; t < 1.7; t += 0.02) {
        block.Run(t);
        most = std::max(most, block.Off());
      }
      block.Run(plan_.whole_body.end_s());
      EXPECT_GT(most, 0.02) << velocity.transpose();
      if (!with_feedback) {
        EXPECT_GT(most, 0.5) << "the plan alone does not";
        continue;
      }
      EXPECT_LT(most, 0.4) << velocity.transpose();
      EXPECT_LT(block.Off(), 0.1 * most) << velocity.transpose();
      EXPECT_GT(block.farthest_step_m(), 0.004) << "feet take their part";
      EXPECT_LT(block.farthest_step_m(), 0.2);
    }
  }
}

TEST_F(HoppingBlock, TheSameElsewhereAsksForTheSame) {
  const auto ask = [&](const MotionPlan& plan, const ControlInput& input) {
    Situation now(model_, plan);
    MomentumFeedback predictive(model_, plan, {});
    Footing footing;
    footing.offset_W.assign(4, Vector3::Zero());
    now.Update(model_, input);
    predictive.Update(now, footing);
    const PointWrench wanted = predictive.Wanted(now);
    Eigen::Vector<double, 8> all;
    all << wanted.force_W, wanted.moment_W, predictive.Step(1);
    return all;
  };
  ControlInput input = displaced::OnPlan(plan_, 0.7);
  ASSERT_EQ(input.contact, FootSet{0b1001});
  input.q = displaced::BaseMoved(model_, input.q, {0.01, -0.02, 0.01}, {0.02, 0.03, -0.04});
  input.v.head<6>() << 0.02, -0.03, 0.01, 0.05, 0.04, -0.03;
  const Eigen::Vector<double, 8> here = ask(plan_, input), none = ask(plan_, displaced::OnPlan(plan_, 0.7));
  EXPECT_GT((here - none).head<6>().norm(), 5.0);
  Pose X(YawRotation(1.1));
  X.translation() = Vector3(3.0, -2.0, 0.5);
  const Eigen::Vector<double, 8> there = ask(displaced::Carried(X, plan_), displaced::Carried(X, input));
  EXPECT_LT((X.linear() * Vector3(here.head<3>()) - Vector3(there.head<3>())).norm(), 1e-6 * here.norm());
  EXPECT_LT((X.linear() * Vector3(here.segment<3>(3)) - Vector3(there.segment<3>(3))).norm(), 1e-6 * here.norm());
  EXPECT_LT((X.linear().topLeftCorner<2, 2>() * here.tail<2>() - there.tail<2>()).norm(), 1e-6);
}

TEST_F(HoppingBlock, AFootIsAskedForNoMoreThanTwiceItsLoad) {
  Situation now(model_, plan_);
  MomentumFeedback predictive(model_, plan_, {});
  Footing footing;
  footing.offset_W.assign(4, Vector3::Zero());
  for (const double speed : {-50.0, 50.0}) {
    ControlInput input = displaced::OnPlan(plan_, 0.7);
    input.v[2] += speed;
    now.Update(model_, input);
    predictive.Update(now, footing);
    const double load = now.sample.wrenches[0].force_W.z() + now.sample.wrenches[3].force_W.z();
    EXPECT_NEAR(predictive.Wanted(now).force_W.z(), (speed < 0.0 ? 2.0 : 0.2) * load, 1e-6 * load);
  }
}

TEST_F(HoppingBlock, InFlightTheGroundIsWhereItWas) {
  const Vector3 offset(0.01, 0.02, 0.03);
  Situation now(model_, plan_);
  SwingFeedback swing(model_, plan_, {});
  int flights = 0;
  for (double t = 0.0; t < 1.0; t += 0.001) {
    ControlInput input = displaced::OnPlan(plan_, t);
    input.q.head<3>() += offset;
    now.Update(model_, input);
    const Footing& footing = swing.UpdateFooting(now);
    if (t < 0.3) continue;
    EXPECT_LT((footing.mean_offset_W - offset).norm(), 1e-4) << t;
    if (now.scheduled == 0) ++flights;
  }
  EXPECT_GT(flights, 100);
}

TEST(MomentumFeedback, LeavesAPlanWithoutFlightAlone) {
  const RobotModel model = synthetic::Robot(4, FootType::kPoint);
  const MotionPlan walk = synthetic::SteppingPlan(model), hops = synthetic::HoppingPlan(model);
  EXPECT_FALSE(MomentumFeedback(model, walk, {}).active());
  EXPECT_TRUE(MomentumFeedback(model, hops, {}).active());
}

}  // namespace
}  // namespace gaitwright
