// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace gaitwright::fuzz {

/// Thrown if a reader has accepted an invalid input, or does not read back what was written.
class BrokenLaw : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// @throws BrokenLaw unless the law holds.
inline void Require(bool holds, const std::string& law) {
  if (!holds) throw BrokenLaw(law);
}

enum class Verdict { kRefused, kAccepted };

/// A part of the program that reads a file or a flag. `read` takes one input, such as the contents of the file, and
/// checks an accepted result; every exception from it is a defect.
struct Reader {
  std::string name;  ///< of its test, fuzz.NAME, and of its folder in tests/fuzz/corpus
  Verdict (*read)(const std::string& input);
  std::vector<std::string> words;                ///< words of its format, for mutations
  std::vector<std::string> own_files;            ///< good inputs in the source tree
  std::vector<std::string> (*made)() = nullptr;  ///< good inputs that the program writes
  int inputs = 1000;                             ///< mutations in ./test; fewer for slow readers
};

/// The readers of the program's room. Add a new reader in the file of its room, ROOM_readers.cc.
const std::vector<Reader>& Readers();

}  // namespace gaitwright::fuzz
