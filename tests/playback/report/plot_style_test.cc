// SPDX-License-Identifier: BSD-3-Clause
// Whether colour-blind people can distinguish the inks of the plots and of the 3D page.
#include "playback/report/plot_style.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "kinematics/spatial/pose.h"
#include "tests/built_paths.h"

namespace gaitwright {
namespace {

using Inks = std::map<std::string, std::string>;

constexpr double kApart = 18.0;  // in CIELAB, between any two inks; 2.3 is just noticeable

Vector3 LinearOf(const std::string& hex) {
  Vector3 rgb;
  for (int i = 0; i < 3; ++i) {
    const double c = std::stoi(hex.substr(static_cast<std::size_t>(1 + 2 * i), 2), nullptr, 16) / 255.0;
    rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

/// CIE 1976 L*a*b* of linear sRGB, white D65.
Vector3 LabOf(const Vector3& rgb) {
  Matrix3 M;
  M << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  const Vector3 xyz = (M * rgb).cwiseQuotient(Vector3(0.95047, 1.0, 1.08883));
  const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
  const double x = f(xyz.x()), y = f(xyz.y()), z = f(xyz.z());
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// Colours as seen with normal eyes, without green cones, and without red cones, from linear sRGB. Machado, Oliveira
/// and Fernandes, TVCG 15(6), 2009, doi:10.1109/TVCG.2009.113, table of severity 1.
std::vector<Matrix3> Eyes() {
  Matrix3 deuteranope, protanope;
  deuteranope << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  protanope << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  return {Matrix3::Identity(), deuteranope, protanope};
}

double Apart(const std::string& a, const std::string& b) {
  double apart = HUGE_VAL;
  for (const Matrix3& eye : Eyes()) {
    const auto seen = [&](const std::string& hex) { return LabOf((eye * LinearOf(hex)).cwiseMax(0.0).cwiseMin(1.0)); };
    apart = std::min(apart, (seen(a) - seen(b)).norm());
  }
  return apart;
}

double Contrast(const std::string& a, const std::string& b) {
  const auto light = [](const std::string& hex) { return Vector3(0.2126, 0.7152, 0.0722).dot(LinearOf(hex)) + 0.05; };
  return std::max(light(a) / light(b), light(b) / light(a));
}

/// By name, every `name: "#rrggbb"` of a text, or another pattern.
Inks Found(const std::string& text, const std::regex& pattern) {
  Inks inks;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), pattern); it != std::sregex_iterator(); ++it)
    inks.emplace((*it)[1], (*it)[2]);
  return inks;
}

/// The colours of the feet's lines, which are a list.
std::vector<std::string> FeetOf(const std::string& theme) {
  const std::string list = theme.substr(theme.find("feet: ["));
  std::vector<std::string> feet;
  const std::regex colour("#[0-9a-f]{6}");
  const std::string within = list.substr(0, list.find(']'));
  for (auto it = std::sregex_iterator(within.begin(), within.end(), colour); it != std::sregex_iterator(); ++it)
    feet.push_back(it->str());
  return feet;
}

/// Light and dark theme, from the source of the page.
std::array<std::string, 2> Themes() {
  const std::string text = ReadFile(SourceFolder() + "/playback/viewer/web/src/colours.ts").value();
  const std::size_t light = text.find("kLight: Theme"), dark = text.find("kDark: Theme");
  return {text.substr(light, dark - light), text.substr(dark)};
}

/// Inks of plots: the light ones come first in the style sheet.
std::array<Inks, 2> PlotInks() {
  const std::string css = PlotStyle();
  const std::regex rule(R"(\.gw \.([a-z]+)\{stroke:(#[0-9a-f]{6});color)");
  const std::size_t dark = css.find("dark");
  return {Found(css.substr(0, dark), rule), Found(css.substr(dark), rule)};
}

/// Inks of the page: the text between `ink: {` and `}`.
Inks PageInks(const std::string& theme) {
  const std::string from = theme.substr(theme.find("ink: {"));
  return Found(from.substr(0, from.find('}')), std::regex(R"re(([a-z]+): "(#[0-9a-f]{6})")re"));
}

TEST(Colours, ABlackAndAWhiteAreFarApartAndReadOnEachOther) {
  EXPECT_NEAR(Apart("#000000", "#ffffff"), 100.0, 0.01);
  EXPECT_NEAR(Contrast("#000000", "#ffffff"), 21.0, 1e-9);
  EXPECT_LT(Apart("#ff6f9f", "#2fd0a2"), 5.0) << "a pink and a green that are one to who has no green cones";
}

TEST(Colours, InksDifferWithoutRedOrGreenCones) {
  const std::array<std::string, 2> themes = Themes();
  const std::array<Inks, 2> plots = PlotInks();
  for (std::size_t dark = 0; dark < 2; ++dark) {
    SCOPED_TRACE(dark == 0 ? "light" : "dark");
    Inks all = plots[dark], page = PageInks(themes[dark]);
    EXPECT_EQ(all.size(), 9U);
    for (const auto& [name, colour] : page) {
      if (name == "pull") continue;
      EXPECT_EQ(all[name], colour) << name << " is another one in the page than in plots";
    }
    all["pull"] = page["pull"];
    all.erase("joint");
    for (const auto& [a, colour] : all) {
      for (const auto& [b, other] : all) {
        if (a >= b) continue;
        EXPECT_GT(Apart(colour, other), kApart) << a << " and " << b;
      }
    }
    EXPECT_EQ(plots[dark].at("joint"), plots[dark].at("com")) << "which are never in one plot";
  }
}

TEST(Colours, LinesOfFeetDifferAndStandOutFromThePaper) {
  for (const std::string& theme : Themes()) {
    const std::string paper = Found(theme, std::regex(R"re((paper): "(#[0-9a-f]{6})")re"))["paper"];
    const std::vector<std::string> feet = FeetOf(theme);
    ASSERT_EQ(feet.size(), 8U);
    for (std::size_t i = 0; i < feet.size(); ++i) {
      EXPECT_GE(Contrast(feet[i], paper), 3.0) << feet[i];
      for (std::size_t k = 0; k < i; ++k) EXPECT_GT(Apart(feet[i], feet[k]), kApart) << feet[k] << " and " << feet[i];
    }
  }
}

TEST(Colours, WordsAreReadOnThePaper) {
  for (const std::string& theme : Themes()) {
    const std::string paper = Found(theme, std::regex(R"re((paper): "(#[0-9a-f]{6})")re"))["paper"];
    const std::string from = theme.substr(theme.find("words: {"));
    Inks words = Found(from.substr(0, from.find('}')), std::regex(R"re(([a-z]+): "(#[0-9a-f]{6})")re"));
    words.merge(PageInks(theme));  // unless a separate text colour is defined
    for (const auto& [name, colour] : words) EXPECT_GE(Contrast(colour, paper), 4.5) << name;
  }
}

}  // namespace
}  // namespace gaitwright
