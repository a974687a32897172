// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/compare/comparison_text.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace gaitwright {
namespace {

constexpr std::size_t kMostInOrder = 8;  // listed in the text

std::string Number(double value) { return fmt::format("{:.4g}", value == 0.0 ? 0.0 : value); }
std::string NumberOrDash(const std::optional<double>& value) { return value ? Number(*value) : "-"; }
std::string NumberOrDash(const std::string& text) { return text.empty() ? "-" : text; }

std::string UnitAfter(const std::string& unit) { return unit.empty() || unit == "1" ? "" : " " + unit; }

std::string DifferenceText(const FirstDifference& one) {
  const std::string tolerance = one.tolerance > 0.0 ? fmt::format(" (tolerance {})", Number(one.tolerance)) : "";
  return fmt::format("{:.3f} s  {}: {} against {}{}{}", one.time_s, one.quantity, Number(one.a), Number(one.b),
                     UnitAfter(one.unit), tolerance);
}

/// "0.0123 (0.045 at 1.23)": rms, and the largest with its time.
std::string Cell(const SeriesDifference& one) {
  if (one.samples == 0) return "-";
  return fmt::format("{}{} ({} at {:.2f})", one.first_s ? "*" : "", Number(one.rms), Number(one.largest), one.at_s);
}

std::string HeadOf(const MotionComparison& c) {
  std::string text =
      fmt::format("A  {} of {}: {}\nB  {} of {}: {}\n", c.kind_a, c.robot_a, c.name_a, c.kind_b, c.robot_b, c.name_b);
  text +=
      fmt::format("compared from {:.3f} to {:.3f} s on A's clock at {} moments; clocks aligned by {}, B {:+.4f} s\n",
                  c.start_s, c.end_s, c.samples, c.aligned_by, c.offset_s);
  if (c.best_offset && c.aligned_by != "best") {
    text += fmt::format("by the joint motion, B's clock would be {:+.4f} s ahead (correlation {:.4f})\n",
                        c.best_offset->offset_s, c.best_offset->agreement);
  } else if (c.best_offset) {
    text += fmt::format("correlation of the joint speeds at this offset: {:.4f} (1 is identical)\n",
                        c.best_offset->agreement);
  }
  return text;
}

std::string JointsOf(const MotionComparison& c) {
  std::string text;
  if (!c.joints.empty()) {
    text += "\njoints: rms (largest at time in s); * marks values beyond tolerance\n";
    text += fmt::format("  {:<24} {:>26} {:>26} {:>26}\n", "joint", "position", "speed", "torque");
    for (const JointDifference& joint : c.joints) {
      text += fmt::format("  {:<24} {:>26} {:>26} {:>26}\n", joint.joint, Cell(joint.position), Cell(joint.speed),
                          Cell(joint.torque));
    }
  }
  if (!c.joints_only_a.empty()) text += fmt::format("  only in A: {}\n", fmt::join(c.joints_only_a, ", "));
  if (!c.joints_only_b.empty()) text += fmt::format("  only in B: {}\n", fmt::join(c.joints_only_b, ", "));
  return text;
}

std::string SeriesLines(const std::string& title, const std::vector<SeriesDifference>& series) {
  if (series.empty()) return "";
  std::string text = "\n" + title + "\n";
  for (const SeriesDifference& one : series)
    text += fmt::format("  {:<28} {:>26} {}\n", one.quantity, Cell(one), one.unit);
  return text;
}

std::string FeetLines(const std::vector<FootDifference>& feet) {
  if (feet.empty()) return "";
  std::string text = "\ntimes of contact (B - A)\n";
  text += fmt::format("  {:<20} {:>10} {:>10} {:>10} {:>10} {:>14} {:>9}\n", "foot", "stances A", "stances B",
                      "unmatched", "rms [ms]", "largest [ms]", "at [s]");
  for (const FootDifference& foot : feet) {
    text += fmt::format("{} {:<20} {:>10} {:>10} {:>10} {:>10.1f} {:>+14.1f} {:>9.3f}\n",
                        foot.timing.first_s ? "*" : " ", foot.foot, foot.stances_a, foot.stances_b, foot.unmatched,
                        1e3 * foot.timing.rms, 1e3 * foot.timing.largest, foot.timing.at_s);
  }
  return text;
}

std::string FigureLines(const std::vector<FigurePair>& figures) {
  if (figures.empty()) return "";
  std::string text = fmt::format("\n  {:<28} {:>12} {:>12}\n", "figure", "A", "B");
  for (const FigurePair& figure : figures)
    text += fmt::format("  {:<28} {:>12} {:>12} {}\n", figure.key, NumberOrDash(figure.a), NumberOrDash(figure.b),
                        figure.unit);
  return text;
}

std::string MetricLines(const std::vector<MetricPair>& metrics) {
  if (metrics.empty()) return "";
  std::string text = fmt::format("\n  {:<28} {:>12} {:>12} {:>12}\n", "metric", "A", "B", "limit");
  for (const MetricPair& metric : metrics) {
    text += fmt::format("{} {:<28} {:>12} {:>12} {:>12} {}{}\n", metric.differs ? "*" : " ", metric.key,
                        NumberOrDash(metric.a), NumberOrDash(metric.b), NumberOrDash(metric.limit), metric.unit,
                        metric.pass_a && metric.pass_b ? ""
                                                       : (metric.pass_a   ? "  B fails"
                                                          : metric.pass_b ? "  A fails"
                                                                          : "  both fail"));
  }
  return text;
}

std::string WordLines(const std::vector<WordDifference>& words) {
  if (words.empty()) return "";
  std::string text = "\ndifferences in text values\n";
  const FoldedWords folded = Folded(words);
  for (const WordDifference& word : folded.each)
    text += fmt::format("  {}: {} against {}\n", word.key, NumberOrDash(word.a), NumberOrDash(word.b));
  if (!folded.only_a.empty()) text += fmt::format("  options only in A: {}\n", folded.only_a);
  if (!folded.only_b.empty()) text += fmt::format("  options only in B: {}\n", folded.only_b);
  return text;
}

}  // namespace

