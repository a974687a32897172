// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/map_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "playback/report/svg_tools.h"

namespace gaitwright {
namespace {

using Colour = std::array<double, 3>;

/// Cividis at 0, 1/8 ... 1.
constexpr std::array<Colour, 9> kCividis = {{{0, 34, 78},
                                             {26, 56, 111},
                                             {64, 77, 107},
                                             {92, 99, 110},
                                             {124, 123, 120},
                                             {156, 148, 115},
                                             {190, 175, 103},
                                             {226, 204, 84},
                                             {254, 232, 56}}};

std::string Outlined(const MapCell& cell, const std::string& style) {
  if (cell.round) {
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>", cell.x + 0.5 * cell.width,
                       cell.y + 0.5 * cell.height, 0.5 * std::min(cell.width, cell.height), style);
  }
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>", cell.x, cell.y,
                     cell.width, cell.height, style);
}

const char* PatternOf(PointStatus status) {
  switch (status) {
    case PointStatus::kFell:
      return "map-dots";
    case PointStatus::kAuditFailed:
      return "map-crossed";
    case PointStatus::kRefused:
      return "map-hatched";
    default:
      return nullptr;
  }
}

}  // namespace

std::optional<double> ShareOf(const PointOutcome& outcome, MapQuantity quantity) {
  if (quantity == MapQuantity::kSurvival)
    return outcome.survival ? std::optional<double>(outcome.survival->share) : std::nullopt;
  return outcome.score ? std::optional<double>(0.01 * *outcome.score) : std::nullopt;
}

std::string MapColour(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (kCividis.size() - 1.0);
  const auto low = std::min(static_cast<std::size_t>(at), kCividis.size() - 2);
  const double part = at - static_cast<double>(low);
  std::string colour = "#";
  for (std::size_t k = 0; k < 3; ++k) {
    const double mixed = kCividis[low][k] + part * (kCividis[low + 1][k] - kCividis[low][k]);
    colour += fmt::format("{:02x}", static_cast<int>(std::lround(mixed)));
  }
  return colour;
}

std::string LetterOf(PointStatus status) {
  switch (status) {
    case PointStatus::kPass:
      return "";
    case PointStatus::kGateMissed:
      return "G";
    case PointStatus::kFell:
      return "F";
    case PointStatus::kAuditFailed:
      return "A";
    case PointStatus::kRefused:
      break;
  }
  return "R";
}

std::string WordsOf(PointStatus status) {
  switch (status) {
    case PointStatus::kPass:
      return "pass";
    case PointStatus::kGateMissed:
      return "stays up, fails a gate";
    case PointStatus::kFell:
      return "fell";
    case PointStatus::kAuditFailed:
      return "plan fails its audit";
    case PointStatus::kRefused:
      break;
  }
  return "refused: no plan, or a plan that cannot be played";
}

std::string MapPatterns() {
  return R"(<defs>
<pattern id="map-hatched" width="6" height="6" patternUnits="userSpaceOnUse"><rect width="6" height="6" fill="#e9ecef"/><path d="M-1,1 l2,-2 M0,6 l6,-6 M5,7 l2,-2" stroke="#8a949e" stroke-width="1.3"/></pattern>
<pattern id="map-crossed" width="7" height="7" patternUnits="userSpaceOnUse"><path d="M0,7 l7,-7 M0,0 l7,7" stroke="#ffffff" stroke-width="2.2"/><path d="M0,7 l7,-7 M0,0 l7,7" stroke="#1f2730" stroke-width="0.9"/></pattern>
<pattern id="map-dots" width="5" height="5" patternUnits="userSpaceOnUse"><circle cx="2.5" cy="2.5" r="1.2" fill="#ffffff"/></pattern>
</defs>
)";
}

std::string DrawCell(const MapCell& cell, PointStatus status, std::optional<double> share) {
  const char* pattern = PatternOf(status);
  std::string svg = "<g>";
  if (!cell.words.empty()) svg += "<title>" + EscapedXml(cell.words) + "</title>";
  svg += Outlined(cell, fmt::format("fill=\"{}\"", share ? MapColour(*share) : "#e9ecef"));
  if (pattern != nullptr) svg += Outlined(cell, fmt::format("fill=\"url(#{})\"", pattern));
  if (cell.framed) svg += Outlined(cell, "fill=\"none\" stroke=\"#d6006c\" stroke-width=\"3\"");
  const double size = std::min({0.62 * cell.height, 0.8 * cell.width, 15.0});
  const std::string letter = LetterOf(status);
  if (!letter.empty() && size >= 5.0) {
    svg += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"{:.1f}\" font-weight=\"700\" "
        "fill=\"#101418\" stroke=\"#ffffff\" stroke-width=\"{:.1f}\" paint-order=\"stroke\">{}</text>",
        cell.x + 0.5 * cell.width, cell.y + 0.5 * cell.height + 0.36 * size, size, 0.28 * size, letter);
  }
  return svg + "</g>\n";
}

}  // namespace gaitwright
