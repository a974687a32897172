// SPDX-License-Identifier: BSD-3-Clause
// Plans of this program are exported and imported again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/file.h"
#include "tests/named_robot.h"
#include "tests/scratch_folder.h"
#include "workflows/exchange/export_csv.h"
#include "workflows/exchange/export_frames_internal.h"
#include "workflows/exchange/export_trajectory.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/exchange/motion_rows.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

Result<ImportedMotion> Imported(const RobotModel& model, const std::string& text,
                                const std::string& name = "round_trip.csv") {
  ImportRequest request;
  request.file = ScratchFile(name);
  EXPECT_TRUE(WriteFileAtomically(request.file, text).ok());
  return ImportMotion(model, request);
}

/// The columns of a plan as `export` writes them, without base rates and accelerations.
std::string CsvOfPlan(const RobotModel& model, const MotionPlan& plan) {
  std::string text = "time_s,base_x_m,base_y_m,base_z_m,base_qx,base_qy,base_qz,base_qw";
  for (const char* part : {"q_{}_rad", "v_{}_rad_s", "tau_{}_nm"}) {
    for (const std::string& name : model.dof_names) text += "," + fmt::format(fmt::runtime(part), name);
  }
  for (const Foot& foot : model.feet) text += ",contact_" + foot.link;
  text += "\n";
  const WholeBodyTrajectory& w = plan.whole_body;
  for (int k = 0; k < w.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double t = w.start_s + k * w.step_s;
    text += fmt::format("{}", t);
    const auto add = [&](const VectorX& values, Eigen::Index from) {
      for (Eigen::Index j = from; j < values.size(); ++j) text += fmt::format(",{}", values[j]);
    };
    add(w.q[i], 0);
    add(w.v[i], 6);
    add(w.tau[i], 0);
    const FootSet stance = plan.schedule.phases[static_cast<std::size_t>(PhaseAt(plan.schedule, t + 1e-9))].stance;
    for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) text += Contains(stance, f) ? ",1" : ",0";
    text += "\n";
  }
  return text;
}

void ExpectRoundTrip(const std::string& robot, const WalkRequest& request) {
  SCOPED_TRACE(robot);
  const Result<RobotModel> model = ChooseRobot(robot, "");
  const Result<PlannedWalk> walk = PlanWalk(*model, request);
  ASSERT_TRUE(walk.ok()) << walk.failure().message;
  const Result<ImportedMotion> imported = Imported(*model, CsvOfPlan(*model, walk->motion.plan));
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  EXPECT_TRUE(imported->audit.pass()) << AuditText(imported->audit);
  const MotionPlan &ours = walk->motion.plan, &theirs = imported->plan;
  EXPECT_EQ(theirs.schedule.phases.size(), ours.schedule.phases.size());
  ASSERT_EQ(theirs.footsteps.footholds.size(), ours.footsteps.footholds.size());
  for (std::size_t i = 0; i < ours.footsteps.footholds.size(); ++i) {
    const Foothold &a = ours.footsteps.footholds[i], &b = theirs.footsteps.footholds[i];
    EXPECT_EQ(a.foot, b.foot);
    EXPECT_LT((a.X_WF.translation() - b.X_WF.translation()).norm(), 1e-3);
    EXPECT_NEAR(a.touchdown_s, b.touchdown_s, 1e-9);
  }
  double force = 0.0;
  for (std::size_t k = 0; k < ours.whole_body.q.size(); ++k) {
    for (std::size_t f = 0; f < model->feet.size(); ++f)
      force =
          std::max(force, (ours.whole_body.wrenches[k][f].force_W - theirs.whole_body.wrenches[k][f].force_W).norm());
  }
  EXPECT_LT(force, 0.05 * model->weight_n());
  const Result<PlayedWalk> one = PlayWalk(*model, ours, {}), two = PlayWalk(*model, theirs, {});
  ASSERT_TRUE(one.ok() && two.ok());
  EXPECT_TRUE(two->report.pass) << two->report.reason;
  EXPECT_NEAR(one->report.score, two->report.score, 2.0);
}

TEST(ImportRoundTrip, PlansOfOursPassTheirAuditAndPlayAsWell) {
  WalkRequest trot;
  trot.gait = "trot";
  trot.command.distance_m = 0.4;
  trot.command.speed_m_s = 0.3;
  ExpectRoundTrip("a1", trot);
  WalkRequest steps;
  steps.command.extent = WalkCommand::Extent::kSteps;
  steps.command.steps = 4;
  steps.command.step_length_m = 0.04;
  ExpectRoundTrip("nao", steps);
  WalkRequest amble = trot;
  amble.gait = "amble";
  amble.command.speed_m_s = 0.5;
  ExpectRoundTrip("a1", amble);
}