FoldedWords Folded(const std::vector<WordDifference>& words) {
  FoldedWords folded;
  std::set<std::pair<char, std::string>> named;
  for (const WordDifference& word : words) {
    if (word.only == ' ') {
      folded.each.push_back(word);
      continue;
    }
    const std::size_t dot = word.key.rfind('.');
    const std::string name = dot == std::string::npos ? word.key : word.key.substr(0, dot) + ".*";
    std::string& only = word.only == 'a' ? folded.only_a : folded.only_b;
    if (named.insert({word.only, name}).second) only += (only.empty() ? "" : ", ") + name;
  }
  return folded;
}

std::string FirstDifferenceText(const MotionComparison& c) {
  if (c.same()) return "equal: all differences are within tolerance";
  const FirstDifference& first = c.in_order.front();
  const std::string tolerance = first.tolerance > 0.0 ? fmt::format(" (tolerance {})", Number(first.tolerance)) : "";
  return fmt::format("{} differs first, at {:.3f} s: {} against {}{}{}", first.quantity, first.time_s, Number(first.a),
                     Number(first.b), UnitAfter(first.unit), tolerance);
}

std::string ComparisonText(const MotionComparison& c, const std::vector<MetricPair>& metrics) {
  std::string text = HeadOf(c) + "\n" + FirstDifferenceText(c) + "\n";
  if (c.in_order.size() > 1) {
    text += "in order of time:\n";
    for (std::size_t i = 0; i < std::min(kMostInOrder, c.in_order.size()); ++i)
      text += "  " + DifferenceText(c.in_order[i]) + "\n";
    if (c.in_order.size() > kMostInOrder) text += fmt::format("  and {} more\n", c.in_order.size() - kMostInOrder);
  }
  text += JointsOf(c) + SeriesLines("base and balance: rms (largest at time in s)", c.base);
  for (const SeriesDifference& one : c.balance)
    text += fmt::format("  {:<28} {:>26} {}\n", one.quantity, Cell(one), one.unit);
  text += FeetLines(c.feet) + FigureLines(c.figures) + MetricLines(metrics) + WordLines(c.words);
  for (const std::string& note : c.notes) text += "note: " + note + "\n";
  return text;
}

std::string ComparisonText(const ReportComparison& c) {
  std::string text = fmt::format(
      "A  report: {}\nB  report: {}\n\n{}\nscore {:.1f} against {:.1f}\n", c.name_a, c.name_b,
      c.same() ? "equal: all differences are within tolerance" : "different; * marks metrics beyond tolerance",
      c.score_a, c.score_b);
  return text + MetricLines(c.metrics) + WordLines(c.words);
}

}  // namespace gaitwright
