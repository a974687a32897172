// SPDX-License-Identifier: BSD-3-Clause
#include "cli/write_results.h"

#include <fmt/format.h>

namespace gaitwright::cli {

Result<std::vector<std::string>> WriteResults(const std::vector<OutputFile>& files, const std::string& so_far) {
  Result<std::vector<std::string>> written = WriteFilesTogether(files);
  if (written) return written;
  Failure failure = written.failure();
  failure.suggestions.push_back(fmt::format(
      "make the file writable, then run the same command with --resume; '{}' keeps the results so far", so_far));
  return failure;
}

}  // namespace gaitwright::cli