/// Contacts are found from the feet: swings begin and end where the feet are at rest.
TEST(ImportRoundTrip, FramesWithoutContactsComeBackWithTheirSwings) {
  const RobotModel model = *ChooseRobot("nao", "");
  WalkRequest request;
  request.command.distance_m = 0.2;
  const Result<PlannedWalk> walk = PlanWalk(model, request);
  ASSERT_TRUE(walk.ok()) << walk.failure().message;
  const MotionPlan& plan = walk->motion.plan;
  constexpr double kRate_hz = 200.0, kRows = 2.5;  // rows by which contact times may differ
  const Result<ImportedMotion> back =
      Imported(model, FramesJson(model, RowsOfPlan(model, plan, kRate_hz), kRate_hz), "frames.json");
  ASSERT_TRUE(back.ok()) << back.failure().message;
  for (const Violation& violation : back->audit.violations) EXPECT_NE(violation.law, Law::kConsistency);
  ASSERT_EQ(back->plan.swings.size(), plan.swings.size());
  for (std::size_t i = 0; i < plan.swings.size(); ++i) {
    const SwingTrajectory &ours = plan.swings[i], &theirs = back->plan.swings[i];
    EXPECT_EQ(theirs.foot, ours.foot);
    EXPECT_NEAR(theirs.start_s, ours.start_s, kRows / kRate_hz);
    EXPECT_NEAR(theirs.end_s, ours.end_s, kRows / kRate_hz);
  }
}

/// The base and the contacts are derived from the joints, with equal results at every rate.
TEST(ImportRoundTrip, JointTrajectoriesOfAnyRateComeBackWithTheirBase) {
  struct Case {
    const char *robot, *gait;
    double speed_m_s;
    std::vector<double> rates_hz;
  };
  for (const Case& each : {Case{"a1", "trot", 0.3, {200.0, 500.0, 1000.0}}, Case{"go1", "trot", 0.4, {500.0}},
                           Case{"a1", "crawl", 0.1, {200.0}}}) {
    const RobotModel model = *ChooseRobot(each.robot, "");
    WalkRequest request;
    request.gait = each.gait;
    request.command.speed_m_s = each.speed_m_s;
    request.command.distance_m = 0.4;
    const Result<PlannedWalk> walk = PlanWalk(model, request);
    ASSERT_TRUE(walk.ok()) << walk.failure().message;
    const MotionPlan& plan = walk->motion.plan;
    for (const double rate_hz : each.rates_hz) {
      SCOPED_TRACE(fmt::format("{} {} at {} Hz", each.robot, each.gait, rate_hz));
      const Result<ImportedMotion> back =
          Imported(model, JointTrajectoryJson(model, RowsOfPlan(model, plan, rate_hz)), "joints.json");
      ASSERT_TRUE(back.ok()) << back.failure().message;
      const WholeBodyTrajectory &ours = plan.whole_body, &theirs = back->plan.whole_body;
      double off_m = 0.0;
      for (std::size_t k = 0; k < ours.q.size(); ++k) {
        const auto row = static_cast<std::size_t>(std::lround(static_cast<double>(k) * ours.step_s / theirs.step_s));
        if (row >= theirs.q.size()) break;
        off_m = std::max(off_m, ((ours.q[k] - ours.q[0]) - (theirs.q[row] - theirs.q[0])).head<3>().norm());
      }
      EXPECT_LT(off_m, 0.005);
      for (const Violation& violation : back->audit.violations) {
        if (violation.law == Law::kDynamics) {
          EXPECT_LT(violation.value, 0.02 * model.weight_n());
        }
      }
      const Result<PlayedWalk> played = PlayWalk(model, back->plan, {});
      ASSERT_TRUE(played.ok());
      EXPECT_TRUE(played->report.pass) << played->report.reason;
    }
  }
}

TEST(ImportRoundTrip, ExportedGaitsThatFlyPassTheirAudit) {
  for (const char* gait : {"pace", "bound", "pronk"}) {
    WalkRequest request;
    request.gait = gait;
    request.command.distance_m = 0.3;
    request.command.speed_m_s = 0.5;
    const Result<PlannedWalk> walk = PlanWalk(NamedRobot("a1"), request);
    ASSERT_TRUE(walk.ok()) << walk.failure().message;
    const MotionPlan& plan = walk->motion.plan;
    const Result<ImportedMotion> imported =
        Imported(NamedRobot("a1"), MotionCsv(NamedRobot("a1"), RowsOfPlan(NamedRobot("a1"), plan, UsualRate(plan))));
    ASSERT_TRUE(imported.ok()) << imported.failure().message;
    EXPECT_TRUE(imported->audit.pass()) << gait << "\n" << AuditText(imported->audit);
    EXPECT_TRUE(imported->notes.warnings.empty());
  }
}

TEST(ImportRoundTrip, OverFlightsTheReferenceStaysInItsSupports) {
  WalkRequest bound;
  bound.gait = "bound";
  bound.command.distance_m = 0.6;
  bound.command.speed_m_s = 0.5;
  const Result<PlannedWalk> walk = PlanWalk(NamedRobot("a1"), bound);
  ASSERT_TRUE(walk.ok()) << walk.failure().message;
  const Result<ImportedMotion> imported = Imported(NamedRobot("a1"), CsvOfPlan(NamedRobot("a1"), walk->motion.plan));
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  for (const Violation& violation : imported->audit.violations)
    EXPECT_NE(violation.where, "reference of the zero-moment point") << AuditText(imported->audit);
}

}  // namespace
}  // namespace gaitwright
