// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/swing_feedback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "playback/control/joint_pd.h"
#include "tests/playback/displaced.h"
#include "tests/playback/short_walk.h"
#include "tests/playback/standing_plan.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

using displaced::BaseMoved;
using displaced::OnPlan;

constexpr double kStep = 0.001;

/// The feedback along a plan, without a world: the test provides the measurements.
class Walk {
 public:
  Walk(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options = {})
      : model_(model),
        plan_(plan),
        options_(options),
        replay_(model_, plan_),
        now(model_, plan_),
        stance_(model_, options_),
        swing_(model_, plan_, options_) {}

  JointCommand Step(const ControlInput& input) {
    input_ = input;
    command = replay_.Update(input);
    now.Update(model_, input);
    footing = swing_.UpdateFooting(now);
    stance_.Update(now, footing, command.tau_ff);
    swing_.Update(now, stance_, command);
    return command;
  }

  /// Runs from one time to another, without the last one, with inputs from `measured`.
  void Run(double from_s, double to_s, const std::function<ControlInput(double)>& measured) {
    for (double t = from_s; t < to_s - 1e-9; t += kStep) Step(measured(t));
  }

  /// Place of a foot that the last command wants at the end of its step, although the base is elsewhere.
  Pose Target(int foot) const {
    VectorX q = input_.q;
    q.head<3>() += kStep * input_.v.head<3>();
    q.tail(model_.num_dofs()) = command.q;
    return FootPose(foot, q);
  }
  Pose Planned(int foot) const { return FootPose(foot, OnPlan(plan_, input_.time_s + kStep).q); }
  Vector3 Offset(int foot) const { return Target(foot).translation() - Planned(foot).translation(); }

  JointCommand command;
  Footing footing;

 private:
  Pose FootPose(int foot, const VectorX& q) const {
    DynamicsScratch scratch(model_);
    ForwardKinematics(model_, q, scratch);
    const Foot& f = model_.feet[static_cast<std::size_t>(foot)];
    return FramePose(scratch, f.body, f.X_BF);
  }

  const RobotModel model_;
  const MotionPlan plan_;
  const StabilisedOptions options_;
  JointPd replay_;

 public:
  Situation now;

 private:
  StanceFeedback stance_;
  SwingFeedback swing_;
  ControlInput input_;
};

/// The block quadruped; feet 0 and 3 swing from 0.85 to 1.05 s and stand until 1.35 s.
class SwingFeedbackTest : public ::testing::Test {
 protected:
  static synthetic::Steps ShortSteps() {
    synthetic::Steps steps;
    steps.swing_s = 0.2;
    steps.double_s = 0.05;
    return steps;
  }
  /// Off the plan by a constant displacement of the base.
  std::function<ControlInput(double)> OffBy(const Vector2& offset) const {
    return [=, this](double t) {
      ControlInput input = OnPlan(plan_, t);
      if (!offset.isZero(0.0)) input.q = BaseMoved(model_, input.q, {offset.x(), offset.y(), 0.0}, Vector3::Zero());
      return input;
    };
  }
  static StabilisedOptions FixedZmp() {
    StabilisedOptions options;
    options.support_use = 0.0;
    return options;
  }
  SwingNow Swing() const { return Swings(model_, plan_).At(0, 0.95); }

  const RobotModel model_ = synthetic::Robot(4, FootType::kPoint);
  const MotionPlan plan_ = synthetic::SteppingPlan(model_, ShortSteps());
  const double omega_ = std::sqrt(kGravity / synthetic::kHeight);
};

TEST_F(SwingFeedbackTest, WithoutErrorSwingsAsPlanned) {
  StabilisedOptions options;
  options.hover = 0.0;
  Walk walk(model_, plan_, options);
  int swings = 0;
  for (double t = 0.7; t < plan_.whole_body.end_s() - 0.1; t += kStep) {
    walk.Step(OnPlan(plan_, t));
    const ControlInput next = OnPlan(plan_, t + kStep), half = OnPlan(plan_, t + 0.5 * kStep);
    for (int foot = 0; foot < 4; ++foot) {
      if (Contains(walk.now.bearing, foot)) continue;
      ++swings;
      EXPECT_LT((walk.command.q - next.q.tail(12)).segment<3>(3 * foot).norm(), 1e-4) << t;
      EXPECT_LT((walk.command.v - half.v.tail(12)).segment<3>(3 * foot).norm(), 1e-2) << t;
    }
  }
  EXPECT_GT(swings, 2000);
}

