// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/inputs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/built_paths.h"

namespace gaitwright::fuzz {
namespace {

namespace fs = std::filesystem;

/// A folder of this process, removed at its end; in memory if the system has such a folder.
class OwnFolder {
 public:
  OwnFolder() { fs::create_directories(path_); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  ~OwnFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  static fs::path Base() {
    std::error_code error;
    return fs::is_directory("/dev/shm", error) ? fs::path("/dev/shm") : fs::temp_directory_path();
  }
  fs::path path_ = Base() / fmt::format("gaitwright_fuzz_{}", ::getpid());
};

std::string Bytes(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("there is no '{}'", path.string()));
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::vector<Seed> SeedsOf(const Reader& reader) {
  std::vector<Seed> seeds;
  const fs::path folder = fs::path(SourceFolder()) / "tests/fuzz/corpus" / reader.name;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::directory_iterator(folder))
      seeds.push_back({entry.path().filename().string(), Bytes(entry.path())});
  }
  std::sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) { return a.name < b.name; });
  for (const std::string& file : reader.own_files) seeds.push_back({file, SourceFile(file)});
  if (reader.made == nullptr) return seeds;
  for (const std::string& made : reader.made()) seeds.push_back({fmt::format("made-{}", seeds.size()), made});
  return seeds;
}

const Reader& ReaderNamed(const std::string& name) {
  std::string names;
  for (const Reader& reader : Readers()) {
    if (reader.name == name) return reader;
    names += " " + reader.name;
  }
  throw std::invalid_argument(fmt::format("there is no reader '{}'; there are{}", name, names));
}

std::string InFile(const std::string& bytes, const std::string& ending) {
  static const OwnFolder folder;
  std::string path = (folder.path() / ("input" + ending)).string();
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

std::string SourceFile(const std::string& path) { return Bytes(fs::path(SourceFolder()) / path); }

}  // namespace gaitwright::fuzz
