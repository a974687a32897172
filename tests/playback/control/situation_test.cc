// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/situation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/playback/displaced.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

using displaced::OnPlan;

/// Diagonals of a quadruped step in turn: feet 0 and 3 swing in 0.9 to 1.3 s, feet 1 and 2 in 1.4 to 1.8 s.
class SituationTest : public ::testing::Test {
 protected:
  /// Advances step by step, with the given measured contact.
  template <class Contact>
  void Run(double from_s, double to_s, Contact contact) {
    for (double t = from_s; t < to_s - 1e-9; t += 0.001) {
      ControlInput input = OnPlan(plan_, t);
      input.contact = contact(t, input.contact);
      now_.Update(model_, input);
    }
  }
  void Run(double from_s, double to_s) {
    Run(from_s, to_s, [](double, FootSet planned) { return planned; });
  }

  const RobotModel model_ = synthetic::Robot(4, FootType::kSphere);
  const MotionPlan plan_ = synthetic::SteppingPlan(model_);
  Situation now_{model_, plan_};
};

TEST_F(SituationTest, OnThePlanWhatShallStandStands) {
  int stances = 0, last = -1;
  for (double t = 0.0; t < plan_.whole_body.end_s(); t += 0.001) {
    now_.Update(model_, OnPlan(plan_, t));
    EXPECT_EQ(now_.bearing, now_.scheduled) << t;
    EXPECT_LT((now_.measured.q - now_.planned.q).norm(), 1e-12);
    EXPECT_LT((now_.measured.p_WC - now_.planned.p_WC).norm(), 1e-12);
    EXPECT_LT((now_.measured.v_WC - now_.planned.v_WC).norm(), 1e-12);
    const int phase = PhaseAt(plan_.schedule, t);
    stances += static_cast<int>(phase != last);
    last = phase;
  }
  EXPECT_EQ(stances, 13);
}

TEST_F(SituationTest, KnowsThePointMassOfTheModel) {
  ControlInput input = OnPlan(plan_, 1.1);
  input.q.head<3>() += Vector3(0.01, -0.02, 0.03);
  input.v.head<3>() += Vector3(0.1, 0.2, -0.3);
  now_.Update(model_, input);
  EXPECT_LT((now_.measured.p_WC - now_.planned.p_WC - Vector3(0.01, -0.02, 0.03)).norm(), 1e-12);
  EXPECT_LT((now_.measured.v_WC - now_.planned.v_WC - Vector3(0.1, 0.2, -0.3)).norm(), 1e-12);
  EXPECT_NEAR(now_.omega_rad_s, std::sqrt(kGravity / synthetic::kHeight), 1e-12);
  const std::vector<Foothold>& footholds = plan_.footsteps.footholds;
  const auto second = static_cast<std::size_t>(FootholdAt(plan_.footsteps, 1, 1.1));
  EXPECT_LT((now_.planned.X_WF[1].translation() - footholds[second].X_WF.translation()).norm(), 1e-9);
}

TEST(Swings, ASoleThatHasRaisedItsHeelStandsOnItsFrontEdgeUntilItLiftsOff) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  MotionPlan plan = synthetic::SteppingPlan(model);
  const auto leaves = std::find_if(plan.footsteps.footholds.begin(), plan.footsteps.footholds.end(),
                                   [](const Foothold& f) { return f.foot == 0 && f.touchdown_s > 0.0; });
  ASSERT_NE(leaves, plan.footsteps.footholds.end());
  leaves->heel_off_s = leaves->liftoff_s - 0.1;
  const Swings swings(model, plan);
  const auto points = [&](double time_s) { return swings.Under(0, time_s).support_F.size(); };
  EXPECT_EQ(points(*leaves->heel_off_s - 0.01), 4u);
  for (const double time_s : {*leaves->heel_off_s, leaves->liftoff_s - 0.01}) {
    const GroundUnder& ground = swings.Under(0, time_s);
    EXPECT_TRUE(ground.on_edge);
    EXPECT_EQ(ground.support_F.size(), 2u);
    EXPECT_NEAR(ground.middle_F.x(), synthetic::kHalfLength, 1e-12);
    EXPECT_NEAR(ground.middle_F.y(), 0.0, 1e-12);
  }
  EXPECT_EQ(points(leaves->liftoff_s + 0.2), 4u) << "a foot that lands early lands on its whole sole";
  EXPECT_FALSE(swings.Under(0, leaves->liftoff_s + 0.2).on_edge);
}

TEST_F(SituationTest, AFootInTheAirThatShallStandDoesNotBear) {
  Run(0.0, 0.5, [](double t, FootSet planned) { return t < 0.2 ? planned : planned & ~FootBit(2); });
  EXPECT_EQ(now_.scheduled, AllFeet(4));
  EXPECT_EQ(now_.bearing, AllFeet(4) & ~FootBit(2));
}