TEST_F(SwingFeedbackTest, AShortSwingHoversNoHigherThoughItSettlesLong) {
  StabilisedOptions options;
  options.hover = 0.02;
  options.settle_s = 0.15;  // more than half of the swing
  const SwingNow swing = Swing();
  Walk walk(model_, plan_, options);
  walk.Run(0.7, swing.liftoff_s, OffBy(Vector2::Zero()));
  for (double t = swing.liftoff_s; t < swing.touchdown_s - 0.5 * kStep; t += kStep) {
    walk.Step(OnPlan(plan_, t));
    EXPECT_LT(walk.Offset(0).z(), 1.05 * options.hover * model_.leg_length_m()) << t;
    EXPECT_TRUE(t + kStep > 0.5 * (swing.liftoff_s + swing.touchdown_s) || walk.Offset(0).z() < 1e-4) << t;
  }
}

TEST_F(SwingFeedbackTest, SwingsHoverOverTheirPlanUntilTheySettle) {
  StabilisedOptions options;
  options.hover = 0.02;
  const double high = options.hover * model_.leg_length_m();
  const SwingNow swing = Swing();
  const double half_s = 0.5 * (swing.liftoff_s + swing.touchdown_s), settle_s = swing.touchdown_s - options.settle_s;
  Walk walk(model_, plan_, options);
  walk.Run(0.7, swing.liftoff_s, OffBy(Vector2::Zero()));
  double before = 0.0, highest = 0.0;
  for (double t = swing.liftoff_s; t < swing.touchdown_s - 0.5 * kStep; t += kStep) {
    walk.Step(OnPlan(plan_, t));
    const double above = walk.Offset(0).z(), then = t + kStep;
    EXPECT_TRUE(then > half_s || std::abs(above) < 1e-4) << t;
    EXPECT_TRUE(then < half_s || then > settle_s || above > before - 1e-4) << t;
    EXPECT_TRUE(then < settle_s + kStep || above < before + 1e-4) << t;
    EXPECT_LT(Vector2(walk.Offset(0).head<2>()).norm(), 1e-4) << t;
    highest = std::max(highest, above);
    before = above;
  }
  EXPECT_NEAR(highest, high, 0.05 * high);
  EXPECT_NEAR(before, 0.0, 1e-4) << "down in time";
}

TEST_F(SwingFeedbackTest, AfterTheStepToComeTheDcmHasDecayedAsWanted) {
  for (const double decay : {0.0, 0.2, 1.0}) {
    StabilisedOptions options = FixedZmp();
    options.step_decay = decay;
    options.step_reach = 1.0;
    Walk walk(model_, plan_, options);
    const Vector2 offset(0.0, 0.02);
    const SwingNow swing = Swing();
    walk.Run(0.7, swing.touchdown_s - 1e-4, OffBy(offset));
    // The last foothold was chosen settle_s before touch-down, for the DCM that was predicted then.
    const Vector2 dcm = offset * std::exp(omega_ * options.settle_s);
    const Vector2 foothold = walk.Offset(0).head<2>();
    const double growth = std::exp(omega_ * (swing.next_liftoff_s - swing.touchdown_s));
    EXPECT_LT((foothold + growth * (dcm - foothold) - decay * dcm).norm(), 0.1 * dcm.norm()) << decay;
    EXPECT_NEAR(foothold.x(), 0.0, 1e-3);
    EXPECT_GT(foothold.y(), 0.9 * offset.y()) << "towards the fall";
    EXPECT_LT((walk.Offset(3) - walk.Offset(0)).norm(), 1e-4) << "both feet of the diagonal alike";
  }
}

