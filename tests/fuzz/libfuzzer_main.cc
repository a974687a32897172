// SPDX-License-Identifier: BSD-3-Clause
// The readers under libFuzzer (https://llvm.org/docs/LibFuzzer.html): libfuzzer_ROOM --reader=NAME CORPUS -runs=N
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <string_view>

#include "tests/fuzz/inputs.h"
#include "tests/fuzz/mutate.h"

using namespace gaitwright::fuzz;

namespace {
const Reader* reader = nullptr;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  constexpr std::string_view kFlag = "--reader=";
  for (int i = 1; i < *argc; ++i) {
    const std::string_view argument = (*argv)[i];
    if (argument.starts_with(kFlag)) reader = &ReaderNamed(std::string(argument.substr(kFlag.size())));
  }
  if (reader == nullptr) reader = &ReaderNamed("");  // throws with the list of readers
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(data), size);
  try {
    reader->read(input);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", reader->name, error.what());
    std::abort();
  }
  return 0;
}

/// Half of the mutations are libFuzzer's, half are those of Mutator, which knows the format.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, most);
  Mutator mutator(reader->words, seed);
  const std::string input(reinterpret_cast<const char*>(data), size);
  const std::string changed = mutator.Mutate(input, input, most);
  std::memcpy(data, changed.data(), changed.size());
  return changed.size();
}
