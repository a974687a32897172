// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace gaitwright::fuzz {

/// Thrown when a reader has accepted what it should have refused, or does not read back what was written.
class BrokenLaw : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// @throws BrokenLaw unless the law holds.
inline void Require(bool holds, const std::string& law) {
  if (!holds) throw BrokenLaw(law);
}

enum class Verdict { kRefused, kAccepted };

/// Something of the program that reads a file or a flag. `read` takes one input as it would stand in the file, and
/// checks what was accepted; whatever it throws is a defect.
struct Reader {
  std::string name;  ///< of its test, fuzz.NAME, and of its folder in tests/fuzz/corpus
  Verdict (*read)(const std::string& input);
  std::vector<std::string> words;                ///< that its format knows, for mutations
  std::vector<std::string> own_files;            ///< of the source tree, that are good inputs
  std::vector<std::string> (*made)() = nullptr;  ///< good inputs that the program itself writes
  int inputs = 1000;                             ///< mutations that ./test tries; what takes long has fewer
};

/// The readers of the program's room. A new reader gets its place here: in the file of its room, ROOM_readers.cc.
const std::vector<Reader>& Readers();

}  // namespace gaitwright::fuzz