TEST_F(SituationTest, ABounceOfLessThanTenMillisecondsIsBridged) {
  const auto lost_for = [](int steps) {
    return [=](double t, FootSet planned) {
      return t > 0.3 - 1e-9 && t < 0.3 + 0.001 * steps - 1e-9 ? FootSet{0} : planned;
    };
  };
  Run(0.0, 0.308, lost_for(8));
  EXPECT_EQ(now_.bearing, AllFeet(4));
  Run(0.308, 0.32, lost_for(8));
  EXPECT_EQ(now_.bearing, AllFeet(4));
  now_.Reset();
  Run(0.0, 0.312, lost_for(100));
  EXPECT_EQ(now_.bearing, 0U);
  Run(0.312, 0.313);
  EXPECT_EQ(now_.bearing, AllFeet(4)) << "at once when they touch again";
}

TEST_F(SituationTest, AnEarlyLandingCountsAfterHalfOfTheSwing) {
  const auto touching = [](double, FootSet) { return AllFeet(4); };
  Run(0.0, 1.09, touching);
  EXPECT_EQ(now_.scheduled, FootSet{0b0110});
  EXPECT_EQ(now_.bearing, FootSet{0b0110}) << "a foot that still scrapes off the ground does not bear";
  Run(1.09, 1.11, touching);
  EXPECT_EQ(now_.scheduled, FootSet{0b0110});
  EXPECT_EQ(now_.bearing, AllFeet(4));
}

TEST_F(SituationTest, WhatWasSeenIsForgotten) {
  Run(0.0, 0.4, [](double, FootSet) { return FootSet{0}; });
  EXPECT_EQ(now_.bearing, 0U);
  now_.Reset();
  Run(0.2, 0.201, [](double, FootSet) { return FootSet{0}; });
  EXPECT_EQ(now_.bearing, AllFeet(4)) << "a robot is put down on its feet";
}

TEST_F(SituationTest, SwingsAreThoseBetweenFootholds) {
  const Swings swings(model_, plan_);
  const SwingNow swing = swings.At(0, 1.0);
  EXPECT_TRUE(swing.swings);
  EXPECT_NEAR(swing.liftoff_s, 0.9, 1e-12);
  EXPECT_NEAR(swing.touchdown_s, 1.3, 1e-12);
  EXPECT_NEAR(swing.next_liftoff_s, 1.9, 1e-12);
  EXPECT_NEAR(swing.Progress(1.0), 0.25, 1e-12);
  EXPECT_EQ(swing.Progress(0.5), 0.0);
  EXPECT_EQ(swing.Progress(1.5), 1.0);
  for (double t = 0.0; t < plan_.whole_body.end_s(); t += 0.0025) {
    const int phase = PhaseAt(plan_.schedule, t);
    for (int foot = 0; foot < 4; ++foot) {
      EXPECT_NE(swings.At(foot, t).swings,
                Contains(plan_.schedule.phases[static_cast<std::size_t>(phase)].stance, foot))
          << foot << " at " << t;
    }
  }
}

TEST_F(SituationTest, TheNextSupportIsAtTheEndOfTheFlightAfterAStance) {
  EXPECT_EQ(Swings(model_, plan_).At(0, 1.0).next_support_s, Swings(model_, plan_).At(0, 1.0).next_liftoff_s);
  // All other feet lift at 1.9 s together with feet 0 and 3, for 0.07 s.
  MotionPlan flying = plan_;
  const auto phase = std::find_if(flying.schedule.phases.begin(), flying.schedule.phases.end(),
                                  [](const ContactPhase& p) { return std::abs(p.start_s - 1.9) < 1e-9; });
  ASSERT_NE(phase, flying.schedule.phases.end());
  ASSERT_GT(phase->end_s, 1.97);
  const auto later = flying.schedule.phases.insert(phase + 1, *phase);
  (later - 1)->end_s = later->start_s = 1.97;
  (later - 1)->stance = 0;
  const Swings swings(model_, flying);
  for (const double t : {1.0, 1.25}) {
    const SwingNow swing = swings.At(0, t);
    EXPECT_NEAR(swing.next_liftoff_s, 1.9, 1e-12);
    EXPECT_NEAR(swing.next_support_s, 1.97, 1e-12);
  }
  const SwingNow other = swings.At(1, 1.5);
  EXPECT_EQ(other.next_support_s, other.next_liftoff_s) << "no flight follows that stance";
}

TEST_F(SituationTest, AFootWithoutFootholdsDoesNotSwing) {
  MotionPlan plan = plan_;
  plan.footsteps = {};
  const Swings none(model_, plan);
  EXPECT_FALSE(none.At(0, 0.5).swings);
  EXPECT_EQ(none.At(0, 0.5).Progress(0.5), 0.0);
}

}  // namespace
}  // namespace gaitwright
