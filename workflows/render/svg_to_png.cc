// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/render/svg_to_png.h"

#include "kinematics/base/file.h"
#include "workflows/render/chromium.h"
#include "workflows/render/temporary_folder_internal.h"

namespace gaitwright {

Result<std::string> SvgToPng(const SvgDrawing& drawing) {
  const TemporaryFolder folder;
  if (!folder.there())
    return Failure{
        FailureKind::kBadInput, FailureCode::kNoFolder, "SvgToPng", "no temporary folder can be created", {}};
  const std::string file = folder.In("drawing.html");
  const auto written = WriteFileAtomically(
      file, "<!doctype html><meta charset=\"utf-8\"><body style=\"margin:0\">" + drawing.svg + "</body>");
  if (!written) return written.failure();
  auto browser = Chromium::Start({.width_px = drawing.width_px, .height_px = drawing.height_px});
  if (!browser) return browser.failure();
  const auto opened = (*browser)->Open(FileUrl(file));
  if (!opened) return opened.failure();
  return (*browser)->Png();
}

}  // namespace gaitwright
