// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/render/svg_to_pdf.h"

#include "kinematics/base/file.h"
#include "workflows/render/run_program.h"
#include "workflows/render/temporary_folder_internal.h"

namespace gaitwright {

Result<std::string> SvgToPdf(const std::string& svg) {
  const std::string program = FindProgram({"rsvg-convert"});
  if (program.empty()) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kNoRsvg,
                   "SvgToPdf",
                   "PDF needs rsvg-convert, which is not installed",
                   {"on Debian: apt-get install librsvg2-bin", "use .svg, which needs no other program"}};
  }
  const TemporaryFolder folder;
  if (!folder.there())
    return Failure{
        FailureKind::kBadInput, FailureCode::kNoFolder, "SvgToPdf", "no temporary folder can be created", {}};
  auto written = WriteFileAtomically(folder.In("figure.svg"), svg);
  if (!written) return written;
  const auto made =
      RunProgram(program, {"--format=pdf", "--output=" + folder.In("figure.pdf"), folder.In("figure.svg")});
  if (!made) return made.failure();
  return ReadBytes(folder.In("figure.pdf"));
}

}  // namespace gaitwright
