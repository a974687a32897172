// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// A kind of file or printed object, and its JSON schema (draft 2020-12).
struct Document {
  std::string name;   ///< such as "motion-plan", also the name of the schema's file
  std::string title;  ///< short title
  std::string schema;
};

/// All kinds: files that the program writes and reads, files that users write, and output of verbs with --json. Schemas
/// of files come from the shapes that their readers use; schemas of output use the names of checks, metrics, statuses
/// and kinds in the code.
std::vector<Document> Documents();

}  // namespace gaitwright
