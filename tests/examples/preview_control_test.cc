// SPDX-License-Identifier: BSD-3-Clause
#include "examples/preview_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "tests/scratch_folder.h"

namespace gaitwright::examples {
namespace {

TEST(PreviewControlExample, TheCentreOfMassMovesBeforeTheZmpDoes) {
  const ZmpTable walk = WalkOfItsOwn();
  std::istringstream csv(PreviewedCsv(walk, 0.814, 1.6));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "time_s,com_x_m,com_y_m,zmp_x_m,zmp_y_m");
  double time = 0.0, com_x = 0.0, com_y = 0.0, early = 0.0;
  std::size_t rows = 0;
  while (std::getline(csv, line)) {
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &time, &com_x, &com_y), 3);
    if (time < 1.99) early = std::max(early, std::abs(com_y));
    ++rows;
  }
  EXPECT_EQ(rows, walk.time_s.size());
  EXPECT_GT(early, 0.005);        // it leans before the first step, at 2 s
  EXPECT_NEAR(com_x, 1.4, 5e-3);  // and ends over the last foothold
}

TEST(PreviewControlExample, WrongFilesNameTheLine) {
  const auto message = [](const std::string& text) {
    try {
      ReadZmp(text);
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string header = "time_s,zmp_x_m,zmp_y_m\n";
  EXPECT_EQ(message(header + "0,0,0\n0.005,0,0\n"), "");
  EXPECT_EQ(message("time_s, zmp_x_m, zmp_y_m\r\n 0, 0, 0\r\n0.005,0 ,0\r\n\r\n"), "");
  EXPECT_NE(message("t,x,y\n").find("line 1"), std::string::npos);
  EXPECT_NE(message(header + "0,0,0\n0.005,abc,0\n").find("line 3: 'abc'"), std::string::npos);
  EXPECT_NE(message(header + "0,0,0\n0.005,0\n").find("line 3: 2 columns"), std::string::npos);
  EXPECT_NE(message(header + "0,0,0\n-1,0,0\n").find("line 3"), std::string::npos);
  EXPECT_NE(message(header + "0,0,0\n0.005,0,0\n0.02,0,0\n").find("line 4"), std::string::npos);
  EXPECT_NE(message(header + "0,0,0,\n").find("line 2: 4 columns"), std::string::npos);
  EXPECT_NE(message(header).find("two rows"), std::string::npos);
}

/// Standard error of the program and its status.
std::pair<int, std::string> Said(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "preview_control");
  testing::internal::CaptureStderr();
  const int status = PreviewControlMain(static_cast<int>(arguments.size()), arguments.data());
  return {status, testing::internal::GetCapturedStderr()};
}

TEST(PreviewControlExample, RefusesInOneLineAndWritesNothing) {
  const std::string out = ScratchFile("refused.csv");
  const std::vector<std::vector<const char*>> wrong = {
      {"--preview", "1e9"},  {"--preview", "-1"}, {"--preview", "nan"}, {"--preview", "soon"},
      {"--com-height", "0"}, {"--frobnicate"},    {"--zmp", "/none"},   {"--preview"}};
  for (std::vector<const char*> arguments : wrong) {
    const std::string offender = arguments.back();
    arguments.insert(arguments.end(), {"--out", out.c_str(), "--plot", "/proc/none.svg"});
    if (offender == "--preview") arguments = {"--out", out.c_str(), "--preview"};
    const auto [status, text] = Said(arguments);
    EXPECT_EQ(status, 1) << offender;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_EQ(text.rfind("preview_control: ", 0), 0U) << text;
    EXPECT_FALSE(std::filesystem::exists(out)) << offender;
  }
  EXPECT_NE(Said({"--com-height", "0"}).second.find("com_height_m is 0"), std::string::npos);
  EXPECT_NE(Said({"--preview", "1e9"}).second.find("at most 10000"), std::string::npos);
}

TEST(PreviewControlExample, DoesNotWriteOverItsReference) {
  const std::filesystem::path folder = ScratchFile("over");
  std::filesystem::create_directories(folder);
  const std::string reference = (folder / "zmp.csv").string(), dotted = (folder / "." / "zmp.csv").string();
  const std::string text = "time_s,zmp_x_m,zmp_y_m\n0,0,0\n0.005,0,0\n";
  std::ofstream(reference) << text;
  for (const char* flag : {"--out", "--plot"}) {
    const auto [status, said] = Said({"--zmp", reference.c_str(), flag, dotted.c_str()});
    EXPECT_EQ(status, 1);
    EXPECT_NE(said.find(flag), std::string::npos) << said;
  }
  std::ifstream stream(reference);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), text);
  std::filesystem::remove_all(folder);
}

/// How often a text stands in another.
int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// Where the lines of the ZMP and the centre of mass begin and end across the picture [px], with those of the legend.
std::vector<std::pair<double, double>> Lines(const std::string& svg) {
  std::vector<std::pair<double, double>> lines;
  for (std::size_t at = 0; (at = svg.find("<path d=\"", at)) != std::string::npos; ++at) {
    const std::size_t first = at + 9, last = svg.find('"', first);
    const std::string ink = svg.substr(last + 9, 3);  // past `" class="`
    if (ink == "zmp" || ink == "com")
      lines.emplace_back(std::stod(svg.substr(first + 1)), std::stod(svg.substr(svg.rfind('L', last) + 1)));
  }
  return lines;
}

TEST(PreviewControlExample, DrawsThreeLinesForEachAxisWhateverTheTimeStartsAt) {
  ZmpTable walk = WalkOfItsOwn();
  const std::string first = PreviewPicture(walk, 0.814, 1.6);
  const double end_s = walk.time_s.back();
  for (double& t : walk.time_s) t -= end_s;
  const std::string second = PreviewPicture(walk, 0.814, 1.6);
  EXPECT_EQ(Lines(first), Lines(second));
  for (const std::string& svg : {first, second}) {
    for (const std::string label : {"ZMP reference", "centre of mass", "time [s]", "x [m]", "y [m]"})
      EXPECT_GE(Count(svg, label), 1) << label;
    EXPECT_EQ(Count(svg, "nan") + Count(svg, "inf"), 0);
    EXPECT_EQ(Lines(svg).size(), 9U);  // three for each axis and for the legend
  }
}

}  // namespace
}  // namespace gaitwright::examples
