// SPDX-License-Identifier: BSD-3-Clause
// The first exercise of many courses: how must the centre of mass move so that the ZMP follows the feet?
#include "examples/preview_control.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <sstream>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"
#include "optimisation/centroidal/preview_control.h"
#include "playback/report/plot_grid.h"
#include "playback/report/plot_style.h"

namespace gaitwright::examples {
namespace {

constexpr char kHeader[] = "time_s,zmp_x_m,zmp_y_m";

std::string Trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The fields between commas, without leading and trailing blanks.
std::vector<std::string> WordsOf(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line + ",");
  for (std::string word; std::getline(stream, word, ',');) words.push_back(Trimmed(word));
  return words;
}

std::vector<double> ParseRow(const std::string& line, int number) {
  const std::vector<std::string> words = WordsOf(line);
  if (words.size() != 3)
    throw InvalidArgument(fmt::format("line {}: {} columns; 3 are needed ({})", number, words.size(), kHeader));
  std::vector<double> values;
  for (const std::string& word : words) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) {
      throw InvalidArgument(fmt::format("line {}: '{}' is not a finite number", number, word));
    }
    values.push_back(value);
  }
  return values;
}

PreviewSetup SetupFor(const ZmpTable& reference, double com_height_m, double preview_s) {
  PreviewSetup setup;
  setup.com_height_m = com_height_m;
  setup.preview_s = preview_s;
  setup.step_s = reference.time_s[1] - reference.time_s[0];
  return setup;
}

struct Axes {
  PreviewMotion x, y;
};

void RefuseSameFile(const char* read_by, const std::string& read, const char* written_by, const std::string& written) {
  if (read.empty() || written.empty() || !IsSameFile(read, written)) return;
  throw InvalidArgument(
      fmt::format("{} '{}' would overwrite {} '{}'; give another file", written_by, written, read_by, read));
}

Axes Follow(const ZmpTable& reference, double com_height_m, double preview_s) {
  const PreviewSetup setup = SetupFor(reference, com_height_m, preview_s);
  return {FollowZmp(setup, reference.zmp_x_m, reference.zmp_x_m.front()),
          FollowZmp(setup, reference.zmp_y_m, reference.zmp_y_m.front())};
}

SvgPlot PlotOf(const std::vector<double>& time_s, const std::vector<double>& wanted, const PreviewMotion& got,
               const std::string& axis) {
  SvgPlot::Options options;
  options.title = "ZMP and centre of mass, " + axis;
  options.x_label = "time [s]";
  options.y_label = axis + " [m]";
  options.x_lowest = time_s.front();
  options.x_highest = time_s.back();
  options.legend = false;  // one legend for both plots
  SvgPlot plot(options);
  const auto line = [&](const std::vector<double>& values, Ink ink, Stroke stroke, const char* label) {
    std::vector<Vector2> points;
    std::transform(time_s.begin(), time_s.end(), values.begin(), std::back_inserter(points),
                   [](double t, double value) { return Vector2(t, value); });
    plot.Line(points, ink, stroke, label);
  };
  line(wanted, Ink::kZmp, Stroke::kPlanned, "ZMP reference");
  line(got.zmp_m, Ink::kZmp, Stroke::kMeasured, "ZMP");
  line(got.com_m, Ink::kCom, Stroke::kMeasured, "centre of mass");
  return plot;
}

}  // namespace

ZmpTable WalkOfItsOwn() {
  constexpr double kStep = 0.005, kStand = 2.0, kStepTime = 0.8, kStepLength = 0.2, kHalfWidth = 0.1;
  constexpr int kSteps = 8;
  ZmpTable table;
  const int samples = 1 + static_cast<int>(std::lround((2.0 * kStand + kSteps * kStepTime) / kStep));
  for (int k = 0; k < samples; ++k) {
    const double t = k * kStep;
    const int step = static_cast<int>(std::floor((t - kStand) / kStepTime));
    table.time_s.push_back(t);
    table.zmp_x_m.push_back(kStepLength * std::clamp(step, 0, kSteps - 1));
    table.zmp_y_m.push_back(step < 0 || step >= kSteps ? 0.0 : (step % 2 == 0 ? kHalfWidth : -kHalfWidth));
  }
  return table;
}