TEST_F(SwingFeedbackTest, AStepReachesOnlySoFarFromTheBase) {
  StabilisedOptions options = FixedZmp();
  const Vector2 offset(0.0, 0.25);
  const auto beyond = [&](double reach) {
    options.step_reach = reach;
    Walk walk(model_, plan_, options);
    walk.Run(0.7, Swing().touchdown_s - 1e-4, OffBy(offset));
    const Vector2 base = offset * std::cosh(omega_ * options.settle_s);
    return Vector2(walk.Offset(0).head<2>() - base).norm();
  };
  EXPECT_NEAR(beyond(0.05), 0.05 * model_.leg_length_m(), 0.005);
  EXPECT_NEAR(beyond(0.1), 0.1 * model_.leg_length_m(), 0.005);
  EXPECT_GT(beyond(1.0), 0.12 * model_.leg_length_m());
}

TEST_F(SwingFeedbackTest, TargetsDoNotJumpWhenTheErrorDoes) {
  const StabilisedOptions options;
  const SwingNow swing = Swing();
  Walk walk(model_, plan_, options);
  Vector3 last = Vector3::Zero(), last_rate = Vector3::Zero();
  double farthest = 0.0, fastest = 0.0, hardest = 0.0;
  for (double t = 0.7; t < swing.touchdown_s - 1e-9; t += kStep) {
    const double since = t - swing.liftoff_s;
    const Vector2 base_offset(0.0, since > 0.15 ? 0.03 : since > 0.1 ? -0.05 : since > 0.03 ? 0.05 : 0.0);
    walk.Step(OffBy(base_offset)(t));
    if (Contains(walk.now.bearing, 0)) continue;
    const Vector3 offset = walk.Offset(0), rate = (offset - last) / kStep;
    farthest = std::max(farthest, offset.norm());
    fastest = std::max(fastest, rate.norm());
    hardest = std::max(hardest, (rate - last_rate).norm() / kStep);
    last = offset;
    last_rate = rate;
  }
  EXPECT_GT(farthest, 0.01);
  EXPECT_LT(fastest, 2.0);
  EXPECT_LT(hardest, 2.0 * options.swing_acceleration_m_s2);
}

TEST_F(SwingFeedbackTest, TheFootholdIsFixedBeforeTouchDown) {
  const SwingNow swing = Swing();
  const StabilisedOptions options;
  const auto landing = [&](double error_since_s) {
    Walk walk(model_, plan_, options);
    walk.Run(0.7, swing.touchdown_s - 1e-4, [&](double t) {
      ControlInput input = OnPlan(plan_, t);
      if (t > error_since_s - 1e-9) input.v[1] += 0.2;
      return input;
    });
    return walk.Offset(0);
  };
  EXPECT_GT(landing(swing.touchdown_s - 3.0 * options.settle_s).y(), 0.005);
  EXPECT_LT(landing(swing.touchdown_s - 0.9 * options.settle_s).norm(), 1e-3);
}

TEST_F(SwingFeedbackTest, AFootThatDoesNotFindTheGroundSearchesForIt) {
  const StabilisedOptions options;
  Walk walk(model_, plan_, options);
  const double touchdown = Swing().touchdown_s;
  const auto late = [&](double t) {
    ControlInput input = OnPlan(plan_, t);
    if (t > touchdown - 0.02) input.contact &= ~FootBit(0);
    return input;
  };
  walk.Run(0.7, touchdown + 0.0205, late);
  const double before = walk.Offset(0).z();
  walk.Run(touchdown + 0.021, touchdown + 0.0415, late);
  EXPECT_LT(before, 0.0);
  EXPECT_NEAR(walk.Offset(0).z() - before, -0.021 * options.search_m_s, 0.002);
  EXPECT_LT(walk.Offset(3).norm(), 1e-3) << "the other one stands";
}

