// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/plot_style.h"

#include <fmt/format.h>

namespace gaitwright {
namespace {

/// A colour by its class, for light and dark screens.
struct Colour {
  const char* name;
  const char* light;
  const char* dark;
};

constexpr Colour kColours[] = {
    {"zmp", "#da7e1b", "#fc7c23"},     {"com", "#0073e7", "#0592f9"},   {"dcm", "#791483", "#dba0da"},
    {"foot", "#009558", "#44d18a"},    {"joint", "#0073e7", "#0592f9"}, {"limit", "#6e2f05", "#f8c068"},
    {"support", "#70bbfd", "#005c90"}, {"bad", "#a70064", "#ed2646"},   {"muted", "#8691a2", "#6d7072"},
};

std::string ColourRules(bool dark) {
  std::string css;
  for (const Colour& c : kColours) {
    const char* colour = dark ? c.dark : c.light;
    css += fmt::format(".gw .{0}{{stroke:{1};color:{1}}}", c.name, colour);
    css += fmt::format(".gw .{0}.dot,.gw .{0}.filled,.gw .{0}.band,.gw rect.{0}{{fill:{1}}}", c.name, colour);
  }
  const char* ink = dark ? "#dfe5ec" : "#1f2730";
  const char* soft = dark ? "#a3adb8" : "#56616d";
  css += fmt::format(".gw text{{fill:{0};stroke:none}}.gw .tick,.gw .note,.gw .label{{fill:{1}}}", ink, soft);
  css += fmt::format(".gw .grid{{stroke:{0}}}.gw .frame{{stroke:{1};fill:none}}.gw .paper{{fill:{2};stroke:none}}",
                     dark ? "#2c343d" : "#e4e8ec", dark ? "#55606b" : "#aab3bc", dark ? "#14181d" : "#ffffff");
  return css;
}

}  // namespace

const char* CssClass(Ink ink) {
  switch (ink) {
    case Ink::kZmp:
      return "zmp";
    case Ink::kCom:
      return "com";
    case Ink::kDcm:
      return "dcm";
    case Ink::kFoot:
      return "foot";
    case Ink::kJoint:
      return "joint";
    case Ink::kLimit:
      return "limit";
    case Ink::kSupport:
      return "support";
    case Ink::kBad:
      return "bad";
    case Ink::kMuted:
      return "muted";
  }
  return "muted";
}

const char* CssClass(Stroke stroke) {
  switch (stroke) {
    case Stroke::kPlanned:
      return "planned";
    case Stroke::kMeasured:
      return "measured";
    case Stroke::kThin:
      return "thin";
    case Stroke::kDashed:
      return "dashed";
  }
  return "thin";
}

std::string PlotStyle() {
  std::string css =
      ".gw text{font:11px system-ui,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif}"
      ".gw .title{font-size:12.5px;font-weight:600}.gw .heading{font-size:14px;font-weight:650}.gw "
      ".mid{text-anchor:middle}.gw .end{text-anchor:end}"
      ".gw .tick,.gw .legend{font-variant-numeric:tabular-nums}"
      ".gw .frame{stroke-width:1}.gw .grid{stroke-width:1;fill:none}"
      ".gw path,.gw line{fill:none;stroke-linejoin:round;stroke-linecap:round}"
      ".gw .planned{stroke-width:4.5;opacity:.32}.gw .measured{stroke-width:1.4}.gw .thin{stroke-width:1}"
      ".gw .dashed{stroke-width:1.2;stroke-dasharray:5 4}.gw .heavy{stroke-width:1.8}"
      ".gw .dot{stroke:none}.gw .filled{stroke-width:.8;fill-opacity:.16;stroke-opacity:.55}"
      ".gw .support.filled{fill-opacity:.09;stroke-opacity:.3}.gw .outline{stroke-width:1.1}.gw "
      ".band{stroke:none;fill-opacity:.22}"
      ".gw .bar-planned{stroke:none;fill-opacity:.28}.gw .bar-measured{stroke:none}";
  css += ColourRules(false);
  return css + "@media (prefers-color-scheme:dark){" + ColourRules(true) + ".gw .planned{opacity:.45}}";
}

std::string StandaloneSvg(const std::string& svg) {
  const std::size_t open = svg.find("<svg"), close = svg.find('>', open);
  if (open == std::string::npos || close == std::string::npos) return svg;
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"" +
         svg.substr(open + 4, close - open - 3) + "<style>" + PlotStyle() +
         "</style><rect class=\"paper\" width=\"100%\" height=\"100%\"/>" + svg.substr(close + 1) + "\n";
}

}  // namespace gaitwright
