// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workflows/exchange/stored_zip.h"

namespace gaitwright {

/// The files within a ZIP archive, stored or deflated, in their order.
/// @param most_bytes  of all files together, unpacked.
/// @throws InvalidArgument for bytes that are no archive, a file that is damaged, encrypted or a duplicate, and for an
/// archive that is too large or has more than 1000 files.
std::vector<ZipEntry> ReadZip(const std::string& bytes, std::size_t most_bytes);

}  // namespace gaitwright
