// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "planning/plan/plan_json.h"
#include "tests/scratch_folder.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/kept_solves_internal.h"
#include "workflows/repair/repair_folder_internal.h"
#include "workflows/repair/repair_motion_internal.h"

namespace gaitwright {
namespace {

TEST(KeptSolves, ALineHoldsASolutionExactly) {
  SolvedWindow solved{VectorX::Random(7) / 3.0, VectorX::Random(11), 42, M_PI};
  solved.x[0] = std::numeric_limits<double>::denorm_min();
  solved.multipliers[3] = -0.0;
  const SolvedWindow read = SolveOfLine(LineOfSolve(solved));
  EXPECT_EQ(read.x, solved.x);
  EXPECT_EQ(read.multipliers, solved.multipliers);
  EXPECT_TRUE(std::signbit(read.multipliers[3]));
  EXPECT_EQ(read.iterations, 42);
  EXPECT_EQ(read.violations, M_PI);
  const SolvedWindow empty = SolveOfLine(LineOfSolve({}));
  EXPECT_EQ(empty.x.size() + empty.multipliers.size(), 0);
}

TEST(KeptSolves, OtherLinesAreRefused) {
  const std::string line = LineOfSolve({VectorX::Ones(3), VectorX::Ones(2), 1, 0.0});
  for (const std::string& wrong : {std::string(), std::string("3"), line.substr(4), line.substr(0, line.size() - 12)})
    EXPECT_THROW(SolveOfLine(wrong), std::runtime_error) << wrong;
}

/// A robot that bounces on its knees and floats for 12 s, and its repair in windows of a second.
RepairRequest Bouncing(const RobotModel& model) {
  EvenMotion motion = synthetic::Standing(model, 1201);
  for (int k = 0; k < motion.size(); ++k) {
    VectorX& q = motion.q[static_cast<std::size_t>(k)];
    const double bend = 0.15 * std::pow(std::sin(M_PI * k / 30.0), 2.0);
    q[2] += 0.02;
    for (const Leg& leg : model.legs) {
      const int knee = model.joints[static_cast<std::size_t>(leg.knee_joint)].dof;
      q[7 + knee - 1] += bend;
      q[7 + knee] -= 2.0 * bend;
    }
  }
  std::ofstream(ScratchFile("bouncing.csv")) << synthetic::FramesOf(model, motion);
  RepairRequest request;
  request.source.file = ScratchFile("bouncing.csv");
  request.source.options.rate_hz = 100.0;
  request.repair.window_s = 1.0;
  request.repair.overlap_s = 0.4;
  request.trajectory.residual = 1e-5;  // several solves
  return request;
}

/// Keeps solves in a journal, and stops the work like an interruption before one of them.
class Interrupted : public KeptSolves {
 public:
  Interrupted(JobJournal& journal, std::size_t before) : KeptSolves(journal), before_(before) {}
  std::optional<SolvedWindow> Find(std::size_t solve) override {
    if (solve == before_) throw std::runtime_error("interrupted");
    std::optional<SolvedWindow> kept = KeptSolves::Find(solve);
    found_ += kept ? 1 : 0;
    solves_ = solve + 1;
    return kept;
  }
  std::size_t found() const { return found_; }
  std::size_t solves() const { return solves_; }

 private:
  std::size_t before_, found_ = 0, solves_ = 0;
};

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

TEST(KeptSolves, AnInterruptedRepairContinuesAndEndsWithTheSamePlan) {
  const RobotModel& model = NamedRobot("a1");
  RepairRequest request = Bouncing(model);
  const auto whole = RepairMotion(model, request);
  ASSERT_TRUE(whole.ok()) << whole.failure().message;
  ASSERT_GT(whole->finished.windows, 5);

  const FolderRequest work{request, ScratchFile("plan.json"), false, false};
  const Result<std::string> identity = MotionIdentity(model, work);
  ASSERT_TRUE(identity.ok()) << identity.failure().message;
  const std::string file = ScratchFile("plan.json.so-far");
  const std::size_t stop = static_cast<std::size_t>(whole->finished.windows) + 3;  // in the second solve
  {
    Result<JobJournal> journal = JobJournal::Open(file, *identity, false);
    ASSERT_TRUE(journal.ok()) << journal.failure().message;
    Interrupted kept(*journal, stop);
    request.record = &kept;
    EXPECT_THROW((void)RepairMotion(model, request), std::runtime_error);
  }
  EXPECT_FALSE(JobJournal::Open(file, *identity, false).ok()) << "it has results";
  Result<JobJournal> journal = JobJournal::Open(file, *identity, true);
  ASSERT_TRUE(journal.ok()) << journal.failure().message;
  Interrupted kept(*journal, kNever);
  request.record = &kept;
  const auto resumed = RepairMotion(model, request);
  ASSERT_TRUE(resumed.ok()) << resumed.failure().message;
  EXPECT_EQ(kept.found(), stop);
  EXPECT_GT(kept.solves(), stop);
  EXPECT_EQ(PlanToJson(resumed->plan), PlanToJson(whole->plan));
}

TEST(KeptSolves, AMotionInOneWindowIsNotKept) {
  const RobotModel& model = NamedRobot("a1");
  RepairRequest request = Bouncing(model);
  request.repair.window_s = 20.0;
  Result<JobJournal> journal = JobJournal::Open(ScratchFile("one.so-far"), "one", false);
  ASSERT_TRUE(journal.ok()) << journal.failure().message;
  Interrupted kept(*journal, kNever);
  request.record = &kept;
  ASSERT_TRUE(RepairMotion(model, request).ok());
  EXPECT_EQ(kept.solves(), 0U);
}

TEST(KeptSolves, OtherWorkHasAnotherIdentity) {
  const RobotModel& model = NamedRobot("a1");
  const FolderRequest work{Bouncing(model), "plan.json", false, true};
  FolderRequest other = work;
  other.repair.repair.joint *= 2.0;
  const std::string before = *MotionIdentity(model, work);
  EXPECT_EQ(*MotionIdentity(model, work), before);
  EXPECT_NE(*MotionIdentity(model, other), before);
  std::ofstream(ScratchFile("bouncing.csv"), std::ios::app) << "\n";
  EXPECT_NE(*MotionIdentity(model, work), before);
  other = work;
  other.repair.source.file = ScratchFile("none.csv");
  EXPECT_FALSE(MotionIdentity(model, other).ok());
}

}  // namespace
}  // namespace gaitwright
