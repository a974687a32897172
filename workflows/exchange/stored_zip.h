// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// A file within an archive.
struct ZipEntry {
  std::string name, bytes;
};

/// A ZIP archive of the files in their order, stored without compression, each dated 1980-01-01: the same files give
/// the same bytes. @throws InvalidArgument for a name that is empty or stands there twice.
std::string StoredZip(const std::vector<ZipEntry>& entries);

}  // namespace gaitwright
