// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/cluster/shared_work.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include "tests/built_paths.h"

namespace gaitwright {
namespace {

TEST(Ranks, AProcessAloneIsRankZeroOfOne) {
  const Ranks ranks = Ranks::Join();
  EXPECT_EQ(ranks.rank(), 0);
  EXPECT_EQ(ranks.count(), 1);
  EXPECT_TRUE(ranks.leads());
  SharedWork work(ranks);
  const auto runners = work.Runners({.work = "w", .problem = ""});
  ASSERT_TRUE(runners.ok());
  EXPECT_TRUE(runners->empty());
}

TEST(Ranks, AProblemOfRankZeroItselfIsAFailure) {
  SharedWork work(Ranks::Join());
  const auto runners = work.Runners({.work = "w", .problem = "no plan"});
  ASSERT_FALSE(runners.ok());
  EXPECT_EQ(runners.failure().message, "no plan");
}

#ifdef GAITWRIGHT_MPIRUN

/// The output of a run of the rank program.
std::string PrintsUnderMpi(int ranks, const std::string& arguments) {
  const std::string command = fmt::format(
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 '{}' --oversubscribe -np {} '{}' {} 2>/dev/null",
      GAITWRIGHT_MPIRUN, ranks, BuildFolder() + "/tests/rank_program", arguments);
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part = {};
  for (std::size_t n = 0; pipe && (n = fread(part.data(), 1, part.size(), pipe.get())) > 0;)
    text.append(part.data(), n);
  return text;
}

std::string Squares(int n) {
  std::string text;
  for (int i = 0; i < n; ++i) text += fmt::format("{}\n", i == 13 ? "piece 13 does not go" : fmt::format("{}", i * i));
  return text;
}

TEST(SharedWork, PiecesOfAllRanksComeBackWhereTheyBelong) {
  EXPECT_EQ(PrintsUnderMpi(2, "squares 12"), "2 ranks\n" + Squares(12));
  EXPECT_EQ(PrintsUnderMpi(4, "squares 12"), "4 ranks\n" + Squares(12));
}

TEST(SharedWork, RanksWithoutWorkDoNoHarm) {
  EXPECT_EQ(PrintsUnderMpi(4, "squares 0"), "4 ranks\n");
  EXPECT_EQ(PrintsUnderMpi(4, "squares 1"), "4 ranks\n0\n");
}

TEST(SharedWork, APieceThatFailsElsewhereSaysWhereAndWhy) {
  const std::string printed = PrintsUnderMpi(2, "fails 15");
  EXPECT_NE(printed.find("144\nrank 1: piece 13 does not go\n196\n"), std::string::npos) << printed;
}

TEST(SharedWork, RanksThatCannotTakePartAreNamed) {
  EXPECT_EQ(PrintsUnderMpi(3, "problem"), "rank 1: no such file\n");
  EXPECT_NE(PrintsUnderMpi(3, "other").find("rank 1 has different work from rank 0"), std::string::npos);
}

TEST(SharedWork, NobodyWaitsForARankThatEndsEarly) {
  EXPECT_EQ(PrintsUnderMpi(3, "early 0"), "");
  EXPECT_EQ(PrintsUnderMpi(3, "early 2"), "rank 2: it ended before the work began\n");
}

#endif

}  // namespace
}  // namespace gaitwright
