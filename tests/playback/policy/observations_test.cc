// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "playback/policy/observations_internal.h"

namespace gaitwright {
namespace {

PolicyContract TwoJoints(std::vector<ObservationTerm> terms) {
  PolicyContract contract;
  contract.default_position = {0.1, -0.2};
  contract.observations = std::move(terms);
  return contract;
}

PolicyState State() {
  PolicyState s;
  s.R_WB = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitX()).toRotationMatrix();  // lies on its right side
  s.height_m = 0.3;
  s.v_WB = Vector3(1.0, 2.0, 3.0);
  s.w_WB = Vector3(0.1, 0.2, 0.3);
  s.command = Vector3(0.4, 0.5, 0.6);
  s.joint_position = Vector2(0.3, 0.5);
  s.joint_velocity = Vector2(7.0, 8.0);
  s.default_position = Vector2(0.1, -0.2);
  s.last_action = Eigen::VectorXf::LinSpaced(2, 9.0F, 10.0F);
  s.time_s = 0.2;
  return s;
}

Eigen::VectorXf ObservedOnce(const ObservationTerm& term) {
  const PolicyContract contract = TwoJoints({term});
  Observer observer(contract, 2);
  return observer.Observe(State());
}

void ExpectNear(const Eigen::VectorXf& observed, const std::vector<float>& expected, const char* what) {
  ASSERT_EQ(observed.size(), static_cast<Eigen::Index>(expected.size())) << what;
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(observed[static_cast<Eigen::Index>(i)], expected[i], 1e-6F) << what << " " << i;
}

TEST(ObservationsTest, EachIsWhatItsNameSays) {
  ExpectNear(ObservedOnce({"base_lin_vel"}), {1.0F, 3.0F, -2.0F}, "base_lin_vel");
  ExpectNear(ObservedOnce({"base_ang_vel"}), {0.1F, 0.3F, -0.2F}, "base_ang_vel");
  ExpectNear(ObservedOnce({"projected_gravity"}), {0.0F, -1.0F, 0.0F}, "projected_gravity");
  ExpectNear(ObservedOnce({"base_pos_z"}), {0.3F}, "base_pos_z");
  ExpectNear(ObservedOnce({"velocity_commands"}), {0.4F, 0.5F, 0.6F}, "velocity_commands");
  ExpectNear(ObservedOnce({"joint_pos"}), {0.3F, 0.5F}, "joint_pos");
  ExpectNear(ObservedOnce({"joint_pos_rel"}), {0.2F, 0.7F}, "joint_pos_rel");
  ExpectNear(ObservedOnce({"joint_vel"}), {7.0F, 8.0F}, "joint_vel");
  ExpectNear(ObservedOnce({"joint_vel_rel"}), {7.0F, 8.0F}, "joint_vel_rel");
  ExpectNear(ObservedOnce({"last_action"}), {9.0F, 10.0F}, "last_action");
  ObservationTerm phase{"gait_phase"};
  phase.period_s = 0.8;  // a quarter of it has passed
  ExpectNear(ObservedOnce(phase), {1.0F, 0.0F}, "gait_phase");
}

TEST(ObservationsTest, SomeJointsInTheirOrder) {
  ObservationTerm term{"joint_vel"};
  term.joints = {1};
  ExpectNear(ObservedOnce(term), {8.0F}, "joint 1");
}

TEST(ObservationsTest, ClipsBeforeItScalesUnlessAsked) {
  ObservationTerm term{"joint_vel"};
  term.clip = PolicyRange{-1.0, 7.5};
  term.scale = {2.0, 0.5};
  ExpectNear(ObservedOnce(term), {14.0F, 3.75F}, "clip first");
  term.scale_first = true;
  ExpectNear(ObservedOnce(term), {7.5F, 4.0F}, "scale first");
}

TEST(ObservationsTest, HistoriesAreOldestFirstAndBeginFull) {
  ObservationTerm velocity{"joint_vel"}, position{"joint_pos"};
  velocity.history = 2;
  position.history = 2;
  PolicyContract contract = TwoJoints({velocity, position});
  PolicyState later = State();
  later.joint_velocity = Vector2(1.0, 2.0);
  later.joint_position = Vector2(3.0, 4.0);
  Observer by_term(contract, 2);
  ExpectNear(by_term.Observe(State()), {7, 8, 7, 8, 0.3F, 0.5F, 0.3F, 0.5F}, "first");
  ExpectNear(by_term.Observe(later), {7, 8, 1, 2, 0.3F, 0.5F, 3, 4}, "second, by term");
  contract.history_by_frame = true;
  Observer by_frame(contract, 2);
  by_frame.Observe(State());
  ExpectNear(by_frame.Observe(later), {7, 8, 0.3F, 0.5F, 1, 2, 3, 4}, "second, by frame");
  by_frame.Reset();
  ExpectNear(by_frame.Observe(later), {1, 2, 3, 4, 1, 2, 3, 4}, "after a reset");
}

}  // namespace
}  // namespace gaitwright
