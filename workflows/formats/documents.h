// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// A kind of file or of printed object, and its JSON schema (draft 2020-12).
struct Document {
  std::string name;   ///< such as "motion-plan", which is the schema's file too
  std::string title;  ///< in a few words
  std::string schema;
};

/// All kinds: files that are written and read, files that people write, and what verbs print with --json. Schemas of
/// files come from the shapes that their readers take their keys from; those of what is printed name the laws, metrics,
/// statuses and kinds that the code lists.
std::vector<Document> Documents();

}  // namespace gaitwright
