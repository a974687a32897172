// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// An input and its origin.
struct Seed {
  std::string name, bytes;
};

/// The initial inputs of a reader: of its corpus, of the source tree and of the program, in the same order everywhere.
std::vector<Seed> SeedsOf(const Reader& reader);

/// The reader with a name. @throws std::invalid_argument listing the existing readers.
const Reader& ReaderNamed(const std::string& name);

/// The path of a file of this process with these bytes and this ending. It is valid until the next call with this
/// ending, and is removed when the program ends.
std::string InFile(const std::string& bytes, const std::string& ending);

/// The bytes of a file of the source tree. @throws std::runtime_error if it does not exist.
std::string SourceFile(const std::string& path);

}  // namespace gaitwright::fuzz
