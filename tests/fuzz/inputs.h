// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// An input and where it is from.
struct Seed {
  std::string name, bytes;
};

/// The inputs that a reader begins with: of its corpus, of the source tree and of the program, in an order that is the
/// same everywhere.
std::vector<Seed> SeedsOf(const Reader& reader);

/// The reader of that name. @throws std::invalid_argument listing those there are.
const Reader& ReaderNamed(const std::string& name);

/// The path of a file of this process with those bytes and that ending; it holds until the next call with this ending,
/// and is taken away when the program ends.
std::string InFile(const std::string& bytes, const std::string& ending);

/// The bytes of a file of the source tree. @throws std::runtime_error when it is not there.
std::string SourceFile(const std::string& path);

}  // namespace gaitwright::fuzz