TEST_F(SwingFeedbackTest, AFootThatThePlanKeepsInTheAirStaysThere) {
  MotionPlan plan = synthetic::StandingPlan(model_, 1.0);
  for (VectorX& q : plan.whole_body.q) q[7 + 2] += 0.1;
  for (auto& wrenches : plan.whole_body.wrenches) wrenches[0] = {};
  plan.schedule.phases = {{0.0, 1.0, AllFeet(4) & ~FootBit(0)}};
  std::vector<Foothold>& footholds = plan.footsteps.footholds;
  std::erase_if(footholds, [](const Foothold& foothold) { return foothold.foot == 0; });
  const auto held = [&] {
    Walk walk(model_, plan);
    walk.Run(0.0, 0.5, [&](double t) { return OnPlan(plan, t); });
    EXPECT_EQ(walk.now.bearing, AllFeet(4) & ~FootBit(0));
    return walk.Offset(0).norm();
  };
  EXPECT_LT(held(), 1e-3) << "without a foothold";
  Foothold later;
  later.foot = 0;
  later.touchdown_s = 0.9;
  later.liftoff_s = 1.0;
  footholds.push_back(later);
  EXPECT_LT(held(), 1e-3) << "before its first foothold";
}

TEST_F(SwingFeedbackTest, LegsThatStandOnlyKeepTheirFeetFromSliding) {
  StabilisedOptions options;
  options.stance_damping = 0.5;
  options.stance_creep = 0.0;
  Walk walk(model_, plan_, options);
  ControlInput input = OnPlan(plan_, 0.5);
  input.v.head<3>() << 0.1, -0.2, 0.05;
  const JointCommand planned = JointPd(model_, plan_).Update(input);
  walk.Step(input);
  EXPECT_EQ(walk.command.stiffness.norm(), 0.0);
  EXPECT_LT((walk.command.damping - 0.5 * planned.damping).norm(), 1e-9);
  for (int leg = 0; leg < 4; ++leg) {
    EXPECT_LT((walk.command.v.segment<3>(3 * leg) + Vector3(0.1, -0.2, 0.05)).norm(), 1e-3) << "against the base";
  }
}

TEST_F(SwingFeedbackTest, StandingFeetTellTheirOffsetInTheTimeThatItTakesToSettle) {
  Walk walk(model_, plan_);
  const Vector3 offset(0.03, -0.02, -0.01);
  const auto all_moved = [&](double t) {
    ControlInput input = OnPlan(plan_, t);
    input.q.head<3>() += offset;
    return input;
  };
  walk.Run(0.0, 0.0205, all_moved);
  EXPECT_LT((walk.footing.mean_offset_W - (1.0 - std::exp(-1.0)) * offset).norm(), 0.06 * offset.norm());
  walk.Run(0.021, 0.3, all_moved);
  EXPECT_LT((walk.footing.mean_offset_W - offset).norm(), 1e-6);
  EXPECT_LT((walk.footing.offset_W[2] - offset).norm(), 1e-6);
}

/// NAO in the middle of its first swing.
class SwingOfASole : public ::testing::Test {
 protected:
  const RobotModel nao_ = standing::Load("nao");
  const MotionPlan plan_ = ShortWalk(nao_, "", 4, 0.04);
  const ContactPhase swing_ = plan_.schedule.phases[1];
  const int lifted_ = swing_.stance == FootSet{1} ? 1 : 0;
};

TEST_F(SwingOfASole, StaysLevelThoughTheRobotTilts) {
  Walk walk(nao_, plan_);
  const double middle = 0.5 * (swing_.start_s + swing_.end_s);
  const Pose tilt(RotationExp({0.06, -0.04, 0.0}));
  walk.Run(swing_.start_s - 0.1, middle, [&](double t) {
    ControlInput input = OnPlan(plan_, t);
    if (t > swing_.start_s + 0.02) input = displaced::Carried(tilt, input);
    for (ContactWrench& wrench : input.wrenches) wrench = {};  // no weight on the sole: it does not measure the ground
    return input;
  });
  const Matrix3 off = walk.Target(lifted_).linear() * walk.Planned(lifted_).linear().transpose();
  EXPECT_LT(RotationLog(off).head<2>().norm(), 0.01);
  EXPECT_LT(walk.footing.ground_tilt_W.norm(), 1e-9);
}

