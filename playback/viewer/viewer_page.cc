// SPDX-License-Identifier: BSD-3-Clause
#include "playback/viewer/viewer_page.h"

#include <fmt/format.h>

#include "kinematics/base/result.h"
#include "playback/report/svg_tools.h"
#include "playback/viewer/viewer_bundle_internal.h"

namespace gaitwright {
namespace {

/// Style and script around an element; CDATA sections keep the page well-formed XML.
std::string Parts(const std::string& element) {
  return fmt::format("<style>/*<![CDATA[*/\n{}\n/*]]>*/</style>\n{}<script>//<![CDATA[\n{}\n//]]></script>\n",
                     ViewerStyle(), element, ViewerScript());
}

/// The viewer's element and its scene.
std::string SceneElement(const std::string& classes, const std::string& scene) {
  return fmt::format(
      "<div class=\"{}\" data-scene=\"scene\"></div>\n<script type=\"application/json\" id=\"scene\">{}</script>\n",
      classes, scene);
}

std::string Page(const std::string& title, const std::string& element) {
  if (!HasViewer()) throw InvalidArgument("this program was built without the viewer (GAITWRIGHT_VIEWER=OFF)");
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"/><title>{}</title>\n<style>body{{margin:0}}</style></head>\n"
      "<body>\n{}</body></html>\n",
      EscapedXml(title), Parts(element));
}

}  // namespace

bool HasViewer() { return !ViewerScript().empty(); }

std::string ViewerPage(const std::string& title, const std::vector<ShownMotion>& motions) {
  return Page(title, SceneElement("gw-page", SceneJson(motions)));
}

std::string LivePage(const std::string& title) {
  return Page(title, fmt::format("<div class=\"gw-page\" data-live=\"{}\"></div>\n", kLivePath));
}

std::string ViewerPart(const std::vector<ShownMotion>& motions) {
  return HasViewer() ? Parts(SceneElement("gw-part", SceneJson(motions))) : "";
}

}  // namespace gaitwright