ZmpTable ReadZmp(const std::string& csv_text) {
  ZmpTable table;
  std::istringstream stream(csv_text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (number == 1) {
      if (WordsOf(line) != WordsOf(kHeader))
        throw InvalidArgument(fmt::format("line 1: the header is '{}'; it must be '{}'", Trimmed(line), kHeader));
      continue;
    }
    if (Trimmed(line).empty()) continue;
    const std::vector<double> row = ParseRow(line, number);
    const std::size_t n = table.time_s.size();
    constexpr double kEven = 1e-6;
    if (n >= 1 && row[0] <= table.time_s.back())
      throw InvalidArgument(fmt::format("line {}: the time does not increase", number));
    if (n >= 2 && std::abs((row[0] - table.time_s[n - 1]) - (table.time_s[1] - table.time_s[0])) > kEven) {
      throw InvalidArgument(fmt::format("line {}: the time step changes; it must be constant", number));
    }
    table.time_s.push_back(row[0]);
    table.zmp_x_m.push_back(row[1]);
    table.zmp_y_m.push_back(row[2]);
  }
  if (table.time_s.size() < 2) throw InvalidArgument("the reference has fewer than two rows");
  return table;
}

std::string PreviewedCsv(const ZmpTable& reference, double com_height_m, double preview_s) {
  const Axes motion = Follow(reference, com_height_m, preview_s);
  std::string csv = "time_s,com_x_m,com_y_m,zmp_x_m,zmp_y_m\n";
  for (std::size_t k = 0; k < reference.time_s.size(); ++k) {
    csv += fmt::format("{},{},{},{},{}\n", reference.time_s[k], motion.x.com_m[k], motion.y.com_m[k], motion.x.zmp_m[k],
                       motion.y.zmp_m[k]);
  }
  return csv;
}

std::string PreviewPicture(const ZmpTable& reference, double com_height_m, double preview_s) {
  const Axes motion = Follow(reference, com_height_m, preview_s);
  const std::vector<SvgPlot> plots = {PlotOf(reference.time_s, reference.zmp_x_m, motion.x, "x"),
                                      PlotOf(reference.time_s, reference.zmp_y_m, motion.y, "y")};
  return StandaloneSvg(GridOfPlots(plots, 1, "Preview control"));
}

int PreviewControlMain(int argc, const char* const* argv) {
  CLI::App app("Motion of the centre of mass for which the ZMP follows its reference: Kajita's preview control",
               "preview_control");
  std::string zmp, out = "com.csv", plot;
  double com_height_m = 0.814, preview_s = 1.6;
  app.add_option("--zmp", zmp, "Reference: CSV with the columns time_s,zmp_x_m,zmp_y_m; default: a built-in walk");
  app.add_option("--com-height", com_height_m, "Height of the centre of mass [m]")->capture_default_str();
  app.add_option("--preview", preview_s, "Preview time of the controller [s]")->capture_default_str();
  app.add_option("--out", out, "CSV to write")->capture_default_str();
  app.add_option("--plot", plot, "SVG to write; default without --zmp: preview_control.svg");
  try {
    app.parse(argc, argv);
    ZmpTable reference = WalkOfItsOwn();
    RefuseSameFile("--zmp", zmp, "--out", out);
    RefuseSameFile("--zmp", zmp, "--plot", plot);
    if (!zmp.empty()) {
      const Result<std::string> text = ReadFile(zmp);
      if (!text) throw InvalidArgument(text.failure().message);
      reference = ReadZmp(*text);
    } else if (plot.empty()) {
      plot = "preview_control.svg";
    }
    const std::string csv = PreviewedCsv(reference, com_height_m, preview_s);
    std::vector<OutputFile> files = {{out, csv}};
    if (!plot.empty()) files.push_back({plot, PreviewPicture(reference, com_height_m, preview_s)});
    const auto written = WriteFilesTogether(files);
    if (!written) throw InvalidArgument(written.failure().message);
    for (const std::string& path : *written) fmt::print("{}\n", path);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    fmt::print(stderr, "preview_control: {} (see --help)\n", error.what());
    return 1;
  } catch (const InvalidArgument& error) {
    fmt::print(stderr, "preview_control: {}\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace gaitwright::examples
