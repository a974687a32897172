// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright::examples {

/// A planar reference or motion over time on a uniform grid.
struct ZmpTable {
  std::vector<double> time_s, zmp_x_m, zmp_y_m;
};

/// A walk of eight steps of 0.2 m with the feet 0.2 m apart, 0.8 s a step, standing 2 s at both ends; every 5 ms.
ZmpTable WalkOfItsOwn();

/// Reads columns time_s, zmp_x_m, zmp_y_m. @throws InvalidArgument naming the line that is wrong.
ZmpTable ReadZmp(const std::string& csv_text);

/// Follows the reference with Kajita's preview control.
/// @return CSV text: time_s, com_x_m, com_y_m, zmp_x_m, zmp_y_m.
std::string PreviewedCsv(const ZmpTable& reference, double com_height_m, double preview_s);

/// The reference, the ZMP and the centre of mass over time, as one SVG picture.
std::string PreviewPicture(const ZmpTable& reference, double com_height_m, double preview_s);

/// The program: see --help. @return the exit status.
int PreviewControlMain(int argc, const char* const* argv);

}  // namespace gaitwright::examples
