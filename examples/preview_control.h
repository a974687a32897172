// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright::examples {

/// Planar ZMP reference on a uniform time grid.
struct ZmpTable {
  std::vector<double> time_s, zmp_x_m, zmp_y_m;
};

/// ZMP reference of a walk of eight steps, each 0.2 m long and 0.8 s in duration, with the feet 0.2 m apart, and 2 s of
/// standing at both ends; one sample every 5 ms.
ZmpTable WalkOfItsOwn();

/// Reads the columns time_s, zmp_x_m, zmp_y_m. @throws InvalidArgument that names the invalid line.
ZmpTable ReadZmp(const std::string& csv_text);

/// Follows the reference with Kajita's preview control.
/// @return CSV text: time_s, com_x_m, com_y_m, zmp_x_m, zmp_y_m.
std::string PreviewedCsv(const ZmpTable& reference, double com_height_m, double preview_s);

/// SVG picture of the reference, the ZMP and the centre of mass over time.
std::string PreviewPicture(const ZmpTable& reference, double com_height_m, double preview_s);

/// The main function of the program, see --help. @return the exit status.
int PreviewControlMain(int argc, const char* const* argv);

}  // namespace gaitwright::examples
