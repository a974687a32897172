// SPDX-License-Identifier: BSD-3-Clause
// fuzz_ROOM NAME [INPUTS [SEED]]   a reader's corpus, then INPUTS mutations of it; by default its share of ./test
// fuzz_ROOM NAME --file FILE...    these inputs
// fuzz_ROOM NAME --write FOLDER    writes the initial inputs of a reader, for libFuzzer
// fuzz_ROOM --list                 the names of the readers
// For builds without libFuzzer. An input that causes a defect is saved in the current folder as bad-NAME.
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/fuzz/inputs.h"
#include "tests/fuzz/mutate.h"
#include "tests/sanitized.h"

namespace gaitwright::fuzz {
namespace {

constexpr int kSlowest = 20;  // seconds of CPU that one input may take; sanitizers make it slow
constexpr std::size_t kMostMemory = std::size_t{4} << 30;  // bytes
constexpr std::size_t kLeastRoom = 4096;                   // minimum size limit of a mutation, for short inputs [byte]

const std::string* present = nullptr;  // the current input, for the signal handler
std::string present_name;              // name of its reader

/// Writes the current input to a file. A signal handler calls it too, so it only opens and writes the file.
void KeepPresent() {
  if (present == nullptr) return;
  std::FILE* file = std::fopen(("bad-" + present_name).c_str(), "wb");
  if (file == nullptr) return;
  std::fwrite(present->data(), 1, present->size(), file);
  std::fclose(file);
}

void OnSignal(int signal) {
  const char* const why = signal == SIGVTALRM ? "takes too long: a hang\n" : "crashes\n";
  if (::write(STDERR_FILENO, why, std::char_traits<char>::length(why)) < 0) std::_Exit(1);
  KeepPresent();
  std::_Exit(1);
}

/// Saves the input and ends the program upon a crash, a hang or too much memory.
void StandGuard() {
  static char stack[1 << 16];
  stack_t own{};
  own.ss_sp = stack;
  own.ss_size = sizeof(stack);
  sigaltstack(&own, nullptr);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGVTALRM}) {
    struct sigaction action {};
    action.sa_handler = OnSignal;
    action.sa_flags = SA_ONSTACK;
    sigaction(signal, &action, nullptr);
  }
#ifndef GAITWRIGHT_SANITIZED
  const rlimit memory{kMostMemory, kMostMemory};
  setrlimit(RLIMIT_AS, &memory);
#endif
}

/// @return whether it was accepted; ends the program if it violates a law.
bool Try(const Reader& reader, const std::string& input, const std::string& name) {
  const itimerval limit{{0, 0}, {kSlowest, 0}};
  setitimer(ITIMER_VIRTUAL, &limit, nullptr);
  present = &input;
  try {
    return reader.read(input) == Verdict::kAccepted;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}, {}: {}\n", reader.name, name, error.what());
    KeepPresent();
    std::exit(1);
  }
}

std::string FileBytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Reads each file of the corpus and its mutations. Fails if the reader accepts none of them, or all of them.
int Run(const Reader& reader, int inputs, std::uint64_t seed) {
  const std::vector<Seed> seeds = SeedsOf(reader);
  int accepted = 0, of_seeds = 0;
  for (const Seed& one : seeds) of_seeds += Try(reader, one.bytes, one.name) ? 1 : 0;
  Mutator mutator(reader.words, seed);
  for (int i = 0; i < inputs && !seeds.empty(); ++i) {
    const std::string& from = seeds[mutator.Below(seeds.size())].bytes;
    const std::string& other = seeds[mutator.Below(seeds.size())].bytes;
    const std::size_t most = std::max(2 * from.size(), kLeastRoom);
    accepted += Try(reader, mutator.Mutate(from, other, most), fmt::format("mutation {} of seed {}", i, seed)) ? 1 : 0;
  }
  fmt::print("{}: {} of {} kept inputs accepted, {} of {} mutations\n", reader.name, of_seeds, seeds.size(), accepted,
             inputs);
  const bool tells = of_seeds > 0 && of_seeds + accepted < static_cast<int>(seeds.size()) + inputs;
  if (!tells) fmt::print(stderr, "{}: inputs of both kinds are needed, good and bad\n", reader.name);
  return tells ? 0 : 1;
}

int Replay(const Reader& reader, const std::vector<std::string>& files) {
  for (const std::string& file : files)
    fmt::print("{}: {}\n", file, Try(reader, FileBytes(file), file) ? "accepted" : "refused");
  return 0;
}

int Write(const Reader& reader, const std::string& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const Seed& seed : SeedsOf(reader))
    std::ofstream(fmt::format("{}/seed-{:03}", folder, number++), std::ios::binary) << seed.bytes;
  return 0;
}

int Main(const std::vector<std::string>& arguments) {
  if (arguments.empty()) throw std::invalid_argument("the name of a reader is needed; --list names them");
  if (arguments[0] == "--list") {
    for (const Reader& reader : Readers()) fmt::print("{} {}\n", reader.name, reader.inputs);
    return 0;
  }
  const Reader& reader = ReaderNamed(arguments[0]);
  present_name = reader.name;
  StandGuard();
  if (arguments.size() > 2 && arguments[1] == "--file") return Replay(reader, {arguments.begin() + 2, arguments.end()});
  if (arguments.size() == 3 && arguments[1] == "--write") return Write(reader, arguments[2]);
  return Run(reader, arguments.size() > 1 ? std::stoi(arguments[1]) : reader.inputs,
             arguments.size() > 2 ? std::stoull(arguments[2]) : 1);
}

}  // namespace
}  // namespace gaitwright::fuzz

int main(int argc, char** argv) {
  try {
    return gaitwright::fuzz::Main({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
