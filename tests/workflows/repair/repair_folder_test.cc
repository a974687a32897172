// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "tests/scratch_folder.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/repair_folder_internal.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// A folder with five clips: one stands, three sink by different depths, one is no motion.
class RepairFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = ScratchFile("clips");
    fs::remove_all(folder_);
    fs::create_directories(fs::path(folder_) / "more");
    request_.repair.source.file = folder_;
    request_.repair.source.options.rate_hz = 100.0;
    request_.out = ScratchFile("repaired");
    request_.plays = false;
    fs::create_directories(request_.out);
    Write("stands.csv", 0.0);
    Write("more/a.csv", 0.01);
    Write("more/b.txt", 0.02);
    Write("c.csv", 0.03);
    std::ofstream(fs::path(folder_) / "broken.csv") << "1,2,3\n4,5,6\n";
    std::ofstream(fs::path(folder_) / "notes.md") << "no motion\n";
  }

  void Write(const std::string& name, double sink_m) {
    EvenMotion motion = synthetic::Standing(model_, 101);
    for (VectorX& q : motion.q) q[2] -= sink_m;
    std::ofstream(fs::path(folder_) / name) << synthetic::FramesOf(model_, motion);
  }

  Result<JobJournal> Journal(bool resume) {
    const auto identity = FolderIdentity(model_, request_, ClipsOf(folder_));
    EXPECT_TRUE(identity.ok());
    return JobJournal::Open(ScratchFile("clips.so-far"), *identity, resume);
  }

  const RobotModel& model_ = NamedRobot("a1");
  std::string folder_;
  FolderRequest request_;
};

TEST_F(RepairFolder, AllMotionsBelowItAreClips) {
  EXPECT_EQ(ClipsOf(folder_),
            (std::vector<std::string>{"broken.csv", "c.csv", "more/a.csv", "more/b.txt", "stands.csv"}));
  fs::create_directories(ScratchFile("empty"));
  EXPECT_THROW(ClipsOf(ScratchFile("empty")), InvalidArgument);
}

TEST_F(RepairFolder, ABagIsOneClip) {
  const fs::path bag = fs::path(ScratchFile("bags")) / "walk";
  fs::create_directories(bag);
  std::ofstream(bag / "metadata.yaml") << "rosbag2_bagfile_information: {storage_identifier: mcap}\n";
  std::ofstream(bag / "walk_0.mcap") << "one";
  const std::vector<std::string> clips = ClipsOf(ScratchFile("bags"));
  EXPECT_EQ(clips, std::vector<std::string>{"walk"});
  request_.repair.source.file = ScratchFile("bags");
  const auto one = FolderIdentity(model_, request_, clips);
  std::ofstream(bag / "walk_0.mcap") << "two";
  const auto two = FolderIdentity(model_, request_, clips);
  ASSERT_TRUE(one.ok() && two.ok());
  EXPECT_NE(*one, *two) << "the contents of its files count";
}

TEST_F(RepairFolder, ClipsMayBeRepairedElsewhere) {
  Result<JobJournal> journal = Journal(false);
  ASSERT_TRUE(journal.ok()) << journal.failure().message;
  request_.check = true;
  const std::vector<std::string> clips = ClipsOf(folder_);
  std::atomic<int> others = 0;
  const auto elsewhere = [&](std::size_t i) {
    ++others;
    return RepairOneClip(model_, request_, clips[i]);
  };
  const auto shared = RepairClips(model_, request_, clips, *journal, {1}, {elsewhere, elsewhere});
  ASSERT_TRUE(shared.ok()) << shared.failure().message;
  EXPECT_GT(others, 0);
  journal->Remove();
  Result<JobJournal> again = Journal(false);
  const auto alone = RepairClips(model_, request_, clips, *again, {1});
  ASSERT_TRUE(alone.ok());
  EXPECT_EQ(*shared, *alone);
  again->Remove();
}

