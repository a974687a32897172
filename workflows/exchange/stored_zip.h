// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// A file within an archive.
struct ZipEntry {
  std::string name, bytes;
};

/// A ZIP archive of the files in their order, without compression and dated 1980-01-01, so that the same files give the
/// same bytes. @throws InvalidArgument for an empty or duplicate name.
std::string StoredZip(const std::vector<ZipEntry>& entries);

}  // namespace gaitwright
