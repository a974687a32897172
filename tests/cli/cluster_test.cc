// SPDX-License-Identifier: BSD-3-Clause
// trials, sweep and tune under mpirun: the same bytes as in one process, and the effect of signals.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

#ifdef GAITWRIGHT_MPIRUN

using Arguments = std::vector<std::string>;

class Cluster : public Stranger {
 protected:
  Cluster() {
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  }

  /// Disables the leak check of sanitizers, which reports leaks of Open MPI at the end of a rank.
  static Arguments UnderMpi(const Arguments& arguments) {
    Arguments words = {GAITWRIGHT_MPIRUN, "--oversubscribe", "-np", "2", "-x", "ASAN_OPTIONS=detect_leaks=0",
                       ProgramPath()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return words;
  }

  /// Whether this number of outcomes is in the journal.
  bool Holds(const std::string& journal, std::ptrdiff_t outcomes) const {
    const std::string text = std::filesystem::exists(In(journal)) ? Read(journal) : "";
    return std::count(text.begin(), text.end(), '\n') > outcomes;
  }
};

TEST_F(Cluster, TrialsAreThoseOfOneProcess) {
  MakePlan("plan.json");
  const Arguments trials = {"trials", "plan.json", "-n", "4", "--quiet", "--out"};
  const auto to = [&](const std::string& file) {
    Arguments words = trials;
    words.push_back(file);
    return words;
  };
  const Ran alone = Run(to("one.json"));
  ASSERT_EQ(alone.status, 0) << alone.err;
  const Ran shared = RunWords(UnderMpi(to("two.json")));
  ASSERT_EQ(shared.status, 0) << shared.err;
  EXPECT_TRUE(alone.out.ends_with(" of 4 survived\n")) << alone.out;
  EXPECT_EQ(shared.out, alone.out) << "one rank speaks";
  EXPECT_TRUE(Read("one.json") == Read("two.json"));
  EXPECT_EQ(Found(), (Arguments{"one.json", "plan.json", "two.json"}));
}

TEST_F(Cluster, ASweepIsThatOfOneProcess) {
  const auto to = [](const std::string& file) {
    return Arguments{
        "sweep",    "--distance", "0.3",    "--over", "speed=0.5:0.6:2", "--over", "stabilised.dcm_gain=1,1.5",
        "--trials", "1",          "--seed", "5",      "--out",           file,     "--json"};
  };
  const Ran alone = Run(to("one.csv"));
  ASSERT_EQ(alone.status, 0) << alone.err;
  const Ran shared = RunWords(UnderMpi(to("two.csv")));
  ASSERT_EQ(shared.status, 0) << shared.err;
  EXPECT_TRUE(Read("one.csv") == Read("two.csv"));
  Json one = alone.json(), two = shared.json();
  one.erase("files");
  two.erase("files");
  EXPECT_EQ(one, two);
}

TEST_F(Cluster, RepairedClipsAreThoseOfOneProcess) {
  ASSERT_EQ(Run({"plan", "--robot", "a1", "--distance", "0.3", "--out", "walk.json", "--quiet"}).status, 0);
  std::filesystem::create_directories(In("clips"));
  for (const char* const clip : {"clips/a.csv", "clips/b.csv", "clips/c.csv"})
    ASSERT_EQ(Run({"export", "walk.json", "--format", "csv", "--out", clip, "--quiet"}).status, 0);
  const Arguments repair = {"repair", "clips", "--robot", "a1", "--check", "--json", "--out"};
  const auto to = [&](const std::string& folder) {
    Arguments words = repair;
    words.push_back(folder);
    return words;
  };
  const Ran alone = Run(to("one"));
  ASSERT_TRUE(alone.status == 0 || alone.status == 3) << alone.err;
  const Ran shared = RunWords(UnderMpi(to("two")));
  EXPECT_EQ(shared.status, alone.status) << shared.err;
  EXPECT_EQ(Read("two/clips.csv"), Read("one/clips.csv"));
  const std::string table = Read("two/clips.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
  const Ran single = RunWords(UnderMpi({"repair", "clips/a.csv", "--robot", "a1"}));
  EXPECT_EQ(single.status, 1);
  EXPECT_NE(single.err.find("a single motion is repaired in one process, and MPI has started 2"), std::string::npos)
      << single.err;
}

TEST_F(Cluster, WhatIsNotSharedIsRefusedPlainlyAndByOneRank) {
  for (const Arguments& verb :
       {Arguments{"tune", "--over", "stabilised.dcm_gain=1:2"}, Arguments{"walk", "--out-dir", "walked"}}) {
    const Ran refused = RunWords(UnderMpi(verb));
    EXPECT_EQ(refused.status, 1) << refused.err;
    const std::string words = "gaitwright: this verb runs in one process, and MPI has started 2";
    const std::size_t first = refused.err.find(words);
    ASSERT_NE(first, std::string::npos) << refused.err;
    EXPECT_EQ(refused.err.find("gaitwright: ", first + 1), std::string::npos) << refused.err;
    EXPECT_TRUE(Found().empty());
  }
}

/// A run of many trials that a signal to mpirun ends after three, and its continuation.
class Interrupted : public Cluster {
 protected:
  Interrupted() { MakePlan("plan.json"); }

  Ran SignalAfterThree(int signal) const {
    return RunWords(UnderMpi(trials_), signal, [&] { return Holds("it.json.so-far", 3); });
  }

  void ExpectGoesOn() const {
    EXPECT_TRUE(Holds("it.json.so-far", 3));
    EXPECT_FALSE(std::filesystem::exists(In("it.json")));
    Arguments few = trials_;
    few[3] = "6";
    few.push_back("--resume");
    const bool more = HoldsFrom("it.json.so-far", 6);
    ASSERT_EQ(Run(few).status, 0);
    Arguments alone = few;
    alone.pop_back();
    alone[5] = "alone.json";
    ASSERT_EQ(Run(alone).status, 0);
    EXPECT_TRUE(Read("it.json") == Read("alone.json"));
    EXPECT_EQ(std::filesystem::exists(In("it.json.so-far")), more) << "it stays where more was done";
  }

  /// Whether a complete line has the outcome of a trial with at least this number.
  bool HoldsFrom(const std::string& journal, int number) const {
    std::istringstream text(Read(journal));
    std::string line;
    std::getline(text, line);
    while (std::getline(text, line) && !text.eof()) {
      if (std::stoi(line) >= number) return true;
    }
    return false;
  }

 private:
  const Arguments trials_ = {"trials", "plan.json", "-n", "100000", "--out", "it.json", "--quiet"};
};

TEST_F(Interrupted, BySigusr1AllRanksFinishWhatTheyHave) {
  const Ran ended = SignalAfterThree(SIGUSR1);
  EXPECT_EQ(ended.status, 130) << ended.err;
  EXPECT_NE(ended.err.find("gaitwright: interrupted after "), std::string::npos) << ended.err;
  ExpectGoesOn();
}

TEST_F(Interrupted, BySigintNothingThatIsDoneIsLost) {
  const Ran ended = SignalAfterThree(SIGINT);
  EXPECT_NE(ended.status, 0) << "mpirun ends the ranks by SIGTERM and, soon after, SIGKILL";
  ExpectGoesOn();
}

#endif

}  // namespace
}  // namespace gaitwright::cli
