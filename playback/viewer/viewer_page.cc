// SPDX-License-Identifier: BSD-3-Clause
#include "playback/viewer/viewer_page.h"

#include <fmt/format.h>

#include "kinematics/base/result.h"
#include "playback/report/svg_tools.h"
#include "playback/viewer/viewer_bundle_internal.h"

namespace gaitwright {
namespace {

/// The viewer's element, what it shows, and the script; sections of characters keep the page well-formed XML.
std::string Parts(const std::string& classes, const std::string& scene) {
  return fmt::format(
      "<style>/*<![CDATA[*/\n{}\n/*]]>*/</style>\n<div class=\"{}\" data-scene=\"scene\"></div>\n"
      "<script type=\"application/json\" id=\"scene\">{}</script>\n<script>//<![CDATA[\n{}\n//]]></script>\n",
      ViewerStyle(), classes, scene, ViewerScript());
}

}  // namespace

bool HasViewer() { return !ViewerScript().empty(); }

std::string ViewerPage(const std::string& title, const std::vector<ShownMotion>& motions) {
  if (!HasViewer()) throw InvalidArgument("this program was built without the viewer (GAITWRIGHT_VIEWER=OFF)");
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"/><title>{}</title>\n<style>body{{margin:0}}</style></head>\n"
      "<body>\n{}</body></html>\n",
      EscapedXml(title), Parts("gw-page", SceneJson(motions)));
}

std::string ViewerPart(const std::vector<ShownMotion>& motions) {
  return HasViewer() ? Parts("gw-part", SceneJson(motions)) : "";
}

}  // namespace gaitwright