TEST_F(RepairFolder, OutcomesAreTheWorstFirst) {
  Result<JobJournal> journal = Journal(false);
  ASSERT_TRUE(journal.ok()) << journal.failure().message;
  const auto outcomes = RepairClips(model_, request_, ClipsOf(folder_), *journal, {2});
  ASSERT_TRUE(outcomes.ok()) << outcomes.failure().message;
  ASSERT_EQ(outcomes->size(), 5U);
  EXPECT_EQ(outcomes->front().clip, "broken.csv");
  EXPECT_EQ(outcomes->front().verdict, ClipVerdict::kRefused);
  EXPECT_NE(outcomes->front().reason.find("3 columns without names"), std::string::npos);
  EXPECT_EQ(outcomes->back().clip, "stands.csv");
  EXPECT_EQ(outcomes->back().broken_share, 0.0);
  for (std::size_t i = 1; i < outcomes->size(); ++i) {
    EXPECT_EQ((*outcomes)[i].verdict, ClipVerdict::kPass) << (*outcomes)[i].clip << ": " << (*outcomes)[i].reason;
    EXPECT_TRUE(fs::exists((*outcomes)[i].plan)) << (*outcomes)[i].plan;
    if (i + 1 == outcomes->size()) break;
    EXPECT_GT((*outcomes)[i].broken_share, 0.5) << "sinks all the time";
  }
  journal->Remove();
}

TEST_F(RepairFolder, AnInterruptedRunEndsWithTheSameTable) {
  Result<JobJournal> whole = Journal(false);
  ASSERT_TRUE(whole.ok());
  const auto expected = RepairClips(model_, request_, ClipsOf(folder_), *whole, {});
  ASSERT_TRUE(expected.ok());
  whole->Remove();
  {
    Result<JobJournal> journal = Journal(false);
    ASSERT_TRUE(journal.ok());
    std::atomic<int> begun = 0;
    const auto stopped =
        RepairClips(model_, request_, ClipsOf(folder_), *journal, {1, {}, [&] { return ++begun > 2; }});
    ASSERT_FALSE(stopped.ok());
    EXPECT_EQ(stopped.failure().code, FailureCode::kInterrupted);
  }
  EXPECT_FALSE(Journal(false).ok()) << "results are not thrown away";
  Result<JobJournal> journal = Journal(true);
  ASSERT_TRUE(journal.ok()) << journal.failure().message;
  EXPECT_EQ(journal->found(), 2U);
  std::atomic<int> done = 0;
  const auto resumed =
      RepairClips(model_, request_, ClipsOf(folder_), *journal, {1, [&](std::size_t, std::size_t) { ++done; }});
  ASSERT_TRUE(resumed.ok());
  EXPECT_EQ(ClipsCsv(*resumed), ClipsCsv(*expected));
  EXPECT_LE(done, 4) << "three clips, and perhaps a call before the first";
  journal->Remove();
}

TEST_F(RepairFolder, AnotherClipIsOtherWork) {
  const auto before = FolderIdentity(model_, request_, ClipsOf(folder_));
  Write("c.csv", 0.031);
  const auto after = FolderIdentity(model_, request_, ClipsOf(folder_));
  ASSERT_TRUE(before.ok() && after.ok());
  EXPECT_NE(*before, *after);
  request_.check = true;
  EXPECT_NE(*FolderIdentity(model_, request_, ClipsOf(folder_)), *after);
}

TEST_F(RepairFolder, MayOnlyExamine) {
  request_.check = true;
  Result<JobJournal> journal = Journal(false);
  ASSERT_TRUE(journal.ok());
  const auto outcomes = RepairClips(model_, request_, ClipsOf(folder_), *journal, {});
  ASSERT_TRUE(outcomes.ok());
  EXPECT_EQ((*outcomes)[1].verdict, ClipVerdict::kFail);
  EXPECT_EQ((*outcomes)[1].plan, "");
  EXPECT_EQ(outcomes->back().verdict, ClipVerdict::kPass);
  journal->Remove();
}

}  // namespace
}  // namespace gaitwright