TEST_F(SwingOfASole, LoadedSolesTellTheGroundsTiltAndTheSwingFollowsIt) {
  const Vector3 turn(0.03, -0.05, 0.0);
  const auto leaning = [&](double t) { return displaced::Carried(Pose(RotationExp(turn)), OnPlan(plan_, t)); };
  Walk walk(nao_, plan_);
  walk.Run(0.0, 0.1, leaning);
  EXPECT_LT((walk.footing.ground_tilt_W - turn).norm(), 0.05 * turn.norm());
  walk.Run(0.1, 0.5 * (swing_.start_s + swing_.end_s), leaning);
  EXPECT_LT((walk.footing.ground_tilt_W - turn).norm(), 0.05 * turn.norm());
  const Matrix3 off = walk.Target(lifted_).linear() * walk.Planned(lifted_).linear().transpose();
  EXPECT_LT((RotationLog(off) - turn).head<2>().norm(), 0.01);
  // The ground under the foot is at the height that follows from the tilt about the standing foot.
  const int standing = 1 - lifted_;
  const Vector3 arm = walk.Planned(lifted_).translation() - walk.Planned(standing).translation();
  EXPECT_NEAR(walk.Offset(lifted_).z() - walk.Offset(standing).z(), turn.cross(arm).z(), 0.002);
}

TEST_F(SwingOfASole, StandingAnklesHoldTheSoleSoftly) {
  Walk walk(nao_, plan_);
  walk.Run(0.0, 0.01, [&](double t) { return OnPlan(plan_, t); });
  const VectorX derived = DeriveGains(nao_, {}).damping;
  const Leg& leg = nao_.legs[0];
  const int ankle = nao_.joints[static_cast<std::size_t>(leg.joints.back())].dof;
  const int hip = nao_.joints[static_cast<std::size_t>(leg.joints[1])].dof;
  EXPECT_LT(walk.command.damping[ankle], 0.25 * derived[ankle]);
  EXPECT_GT(walk.command.damping[ankle], 0.0);
  EXPECT_GT(walk.command.damping[hip], 0.7 * derived[hip]);
}

TEST(SwingFeedback, GivesStandingLegsWhatTheirOwnInertiaTakesToLiftTheBase) {
  const RobotModel a1 = standing::Load("a1");
  const MotionPlan plan = standing::Plan(a1, 1.0);
  StabilisedOptions options;
  options.attitude_rad_s = 0.0;
  const double low_m = 0.01, lifted = options.height_rad_s * options.height_rad_s * low_m;
  ControlInput input = OnPlan(plan, 0.5);
  input.q = BaseMoved(a1, input.q, {0.0, 0.0, -low_m}, Vector3::Zero());
  Walk walk(a1, plan, options);
  walk.Step(input);
  JointCommand alone = JointPd(a1, plan).Update(input);
  StanceFeedback stance(a1, options);
  stance.Update(walk.now, walk.footing, alone.tau_ff);
  EXPECT_NEAR(stance.lifted_m_s2(), lifted, 0.1 * lifted);

  DynamicsScratch scratch(a1);
  MatrixX M, J(6, a1.nv());
  MassMatrix(a1, input.q, scratch, M);
  for (int leg = 0; leg < 4; ++leg) {
    const auto body = static_cast<std::size_t>(a1.feet[static_cast<std::size_t>(leg)].body);
    const Vector3 p_WQ = ContactFrame(a1, scratch, leg, Vector3::UnitZ()).translation();
    PointJacobian(a1, scratch, static_cast<int>(body), scratch.R_WB[body].transpose() * (p_WQ - scratch.p_WB[body]), J);
    // Relative to the base, standing feet move down as the base moves up.
    const Vector3 joints = J.block<3, 3>(0, 6 + 3 * leg).lu().solve(Vector3(0.0, 0.0, -stance.lifted_m_s2()));
    const Vector3 torque = M.block<3, 3>(6 + 3 * leg, 6 + 3 * leg) * joints;
    EXPECT_GT(torque.norm(), 0.01);
    EXPECT_LT(((walk.command.tau_ff - alone.tau_ff).segment<3>(3 * leg) - torque).norm(), 0.02 * torque.norm()) << leg;
  }
}

}  // namespace
}  // namespace gaitwright
